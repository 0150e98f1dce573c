"""Find the files that a module imports and parse them without running them."""

import ast
import hashlib
import json
import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from itertools import accumulate, chain
from pathlib import Path, PurePosixPath
from typing import Any

from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError
from measured_report.files.units import TYPED

# Identities leave out the files of this package, because it only passes calls on and
# does not change the rows that they return.
GENERATOR = "measured_report"
HERE = str(Path(__file__).resolve().parents[2])
ASSETS = ("assets/", "experiments/", "packages/")
"""Folders of files that a program opens or starts by path."""
DRAWING = (
    *("axhline", "axvline"),
    *("bar", "barh", "errorbar", "fill_between", "hist", "loglog", "pie", "plot"),
    *("scatter", "semilogx", "semilogy", "stairs", "stem", "step"),
)
"""Methods of Matplotlib and pandas that draw their arguments."""
WRITING = ("annotate", "set", "set_title", "suptitle", "text")
"""Methods of Matplotlib that write their arguments."""
UNREPEATABLE = re.compile(
    r"""
    (numpy\.)?random\.\w+ | (secrets|uuid)\.\w+
    | numpy\.(fromfile|genfromtxt|load|loadtxt) | pandas\.read_\w+ | csv\.\w*[rR]eader
    | time\.(time|perf_counter|monotonic)(_ns)? | datetime\.\w+\.(now|today|utcnow)
    """,
    re.VERBOSE,
)
"""Functions whose results are not from records: random numbers, the time and data."""
SEEDED = ("default_rng", "Random", "RandomState", "SeedSequence")
"""Generators of random numbers that repeat if they are called with a seed."""
LISTS = (ast.Dict, ast.List, ast.Tuple)
COMPUTED = ...  # stands for a value that is computed at import
LAYOUT = ("ctx", "kind", "type_comment")
"""Fields of a syntax tree that follow from others or have no meaning."""


@dataclass(frozen=True)
class Source:
    """The facts about one file."""

    digest: str  # of its syntax tree, without comments, docstrings and layout
    modules: tuple[str, ...]  # names in its import statements; some of them are modules
    assets: tuple[str, ...]  # strings that may be paths of assets
    top: Mapping[str, Any]  # constants by name, and argument counts of functions
    typed: tuple[int, ...]  # lines that draw numbers which are typed in the code
    random: tuple[int, ...]  # lines that call functions of UNREPEATABLE


class Code:
    """Give access to the files of a project.

    Each file is read once, so a later state of the code needs a new object.
    """

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
        """Return the path of a file relative to the innermost root that contains it."""
        return path[
            max(len(root) for root in self.roots if path.startswith(f"{root}/")) + 1 :
        ]

    def _source(self, path: str) -> Source:
        return read_source(Path(path), self.name_of(path))

    def _module(self, name: str) -> str:
        """Return the file of a module in this project, or an empty string."""
        stem = name.replace(".", "/")
        stems = [f"{root}/{stem}" for root in self._roots_with(name.partition(".")[0])]
        files = (
            file for stem in stems for file in (f"{stem}/__init__.py", f"{stem}.py")
        )
        # os.path.isfile is used, because Path.is_file would take ten times as long.
        return next(filter(os.path.isfile, files), "")

    def _roots_that_have(self, package: str) -> list[str]:
        # Packages that are installed beside the generator do not belong to the project.
        roots = [root for root in self.roots if root != HERE or package == GENERATOR]
        paths = {root: Path(root, package) for root in roots}
        return [
            root
            for root, path in paths.items()
            if path.is_dir() or path.with_suffix(".py").is_file()
        ]

    def _imported(self, path: str) -> list[str]:
        """Return the files of all modules and packages that a file may import."""
        dotted = (
            accumulate(name.split("."), "{}.{}".format)
            for name in self.source(path).modules
        )
        names = sorted({prefix for prefixes in dotted for prefix in prefixes})
        return list(filter(None, map(self.module, names)))

    def _closure(self, start: str, without: str = "") -> list[str]:
        """Return a file and all files that it imports, directly or indirectly.

        Files of the package named by ``without`` are excluded.
        """
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

    def digests(
        self, starts: Iterable[str], root: Path, without: str = ""
    ) -> tuple[dict[str, str], dict[str, str]]:
        """Return the digests of files and of all files that they import, by name, and
        those of the files below ``root`` that their strings name.
        """
        files = {file for start in starts for file in self.closure(start, without)}
        sources = {self.name_of(file): self.source(file) for file in files}
        names = {name for source in sources.values() for name in source.assets}
        assets = {
            name: self.digest(root / name)
            for name in sorted(names)
            if (root / name).is_file()
        }
        return {name: sources[name].digest for name in sorted(sources)}, assets

    def _digest(self, path: Path) -> str:
        return hashlib.sha256(path.read_bytes()).hexdigest()


_sources: dict[str, Source] = {}  # by a digest of the file's text and package


def read_source(path: Path, name: str) -> Source:
    """Return the facts about a file; raise ReportError if it cannot be read.

    ``name`` identifies the file in messages.
    """
    package = PurePosixPath(name).parts[:-1]
    try:
        text = path.read_bytes()
        key = hashlib.sha256(f"{package}\0".encode() + text).hexdigest()
        if key not in _sources:
            _sources[key] = _source_of(ast.parse(text, filename=name), package)
        return _sources[key]
    except (OSError, SyntaxError, ValueError) as error:
        raise ReportError(
            f"{name} cannot be read or parsed: {' '.join(str(error).split())}"
        ) from None


@contextmanager
def cached_sources() -> Iterator[None]:
    """Keep the facts of parsed files for later processes.

    Parsing all files takes seconds.
    """
    store = Cache(Path(HERE))
    made_by = (sys.version, hashlib.sha256(Path(__file__).read_bytes()).hexdigest())
    _sources.update(store.get("sources", made_by) or {})
    count_before = len(_sources)
    try:
        yield
    finally:
        if len(_sources) > count_before:
            # A limit keeps the cache from growing with each change of a file.
            newest = list(_sources.items())[-2000:]
            store.put("sources", made_by, dict(newest))


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
    return Source(
        digest_of(plain(tree)),
        modules,
        assets,
        dict(_top(tree)),
        tuple(_typed(nodes)),
        tuple(_random(nodes, package)),
    )


def _random(nodes: Sequence[ast.AST], package: tuple[str, ...]) -> Iterator[int]:
    """Yield the lines of calls that return random numbers, the time or data."""
    paths = dict(chain.from_iterable(imported_names(node, package) for node in nodes))
    for node in nodes:
        if isinstance(node, ast.Call) and isinstance(
            node.func, ast.Attribute | ast.Name
        ):
            name, dot, attribute = ast.unparse(node.func).partition(".")
            path = f"{paths.get(name, '')}{dot}{attribute}"
            is_seeded = path.endswith(SEEDED) and (node.args or node.keywords)
            if UNREPEATABLE.fullmatch(path) and not is_seeded:
                yield node.lineno


def _typed(nodes: Sequence[ast.AST]) -> Iterator[int]:
    """Yield the lines of calls that draw a literal list, directly or by its name, or
    that write a number with its unit.

    Positions such as ``[0, 1, 2]`` are not data.
    """
    named = {
        target.id: node.value
        for node in nodes
        if isinstance(node, ast.Assign)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for node in nodes:
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
            continue
        if node.func.attr in WRITING:
            texts = [node.args, [option.value for option in node.keywords]]
            values = [getattr(text, "value", "") for text in chain(*texts)]
            if any(isinstance(text, str) and TYPED.search(text) for text in values):
                yield node.lineno
        if node.func.attr not in DRAWING:
            continue
        is_line = node.func.attr in ("axhline", "axvline")
        drawn = [node.func.value, *([ast.List(node.args)] if is_line else node.args)]
        # Names assigned in the same file, as in ``sizes = [3, 7]``.
        drawn += [
            named[part.id]
            for part in chain.from_iterable(map(ast.walk, drawn))
            if isinstance(part, ast.Name) and part.id in named
        ]
        for part in chain.from_iterable(map(ast.walk, drawn)):
            if not isinstance(part, LISTS):
                continue
            with suppress(ValueError):
                ast.literal_eval(part)  # raises ValueError if anything is computed
                cells = [getattr(cell, "value", None) for cell in ast.walk(part)]
                numbers = [cell for cell in cells if type(cell) in (int, float)]
                # Positions count from 0 or from 1.
                start = int(0 not in numbers)
                is_data = numbers[1:] or float in map(type, numbers)
                if is_data and numbers != [*range(start, start + len(numbers))]:
                    yield node.lineno
                    break


def imported_names(
    node: ast.AST, package: tuple[str, ...]
) -> Iterator[tuple[str, str]]:
    """Yield each name that an import statement binds, with its dotted path."""
    if isinstance(node, ast.Import):
        for alias in node.names:
            yield alias.asname or alias.name.partition(".")[0], alias.name
    elif isinstance(node, ast.ImportFrom):
        start = package[: len(package) - node.level + 1] if node.level else ()
        module = ".".join([*start, *filter(None, [node.module])])
        for alias in node.names:
            # A module outside of a package may import a module beside it.
            path = f"{module}.{alias.name}".lstrip(".")
            yield alias.asname or alias.name, path


def _top(tree: ast.Module) -> Iterator[tuple[str, Any]]:
    """Yield the names that a module defines at its top level, as `Source.top` does."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, len(node.args.args)
        elif isinstance(node, ast.Assign):
            value: Any = COMPUTED
            with suppress(ValueError):
                value = ast.literal_eval(node.value)
            yield from (
                (target.id, value)
                for target in node.targets
                if isinstance(target, ast.Name)
            )


def plain(node: Any) -> Any:
    """Return a syntax tree as nested lists, which are the same in every Python version.

    Docstrings and layout are left out.
    """
    if isinstance(node, list):
        return [plain(child) for child in node if not is_docstring(child)]
    if not isinstance(node, ast.AST):
        return ascii(node)
    fields = {
        name: value for name, value in ast.iter_fields(node) if name not in LAYOUT
    }
    # From Python 3.12 on, a nested format specification ends with an empty string.
    if isinstance(node, ast.JoinedStr):
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
    """Return whether a statement is only a string."""
    value = node.value if isinstance(node, ast.Expr) else None
    return isinstance(value, ast.Constant) and isinstance(value.value, str)


def digest_of(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
