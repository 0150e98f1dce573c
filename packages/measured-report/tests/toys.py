"""Build a small report with one section, which is measured by hand and has the three
files of a section.
"""

import atexit
import gc
import importlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partialmethod
from pathlib import Path

import jinja2
import pytest
from current_columns import units_of
from jinja2.bccache import Bucket

import measured_report
from measured_report.changes.compare import Comparison, compare
from measured_report.commands.new import SKELETON
from measured_report.editions.project import Project
from measured_report.editions.status import states_of
from measured_report.files.atomic import locked
from measured_report.files.config import report
from measured_report.findings.editions import Edition, derive_edition
from measured_report.records.identity import identity_of
from measured_report.records.record import Record, write_record
from measured_report.records.traces import packed
from measured_report.site.build import build

gc.set_threshold(
    100_000, 50, 50
)  # by default, Python collects garbage a hundred times as often
atexit.register(gc.freeze)  # a collection at exit would take three seconds
os.fsync = (
    lambda _: None
)  # tests would wait for the disk thousands of times, although these files are temporary
GENERATOR, HERE = Path(measured_report.__file__).parents[1], Path(__file__).parent
os.environ["PYTHONPATH"] = (
    f"{GENERATOR}{os.pathsep}{HERE}"  # for the programs that the tests start
)
IS_WEEKLY = bool(os.environ.get("WORLDS"))
"""Whether to test all cases instead of the suite's sample, as the weekly workflow does.
"""
CACHE = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
KEPT = Path(
    os.environ.setdefault("CACHE_OF_TESTS", CACHE)
)  # shared by all runs of the tests
os.environ.setdefault(
    "UV_CACHE_DIR", str(KEPT / "uv")
)  # a new report's packages are already unpacked there
if (
    "PYTEST_XDIST_WORKER" not in os.environ
):  # the processes of one run share their derived results
    CACHES = tempfile.TemporaryDirectory(prefix="caches-")
    os.environ["XDG_CACHE_HOME"] = os.environ["TMPDIR"] = (
        CACHES.name
    )  # these tests do not wait for other measurements


class Compiled(jinja2.BytecodeCache):
    """Cache the compiled templates.

    All tests have the same layout, and compiling it takes a third of the time of a
    small site.
    """

    def __init__(self):
        self.buckets: dict[tuple, Bucket] = {}

    def get_bucket(self, environment, name, filename, source) -> Bucket:
        key = (
            environment.finalize,
            tuple(environment.extensions),
            name,
            filename,
            source,
        )
        return self.buckets.setdefault(key, Bucket(environment, str(key), ""))

    def set_bucket(self, bucket: Bucket) -> None:
        """Does nothing, because the template is cached already."""


jinja2.Environment.__init__ = partialmethod(
    jinja2.Environment.__init__, bytecode_cache=Compiled()
)

BY_HAND = {
    "machine": {
        "device": "cpu",
        "gpu": None,
        "driver": None,
        "cpu": "A processor",
        "python": "3.12.1",
    },
    "measured": {
        "date": "2026-01-02T03:04:05+00:00",
        "commit": "abc",
        "command": "make",
        "seconds": 1.5,
    },
}
"""Machine and author of the records that are made here."""

MODULE = """
from measured_report.parts.claim import Claim, at_least
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Figure, Section, Table
import pandas as pd

order = 1

def draw(trace):
    drawing, axes = new_figure()
    axes.plot(trace.value["time_s"], trace.value["x_mm"], label="x")
    axes.legend()
    return drawing

def derive(results):
    soft, stiff = results.rows[0], results.row["stiff"]
    gain = results.value("gain", "soft over stiff", lambda a, b: a / b, soft.slip_mm, stiff.slip_mm)
    bound = results.value("bound", "chosen", lambda: 10.0)
    trace = results.trace("stiff")
    rows = results.rows
    table = pd.DataFrame({"slip": [row.slip_mm for row in rows]}, index=[row.case for row in rows])
    return Section(
        tables={"cases": Table(table)},
        figures={"way": Figure(lambda: draw(trace), [trace], {"slip": stiff.slip_mm})},
        claims=[Claim("helps", at_least(gain, bound), {"gain": gain})],
    )
"""
TEMPLATE = """# A toy

{% claim helps %}
{% holds %} It helps {{ gain }} times.
{% fails %} It does not.
{% asks %} whether it helps
{% because %} Because it is stiff.
{% endclaim %}
Stiff is {{ row["stiff"].slip_mm }}.

{% figure way %} The way {% alt %} It moves {{ slip }}. {% endfigure %}

{% table cases %} All cases {% endtable %}
"""
SCENE = '''"""The scene."""

from dataclasses import dataclass


@dataclass
class Case:
    pad_ke: float = 1e4


ROBOT = "assets/robot.urdf"


def slip():
    """The slip in the toy scene."""
    return 1.0 if ROBOT else 0.0
'''
INSTALLED = {
    "newton": "1.4.0",
    "warp-lang": "1.15.0",
    "mujoco-warp": "3.10.0.3",
    "mujoco": "3.10.0",
}
"""Packages that count as installed while the toy is the current report.

An edition belongs to the first of them.
"""
CARDS = 'from measured_report.measuring.host import *\nKIND, NOUN = "cuda", "GPU"\n'
SETTINGS = """
edition = "newton"
packages = ["warp-lang", "mujoco-warp", "mujoco", "mujoco-core"]
implied = { mujoco-core = "mujoco" }
requirement = "newton[sim]"
edition_name = "Newton"
accelerator = "experiments.cards"
case = "experiments.scene:Case"
short_names = { warp-lang = "warp" }
baseline = "the scene as shipped"
repeating = { case = ["c"] }
pages = [{ name = "index", texts = ["front.md.j2", "story.md.j2"] }, { name = "cause" }, { name = "limits" }]
columns = [
    { kind = "setting", pattern = "frame_count|substeps" },
    { kind = "cost", pattern = "(frame_ms|ms_per_s)(_p[0-9]+)?" },
    { kind = "failure", pattern = "dropped|failure" },
    { unless = "dropped", resolution = 1e-3, signed = false, pattern = "slip_mm" },
    { better = "less", pattern = "slip_mm|frame_ms|dropped" },
    { signed = true, pattern = "growth_per_s" },
    { resolution = 1, pattern = ".*_count" },
]
[changes]
upgrade_sections = ["toy"]
package_groups = [["warp-lang"], ["mujoco-warp", "mujoco", "mujoco-core"]]
keys = ["case", "substeps", "worlds"]
endings = "classes"
settings = { option = "solver option" }
"""
REPORT = """
import sys
from pathlib import Path
from measured_report.editions.project import Project, own_release
from measured_report.records.code import cached_sources
from measured_report.site.build import build

with cached_sources():
    build(Project(sys.argv[2], root=Path(sys.argv[1]), own_release=own_release()))
sys.exit(bool({"warp", "newton", "mujoco"} & set(sys.modules)))
"""
"""Builds the site of a folder and a release, without importing the simulator."""
EXPERIMENT = """from experiments.scene import slip


def measure(conditions):
    return slip()
"""
ROWS = (
    {"case": "soft", "slip_mm": 6.3617, "dropped": False},
    {"case": "stiff", "slip_mm": 0.3124, "dropped": False},
)


@dataclass(frozen=True)
class Toy:
    """Provides the project and the actions of the tests on it."""

    project: Project

    @property
    def record_path(self) -> Path:
        return self.project.record_path("toy")

    @property
    def packages(self) -> dict[str, str]:
        return {**INSTALLED, "newton": self.project.release}

    @property
    def page_path(self) -> Path:
        """Return the page of its section, or the front page if no section is given."""
        path = self.project.site / "cause.html"
        return path if path.is_file() else self.project.site / "index.html"

    @property
    def page(self) -> str:
        return self.page_path.read_text(encoding="utf-8")

    @property
    def front(self) -> str:
        return (self.project.site / "index.html").read_text(encoding="utf-8")

    def write(self, name: str, text: str) -> None:
        put(self.project.root, name, text)
        forget_sections()

    def record(self, rows=ROWS, **changes) -> Record:
        fields = {
            "section": "toy",
            "identity": identity_of(
                "toy", self.project.profile, self.project.root, self.packages
            ),
            "units": units_of(rows),
            "rows": list(rows),
        }
        return Record(**{**BY_HAND, **fields, **changes})

    def measure(self, rows=ROWS, end_mm=0.3) -> None:
        traces = {
            "stiff": packed(
                self.record_path, "stiff", {"time_s": [0.0, 1.0], "x_mm": [0.0, end_mm]}
            )
        }
        write_record(self.record_path, self.record(rows), traces)

    def state(self):
        return next(
            state for state in states_of(self.project) if state.section == "toy"
        )

    def of(self, release: str) -> "Toy":
        """Return the same project with another Newton release."""
        return replace(self, project=self.project.of(release))

    def build(self) -> None:
        build(self.project)


def forget_sections() -> None:
    """Remove the modules of sections, so that they are imported again."""
    for name in [name for name in sys.modules if name.startswith("report.sections.")]:
        del sys.modules[name]
    importlib.invalidate_caches()


def put(folder: Path, name: str, text: str) -> None:
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text, encoding="utf-8")


def lay_out(folder: Path) -> None:
    """Write a report without a record."""
    put(folder, "report.toml", SETTINGS)
    put(
        folder,
        "pyproject.toml",
        f'[project]\ndependencies = ["newton[sim]=={INSTALLED["newton"]}"]\n',
    )
    for name, version in INSTALLED.items():
        put(
            folder,
            f"{name.replace('-', '_')}-{version}.dist-info/METADATA",
            f"Name: {name}\nVersion: {version}\n",
        )
    put(folder, "experiments/__init__.py", "")
    put(folder, "experiments/scene.py", SCENE)
    put(folder, "experiments/toy.py", EXPERIMENT)
    put(folder, "experiments/cards.py", CARDS)
    put(
        folder, "report/__init__.py", ""
    )  # otherwise a path of the tests with this package would come first
    put(folder, "report/sections/__init__.py", "")
    put(folder, "report/sections/toy.py", MODULE)
    put(folder, "templates/sections/toy.md.j2", TEMPLATE)
    put(
        folder,
        "templates/front.md.j2",
        "# A report\n\n{% for name in measured %}{{ name }}{% endfor %}\n",
    )
    put(folder, "templates/story.md.j2", "# The story\n")
    for page in ("cause", "limits"):
        put(folder, f"templates/pages/{page}.md.j2", f"# {page.capitalize()}\n")
    put(folder, "assets/robot.urdf", "<robot/>")
    put(folder, "build.py", (SKELETON / "build.py").read_text(encoding="utf-8"))
    put(folder, "CITATION.cff", "title: A toy\nauthors:\n  - name: Its authors\n")
    forget_sections()


def made_once(
    factory: pytest.TempPathFactory, name: str, make: Callable[[Path], None]
) -> Path:
    """Return the folder ``name``, which ``make`` fills once for all processes of this
    run of the tests.
    """
    own = factory.getbasetemp()
    base = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own
    (base / f"{name}.lock").mkdir(exist_ok=True)
    with locked(base / f"{name}.lock"):
        if not (base / name).exists():
            (base / name).mkdir()
            try:  # in its own folder, which is a part of the keys in the cache
                make(base / name)
            except BaseException:
                shutil.rmtree(base / name)
                raise
    return base / name


def program(
    *arguments: str | Path, cwd: Path | None = None, **environment: str
) -> subprocess.CompletedProcess:
    """Return the output of a Python program and its exit status."""
    command, environment = [sys.executable, *arguments], {**os.environ, **environment}
    folder = cwd or report().root
    return subprocess.run(
        command,
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def link(root: Path, *names: str) -> None:
    """Copy entries of the checkout with these names into a folder."""
    for name in names:
        (root / name).symlink_to(report().root / name)


def killed_at(
    stop: int, changes: Callable[[str, tuple], bool], work: Callable[[], object]
) -> int:
    """Run a function in a process that is killed before one of its steps that change a
    file. Return how the process ended.
    """
    child = os.fork()
    if not child:
        steps = iter(range(stop))

        def step(event: str, arguments: tuple) -> None:
            if changes(event, arguments) and next(steps, None) is None:
                os.kill(os.getpid(), signal.SIGKILL)

        sys.addaudithook(step)
        work()
        os._exit(0)
    return os.waitpid(child, 0)[1]


def derived(project: Project) -> Edition:
    return derive_edition(project)


def compared(*projects: Project) -> Comparison:
    return compare(*map(derive_edition, projects))


def git(folder: Path, *command: str) -> str:
    who = [
        "-c",
        "user.name=A",
        "-c",
        "user.email=a@example.org",
        "-c",
        "commit.gpgsign=false",
    ]
    done = subprocess.run(
        ["git", "-C", folder, *who, *command],
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.strip()
