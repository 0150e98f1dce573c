"""Code: the files that a module imports, and their syntax. They are read, never run."""

import ast
import hashlib
import json
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from itertools import accumulate
from pathlib import Path, PurePosixPath
from typing import Any

from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError

GENERATOR = "measured_report"  # the package that passes calls on, and changes none of the rows that they return
HERE = str(Path(__file__).resolve().parents[2])
ASSETS = (
    "assets/",
    "experiments/",
    "packages/",
)  # folders of files that a program reads or starts by their path
WORKED_OUT = ...  # stands for a value that a module computes at its top level
LAYOUT = (
    "ctx",
    "kind",
    "type_comment",
)  # fields of a syntax tree that follow from the others, or say nothing


@dataclass(frozen=True)
class Source:
    """Describes one file."""

    digest: str  # of its syntax tree, without comments, docstrings and formatting
    modules: tuple[
        str, ...
    ]  # names in its import statements, some of which are modules
    assets: tuple[str, ...]  # texts that may be paths of assets
    top: Mapping[
        str, Any
    ]  # names at its top level: constants, and the argument count of a function


class Code:
    """Holds the files of a project. Each is read once, so a later state of the code needs a new object."""

    def __init__(self, *roots: Path):
        folders = [
            folder
            for root in roots
            for folder in (root, *sorted((root / "packages").glob("*")))
        ]
        self.roots = tuple(dict.fromkeys([*map(str, folders), HERE]))
        self.source = cache(self._source)
        self.module = cache(self._module)
        self.imported = cache(self._imported)
        self.closure = cache(self._closure)
        self.digest = cache(self._digest)
        self._roots_with = cache(self._roots_that_have)

    def name_of(self, path: str) -> str:
        """Name a file below the innermost of the folders that it lies in."""
        return path[
            max(len(root) for root in self.roots if path.startswith(f"{root}/")) + 1 :
        ]

    def _source(self, path: str) -> Source:
        return read_source(Path(path), self.name_of(path))

    def _module(self, name: str) -> str:
        """Return the file of a module; empty if it is not one of this project."""
        stem = name.replace(".", "/")
        stems = [f"{root}/{stem}" for root in self._roots_with(name.partition(".")[0])]
        files = (
            file for stem in stems for file in (f"{stem}/__init__.py", f"{stem}.py")
        )
        return next(
            filter(os.path.isfile, files), ""
        )  # with Path this would take ten times as long

    def _roots_that_have(self, package: str) -> list[str]:
        # Other packages that are installed beside the generator do not belong to the project.
        roots = [root for root in self.roots if root != HERE or package == GENERATOR]
        paths = {root: Path(root, package) for root in roots}
        return [
            root
            for root, path in paths.items()
            if path.is_dir() or path.with_suffix(".py").is_file()
        ]

    def _imported(self, path: str) -> list[str]:
        """List the files of the modules, and of their packages, that a file may import."""
        dotted = (
            accumulate(name.split("."), "{}.{}".format)
            for name in self.source(path).modules
        )
        names = sorted({prefix for prefixes in dotted for prefix in prefixes})
        return list(filter(None, map(self.module, names)))

    def _closure(self, start: str, without: str = "") -> list[str]:
        """List a file and all files that it imports, directly or not, except those of the package ``without``."""
        closure = dict.fromkeys([start])
        waiting = [start]
        while waiting:
            new = [file for file in self.imported(waiting.pop()) if file not in closure]
            if without:
                new = [
                    file
                    for file in new
                    if not self.name_of(file).startswith(f"{without}/")
                ]
            closure |= dict.fromkeys(new)
            waiting += new
        return list(closure)

    def _digest(self, path: Path) -> str:
        return hashlib.sha256(path.read_bytes()).hexdigest()


_known: dict[str, Source] = {}  # by a digest of the text and of the package of a file


def read_source(path: Path, name: str) -> Source:
    """Return the facts of a file, which messages call ``name``; ReportError if it cannot be read."""
    package = PurePosixPath(name).parts[:-1]
    try:
        text = path.read_bytes()
        key = hashlib.sha256(f"{package}\0".encode() + text).hexdigest()
        if key not in _known:
            _known[key] = _source_of(ast.parse(text, filename=name), package)
        return _known[key]
    except (OSError, SyntaxError, ValueError) as error:
        raise ReportError(
            f"cannot read {name}: {' '.join(str(error).split())}"
        ) from None


@contextmanager
def cached_sources() -> Iterator[None]:
    """Keep what was read of files from one process to the next, because parsing all of them takes seconds."""
    store = Cache(Path(HERE))
    made_by = sys.version, hashlib.sha256(Path(__file__).read_bytes()).hexdigest()
    _known.update(store.get("sources", made_by) or {})
    count_before = len(_known)
    try:
        yield
    finally:
        if len(_known) > count_before:
            store.put(
                "sources", made_by, dict(list(_known.items())[-2000:])
            )  # the newest


def _source_of(tree: ast.Module, package: tuple[str, ...]) -> Source:
    nodes = list(ast.walk(tree))
    modules = tuple(
        dict.fromkeys(
            path for node in nodes for _, path in imported_names(node, package)
        )
    )
    texts = (
        node.value
        for node in nodes
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    )
    assets = tuple(
        text for text in texts if text.startswith(ASSETS) and "\n" not in text
    )
    return Source(digest_of(plain(tree)), modules, assets, dict(_top(tree)))


def imported_names(
    node: ast.AST, package: tuple[str, ...]
) -> Iterator[tuple[str, str]]:
    """Yield the names that an import statement binds, and the dotted path of each."""
    if isinstance(node, ast.Import):
        for alias in node.names:
            yield alias.asname or alias.name.partition(".")[0], alias.name
    elif isinstance(node, ast.ImportFrom):
        start = package[: len(package) - node.level + 1] if node.level else ()
        module = ".".join([*start, *filter(None, [node.module])])
        for alias in node.names:
            path = f"{module}.{alias.name}".lstrip(
                "."
            )  # a module in no package may import one beside it
            yield alias.asname or alias.name, path


def _top(tree: ast.Module) -> Iterator[tuple[str, Any]]:
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, len(node.args.args)
        elif isinstance(node, ast.Assign):
            value: Any = WORKED_OUT
            with suppress(ValueError):
                value = ast.literal_eval(node.value)
            yield from (
                (target.id, value)
                for target in node.targets
                if isinstance(target, ast.Name)
            )


def plain(node: Any) -> Any:
    """Return a syntax tree as lists and texts that are the same in every Python, without docstrings and layout."""
    if isinstance(node, list):
        return [plain(child) for child in node if not is_docstring(child)]
    if not isinstance(node, ast.AST):
        return ascii(node)
    fields = {
        name: value for name, value in ast.iter_fields(node) if name not in LAYOUT
    }
    if isinstance(
        node, ast.JoinedStr
    ):  # Python 3.12 and later end a nested format specification with an empty text
        fields["values"] = [
            value for value in node.values if getattr(value, "value", None) != ""
        ]
    return [
        type(node).__name__,
        {
            name: plain(value)
            for name, value in fields.items()
            if value not in (None, [])
        },
    ]


def is_docstring(node: Any) -> bool:
    """Return whether a statement is a text alone."""
    value = node.value if isinstance(node, ast.Expr) else None
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


def digest_of(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
