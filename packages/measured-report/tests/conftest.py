"""The report of the tests is the toy, and what it measures on is this machine's processor."""

import shutil
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from toys import Toy, git, lay_out

from measured_report.editions.project import Project
from measured_report.files.cache import Cache
from measured_report.files.config import report_in
from measured_report.records.code import unchanged_files

with suppress(ImportError):  # an extra
    from hypothesis import settings

    settings.register_profile("project", deadline=None, derandomize=True)  # however slow the machine
    settings.load_profile("project")


@pytest.fixture(scope="session")
def outside(tmp_path_factory) -> Path:
    """A report that no test changes."""
    lay_out(folder := tmp_path_factory.mktemp("outside"))
    return folder


@pytest.fixture(scope="module", autouse=True)
def entered(outside) -> Iterator[None]:
    with report_in(outside):
        yield


@pytest.fixture
def toy(tmp_path, monkeypatch) -> Iterator[Toy]:
    """A report that is current."""
    monkeypatch.setattr("sys.dont_write_bytecode", True)  # a file changes here within the second that a cache tells
    lay_out(folder := tmp_path / "project")
    with report_in(folder):
        toy = Toy(Project("1.4.0"))
        toy.measure()
        yield toy


@pytest.fixture(scope="session")
def kept(tmp_path_factory) -> Path:
    """What a build of the project leaves, once one was asked for."""
    return tmp_path_factory.mktemp("kept")


@pytest.fixture
def built(toy, kept) -> Toy:
    """The project with its site; a copy, but for the first that asks, as is what is kept for the next build."""
    if not any(kept.iterdir()):
        toy.build()
        shutil.copytree(toy.project.site, kept / "site")
        shutil.copytree(Cache(toy.project.root).folder, kept / "cache")
    else:
        shutil.copytree(kept / "site", toy.project.site)
        shutil.copytree(kept / "cache", Cache(toy.project.root).folder)
    return toy


@pytest.fixture(scope="module")
def unchanged() -> Iterator[None]:
    """Look at each source once for all tests of a module, of which none changes any."""
    with unchanged_files():
        yield


@pytest.fixture
def log(tmp_path) -> Path:
    """The log of the batches without physics."""
    path = tmp_path / "log"
    path.touch()
    return path


@pytest.fixture
def checkout(tmp_path) -> Path:
    """A repository with a package newton."""
    folder = tmp_path / "newton"
    (folder / "newton").mkdir(parents=True)
    (folder / "newton/__init__.py").write_text("x = 1\n")
    (folder / "pyproject.toml").write_text('[project]\nname = "newton"\nversion = "1.9.0.dev0"\n')
    git(folder, "init", "--quiet", "--initial-branch", "main")
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "-m", "one")
    return folder
