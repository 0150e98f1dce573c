"""Identity: what a section's numbers depend on, found by reading the sources and never by running them."""

import ast
import hashlib
import json
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field
from importlib import metadata
from itertools import accumulate
from pathlib import Path, PurePosixPath
from typing import Any

from report import ROOT, ReportError
from report.records.cache import Cache
from report.records.sources import source_of

PACKAGES = ("newton", "warp-lang", "mujoco-warp", "mujoco")
ASSETS = "assets/"
MISSING = "missing"


@dataclass(frozen=True)
class Identity:
    """Digests of all that a measurement depends on, except the machine."""

    code: str
    """Digest of the section's module and of the project code that it imports."""
    config: str
    """Digest of the profile and of the assets that this code names."""
    packages: Mapping[str, str]
    """Version by package."""
    profile: str = "full"
    files: Mapping[str, str] = field(default_factory=dict)
    """Digest by file: the parts of ``code`` and ``config``, so that a change can be named."""


@dataclass(frozen=True)
class Source:
    """What the text of one module says, as far as it matters here."""

    digest: str
    imports: tuple[str, ...]
    """Names that it imports, of which some are modules of this project."""
    assets: tuple[str, ...]
    """Paths of assets that it may name."""
    top: Mapping[str, Any]
    """By name, at its top level: the plain constants, and how many parameters a function has."""


_known: dict[str, Source] = {}
"""By the digest of their names and texts: every section imports the same few modules."""
SOURCES = "sources"
"""Their name in the cache."""


class _Files:
    """Sources and what they import, each looked at once, and what is installed."""

    def __init__(self) -> None:
        self.versions: dict[str, str] = {}
        self._sources: dict[str, Source] = {}
        self._imported: dict[tuple[str, str], list[str]] = {}
        self._folders: dict[str, set[str]] = {}

    def source(self, path: str, name: str) -> Source:
        if path not in self._sources:
            self._sources[path] = read_source(Path(path), name)
        return self._sources[path]

    def imported(self, path: str, root: str) -> list[str]:
        """The files below ``root`` that the source at ``path``, which was looked at, may import."""
        if (path, root) not in self._imported:
            self._imported[path, root] = [*_module_files(self._sources[path].imports, root, self._folders)]
        return self._imported[path, root]


_files: ContextVar[_Files | None] = ContextVar("files", default=None)


@contextmanager
def unchanged_files() -> Iterator[None]:
    """Within it no source changes and nothing is installed: of one that many sections import it is seen once what it
    says."""
    token = _files.set(_Files())
    try:
        yield
    finally:
        _files.reset(token)


@contextmanager
def sources_kept(root: Path = ROOT) -> Iterator[None]:
    """Within it, what sources say is known from the processes before, since parsing all of them takes a second."""
    cache = Cache(root)
    made_by = sys.version, hashlib.sha256(Path(__file__).read_bytes()).hexdigest()
    _known.update(cache.get(SOURCES, made_by) or {})
    before = len(_known)
    try:
        yield
    finally:
        if len(_known) > before:
            # The newest: those of texts that are no more need not be kept for ever.
            cache.put(SOURCES, made_by, dict(list(_known.items())[-1000:]))


def identity_of(section: str, profile: str, root: Path = ROOT, packages: Mapping[str, str] | None = None) -> Identity:
    """The identity that ``experiments/<section>.py`` has now, with ``packages``, or else with those installed here."""
    sources = import_closure(root / "experiments" / f"{section}.py", root)
    code = {name: source.digest for name, source in sources.items()}
    assets = {name for source in sources.values() for name in source.assets if (root / name).is_file()}
    config = {name: hashlib.sha256((root / name).read_bytes()).hexdigest() for name in assets}
    return Identity(
        code=_digest(code),
        config=_digest({"profile": profile, **config}),
        packages=package_versions() if packages is None else packages,
        profile=profile,
        files=dict(sorted({**code, **config}.items())),
    )


def changes(recorded: Identity, current: Identity) -> list[str]:
    """What differs between two identities, in words; empty when the record is fresh."""
    changed = [
        name
        for name in sorted({*recorded.files, *current.files})
        if recorded.files.get(name) != current.files.get(name)
    ]
    words = []
    if recorded.code != current.code:
        words += [f"code: {name}" for name in changed if name.endswith(".py")] or ["code"]
    if recorded.config != current.config:
        parts = [f"config: {name}" for name in changed if not name.endswith(".py")]
        if recorded.profile != current.profile:
            parts.append(f"config: profile {recorded.profile} → {current.profile}")
        words += parts or ["config"]
    return words + [f"packages: {change}" for change in package_changes(recorded.packages, current.packages)]


def package_changes(
    before: Mapping[str, str | None], after: Mapping[str, str | None], names: Sequence[str] = PACKAGES
) -> list[str]:
    """Which packages are of another version than before, each with both."""
    versions = {name: (before.get(name), after.get(name)) for name in names}
    return [f"{name} {old} → {new}" for name, (old, new) in versions.items() if old != new]


def sections(root: Path = ROOT) -> list[str]:
    """Names of the sections: those that have a module, or a folder of modules, on the report's side."""
    folder = root / "report" / "sections"
    found = {path.stem for path in folder.glob("*.py")} | {path.parent.name for path in folder.glob("*/__init__.py")}
    return sorted(found - {"__init__"})


def source_at(path: Path, name: str) -> Source:
    """What ``read_source`` says, of one that was looked at before as well."""
    files = _files.get()
    return files.source(str(path), name) if files else read_source(path, name)


def package_versions() -> dict[str, str]:
    """Version of each package that is installed here; Newton's says which code it is, where that is not an index's."""
    files = _files.get() or _Files()
    files.versions = files.versions or _installed_versions()
    return dict(files.versions)


def _installed_versions() -> dict[str, str]:
    versions = {package: _installed_version(package) for package in PACKAGES}
    source = source_of("newton")
    return versions | ({"newton": f"{versions['newton']}+{source}"} if source else {})


def _installed_version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return MISSING


def canonical(node: Any) -> Any:
    """A syntax tree as plain tuples, without comments, docstrings and positions.

    Fields that are empty or that only some Python versions know are left out: a record measured under
    one Python has to be fresh under another.
    """
    if isinstance(node, ast.JoinedStr):
        # Python 3.12 and later put an empty text behind a nested format specification.
        node = ast.JoinedStr([part for part in node.values if getattr(part, "value", None) != ""])
    if isinstance(node, ast.AST):
        fields = [(name, canonical(value)) for name, value in ast.iter_fields(node) if name != "kind"]
        return type(node).__name__, *(pair for pair in fields if pair[1] not in ("None", ()))
    if isinstance(node, list):
        return tuple(canonical(item) for item in node if not _is_docstring(item))
    return repr(node)


def _is_docstring(node: Any) -> bool:
    # Any string that stands alone does nothing, wherever it stands: field docstrings are left out as well.
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def import_closure(start: Path, *roots: Path) -> dict[str, Source]:
    """What the module at ``start`` and the modules below ``roots`` that it imports say, by their names."""
    sources: dict[str, Source] = {}
    files = _files.get() or _Files()
    waiting = [(str(start), str(roots[0]))]
    while waiting:
        path, root = waiting.pop()
        name = path[len(root) + 1 :]
        if name not in sources:
            sources[name] = files.source(path, name)
            for each in map(str, roots):
                waiting += [(file, each) for file in files.imported(path, each)]
    return sources


def read_source(path: Path, name: str) -> Source:
    """What the module at ``path`` says; ReportError, with its ``name``, where it can't be read."""
    try:
        text = path.read_bytes()
        key = hashlib.sha256(name.encode() + b"\0" + text).hexdigest()
        if key not in _known:
            tree = ast.parse(text, filename=name)
            nodes = list(ast.walk(tree))
            imports = _imported_names(nodes, PurePosixPath(name).parts[:-1])
            _known[key] = Source(
                _digest(canonical(tree)), tuple(dict.fromkeys(imports)), tuple(_named_assets(nodes)), dict(_top(tree))
            )
        return _known[key]
    except (OSError, SyntaxError, ValueError) as error:
        raise ReportError(f"cannot read {name}: {' '.join(str(error).split())}") from None


def _top(tree: ast.Module) -> Iterator[tuple[str, Any]]:
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
            yield from ((target.id, node.value.value) for target in node.targets if isinstance(target, ast.Name))
        elif isinstance(node, ast.FunctionDef):
            yield node.name, len(node.args.args)


def _imported_names(nodes: Iterable[ast.AST], package: tuple[str, ...]) -> Iterator[str]:
    for node in nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            start = package[: len(package) - node.level + 1] if node.level else ()
            module = ".".join((*start, *([node.module] if node.module else [])))
            # Each name may be a module of the package or something in it; what is no file drops out later.
            yield from (f"{module}.{alias.name}" for alias in node.names)


def _module_files(names: Iterable[str], root: str, folders: dict[str, set[str]]) -> Iterator[str]:
    """The files below ``root`` that these names may import, each once; ``folders`` are those that were looked into."""
    modules = {module for name in names for module in accumulate(name.split("."), "{}/{}".format)}
    for module in sorted(modules):
        folder, _, last = f"{root}/{module}".rpartition("/")
        if f"{last}.py" in _names_in(folder, folders):
            yield f"{folder}/{last}.py"
        if last in _names_in(folder, folders) and "__init__.py" in _names_in(f"{folder}/{last}", folders):
            yield f"{folder}/{last}/__init__.py"


def _names_in(folder: str, folders: dict[str, set[str]]) -> set[str]:
    if folder not in folders:
        folders[folder] = {path.name for path in Path(folder).glob("*")}
    return folders[folder]


def _named_assets(nodes: Iterable[ast.AST]) -> Iterator[str]:
    for node in nodes:
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and text.startswith(ASSETS) and "\n" not in text:
            yield text


def files_digest(paths: Iterable[Path], root: Path) -> str:
    """Digest of files, by their names below ``root`` and what they hold; folders are passed over."""
    digest = hashlib.sha256()
    for path in sorted(paths):
        if path.is_file():
            content = path.read_bytes()
            digest.update(f"{_name(path, root)}\0{len(content)}\0".encode() + content)
    return digest.hexdigest()


def _digest(data: Any) -> str:
    return hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()


def _name(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix()
