"""Programs: the functions of a section's code, and whether runs of an old and a new code cover all changes.

A run covers a change in a function that it calls. It does not show a constant, an operator or a name that only the full
profile uses, so all changed functions together must have the same ones before and after.
"""

import ast
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence, Set
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

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


@dataclass(frozen=True)
class Function:
    body: Any  # its parameters and statements, as `plain` returns them
    header: Any  # its decorators and defaults, which run when it is defined
    tokens: Counter[Token]
    place: Place


class Program:
    """Holds the code of a section in the folder ``root``."""

    def __init__(self, section: str, root: Path):
        self.code = Code(root)
        self.functions: dict[str, Function] = {}
        self.statements: dict[str, Any] = {}
        """By file, those that run when it is imported."""
        self.defined: set[str] = set()  # all names that the project gives to something
        start = self.code.module(f"experiments.{section}")
        for file in self.code.closure(start, GENERATOR):
            name = self.code.name_of(file)
            tree = ast.parse(Path(file).read_bytes())
            _resolve_imports(tree, name)
            self.defined |= _names_defined(ast.walk(tree))
            self.statements[name] = _import_time(tree.body)
            self._find(tree, f"{name}:", file, frozenset())

    def _find(self, node: ast.AST, prefix: str, file: str, local: Set[str]) -> None:
        """Note the functions below a node; ``local`` are names of the outermost function around it."""
        for child in ast.iter_child_nodes(node):
            below = prefix
            names = local
            if isinstance(child, (*FUNCTIONS, ast.ClassDef)):
                below += _name(child)
                while below in self.functions:
                    below += "'"  # as a second lambda of one function
            if isinstance(child, FUNCTIONS):
                inside = [each for each in ast.walk(child) if not _is_attribute(each)]
                names = local or _names_defined(inside)
                self.functions[below] = self._function(child, file, names)
            if below != prefix:
                below += "."
            self._find(child, below, file, names)

    def _function(self, node: Any, file: str, local: Set[str]) -> Function:
        body = node.body if isinstance(node.body, list) else [node.body]
        decorators = getattr(node, "decorator_list", [])
        header = [*decorators, *node.args.defaults]
        header += filter(None, node.args.kw_defaults)
        tokens = Counter(self._tokens(_own_nodes([*header, *body]), local))
        line = min([node.lineno, *(decorator.lineno for decorator in decorators)])
        arguments = [each.arg for each in ast.walk(node.args) if hasattr(each, "arg")]
        if decorators:  # which may ask for names and kinds of parameters
            header.append(node.args)
        place = file, line, _name(node)
        return Function([arguments, plain(body)], plain(header), tokens, place)

    def _tokens(self, nodes: Iterable[Any], local: Set[str]) -> Iterator[Token]:
        for node in nodes:
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

    def tokens_of(self, names: Collection[str], renamed: Set[str]) -> Counter[Token]:
        """Count the tokens of functions, without names that were ``renamed``."""
        tokens = Counter[Token]()
        for name in names:
            if name in self.functions:
                tokens += self.functions[name].tokens
        for name in renamed:
            tokens.pop(("name", name), None)
        return tokens


def uncovered(old: Program, new: Program, called: Set[Place]) -> str:
    """Return the first change that runs of both, which called these functions, do not cover; empty for none."""
    for name in sorted({*old.statements, *new.statements}):
        if old.statements.get(name, []) != new.statements.get(name, []):
            return f"a statement that runs when {name} is imported changed"
    functions = [*old.functions.values(), *new.functions.values()]
    places = Counter(function.place for function in functions)
    changed = []
    for name in sorted({*old.functions, *new.functions}):
        sides = [side.functions.get(name) for side in (old, new)]
        forms = [(side.body, side.header) for side in sides if side]
        if len(forms) == 2 and forms[0] == forms[1]:
            continue
        if len(forms) == 2 and forms[0][1] != forms[1][1]:
            return f"a default or a decorator of {name} changed"
        for function in filter(None, sides):
            if function.place not in called or places[function.place] > 1:
                return f"no run calls {name}"
        changed.append(name)
    renamed = old.defined ^ new.defined
    gone = old.tokens_of(changed, renamed)
    come = new.tokens_of(changed, renamed)
    for kind, text in sorted((gone - come) | (come - gone)):
        return f"a run may not show the {kind} {text} of {', '.join(changed)}"
    return ""


def _resolve_imports(tree: ast.Module, name: str) -> None:
    """Write imported names as the paths that they stand for."""
    package = PurePosixPath(name).parts[:-1]
    imports: dict[str, str] = {}
    for node in ast.walk(tree):
        imports.update(imported_names(node, package))
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            node.id = imports.get(node.id, node.id)


def _name(node: Any) -> str:
    return getattr(node, "name", "<lambda>")


def _own_nodes(nodes: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Yield nodes with those below them, without docstrings, checks, and the bodies of functions."""
    for node in nodes:
        if isinstance(node, FUNCTIONS):
            defaults = [*node.args.defaults, *filter(None, node.args.kw_defaults)]
            yield from _own_nodes(defaults)
        elif not is_docstring(node) and not _is_check(node):
            yield node
            yield from _own_nodes(ast.iter_child_nodes(node))


def _is_check(node: ast.AST) -> bool:
    """Return whether a statement does nothing but raise errors."""
    if isinstance(node, ast.If):
        blocks = filter(None, (node.body, node.orelse))
        return all(
            isinstance(block[-1], ast.Raise) or all(map(_is_check, block))
            for block in blocks
        )
    if isinstance(node, ast.For):
        return all(map(_is_check, [*node.body, *node.orelse]))
    return isinstance(node, ast.Raise | ast.Assert)


def _import_time(body: Sequence[ast.stmt]) -> list[Any]:
    """Return what the statements of a module or a class do when it is imported, besides importing and defining."""
    skipped = (*FUNCTIONS, ast.Import, ast.ImportFrom)
    forms: list[Any] = []
    for node in body:
        if isinstance(node, ast.ClassDef):
            header = [*node.bases, *node.keywords, *node.decorator_list]
            inside = [*plain(header), *_import_time(node.body)]
            forms += [[node.name, inside]] if inside else []
        elif not isinstance(node, skipped) and not is_docstring(node):
            forms.append(plain(node))
    return forms


def _names_defined(nodes: Iterable[Any]) -> set[str]:
    """Return the names that functions, classes, parameters, variables and attributes get."""
    names = set[str]()
    for node in nodes:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.arg):
            names.add(node.arg)
        elif not isinstance(getattr(node, "ctx", ast.Load()), ast.Load):
            names.add(str(getattr(node, "id", getattr(node, "attr", ""))))
    return names


def _is_attribute(node: ast.AST) -> bool:
    return isinstance(node, ast.Attribute)
