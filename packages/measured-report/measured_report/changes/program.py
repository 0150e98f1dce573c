"""Programs: the functions of a section's code, and whether runs of an old and a new code cover all changes.

A run covers a change in a function that it calls. It does not show a constant, an operator or a name that only the full
profile uses, so all changed functions together must have the same ones before and after.
"""

import ast
from collections import Counter
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from measured_report.records.code import (
    GENERATOR,
    Code,
    digest_of,
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
    form: str  # digest of its syntax
    header: str  # digest of its decorators and defaults, which run when it is defined; empty if it has none
    tokens: Counter[Token]
    place: Place


class Program:
    """Holds the code of a section in the folder ``root``."""

    def __init__(self, section: str, root: Path):
        self.code = Code(root)
        self.functions: dict[str, Function] = {}
        self.statements: dict[
            str, list[Any]
        ] = {}  # by file, those that run when it is imported
        self.defined: set[str] = set()  # all names that the project gives to something
        for file in self.code.closure(
            self.code.module(f"experiments.{section}"), GENERATOR
        ):
            self._read(file)

    def _read(self, file: str) -> None:
        name = self.code.name_of(file)
        tree = ast.parse(Path(file).read_bytes())
        nodes = list(ast.walk(tree))
        imports = dict(
            pair
            for node in nodes
            for pair in imported_names(node, PurePosixPath(name).parts[:-1])
        )
        for node in nodes:
            self.defined.update(_names_defined(node))
            if isinstance(node, ast.Name):
                node.id = imports.get(node.id, node.id)
        self.statements[name] = _import_time(tree.body)
        for qualified, outer in _outer_functions(tree, f"{name}:"):
            inside = list(ast.walk(outer))
            local = {
                name
                for node in inside
                for name in _names_defined(node)
                if not isinstance(node, ast.Attribute)
            }
            for node in inside:
                if isinstance(node, FUNCTIONS):
                    nested = (
                        qualified if node is outer else f"{qualified}.{_name(node)}"
                    )
                    while nested in self.functions:
                        nested += "'"  # as a second lambda of one function
                    self.functions[nested] = self._function(node, file, local)

    def _function(self, node: Any, file: str, local: Set[str]) -> Function:
        body = node.body if isinstance(node.body, list) else [node.body]
        decorators = getattr(node, "decorator_list", [])
        at_definition = [
            *decorators,
            *node.args.defaults,
            *filter(None, node.args.kw_defaults),
        ]
        header = (
            digest_of(plain([*at_definition, *([node.args] if decorators else [])]))
            if at_definition
            else ""
        )
        tokens = Counter(self._tokens(_own_nodes(body), local))
        tokens.update([("header", header)] if header else [])
        line = min([node.lineno, *(decorator.lineno for decorator in decorators)])
        parameters = [
            child.arg
            for child in ast.iter_child_nodes(node.args)
            if isinstance(child, ast.arg)
        ]
        return Function(
            digest_of([parameters, plain(body)]),
            header,
            tokens,
            (file, line, _name(node)),
        )

    def _tokens(self, nodes: Iterator[ast.AST], local: Set[str]) -> Iterator[Token]:
        for node in nodes:
            if isinstance(node, ast.Constant):
                yield "constant", ascii(node.value)
            elif isinstance(node, OPERATORS):
                yield "operator", type(node).__name__
            elif isinstance(node, ast.Attribute | ast.keyword):
                yield (
                    "name",
                    str(node.attr if isinstance(node, ast.Attribute) else node.arg),
                )
            elif (
                isinstance(node, ast.Name)
                and node.id not in local
                and not self.code.module(node.id)
            ):
                yield "name", node.id.rpartition(".")[2]

    def of_both(self, other: "Program", names: Sequence[str]) -> Counter[Token]:
        """Count the tokens of functions, without names that only one of both programs defines: those were renamed."""
        renamed = {("name", name) for name in self.defined ^ other.defined}
        tokens = sum(
            (self.functions[name].tokens for name in names if name in self.functions),
            Counter[Token](),
        )
        return Counter(
            {token: count for token, count in tokens.items() if token not in renamed}
        )


def uncovered(old: Program, new: Program, called: Set[Place]) -> str:
    """Return the first change that runs of both, which called these functions, do not cover; empty for none."""
    for name in sorted({*old.statements, *new.statements}):
        if old.statements.get(name, []) != new.statements.get(name, []):
            return f"a statement that runs when {name} is imported changed"
    names = sorted({*old.functions, *new.functions})
    pairs = {name: (old.functions.get(name), new.functions.get(name)) for name in names}
    changed = {
        name: (a, b)
        for name, (a, b) in pairs.items()
        if not (a and b and _is_same(a, b))
    }
    places = Counter(
        function.place
        for program in (old, new)
        for function in program.functions.values()
    )
    for name, (before, after) in changed.items():
        if before and after and before.header != after.header:
            return f"a default or a decorator of {name} changed"
        for function in filter(None, (before, after)):
            if function.place not in called or places[function.place] > 1:
                return f"no run calls {name}"
    gone = old.of_both(new, [*changed])
    come = new.of_both(old, [*changed])
    for kind, text in sorted((gone - come) | (come - gone)):
        return f"a run may not show the {kind} {text} of {', '.join(changed)}"
    return ""


def _is_same(a: Function, b: Function) -> bool:
    return (a.form, a.header) == (b.form, b.header)


def _outer_functions(node: ast.AST, prefix: str) -> Iterator[tuple[str, ast.AST]]:
    """Yield the functions below a node that are in no other one, with their qualified names."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, FUNCTIONS):
            yield prefix + _name(child), child
        else:
            yield from _outer_functions(
                child,
                f"{prefix}{child.name}." if isinstance(child, ast.ClassDef) else prefix,
            )


def _name(function: Any) -> str:
    return getattr(function, "name", "<lambda>")


def _own_nodes(nodes: Sequence[ast.AST]) -> Iterator[ast.AST]:
    """Yield nodes and those below them, without checks and their texts, and without the bodies of functions."""
    for node in nodes:
        if is_docstring(node) or _is_check(node):
            continue
        if isinstance(node, FUNCTIONS):
            yield from _own_nodes(
                [*node.args.defaults, *filter(None, node.args.kw_defaults)]
            )
        elif isinstance(node, ast.JoinedStr):
            yield from _own_nodes(
                [
                    part.value
                    for part in node.values
                    if isinstance(part, ast.FormattedValue)
                ]
            )
        else:
            yield node
            yield from _own_nodes(list(ast.iter_child_nodes(node)))


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
    forms: list[Any] = []
    for node in body:
        if isinstance(node, ast.ClassDef):
            parts = [
                plain(part) for part in (node.bases, node.keywords, node.decorator_list)
            ]
            if any(inside := [*parts, _import_time(node.body)]):
                forms.append([node.name, inside])
        elif not isinstance(
            node, (*FUNCTIONS, ast.Import, ast.ImportFrom)
        ) and not is_docstring(node):
            forms.append(plain(node))
    return forms


def _names_defined(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
        yield node.name
    elif isinstance(node, ast.arg):
        yield node.arg
    elif isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
        yield node.id
    elif isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
        yield node.attr
