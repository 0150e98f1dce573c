"""Code: what the definitions of a program do, found by reading its files and never by running them.

A function, class or constant of a module has the digest of its syntax tree, with the digests of what its names mean in
the place of these. So it stays the same when it, or what it names, moves to another file or gets another name.
"""

import ast
import hashlib
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache, cached_property, partial
from itertools import accumulate
from pathlib import Path, PurePosixPath
from typing import Any, TypeVar

from measured_report.files import root
from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.records import syntax
from measured_report.records.syntax import (
    EFFECTS,
    Definition,
    Definitions,
    Reader,
    Source,
    digest_of,
)

CARRIED = "measured_report"  # the package that carries calls, and changes nothing of what they return
ROUNDS = 3  # so many steps from a definition what its names mean is part of its digest
Node = tuple[str, str]
Some = TypeVar("Some")

_contents: dict[str, Any] = {}  # what was read of modules, by the digest of name and text, wherever they lie
SOURCES = "sources"


class Files:
    def __init__(self) -> None:
        self.source, self.graph = cache(partial(_read, "source")), cache(Graph)
        self.versions: dict[str, str] = {}  # of installed packages
        self.root = root.ROOT


_files: ContextVar[Files | None] = ContextVar("files", default=None)


@contextmanager
def unchanged_files() -> Iterator[None]:
    """Look at each source once: within this no source changes and nothing is installed."""
    token = _files.set(files())
    try:
        yield
    finally:
        _files.reset(token)


def files() -> Files:
    current = _files.get()
    return current if current and current.root == root.ROOT else Files()  # another report has other packages


@contextmanager
def cached_sources() -> Iterator[None]:
    """Know what sources say from the processes before, of any project, since parsing all of them takes seconds."""
    store = Cache(Path(HERE))
    made_by = sys.version, hashlib.sha256(Path(syntax.__file__).read_bytes()).hexdigest()
    _contents.update(store.get(SOURCES, made_by) or {})
    before = len(_contents)
    try:
        yield
    finally:
        if len(_contents) > before:
            # The newest: those of texts that are no more need not be kept for ever.
            store.put(SOURCES, made_by, dict(list(_contents.items())[-2000:]))


_reader = cache(lambda text, name: Reader(ast.parse(text, filename=name), PurePosixPath(name).parts[:-1]))
HERE = str(Path(__file__).resolve().parents[2])


def cached_method(method: Callable[..., Some]) -> "cached_property[Callable[..., Some]]":
    """Keep what a method returns of the same arguments, while its object lives: a cache of the class has no end."""
    return cached_property(lambda owner: cache(partial(method, owner)))


class Graph:
    """Finds the definitions of the modules below some folders, and what their names mean."""

    def __init__(self, roots: tuple[str, ...]):
        self.roots = roots

    def name_of(self, path: str) -> str:
        """Name a file below the innermost of the folders that it lies in."""
        return path[max(len(root) for root in self.roots if path.startswith(f"{root}/")) + 1 :]

    @cached_method
    def source(self, path: str) -> Source:
        return _read("source", Path(path), self.name_of(path))

    @cached_method
    def defined(self, path: str) -> Definitions:
        return _read("definitions", Path(path), self.name_of(path))

    @cached_method
    def imported(self, path: str) -> list[str]:
        """Name the files that the source at ``path`` may import."""
        named = {prefix for name in self.source(path).modules for prefix in accumulate(name.split("."), "{}.{}".format)}
        return list(filter(None, map(self.module, sorted(named))))

    @cached_method
    def module(self, name: str) -> str:
        """Name the file of a module; nothing where it is none of this project."""
        # Where this program is installed lie other packages beside it, which are none of the project's.
        roots = [root for root in self.roots if root != HERE or name.partition(".")[0] == CARRIED]
        stems = (f"{root}/{name.replace('.', '/')}" for root in roots)
        files = (file for stem in stems for file in (f"{stem}/__init__.py", f"{stem}.py"))
        return next(filter(os.path.isfile, files), "")  # a Path of each would take ten times as long

    def closure(self, start: str, without: str = "") -> list[str]:
        """Name a file and all that it may import, directly or not; ``without`` is a package that is left out."""
        closure, waiting = dict.fromkeys([start]), [start]
        while waiting:
            new = [file for file in self.imported(waiting.pop()) if file not in closure]
            new = [file for file in new if not (without and self.name_of(file).startswith(f"{without}/"))]
            closure |= dict.fromkeys(new)
            waiting += new
        return list(closure)

    @cached_method
    def reached(self, name: str) -> dict[Node, str]:
        """Digest what may be run when what has this dotted name is, and what importing its files does."""
        if isinstance(nodes := self.resolve(name), str):
            raise ReportError(f"there is no {name}")
        loaded = {file for first in {file for file, _ in nodes} for file in self.closure(first, CARRIED)}
        waiting = [*nodes, *(node for file in loaded for node in self._effects(file))]
        reached: set[Node] = set()
        while waiting:
            node = waiting.pop()
            if node not in reached:
                reached.add(node)
                waiting += (node for meaning in self.meanings(node) if isinstance(meaning, list) for node in meaning)
        return {node: self.digest(node) for node in reached if self.definitions(node)}

    @cached_method
    def summary(self, name: str) -> tuple[str, dict[str, str], list[str]]:
        """Digest what may be run; with the digests by file of what lies there, and the assets that it names."""
        reached = self.reached(name)
        by_file = grouped((self.name_of(file), digest) for (file, _), digest in reached.items())
        code = {file: digest_of(sorted(set(digests))) for file, digests in by_file.items()}
        named = {asset for node in reached for definition in self.definitions(node) for asset in definition.assets}
        return digest_of(sorted({*reached.values()})), code, sorted(named)

    def definitions(self, node: Node) -> tuple[Definition, ...]:
        return self.defined(node[0]).get(node[1], ())

    def _effects(self, file: str) -> Iterator[Node]:
        """Find what is done when a file is imported: a decorator of this project may note what it is put on."""
        yield file, EFFECTS
        for name, definitions in self.defined(file).items():
            pairs = ((definition, decorator) for definition in definitions for decorator in definition.decorators)
            if any(isinstance(self.meaning(file, *pair), list) for pair in pairs):
                yield file, name

    @cached_method
    def digest(self, node: Node, rounds: int = ROUNDS) -> str:
        """Digest what defines a name, and what the names in it mean."""
        meanings = self.meanings(node) if rounds else []
        forms = [ref if isinstance(ref, str) else [self.digest(node, rounds - 1) for node in ref] for ref in meanings]
        return digest_of([[definition.tree for definition in self.definitions(node)], forms])

    @cached_method
    def meanings(self, node: Node) -> list[list[Node] | str]:
        """Find what the names mean that stand in what defines a name, in order."""
        return [self.meaning(node[0], binding, name) for binding in self.definitions(node) for name in binding.names]

    def meaning(self, file: str, definition: Definition, name: str) -> list[Node] | str:
        first, _, attributes = name.partition(".")
        if first in self.defined(file) and first not in definition.imports:
            return [(file, first)]
        imported = definition.imports.get(first) or self.source(file).imports[first]
        return self.resolve(f"{imported}.{attributes}".rstrip("."))

    def resolve(self, name: str) -> list[Node] | str:
        """Find what of this project a dotted name stands for, or what it is called elsewhere."""
        parts = name.split(".")
        if parts[0] == CARRIED:
            return CARRIED
        for end in range(len(parts), 0, -1):
            if file := self.module(".".join(parts[:end])):
                imports, (first, *tail) = self.source(file).imports, parts[end:] or [""]
                if first and first in self.defined(file):
                    return [(file, first)]
                if first in imports:
                    return self.resolve(".".join([imports[first], *tail]))
                return [(file, name) for name in self.defined(file)]  # whoever has a module may ask it for anything
        return name


def roots_of(root: Path) -> tuple[str, ...]:
    """Name the folders that a project's modules are below: its own, its packages', and those of this program."""
    return tuple(dict.fromkeys(map(str, [root, *sorted((root / "packages").glob("*")), HERE])))


def _read(kind: str, path: Path, name: str) -> Any:
    """Read ``source`` or ``definitions`` of a module; ReportError, with its ``name``, where it can't be read."""
    try:
        text = path.read_bytes()
        key = hashlib.sha256(f"{kind}\0{name}\0".encode() + text).hexdigest()
        if key not in _contents:
            _contents[key] = getattr(_reader(text, name), kind)()
        return _contents[key]
    except (OSError, SyntaxError, ValueError) as error:
        raise ReportError(f"cannot read {name}: {' '.join(str(error).split())}") from None
