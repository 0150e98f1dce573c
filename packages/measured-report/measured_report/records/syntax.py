"""Syntax: what each definition of a module says, in a form that does not change with its place, name and layout."""

import ast
import hashlib
import json
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import chain
from typing import Any, TypeGuard

ASSETS = ("assets/", "experiments/", "packages/")  # where files lie that a program reads or starts by their path
GAP = "·"
WORKED_OUT = ...  # stands for what a module gives a name at its top level, and is no constant
Meanings = Mapping[str, str]  # by name what it stands for
EFFECTS = ""  # the name under which is kept what a module does besides defining names


@dataclass(frozen=True)
class Definition:
    """Holds one statement that defines a name."""

    tree: str  # digest of its syntax tree, with a gap in the place of each name that is not its own
    names: tuple[str, ...]  # what stands in the gaps: names, and attributes that are asked of them: `metrics.height_mm`
    imports: Meanings
    assets: tuple[str, ...]
    decorators: tuple[str, ...]


@dataclass(frozen=True)
class Source:
    """Holds what the text of one module says, as far as it matters here."""

    digest: str
    modules: tuple[str, ...]  # names that it imports, anywhere in it, of which some are modules of this project
    assets: tuple[str, ...]
    top: Mapping[str, Any]  # by name, at its top level: constants, and how many parameters a function has
    imports: Meanings


Definitions = Mapping[str, tuple[Definition, ...]]


class Reader:
    def __init__(self, tree: ast.Module, package: tuple[str, ...]):
        self._tree, self._package = tree, package
        aside = (_imports_alone, is_text, _is_aside)
        self._statements = [node for node in tree.body if not any(is_so(node) for is_so in aside)]
        loose = (node for node in tree.body if not isinstance(node, DEFINING))
        self._imports = self._imported(chain(*map(ast.walk, loose)))
        self._names = {*self._imports, *(name for node in self._statements for name in bound_names(node))}

    def source(self) -> Source:
        nodes = list(ast.walk(self._tree))
        digest = hashlib.sha256(ast.dump(self._tree).encode()).hexdigest()
        modules = tuple(dict.fromkeys(module for node in nodes for _, _, module in self._named(node)))
        return Source(digest, modules, _named_assets(nodes), dict(self._top()), self._imports)

    def definitions(self) -> Definitions:
        """Find the definitions, which most modules are never asked for, and which take longer than all else."""
        definitions: dict[str, list[Definition]] = {}
        for node in self._statements:
            for index, name in enumerate(dict.fromkeys(bound_names(node)) or [EFFECTS]):
                definitions.setdefault(name, []).append(self._definition(node, index))
        return {name: tuple(group) for name, group in definitions.items()}

    def canonical(self, node: ast.stmt, meanings: Meanings | None = None) -> "Canonical":
        """Return the forms of a definition of this module and of what is in it."""
        inner = self._imported(ast.walk(node))
        return Canonical(node, self._names | inner.keys(), {**self._imports, **inner}, meanings)

    def _definition(self, node: ast.stmt, index: int) -> Definition:
        canonical = self.canonical(node)
        called = (chain_of(getattr(child, "func", child)) for child in getattr(node, "decorator_list", ()))
        decorators = tuple(name for name in called if name.partition(".")[0] in self._names)
        imports, assets = self._imported(ast.walk(node)), _named_assets(ast.walk(node))
        return Definition(digest_of([canonical.form, index]), tuple(canonical.gaps), imports, assets, decorators)

    def _top(self) -> Iterator[tuple[str, Any]]:
        for node in self._tree.body:
            if isinstance(node, ast.Assign):
                value: Any = WORKED_OUT
                with suppress(ValueError):
                    value = ast.literal_eval(node.value)
                yield from ((target.id, value) for target in node.targets if isinstance(target, ast.Name))
            elif isinstance(node, ast.FunctionDef):
                yield node.name, len(node.args.args)

    def _imported(self, nodes: Iterable[ast.AST]) -> dict[str, str]:
        return {name: path for node in nodes for name, path, _ in self._named(node)}

    def _named(self, node: ast.AST) -> Iterator[tuple[str, str, str]]:
        if isinstance(node, ast.Import):
            for alias in node.names:
                path = alias.name if alias.asname else alias.name.partition(".")[0]
                yield alias.asname or path, path, alias.name
        elif isinstance(node, ast.ImportFrom):
            start = self._package[: len(self._package) - node.level + 1] if node.level else ()
            module = ".".join((*start, *([node.module] if node.module else [])))
            for alias in node.names:
                path = f"{module}.{alias.name}".lstrip(".")  # a module in no package may import one beside it
                yield alias.asname or alias.name, path, path


IMPORTS = (ast.Import, ast.ImportFrom)
DECLARING = (*IMPORTS, ast.Global, ast.Nonlocal)
DEFINING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
BINDING = {ast.ExceptHandler: "name", ast.MatchAs: "name", ast.MatchStar: "name", ast.MatchMapping: "rest"}
"""Field by kind of node, of a name that it binds and that is no node itself."""


def _in_scope(node: ast.AST) -> Iterator[ast.AST]:
    """Find a node and those below it that are in no scope of their own."""
    yield node
    if isinstance(node, COMPREHENSIONS):
        yield from (child.target for child in ast.walk(node) if isinstance(child, ast.NamedExpr))
    elif not isinstance(node, (*DEFINING, ast.Lambda)):
        for child in ast.iter_child_nodes(node):
            yield from _in_scope(child)


def bound_names(node: ast.AST) -> Iterator[str]:
    for child in _in_scope(node):
        if isinstance(child, DEFINING):
            yield child.name
        elif _is_bound(child):
            yield child.id
        elif name := getattr(child, BINDING.get(type(child), ""), None):
            yield name


def _imports_alone(node: ast.AST) -> bool:
    """Tell whether a statement imports and does nothing else, as behind a condition."""
    if isinstance(node, ast.If | ast.Try):
        return all(map(_imports_alone, [*node.body, *node.orelse, *getattr(node, "handlers", ())]))
    return isinstance(node, (*IMPORTS, ast.Pass))


def is_text(node: Any) -> bool:
    # Any string that stands alone does nothing, wherever it stands: field docstrings are left out as well.
    return isinstance(node, ast.Expr) and _is_string(node.value)


def _is_aside(node: ast.AST) -> bool:
    """Tell whether a statement is run only in a program, or says where modules are found."""
    if isinstance(node, ast.If):
        return ast.unparse(node.test) == "__name__ == '__main__'"
    return isinstance(node, ast.Assign) and ast.unparse(node.targets[0]).startswith("sys.path")


def chain_of(node: ast.AST) -> str:
    """Write a name with the attributes that are asked of it, as ``metrics.height_mm``; nothing for what is none."""
    attributes: list[str] = []
    while isinstance(node, ast.Attribute):
        attributes.append(node.attr)
        node = node.value
    return ".".join([node.id, *reversed(attributes)]) if isinstance(node, ast.Name) else ""


SAID = {"print", "warnings.warn", "tqdm.tqdm.write", "tqdm.auto.tqdm.write"}  # functions whose texts are only printed
LEVELS = ("debug", "info", "warning", "error", "exception", "critical")
SAID |= {f"{logger}.{level}" for logger in ("logging", "logger") for level in LEVELS}
PARSERS = {"ArgumentParser", "add_argument", "add_parser", "add_subparsers"}
HELP = {"help", "metavar", "description", "epilog", "usage", "prog"}
NOTHING = ("nothing",)  # stands for a statement that only prints texts


@dataclass(frozen=True)
class Scope:
    """Holds names as they are bound around a place."""

    local: Mapping[str, int] = field(default_factory=dict)
    attributes: Collection[str] = ()  # names that the class binds whose body this is


class Canonical:
    """Makes plain tuples of a syntax tree, without comments, docstrings, positions and texts that are only printed.

    What a function binds is numbered in order of binding; a parameter that can be passed by name keeps it in the
    signature. Fields that are empty, as those that only some Pythons know, are left out.
    """

    def __init__(self, node: ast.stmt, names: Collection[str], imports: Meanings, meanings: Meanings | None = None):
        """Make those of a statement at the top of its module, in which the names that it defines do not count.

        The ``names`` of its module become gaps, or what ``meanings`` has of them; of them ``imports`` are imported.
        """
        self.gaps: list[str] = []
        self._names, self._imports, self._meanings = names, imports, meanings
        self._own = frozenset(bound_names(node))
        self._local_count, self._is_silent = 0, False
        nodes = list(ast.walk(node))
        self._locals_count = any(map(_reads_locals, nodes))
        # What a definition is called counts where it is asked for.
        attributes = [node for node in nodes if isinstance(node, ast.Attribute)]
        self._names_count = any(node.attr in ("__name__", "__qualname__") and chain_of(node) for node in attributes)
        self._forms: dict[ast.AST, Any] = {}
        self.form = self.plain(node, Scope())

    def of(self, node: ast.AST, without: Collection[str] = ()) -> Any:
        """Return the form of a node, ``without`` some of its fields; of one that has none, that of what is in it."""
        if node not in self._forms:
            return type(node).__name__, *map(self.of, ast.iter_child_nodes(node))
        form = self._forms[node]
        return tuple(part for part in form if not (isinstance(part, tuple) and part and part[0] in without))

    def plain(self, node: Any, scope: Scope) -> Any:
        if isinstance(node, list):
            children = (child for child in node if not (is_text(child) or isinstance(child, DECLARING)))
            return tuple(form for form in (self.plain(child, scope) for child in children) if form != NOTHING)
        if not isinstance(node, ast.AST):
            return repr(node)
        self._forms[node] = form = getattr(self, f"visit_{type(node).__name__}", self._fields)(node, scope)
        return form

    def _fields(self, node: ast.AST, scope: Scope, **instead: Any) -> Any:
        pairs = ((name, value) for name, value in ast.iter_fields(node) if name != "kind")
        fields = [(name, instead[name] if name in instead else self.plain(value, scope)) for name, value in pairs]
        return type(node).__name__, *(pair for pair in fields if pair[1] not in ("None", ()))

    def visit_Name(self, node: ast.Name, scope: Scope) -> Any:
        name = node.id
        is_attribute = name in scope.attributes
        if not isinstance(node.ctx, ast.Load):
            return "Name", self._stands_for(name, scope)
        if is_attribute or name in scope.local:
            # A class may read the module's name before its own is bound, and a function what it imports.
            outside = name in (self._names if is_attribute else self._imports)
            return "Name", self._stands_for(name, scope), *(self._gap(name) if outside else ())
        return self._gap(name) if name in self._names else ("Name", name)

    def visit_Attribute(self, node: ast.Attribute, scope: Scope) -> Any:
        chain = chain_of(node)
        first = chain.partition(".")[0]
        if first not in self._names or first in scope.local or first in scope.attributes:
            return self._fields(node, scope)
        return *self._gap(chain), type(node.ctx).__name__

    def _gap(self, chain: str) -> tuple[str, ...]:
        self.gaps.append(chain)
        first, *attributes = chain.split(".")
        if self._meanings is not None:
            return GAP, self._meanings.get(first, first), *attributes
        return GAP, *([first] if self._names_count else []), *attributes

    def _stands_for(self, name: str, scope: Scope) -> Any:
        if name in scope.attributes:
            return name
        if name in scope.local:
            return (scope.local[name], name) if self._locals_count else scope.local[name]
        return GAP if name in self._own else name

    def _binding(self, node: ast.AST, scope: Scope) -> Any:
        where = BINDING[type(node)]
        name = getattr(node, where)
        return self._fields(node, scope, **{where: self._stands_for(name, scope) if name else "None"})

    visit_ExceptHandler = visit_MatchAs = visit_MatchStar = visit_MatchMapping = _binding

    def visit_ClassDef(self, node: ast.ClassDef, scope: Scope) -> Any:
        inner = Scope(scope.local, frozenset(name for child in node.body for name in bound_names(child)))
        return self._fields(node, scope, name=self._stands_for(node.name, scope), body=self.plain(node.body, inner))

    def _function(self, node: Any, scope: Scope) -> Any:
        body = node.body if isinstance(node.body, list) else [node.body]
        declared = [child for child in chain(*map(_in_scope, body)) if isinstance(child, ast.Global | ast.Nonlocal)]
        outer = {name for child in declared for name in child.names}
        parameters = (child.arg for child in ast.iter_child_nodes(node.args) if isinstance(child, ast.arg))
        bound = [*parameters, *(name for name in chain(*map(bound_names, body)) if name not in outer)]
        globals_ = {name for child in declared if isinstance(child, ast.Global) for name in child.names}
        instead = {"body": self.plain(node.body, self._within(scope, bound, globals_))}
        if not isinstance(node, ast.Lambda):
            instead["name"] = self._stands_for(node.name, scope)
        return self._fields(node, scope, **instead)

    visit_FunctionDef = visit_AsyncFunctionDef = visit_Lambda = _function

    def visit_arguments(self, node: ast.arguments, scope: Scope) -> Any:
        def unnamed(argument: ast.arg | None) -> Any:
            return (GAP, self.plain(argument.annotation, scope)) if argument else "None"

        positional = tuple(map(unnamed, node.posonlyargs))
        return self._fields(node, scope, posonlyargs=positional, vararg=unnamed(node.vararg), kwarg=unnamed(node.kwarg))

    def _comprehension(self, node: Any, scope: Scope) -> Any:
        targets = (child for clause in node.generators for child in ast.walk(clause.target))
        inner = self._within(scope, [child.id for child in targets if _is_bound(child)])
        first, *clauses = node.generators
        parts = [first.target, first.ifs, clauses, [getattr(node, name, None) for name in ("elt", "key", "value")]]
        return type(node).__name__, self.plain(first.iter, scope), *(self.plain(piece, inner) for piece in parts)

    visit_ListComp = visit_SetComp = visit_DictComp = visit_GeneratorExp = _comprehension

    def _within(self, scope: Scope, bound: Iterable[str], without: Collection[str] = ()) -> Scope:
        local = {name: number for name, number in scope.local.items() if name not in without}
        for name in dict.fromkeys(bound):
            local[name] = self._local_count
            self._local_count += 1
        return Scope(local)

    def visit_Raise(self, node: ast.Raise, scope: Scope) -> Any:
        self._is_silent = isinstance(node.exc, ast.Call)
        raised = self.plain(node.exc, scope)
        self._is_silent = False
        return "Raise", raised, self.plain(node.cause, scope)

    def visit_Assert(self, node: ast.Assert, scope: Scope) -> Any:
        return "Assert", self.plain(node.test, scope)

    def visit_Constant(self, node: ast.Constant, scope: Scope) -> Any:
        return "Constant", repr("" if self._is_silent and isinstance(node.value, str) else node.value)

    def visit_JoinedStr(self, node: ast.JoinedStr, scope: Scope) -> Any:
        if self._is_silent:
            return "Constant", repr("")
        # Python 3.12 and later put an empty text behind a nested format specification.
        return "JoinedStr", self.plain([value for value in node.values if getattr(value, "value", None) != ""], scope)

    def visit_Expr(self, node: ast.Expr, scope: Scope) -> Any:
        form = self.plain(node.value, scope)
        return form if form == NOTHING else ("Expr", form)

    def visit_Call(self, node: ast.Call, scope: Scope) -> Any:
        called, keywords = self._called(node.func, scope), node.keywords
        if called in SAID and all(self._is_shown(keyword, scope) for keyword in keywords):
            pieces = chain(*(arg.values if isinstance(arg, ast.JoinedStr) else [arg] for arg in node.args))
            form = self.plain([piece for piece in pieces if not _is_string(piece)], scope)
            return ("Said", called, form) if form else NOTHING
        if called in ("tqdm.tqdm", "tqdm.auto.tqdm"):  # what a bar goes through counts, and not how it shows that
            through = [keyword for keyword in keywords if keyword.arg in (None, "iterable")]
            return self._fields(node, scope, args=self.plain(node.args[:1], scope), keywords=self.plain(through, scope))
        if called.rpartition(".")[2] in PARSERS:
            keywords = [keyword for keyword in keywords if keyword.arg not in HELP]
            return self._fields(node, scope, keywords=self.plain(keywords, scope))
        return self._fields(node, scope)

    def _called(self, function: ast.expr, scope: Scope) -> str:
        """Name what is called as it is known elsewhere; empty where that is not so."""
        first, dot, attributes = chain_of(function).partition(".")
        if first in scope.local or first in scope.attributes:
            return dot + attributes
        if first in self._imports:
            return self._imports[first] + dot + attributes
        return first + dot + attributes if dot or first not in self._names else ""

    def _is_shown(self, keyword: ast.keyword, scope: Scope) -> bool:
        """Tell whether what is printed so is lost: not with a file of one's own, nor with what is not known."""
        if keyword.arg == "file":
            return self._called(keyword.value, scope) in ("sys.stderr", "sys.stdout")
        return keyword.arg is not None


def _is_bound(node: ast.AST) -> TypeGuard[ast.Name]:
    return isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)


def _is_string(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def _reads_locals(node: ast.AST) -> bool:
    """Tell whether a node may find what its function binds by name, which then counts."""
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
        return False
    return node.func.id in ("locals", "eval", "exec") or (node.func.id in ("vars", "dir") and not node.args)


def _named_assets(nodes: Iterable[ast.AST]) -> tuple[str, ...]:
    texts = (node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, str))
    return tuple(text for text in texts if text.startswith(ASSETS) and "\n" not in text)


def digest_of(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
