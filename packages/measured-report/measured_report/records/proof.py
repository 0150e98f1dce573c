"""Proof: what differs between two codes of a section, and what of that two runs of it do not settle.

Where the runs gave the same, what they executed of the definitions that differ makes no difference. The rest has to
stand in the other code too, in such a place, and to mean the same there. So have numbers, texts and named values, which
a run may read and not use.
"""

import ast
import copy
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path, PurePosixPath
from types import CodeType
from typing import Any

from measured_report.files.groups import grouped
from measured_report.records.code import Graph, Node, roots_of
from measured_report.records.syntax import (
    EFFECTS,
    Canonical,
    Reader,
    bound_names,
    chain_of,
    is_text,
)

Text = tuple[str, Any]  # of a piece, by the names in it and by their numbers
Place = tuple[Any, ...]  # file, and line, last line, column and last column, as instructions have them
BODIES = ("body", "orelse", "finalbody", "handlers", "cases")
HEADLESS = ("name", "returns", *BODIES)  # of a definition neither its name counts nor what type it returns
HEADED = (ast.stmt, ast.ExceptHandler, ast.match_case)
SILENT = (ast.Raise, ast.Assert, ast.JoinedStr)  # their texts are only printed
UNEXECUTED, TIMED = "no run executes", "what is timed has changed"
TYPES = ("annotation", "returns")


@dataclass(frozen=True)
class Piece:
    """Hold a piece of a definition, and what decides whether it is executed."""

    definition: Node
    syntax: ast.AST
    meanings: Mapping[str, str]  # by name of what both codes have: what it is called does not count
    forms: Canonical  # in which what a function binds is numbered: what it is called does not count either
    context: tuple[Text, ...] = ()  # what heads the statement around it, its list there, and the statement before

    @cached_property
    def texts(self) -> tuple[Any, Any]:
        names, forms = zip(self.text(self.syntax), *self.context, strict=True)
        return names, forms

    def text(self, syntax: ast.AST) -> Text:
        return self.dump(syntax), self.forms.of(syntax)

    def dump(self, syntax: ast.AST) -> str:
        return re.sub(r"Name\(id='(\w+)'", lambda name: self.meanings.get(name[1], name[0]), ast.dump(syntax))

    def children(self) -> Iterator["Piece"]:
        head = self.context[:1]
        if isinstance(self.syntax, HEADED):
            head = ((self.dump(_bare(self.syntax)), self.forms.of(self.syntax, HEADLESS)),)
        for name, value in ast.iter_fields(self.syntax):
            before: Text = ("", "")
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST) and name != "msg":  # an assertion that held has not read its message
                    yield replace(self, syntax=child, context=(*head, (name, name), before) if name in BODIES else head)
                    before = before if is_text(child) else self.text(child)

    def all(self) -> Iterator["Piece"]:
        yield self
        for child in self.children():
            yield from child.all()


class Code:
    """Reads what a section runs in the tree ``root``, and knows what of that differs from another code."""

    def __init__(self, section: str, root: Path):
        self.graph = Graph(roots_of(root))
        self.reached = self.graph.reached(f"experiments.{section}.measure")
        self.own_digests = {self.graph.digest(node, 0) for node in self.reached}
        self.common: Set[str] = frozenset()  # of these, what another code has as well
        self.changed: list[Piece] = []

    def compare(self, other: "Code") -> None:
        """Find the definitions that are not in ``other``, or name what is not there."""
        digests, self.common = set(other.reached.values()), self.own_digests & other.own_digests
        nodes = sorted(node for node, digest in self.reached.items() if digest not in digests)
        trees = {file: ast.parse(Path(file).read_bytes()) for file, _ in nodes}
        packages = {file: PurePosixPath(self.graph.name_of(file)).parts[:-1] for file in trees}
        readers = {file: Reader(tree, packages[file]) for file, tree in trees.items()}
        pairs = ((node, tree) for node in nodes for tree in trees[node[0]].body)
        for node, tree in pairs:
            if node[1] in (list(bound_names(tree)) or [EFFECTS]):
                meanings = self._shared_meanings(node)
                self.changed.append(Piece(node, tree, meanings, readers[node[0]].canonical(tree, meanings)))

    def _shared_meanings(self, node: Node) -> dict[str, str]:
        """Digest by name what stands in a definition and both codes have."""
        pairs = ((definition, name) for definition in self.graph.definitions(node) for name in definition.names)
        meanings = {name: self.graph.meaning(node[0], definition, name) for definition, name in pairs}
        nodes_by_name = {name: nodes for name, nodes in meanings.items() if isinstance(nodes, list) and "." not in name}
        digests = {name: {self.graph.digest(target, 0) for target in nodes} for name, nodes in nodes_by_name.items()}
        return {name: " ".join(sorted(of_name)) for name, of_name in digests.items() if of_name <= self.common}

    @property
    def spans(self) -> dict[str, list[tuple[int, int]]]:
        """Return the first and last lines of what changed, by file."""
        spans: dict[str, list[tuple[int, int]]] = {}
        for piece in self.changed:
            lines = [node.lineno for node in ast.walk(piece.syntax) if hasattr(node, "lineno")]
            spans.setdefault(piece.definition[0], []).append((min(lines), piece.syntax.end_lineno))  # type: ignore
        return spans

    def unexecuted(self, other: "Code", executed: Sequence[Set[Place]]) -> Iterator[str]:
        """Say what changed, has instructions of which none was executed, and is not in ``other`` as well."""
        others = (inner for outer in other.changed for inner in outer.all())
        pieces_by_text = grouped((text, piece) for piece in others for text in piece.texts)
        compiled = {file: {*_places(compile(Path(file).read_bytes(), file, "exec"))} for file in self.spans}
        waiting = list(self.changed)
        while waiting:
            piece = waiting.pop()
            places = {place for place in compiled[piece.definition[0]] if _is_within(place, piece)}
            if any(map(places.intersection, executed)):
                waiting += piece.children()
            elif places:
                twins = (twin for text in piece.texts for twin in pieces_by_text.get(text, ()))
                if not any(self._named(piece) == other._named(twin) for twin in twins):
                    yield f"{UNEXECUTED} {self._name(piece)}"

    def unread(self, other: "Code", *, is_old: bool = False) -> Iterator[str]:
        """Say which data are not in ``other`` as well; of old code it is no loss that some stand in fewer places."""
        excerpts = dict(self._data())
        mine, theirs = (Counter(text for text, _ in code._data()) for code in (self, other))
        for text in sorted((set(mine) - set(theirs)) if is_old else (mine - theirs).elements()):
            yield f"a run may read and not use {excerpts[text]:.80}"

    def timed(self, executed: Set[Place]) -> Iterator[str]:
        """Name what is in no other code and was ``executed`` while times were measured."""
        for piece in self.changed:
            is_other = self.graph.digest(piece.definition, 0) not in self.common
            if is_other and any(_is_within(place, piece) for place in executed):
                yield f"{TIMED}: {self._name(piece)}"

    def _named(self, piece: Piece, nodes: Iterable[ast.AST] | None = None) -> list[str]:
        """Say what each name of a piece, or of ``nodes`` in it, is: a digest of what both codes have, or its name."""
        definitions = {name: binding for binding in self.graph.definitions(piece.definition) for name in binding.names}
        meanings = []
        for name in filter(definitions.__contains__, map(chain_of, nodes or ast.walk(piece.syntax))):
            meaning = self.graph.meaning(piece.definition[0], definitions[name], name)
            nodes_meant = [] if isinstance(meaning, str) else meaning
            digests = [self.graph.digest(node, 0) for node in nodes_meant]
            called = [f"{self.graph.name_of(file)} {name}" for file, name in nodes_meant]
            names = [digest if digest in self.common else name for digest, name in zip(digests, called, strict=True)]
            meanings.append(" ".join(names) if nodes_meant else str(meaning))
        return meanings

    def _data(self) -> Iterator[tuple[str, str]]:
        """Yield what counts, and how it is said: numbers, texts, and statements that name definitions as values."""
        for piece in self.changed:
            yield from ((text, text) for text in _literals(piece.syntax))
            headed = (node for node in ast.walk(piece.syntax) if isinstance(node, HEADED))
            for head in (_bare(node) for node in headed if not isinstance(node, SILENT)):
                # What is called is executed, and what a type is called does nothing.
                called = [node.func for node in ast.walk(head) if isinstance(node, ast.Call)]
                types = [getattr(node, name, None) for node in ast.walk(head) for name in TYPES]
                aside = {*called, *(below for node in types if node for below in ast.walk(node))}
                for part, nodes in _parts(head).items():
                    values = self._named(piece, (node for node in nodes if node not in aside))
                    if values := [value for value in values if value in self.common]:
                        yield "\n".join([*map(piece.dump, part), *values]), ast.unparse(head)

    def _name(self, piece: Piece) -> str:
        line = getattr(piece.syntax, "lineno", 1)
        return f"{self.graph.name_of(piece.definition[0])}:{line}: {ast.unparse(piece.syntax).splitlines()[0]:.80}"


def _bare(node: ast.AST) -> ast.AST:
    """Return a statement without those in it, without its name, and without what type it returns."""
    bare = copy.copy(node)
    for name in (name for name in HEADLESS if hasattr(bare, name)):
        setattr(bare, name, [] if name in BODIES else "" if name == "name" else None)
    return bare


def _parts(head: ast.AST) -> dict[tuple[ast.AST, ...], list[ast.AST]]:
    """Return by what is passed to a call, by what is gone through, and by the rest the nodes that are in no smaller."""
    parts: dict[ast.AST, tuple[ast.AST, ...]] = dict.fromkeys(ast.walk(head), (head,))
    for node in ast.walk(head):  # what is in another comes after it
        if isinstance(node, ast.Call):
            for place, argument in enumerate((*node.args, *node.keywords)):
                parts |= dict.fromkeys(ast.walk(argument), (node.func, ast.Constant(place), argument))
        elif isinstance(node, ast.comprehension):
            parts |= dict.fromkeys(ast.walk(node.iter), (node.iter,))
    return grouped((part, node) for node, part in parts.items())


def _literals(node: ast.AST, is_top: bool = True) -> Iterator[str]:
    """Yield the numbers and texts below a node, and what is made of these alone: displays, constants and fields."""
    if _is_number(node):
        yield repr(node.value)  # type: ignore[attr-defined]
    elif not isinstance(node, SILENT) and not is_text(node):
        displays = (ast.Dict, ast.List, ast.Tuple, ast.Set, *((ast.Assign, ast.AnnAssign) if is_top else ()))
        if isinstance(node, displays):
            with suppress(ValueError):
                ast.literal_eval(getattr(node, "value", node))
                yield ast.unparse(node)
        if isinstance(node, ast.arguments):
            pairs = [*zip([*node.posonlyargs, *node.args][::-1], node.defaults[::-1], strict=False)]
            pairs += [(arg, value) for arg, value in zip(node.kwonlyargs, node.kw_defaults, strict=True) if value]
            yield from (f"{arg.arg}={ast.unparse(default)}" for arg, default in pairs if _is_number(default))
        for name, value in ast.iter_fields(node):
            if name in TYPES or (name == "slice" and isinstance(getattr(value, "value", ""), int)):
                continue  # which place of a few is no number that was chosen
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST):
                    yield from _literals(child, is_top and not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef))


def _is_number(node: ast.AST | None) -> bool:
    """Tell whether a node is a number or a text."""
    value = node.value if isinstance(node, ast.Constant) else None
    return isinstance(value, str | int | float) and not isinstance(value, bool)


def _places(code: CodeType) -> Iterator[Place]:
    yield from ((code.co_filename, *position) for position in code.co_positions())
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _places(constant)


def _is_within(place: Place, piece: Piece) -> bool:
    node: Any = piece.syntax
    if not hasattr(node, "lineno"):  # as the arguments of a function
        return any(_is_within(place, replace(piece, syntax=child)) for child in ast.iter_child_nodes(node))
    file, first, last, column, last_column = place
    if file != piece.definition[0] or None in place:
        return False
    start, end = (node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset)
    return start <= (first, column) and (last, last_column) <= end
