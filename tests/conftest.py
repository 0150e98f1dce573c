"""Provide this repository's report to the tests."""

import os
import shutil
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from unittest import mock

import pytest
import warp as wp
from toys import (
    HERE,
    KEPT,
    REPORT,
    Toy,
    forget_sections,
    lay_out,
    link,
    made_once,
    program,
)

from measured_report.editions.project import Project, own_release
from measured_report.files.atomic import put_in_place, staging_folder
from measured_report.files.cache import Cache
from measured_report.files.root import ROOT
from measured_report.findings import replicas
from measured_report.findings.editions import Edition
from measured_report.pages.prose import Templates
from measured_report.pages.wording import worded_editions
from measured_report.parts.prose import Prose
from measured_report.records import code
from measured_report.records.code import cached_sources
from measured_report.records.identity import package_versions
from measured_report.records.replicas import read_replica
from measured_report.records.traces import load_trace
from measured_report.site.pages import Content, contents_of
from report import sections

wp.config.enable_backward = False  # before the import of kernels, half of whose compiled code would be gradients
INSTALLED = package_versions()
IMPORTED = (ROOT, *(ROOT / "packages").iterdir(), ROOT / "tests", HERE)
os.environ["PYTHONPATH"] = os.pathsep.join(
    map(str, IMPORTED)
)  # for the programs that the tests start
# Compiling the kernels takes minutes, and Warp detects changes itself.
os.environ.setdefault("WARP_CACHE_PATH", str(KEPT / "warp-of-tests"))

needs_boxes_in_c = pytest.mark.skipif(
    INSTALLED["mujoco"].startswith("3.11."),
    reason="MuJoCo 3.11 in C finds contacts 75 mm deep between boxes that are 30 mm apart",
)
"""Marks a test of the shake in MuJoCo's C engine, which does not work with the MuJoCo
of release 1.5. The error was observed with fixed_scene.py while the hand moves down.
"""
SOURCES = (
    "packages",
    "experiments",
    "report",
    "templates",
    "assets",
    "pyproject.toml",
    "report.toml",
)
SIMULATING = ("tests/experiments", "tests/newton_lint/newton_models")


LONGEST = (
    "tests/experiments/test_fix.py",
    "packages/measured-report/tests/changes/test_carry.py",
    "tests/test_your_own.py",
    "packages/measured-report/tests/findings/test_cache.py",
    "packages/measured-report/tests/commands/test_publish.py",
    "packages/measured-report/tests/commands/test_mistakes.py",
    "packages/measured-report/tests/commands/test_secrets.py",
    "tests/report/test_replicas.py",
    "tests/report/test_sensitivity.py",
    "tests/test_missing_results.py",
    "tests/test_altered_results.py",
    "tests/assets/test_page.py",
    "tests/assets/lab/test_lab_page.py",
    "packages/contact-bias/tests/test_contact_place.py",
    "tests/report/test_tracked.py",
    "tests/test_readme.py",
    "tests/test_worlds.py",
    "tests/experiments/simulation/test_simulation.py",
    "tests/experiments/test_stability.py",
)
"""Files with the slowest tests.

The first file compiles the kernels and builds the tracked site, which the next six do
not need.
"""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the slowest files, so that no process ends long after the others."""
    ranks = {ROOT / name: rank for rank, name in enumerate(LONGEST)}
    items.sort(key=lambda item: ranks.get(item.path, len(ranks)))
    for item in items:
        if any(item.path.is_relative_to(ROOT / path) for path in SIMULATING):
            item.fixturenames.insert(0, "kernels")


@pytest.fixture(scope="session")
def kernels(tmp_path_factory) -> None:
    """Return the kernels of the scene, compiled once for all processes of this run of
    the tests.
    """

    def make(_: Path) -> None:
        from experiments.simulation.host import compile_first

        compile_first("cpu")

    made_once(tmp_path_factory, "kernels", make)


@pytest.fixture(scope="session")
def site(tmp_path_factory) -> Path:
    """Build the site of the tracked results in a folder outside the checkout.

    Unchanged parts are derived and drawn once. ``findings/test_cache.py`` tests that
    entries of the cache are read only if all of their sources are unchanged.
    """

    def make(root: Path) -> None:
        link(root, "results", *SOURCES)
        kept = KEPT / "caches-of-tests"
        caches = {
            "derived": Cache(root).folder,
            "sources": Cache(Path(code.HERE)).folder,
        }
        for name, folder in caches.items():
            with suppress(FileNotFoundError):
                shutil.copytree(kept / name, folder, dirs_exist_ok=True)
        done = program("-c", REPORT, root, own_release())
        assert done.returncode == 0, done.stderr
        with suppress(OSError), staging_folder(kept) as fresh:
            for name, folder in caches.items():
                shutil.copytree(folder, fresh / name)
            put_in_place(kept, fresh)
        # The checkout has the same files, so its findings are the same.
        own = Cache(ROOT).folder
        own.mkdir(mode=0o700, parents=True, exist_ok=True)
        shutil.copytree(caches["derived"], own, dirs_exist_ok=True)

    return made_once(tmp_path_factory, "tracked", make) / "site"


@pytest.fixture(scope="session")
def editions(site) -> Mapping[str, Edition]:
    """Return the derived results of every release from the cache of their site."""
    project = Project(own_release(), root=site.parent)
    with cached_sources():
        return worded_editions(project, Templates(project.templates))


read_once = cache(read_replica)


@pytest.fixture(scope="module")
def unchanged() -> Iterator[None]:
    """Mark tests that change neither sources nor replicas, so that each replica is read
    once.
    """
    with mock.patch.object(replicas, "read_replica", read_once):
        yield


@pytest.fixture
def toy(tmp_path, monkeypatch) -> Iterator[Toy]:
    """Return a function that derives a section of this report among all others."""
    monkeypatch.setattr(
        sys, "dont_write_bytecode", True
    )  # a file changes here within a second, the resolution of the cache
    lay_out(folder := tmp_path / "project")
    for name in ("report.toml", "pyproject.toml"):
        (folder / name).unlink()
    shutil.copy(ROOT / "templates/investigation.md.j2", folder / "templates")
    shutil.copytree(
        ROOT / "templates" / "pages", folder / "templates" / "pages", dirs_exist_ok=True
    )
    monkeypatch.setattr(
        sections, "__path__", [str(folder / "report" / "sections"), *sections.__path__]
    )
    toy = Toy(Project("1.4.0", root=folder))
    toy.measure()
    yield toy
    forget_sections()


@pytest.fixture(scope="session")
def poses_path(tmp_path_factory) -> Path:
    """Return a copy of the tracked record of section poses with its traces."""
    results = tmp_path_factory.mktemp("project") / f"results/newton-{own_release()}"
    results.mkdir(parents=True)
    for path in Project(own_release()).results.glob("poses.*"):
        shutil.copy(path, results)
    return results / "poses.json"


def tracked_mm(folder: Path, case: str, frame_count: int) -> float:
    """Return how far a tracked run has slipped after a number of frames."""
    from experiments.simulation.measurement import (
        SETUP_FRAME_COUNT,  # most tests do not need the simulator
    )

    moved = load_trace(folder / f"reproduction.{case}.csv.gz")[["x_mm", "y_mm", "z_mm"]]
    return float((moved.loc[frame_count - SETUP_FRAME_COUNT - 1] ** 2).sum() ** 0.5)


def contents(
    editions: Mapping[str, Edition], templates: Templates, release: str
) -> list[Content]:
    """Return the pages of one release as they are rendered without a site."""
    return contents_of(editions, release, templates)


def undrawn(parts: Sequence[Prose]) -> str:
    """Return the texts of some parts with their titles."""
    return "".join(f"<h2>{part.title}</h2>{part.body}" for part in parts)
