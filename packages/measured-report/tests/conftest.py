"""Provide the toy as the report of the tests, measured on this machine's processor."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from toys import Toy, git, lay_out

from measured_report.editions.project import Project
from measured_report.files.cache import Cache
from measured_report.files.config import report_in

with suppress(ImportError):  # an optional dependency
    from hypothesis import settings

    settings.register_profile(
        "project", deadline=None, derandomize=True
    )  # even on a slow machine
    settings.load_profile("project")


@pytest.fixture(scope="session")
def outside(tmp_path_factory) -> Path:
    """Return a report that no test changes."""
    lay_out(folder := tmp_path_factory.mktemp("outside"))
    return folder


@pytest.fixture(scope="module", autouse=True)
def entered(outside) -> Iterator[None]:
    with report_in(outside):
        yield


@contextmanager
def entered_toy(folder: Path) -> Iterator[Toy]:
    lay_out(folder)
    with report_in(folder), pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            "sys.dont_write_bytecode", True
        )  # a file changes here within a second, the resolution of the cache
        toy = Toy(Project("1.4.0"))
        toy.measure()
        yield toy


@pytest.fixture(scope="session")
def model(tmp_path_factory) -> Toy:
    """Return a built toy, from which tests make copies."""
    with entered_toy(tmp_path_factory.mktemp("model") / "project") as toy:
        toy.build()
        return toy


@pytest.fixture
def toy(tmp_path, model) -> Iterator[Toy]:
    """Return a fresh report.

    The derived values and figures of its model are kept for its first build.
    """
    with entered_toy(tmp_path / "project") as toy:
        shutil.copytree(
            Cache(model.project.root).folder, Cache(toy.project.root).folder
        )
        yield toy


@pytest.fixture
def built(toy, model) -> Toy:
    """Return the project with its site."""
    shutil.copytree(model.project.site, toy.project.site)
    return toy


@pytest.fixture
def log(tmp_path) -> Path:
    """Return the log of the batches without physics."""
    path = tmp_path / "log"
    path.touch()
    return path


@pytest.fixture
def checkout(tmp_path) -> Path:
    """Return a repository with a package newton."""
    folder = tmp_path / "newton"
    (folder / "newton").mkdir(parents=True)
    (folder / "newton/__init__.py").write_text("x = 1\n")
    (folder / "pyproject.toml").write_text(
        '[project]\nname = "newton"\nversion = "1.9.0.dev0"\n'
    )
    git(folder, "init", "--quiet", "--initial-branch", "main")
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "-m", "one")
    return folder
