"""Syntax: what each definition of a module says, in a form that does not change with its place, name and layout."""

import ast
import copy
import hashlib
import json
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

ASSETS = ("assets/", "experiments/")
"""Where files lie that a program reads or starts by their path."""
GAP = "·"
EFFECTS = ""
"""The name under which is kept what a module does besides defining names."""


@dataclass(frozen=True)
class Definition:
    """One statement that defines a name."""

    tree: str
    """Digest of its syntax tree, with a gap in the place of each name that is not its own."""
    names: tuple[str, ...]
    """What stands in the gaps: names, and the attributes that are asked of them, as ``metrics.height_mm``."""
    imports: Mapping[str, str]
    """What it imports itself, by name."""
    assets: tuple[str, ...]
    """Paths of assets that it names."""
    decorators: tuple[str, ...]


@dataclass(frozen=True)
class Source:
    """What the text of one module says, as far as it matters here."""

    digest: str
    """Of its whole syntax tree."""
    modules: tuple[str, ...]
    """Names that it imports, anywhere in it, of which some are modules of this project."""
    assets: tuple[str, ...]
    top: Mapping[str, Any]
    """By name, at its top level: the plain constants, and how many parameters a function has."""
    imports: Mapping[str, str]
    """What its names are that it imports, as ``experiments.facts.metrics``."""


Definitions = Mapping[str, tuple[Definition, ...]]
"""Those of one module by name."""


class Reader:
    """Reads the syntax tree of one module of a package."""

    def __init__(self, tree: ast.Module, package: tuple[str, ...]):
        self._tree, self._package = tree, package
        aside = (_imports_alone, _is_text, _is_aside)
        self._statements = [node for node in tree.body if not any(is_so(node) for is_so in aside)]
        there = (node for node in tree.body if not isinstance(node, DEFINING))
        self._imports = {name: what for top in there for node in _walk(top) for name, what, _ in self._named(node)}
        self._names = {*self._imports, *(name for node in self._statements for name in _bound(node))}

    def source(self) -> Source:
        nodes = _walk(self._tree)
        return Source(
            digest=hashlib.sha256(ast.dump(self._tree).encode()).hexdigest(),
            modules=tuple(dict.fromkeys(module for node in nodes for _, _, module in self._named(node))),
            assets=tuple(_named_assets(nodes)),
            top=dict(self._top()),
            imports=self._imports,
        )

    def definitions(self) -> Definitions:
        """What most modules are never asked for, and takes longer than all else."""
        definitions: dict[str, list[Definition]] = {}
        for node in self._statements:
            names = list(dict.fromkeys(_bound(node))) or [EFFECTS]
            for place, name in enumerate(names):
                definitions.setdefault(name, []).append(self._definition(node, place))
        return {name: tuple(found) for name, found in definitions.items()}

    def _definition(self, node: ast.stmt, place: int) -> Definition:
        """What defines the name that a statement binds at this place."""
        nodes = _walk(node)
        inner = {name: what for each in nodes for name, what, _ in self._named(each)}
        tree, scope = Canonical(), self._names | inner.keys()
        if isinstance(node, DEFINING):
            text = [part for part in tree.plain(node, scope) if part != ("name", repr(node.name))]
        else:
            text = tree.plain(node, scope, frozenset(_bound(node)))
        decorators = (_chain(getattr(each, "func", each)) for each in getattr(node, "decorator_list", ()))
        return Definition(
            tree=digest_of([text, place]),
            names=tuple(tree.gaps),
            imports=inner,
            assets=tuple(_named_assets(nodes)),
            decorators=tuple(name for name in decorators if name.partition(".")[0] in self._names),
        )

    def _top(self) -> Iterator[tuple[str, Any]]:
        for node in self._tree.body:
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant | ast.Dict):
                with suppress(ValueError):  # a dict that is worked out is no constant
                    value = ast.literal_eval(node.value)
                    yield from ((target.id, value) for target in node.targets if isinstance(target, ast.Name))
            elif isinstance(node, ast.FunctionDef):
                yield node.name, len(node.args.args)

    def _named(self, node: ast.AST) -> Iterator[tuple[str, str, str]]:
        """The names that an import binds, what they are, and the module that each may be or be of."""
        if isinstance(node, ast.Import):
            for alias in node.names:
                what = alias.name if alias.asname else alias.name.partition(".")[0]
                yield alias.asname or what, what, alias.name
        elif isinstance(node, ast.ImportFrom):
            start = self._package[: len(self._package) - node.level + 1] if node.level else ()
            module = ".".join((*start, *([node.module] if node.module else [])))
            for alias in node.names:
                what = f"{module}.{alias.name}"
                yield alias.asname or alias.name, what, what


def _walk(node: ast.AST) -> list[ast.AST]:
    """A node and all below it, in the order of ``ast.walk``, which takes nearly twice as long."""
    found = [node]
    for each in found:
        for name in each._fields:
            value = getattr(each, name, None)
            if isinstance(value, list):
                found += [item for item in value if isinstance(item, ast.AST)]
            elif isinstance(value, ast.AST):
                found.append(value)
    return found


IMPORTS = (ast.Import, ast.ImportFrom)
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
DEFINING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


def _bound(node: ast.AST) -> Iterator[str]:
    """The names that a statement binds where it stands, and not in a scope of its own."""
    if isinstance(node, DEFINING):
        yield node.name
    elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
        yield node.id
    elif not isinstance(node, (*COMPREHENSIONS, ast.Lambda)):
        for child in ast.iter_child_nodes(node):
            yield from _bound(child)


def _imports_alone(node: ast.AST) -> bool:
    """Whether a statement imports and does nothing else, as behind a condition."""
    if isinstance(node, ast.If | ast.Try):
        return all(map(_imports_alone, [*node.body, *node.orelse, *getattr(node, "handlers", ())]))
    return isinstance(node, (*IMPORTS, ast.Pass))


def _is_text(node: Any) -> bool:
    # Any string that stands alone does nothing, wherever it stands: field docstrings are left out as well.
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _is_aside(node: ast.AST) -> bool:
    """Whether a statement is run only where its module is a program, or says where modules are found."""
    if isinstance(node, ast.If):
        return ast.unparse(node.test) == "__name__ == '__main__'"
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]).startswith("sys.path")


def _chain(node: ast.AST) -> str:
    """A name with the attributes that are asked of it, as ``metrics.height_mm``; empty where it is something else."""
    attributes: list[str] = []
    while isinstance(node, ast.Attribute):
        attributes.append(node.attr)
        node = node.value
    return ".".join([node.id, *reversed(attributes)]) if isinstance(node, ast.Name) else ""


class Canonical:
    """Makes plain tuples of a syntax tree, without comments, docstrings and positions.

    Fields that are empty or that only some Python versions know are left out: a record measured under one Python has
    to be fresh under another.
    """

    def __init__(self) -> None:
        self.gaps: list[str] = []

    def plain(self, node: Any, scope: Collection[str], own: Collection[str] = ()) -> Any:
        """Tuples for a node, whose ``own`` names do not count; those in ``scope`` become gaps."""
        if isinstance(node, list):
            kept = (each for each in node if not (_is_text(each) or isinstance(each, IMPORTS)))
            return tuple(self.plain(each, scope, own) for each in kept)
        if not isinstance(node, ast.AST):
            return repr(node)
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            return GAP if node.id in own else ("Name", node.id)
        if isinstance(node, (ast.Name, ast.Attribute)) and (chain := _chain(node)).partition(".")[0] in scope:
            self.gaps.append(chain)
            return GAP, type(node.ctx).__name__, *chain.split(".")[1:]
        if isinstance(node, ast.Raise):
            # What is raised, without what it says.
            raised = _Silence().visit(copy.deepcopy(node.exc)) if isinstance(node.exc, ast.Call) else node.exc
            return "Raise", self.plain(raised, scope), self.plain(node.cause, scope)
        if isinstance(node, ast.Assert):
            return "Assert", self.plain(node.test, scope)
        if isinstance(node, ast.JoinedStr):
            # Python 3.12 and later put an empty text behind a nested format specification.
            node = ast.JoinedStr([part for part in node.values if getattr(part, "value", None) != ""])
        if isinstance(node, COMPREHENSIONS):
            return self._comprehension(node, scope)
        inner = _inner(node, scope)
        fields = [
            (name, self.plain(value, inner if name == "body" else scope, own))
            for name, value in ast.iter_fields(node)
            if name != "kind"
        ]
        return type(node).__name__, *(pair for pair in fields if pair[1] not in ("None", ()))

    def _comprehension(self, node: Any, scope: Collection[str]) -> Any:
        """One whose variables hide names of the module, but for what its first part goes through."""
        targets = (each for part in node.generators for each in ast.walk(part.target))
        inner = frozenset(scope) - {each.id for each in targets if isinstance(each, ast.Name)}
        first, *rest = node.generators
        found = [getattr(node, name, None) for name in ("elt", "key", "value")]
        parts = [first.target, first.ifs, rest, found]
        return type(node).__name__, self.plain(first.iter, scope), *(self.plain(part, inner) for part in parts)


def _inner(node: ast.AST, scope: Collection[str]) -> Collection[str]:
    """What of the names means the same within a function: not its parameters, nor what it binds itself."""
    if not isinstance(node, FUNCTIONS):
        return scope
    body = node.body if isinstance(node.body, list) else []
    parameters = {each.arg for each in _walk(node.args) if isinstance(each, ast.arg)}
    outside = {name for each in _walk(node) if isinstance(each, ast.Global) for name in each.names}
    return frozenset(scope) - ((parameters | {name for each in body for name in _bound(each)}) - outside)


class _Silence(ast.NodeTransformer):
    def visit_Constant(self, node: ast.Constant) -> ast.Constant:
        return ast.Constant("") if isinstance(node.value, str) else node

    def visit_JoinedStr(self, node: ast.JoinedStr) -> ast.Constant:
        return ast.Constant("")


def _named_assets(nodes: Iterable[ast.AST]) -> Iterator[str]:
    for node in nodes:
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and text.startswith(ASSETS) and "\n" not in text:
            yield text


def digest_of(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
