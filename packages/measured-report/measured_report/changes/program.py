"""Check whether runs of the old and the new code of a section cover all changes.

A quick run covers a change in a function that it calls. However, it might not use a
constant, an operator or a name that only the full profile needs. Therefore the changed
functions together must contain the same constants, operators and names before and after
the change.
"""

import ast
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path, PurePosixPath
from typing import Any

from measured_report.files.errors import ReportError
from measured_report.records.code import (
    GENERATOR,
    Code,
    imported_names,
    is_docstring,
    plain,
)

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
OPERATORS = (ast.operator, ast.unaryop, ast.boolop, ast.cmpop)
Place = tuple[str, int, str]  # file, first line and name of a code object
Token = tuple[str, str]  # kind and text
AGAIN = "measure again with make rerun"


class Program:
    """The code of a section in the folder ``root``."""

    def __init__(self, section: str, root: Path):
        self.code = Code(root)
        self.functions: dict[str, tuple[str, Any]] = {}
        """The file and the syntax tree of each function and method, by qualified name."""
        self.statements: dict[str, Any] = {}
        """The statements of each file that run when it is imported."""
        self.defined: set[str] = set()  # all names that the project defines
        start = self.code.module(f"experiments.{section}")
        for file in self.code.closure(start, GENERATOR):
            name = self.code.name_of(file)
            tree = ast.parse(Path(file).read_bytes())
            _resolve_imports(tree, name)
            self.defined |= _names_defined(tree)
            self.statements[name] = _import_time(tree.body)
            for qualified, function in _definitions(tree.body, f"{name}:"):
                while qualified in self.functions:
                    qualified += "'"  # such as the setter of a property
                self.functions[qualified] = file, function

    def places(self, name: str) -> list[Place]:
        """Return the code objects of a function."""
        file, function = self.functions[name]
        places = []
        for node in ast.walk(function):
            if isinstance(node, FUNCTIONS):
                starts = [node, *getattr(node, "decorator_list", ())]
                line = min(start.lineno for start in starts)
                places.append((file, line, getattr(node, "name", "<lambda>")))
        return places

    def tokens(self, name: str) -> Iterator[Token]:
        """Yield the constants, operators and names in a function.

        Its local variables and its checks are left out.
        """
        function = self.functions[name][1]
        local = _names_defined(function, with_attributes=False)
        for node in _working_nodes([*_header(function), *function.body]):
            if isinstance(node, ast.Constant):
                yield "constant", ascii(node.value)
            elif isinstance(node, OPERATORS):
                yield "operator", type(node).__name__
            elif isinstance(node, ast.Attribute):
                yield "name", node.attr
            elif isinstance(node, ast.keyword):
                yield "name", str(node.arg)
            elif isinstance(node, ast.Name) and not (
                node.id in local or self.code.module(node.id)
            ):
                yield "name", node.id.rpartition(".")[2]


def changed_functions(old: Program, new: Program) -> list[tuple[str, list[Program]]]:
    """Return the functions that differ, each with the programs that contain it.

    Raise ReportError if no quick run can cover the change.
    """
    for name in sorted({*old.statements, *new.statements}):
        if old.statements.get(name, []) != new.statements.get(name, []):
            raise ReportError(
                f"a statement that runs at the import of {name} has changed: {AGAIN}"
            )
    counts = Counter[Token]()
    changed = []
    for name in sorted({*old.functions, *new.functions}):
        sides = [side for side in (old, new) if name in side.functions]
        trees = [side.functions[name][1] for side in sides]
        if len(sides) == 2:
            if plain(trees[0]) == plain(trees[1]):
                continue
            if plain(_header(trees[0])) != plain(_header(trees[1])):
                raise ReportError(
                    f"a default or a decorator of {name} has changed: {AGAIN}"
                )
        for side in sides:
            for token in side.tokens(name):
                # A token that only moved between functions cancels out.
                counts[token] += 1 if side is new else -1
        changed.append((name, sides))
    # A function with a new name changes each of its calls.
    renamed = old.defined ^ new.defined
    for (kind, text), count in sorted(counts.items()):
        if count and not (kind == "name" and text in renamed):
            names = ", ".join(name for name, _ in changed)
            raise ReportError(
                f"the quick run might not use the changed {kind} {text} in {names}: "
                f"{AGAIN}"
            )
    return changed


def refuse_uncalled(
    changed: Iterable[tuple[str, list[Program]]], called_places: set[Place]
) -> None:
    """Raise ReportError for a changed function that the runs did not call.

    ``called`` contains the functions that the runs of the old and the new code called.
    """
    for name, sides in changed:
        for side in sides:
            places = side.places(name)
            # Two functions at the same place cannot be distinguished in the log.
            if not called_places.issuperset(places) or len({*places}) < len(places):
                raise ReportError(f"the quick run does not call all of {name}: {AGAIN}")


def _resolve_imports(tree: ast.Module, name: str) -> None:
    """Replace imported names with the dotted paths that they stand for."""
    package = PurePosixPath(name).parts[:-1]
    imports: dict[str, str] = {}
    for node in ast.walk(tree):
        imports.update(imported_names(node, package))
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            node.id = imports.get(node.id, node.id)


def _definitions(body: Sequence[ast.stmt], prefix: str) -> Iterator[tuple[str, Any]]:
    """Yield functions and methods with their qualified names."""
    for node in body:
        if isinstance(node, ast.ClassDef):
            yield from _definitions(node.body, f"{prefix}{node.name}.")
        elif isinstance(node, FUNCTIONS):
            yield prefix + node.name, node


def _header(function: Any) -> list[ast.AST]:
    """Return the decorators and defaults of a function, which are evaluated when it is
    defined.
    """
    defaults = [*function.args.defaults, *filter(None, function.args.kw_defaults)]
    return [*function.decorator_list, *defaults]


def _working_nodes(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Yield nodes and their descendants, without docstrings and checks."""
    for node in nodes:
        if not is_docstring(node) and not _is_check(node):
            yield node
            yield from _working_nodes(ast.iter_child_nodes(node))


def _is_check(node: ast.AST) -> bool:
    """Return whether a statement only raises errors."""
    if isinstance(node, ast.If):
        blocks = filter(None, (node.body, node.orelse))
        return all(all(map(_is_check, block)) for block in blocks)
    if isinstance(node, ast.For):
        return all(map(_is_check, [*node.body, *node.orelse]))
    return isinstance(node, ast.Raise | ast.Assert)


def _import_time(body: Sequence[ast.stmt]) -> list[Any]:
    """Return the statements that run when a module or a class is imported.

    Imports and definitions of functions are left out.
    """
    skipped = (*FUNCTIONS, ast.Import, ast.ImportFrom)
    statements: list[Any] = []
    for node in body:
        if isinstance(node, ast.ClassDef):
            header = [*node.bases, *node.keywords, *node.decorator_list]
            class_statements = [*plain(header), *_import_time(node.body)]
            if class_statements:
                statements.append([node.name, class_statements])
        elif not isinstance(node, skipped) and not is_docstring(node):
            statements.append(plain(node))
    return statements


def _names_defined(tree: ast.AST, with_attributes: bool = True) -> set[str]:
    """Return the names of everything that is defined below a node.

    These are functions, classes, parameters, variables and attributes.
    """
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.arg):
            names.add(node.arg)
        elif not isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            if isinstance(node, ast.Name):
                names.add(node.id)
            elif isinstance(node, ast.Attribute) and with_attributes:
                names.add(node.attr)
    return names
