"""Environments: the project's own, and one of its own for each other edition, which leaves the lock alone.

Each is made aside and put in place whole, so that one that is there can be used. Run as a program, by a Python that has
nothing yet, this makes the project's own.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from datetime import date, timedelta
from functools import partial
from pathlib import Path

import measured_report
from measured_report.editions.release import Release, release_date
from measured_report.files.atomic import locked
from measured_report.files.config import config, read_toml
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.processes import end_with_parent
from measured_report.files.root import ROOT
from measured_report.files.staging import replace as exchange
from measured_report.files.staging import staging_folder
from measured_report.records.provenance import EDITED, MISSING, package_versions

VERSION = re.compile(r"[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?")
NAME = re.compile(r"[^A-Za-z0-9-].*")
OFFLINE = re.compile(r"dns|connect|network|resolve host|timed out|Failed to fetch|name resolution", re.IGNORECASE)
FILTER = "UV_EXCLUDE_NEWER"
"""The variable that names another day for the installer's filter than the one on which a release came out."""
READY = ".ready"
"""In an environment: the digest of what it was made from."""


def own_environment(root: Path = ROOT) -> None:
    """Make ``.venv`` as the lock says, unless it is there already."""
    sources = [root / "pyproject.toml", root / "uv.lock"]
    folder = root / ".venv"
    _make(folder, ".venv", b"".join(path.read_bytes() for path in sources), partial(_from_lock, root), root)
    # Make goes by times: what was made is newer than what it was made from, whatever the clock says.
    newest = max(path.stat().st_mtime for path in [*sources, folder / READY])
    os.utime(folder / READY, (newest, newest))


def add_group(group: str, root: Path = ROOT) -> None:
    """Install a group of pyproject.toml into ``.venv`` as the lock says; another Python is left as it is."""
    if Path(sys.prefix) == root / ".venv":
        with locked(root), _installer(root, group) as uv:
            _run([uv, "sync", "--frozen", "--inexact", "--group", group, "--project", str(root)], group)


def add_cluster(python: Path, root: Path = ROOT) -> None:
    """Install what a cluster takes for ``python``, unless it is there; UsageError where that can't be."""
    asking = "import sys; from importlib.util import find_spec; sys.exit(not all(map(find_spec, sys.argv[1:])))"
    takes = read_toml(root / "pyproject.toml")["project"].get("optional-dependencies", {}).get("cluster", ())
    names = [NAME.sub("", requirement) for requirement in takes]
    if subprocess.run([python, "-c", asking, *names], check=False).returncode == 0:
        return
    folder = python.parent.parent
    if folder.parent != root:
        raise UsageError(f"CLUSTER takes {' and '.join(names)}, which {python} lacks; install them there")
    with locked(root), _installer(root, "cluster") as uv:
        own = [uv, "sync", "--frozen", "--inexact", "--extra", "cluster", "--project", str(root)]
        _run(own if folder.name == ".venv" else [uv, "pip", "install", "--python", str(python), *takes], "cluster")


def python_of(release: Release, packages: Mapping[str, str], root: Path = ROOT) -> Path:
    """Return the Python that has a release; its environment is made when it is not there.

    ``packages`` are the versions that its earlier measurements were made with, to be installed again; one that is
    ``missing`` there is as ``requirements`` says.
    """
    package, option = config().package, config().option
    if release.is_installed_with(package_versions()):
        return Path(sys.executable)
    if not release.requirement:
        place = f"a path or git+https://HOST/{package}.git@COMMIT"
        raise UsageError(f"{option}={release} does not say where its code is; {place} does")
    folder = environment_of(release, root)
    others = {name: version for name, version in packages.items() if name != package}
    rest = requirements(root, {package: MISSING, **others, **dict(release.pins)})
    source = "\n".join([release.requirement, *rest]).encode()
    if release.checkout:
        source += (release.checkout / "pyproject.toml").read_bytes()
    if release.checkout or not (folder / READY).exists():
        _make(folder, f"{option}={release.asked}", source, partial(_from_requirements, root, release, rest), root)
    _refuse_other(folder / "bin" / "python", release, root)
    return folder / "bin" / "python"


def python_with(name: str, requirements: Sequence[str], root: Path = ROOT) -> Path:
    """Return the Python of the environment ``.venv-<name>``, which has these requirements and nothing of the project's.

    It is made when it is not there; UsageError, one line, where it can't be.
    """

    def install(uv: str, new: Path) -> list[list[str]]:
        return [[uv, "pip", "install", "--python", str(new / "bin" / "python"), *requirements]]

    folder = root / f".venv-{name}"
    _make(folder, name, "\n".join(requirements).encode(), install, root)
    return folder / "bin" / "python"


def environment_of(release: Release, root: Path = ROOT) -> Path:
    """Name the folder of a release's environment; that of a checkout serves all that is edited in it."""
    name = str(replace(release, machine=""))
    if release.checkout:
        pins = "".join(f"+{part}" for part in name.split("+")[2:])
        name = f"{release.checkout.name}-{hashlib.sha256(str(release.checkout).encode()).hexdigest()[:7]}{pins}"
    return root / f".venv-{config().edition_folder(name)}"


def _refuse_other(python: Path, release: Release, root: Path) -> None:
    """Raise UsageError unless what is installed is what was asked for."""
    code = (
        f"import json, sys; sys.path.append({str(Path(measured_report.__file__).parents[1])!r});"
        "from measured_report.records.provenance import package_versions; print(json.dumps(package_versions()))"
    )
    done = subprocess.run([python, "-c", code], cwd=root, capture_output=True, text=True, check=False)
    if done.returncode:
        asked = f"{config().option}={release.asked}"
        raise UsageError(f"{asked}: {python} does not run; remove its folder and it is made anew")
    installed = json.loads(done.stdout)
    wanted = {**dict(release.pins), config().package: release.package_version}
    for package, version in wanted.items():
        found = installed[package]
        if found.partition(f"{EDITED}.")[0] != version.removesuffix(EDITED):
            folder = python.parent.parent.name
            raise UsageError(f"{folder} has {package} {found} in place of {version}; remove it and it is made anew")


def requirements(root: Path, packages: Mapping[str, str]) -> list[str]:
    """Read the requirements in the project's pyproject.toml, with these versions of packages in the place of its own.

    One that is ``missing`` is as the project asks for it, or, if it comes out with the edition as those in ``together``
    do, left to the others, which know which one they take.
    """
    for name, version in packages.items():
        if name not in config().packages or (not VERSION.fullmatch(version) and version != MISSING):
            raise ReportError(f"{name} {version!r:.60} is no package of this report with a plain version")
    asked = read_toml(root / "pyproject.toml").get("project", {}).get("dependencies", ())
    known = {name: version for name, version in packages.items() if version != MISSING}
    other = {*known, config().package}.union(*config().changes.together)
    own = [requirement for requirement in asked if NAME.sub("", requirement) not in other]
    return own + [f"{config().requirement_of(name)}=={version}" for name, version in known.items()]


def _make(folder: Path, name: str, source: bytes, commands: Callable[[str, Path], list[list[str]]], root: Path) -> None:
    """Make the environment ``folder``, asked for as ``name``: aside, and then put in place, unless it is there, made
    from the same ``source``. ``commands`` install what it needs."""
    digest, ready = hashlib.sha256(source).hexdigest(), folder / READY
    try:
        with staging_folder(folder) as new:
            if ready.is_file() and ready.read_text(encoding="utf-8") == digest:
                return
            with _installer(root, name) as uv:
                # Its programs are found from where they lie, so that it can be moved.
                _run([uv, "venv", "--relocatable", "--python", sys.executable, str(new)], name)
                for command in commands(uv, new):
                    _run(command, name, UV_PROJECT_ENVIRONMENT=str(new))
            (new / READY).write_text(digest, encoding="utf-8")
            exchange(folder, new)
    except OSError as error:
        raise UsageError(f"{name} cannot be installed: {folder}: {error.strerror}") from None


@contextmanager
def _installer(root: Path, name: str) -> Iterator[str]:
    """Find the program that makes environments; where there is none it is installed for the time being."""
    tools = root / ".venv.tools"
    uv = shutil.which("uv") or shutil.which("uv", path=str(root / ".venv" / "bin"))
    try:
        if not uv:
            shutil.rmtree(tools, ignore_errors=True)  # of one that was killed
            _run([sys.executable, "-m", "venv", str(tools)], name)
            pinned = tools / "uv.txt"
            pinned.write_text(_locked(root, "uv"), encoding="utf-8")
            pip = [str(tools / "bin" / "python"), "-m", "pip", "install", "--quiet", "--require-hashes", "--no-deps"]
            _run([*pip, "--only-binary", ":all:", "--requirement", str(pinned)], name)
        yield uv or str(tools / "bin" / "uv")
    finally:
        shutil.rmtree(tools, ignore_errors=True)


def _locked(root: Path, name: str) -> str:
    """Write the requirement of a package as the lock has it, with the digests of its files."""
    lock = (root / "uv.lock").read_text(encoding="utf-8")
    [entry] = [each for each in lock.split("[[package]]\n") if each.startswith(f'name = "{name}"\n')]
    [version], digests = re.findall('^version = "(.+)"$', entry, re.MULTILINE), re.findall("sha256:[0-9a-f]{64}", entry)
    return " ".join([f"{name}=={version}", *(f"--hash={digest}" for digest in digests)])


def _from_lock(root: Path, uv: str, new: Path) -> list[list[str]]:
    return [[uv, "sync", "--frozen", "--project", str(root)]]


def _from_requirements(root: Path, release: Release, rest: Sequence[str], uv: str, new: Path) -> list[list[str]]:
    """Install what was asked for and the rest: packages that nobody named are those of the day on which it came out."""
    pins = dict(release.pins)
    overrides = new / "overrides.txt"
    overrides.write_text("".join(f"{name}=={version}\n" for name, version in pins.items()), encoding="utf-8")
    options = ["--python", str(new / "bin" / "python"), "--group", f"{root / 'pyproject.toml'}:dev"]
    options += ["--overrides", str(overrides)] if pins else []
    if not os.environ.get(FILTER) and (day := release_date(release)):
        print(f"{config().option}={release.asked}: came out on {day}; its packages are those of that day", flush=True)
        after = (date.fromisoformat(day) + timedelta(days=1)).isoformat()
        options += ["--exclude-newer", after]
        named = [requirement.partition("==")[0] for requirement in rest if "==" in requirement]
        options += [word for name in named for word in ("--exclude-newer-package", f"{name}=2100-01-01")]
    extras = config().requirement.removeprefix(config().package)
    asked = ["--editable", f"{release.checkout}{extras}"] if release.checkout else [release.requirement]
    return [[uv, "pip", "install", *options, *rest, *asked]]


def _run(command: list[str], name: str, **settings: str) -> None:
    """Run a program, which takes a while; UsageError, one line, with the last that it said where it fails."""
    if sys.stdout.isatty():  # a log has the one line that says why it failed
        print(f"{name}: {Path(command[0]).name} {' '.join(command[1:3])} …", flush=True)
    program = subprocess.run(
        command,
        stderr=subprocess.STDOUT,
        stdout=subprocess.PIPE,
        text=True,
        errors="replace",
        env={**os.environ, **settings},
        preexec_fn=end_with_parent,
        check=False,
    )
    if program.returncode:
        said = [*filter(None, (line.strip(" ×╰─▶\t") for line in program.stdout.splitlines()))]
        hint = " (this takes the network, once)" if any(map(OFFLINE.search, said)) else ""
        if "--exclude-newer" in command:
            day = command[command.index("--exclude-newer") + 1]
            hint += f"; nothing that came out from {day} on was looked at, and {FILTER}={date.today()} lifts that"
        raise UsageError(f"{name} cannot be installed: {said[-1] if said else 'no reason was given'}{hint}")


if __name__ == "__main__":
    try:
        own_environment()
    except KeyboardInterrupt:
        sys.exit("stopped; make begins again")
    except ReportError as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
