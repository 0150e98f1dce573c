"""A small project of its own: one section, measured by hand, in the three files that a section takes."""

import atexit
import gc
import importlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partialmethod
from pathlib import Path

import jinja2
import pytest
import warp as wp
from hypothesis import settings
from jinja2.bccache import Bucket
from markupsafe import Markup

import report.sections
from measured_report.changes.compare import Comparison, compare
from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.files.atomic import locked
from measured_report.files.cache import Cache
from measured_report.files.root import ROOT
from measured_report.findings.cache import DerivedCache
from measured_report.findings.editions import Edition, derive_edition
from measured_report.pages.editions import WordedEdition, worded_editions
from measured_report.pages.prose import Prose, Templates
from measured_report.records.code import cached_sources, unchanged_files
from measured_report.records.columns import units_of
from measured_report.records.identity import identity_of, package_versions
from measured_report.records.record import Record, write_record
from measured_report.records.traces import load_trace, packed
from measured_report.site.build import build
from measured_report.site.pages import Content, contents_of, links_of

gc.set_threshold(100_000, 50, 50)  # by itself Python looks for rings of garbage a hundred times as often
atexit.register(gc.freeze)  # nor has it to look at the end, for three seconds
wp.config.enable_backward = False  # before kernels are imported, of which gradients are half of what is compiled
INSTALLED = package_versions()
IMPORTED = (ROOT, *(ROOT / "packages").iterdir(), ROOT / "tests")
os.environ["PYTHONPATH"] = os.pathsep.join(map(str, IMPORTED))  # of the programs that the tests start
KEPT = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")  # from one run of the tests to the next
# To compile the kernels takes minutes, and Warp tells what has changed.
os.environ.setdefault("WARP_CACHE_PATH", str(KEPT / "warp-of-tests"))
os.environ.setdefault("UV_CACHE_DIR", str(KEPT / "uv"))  # a new report's packages are unpacked there already
if "PYTEST_XDIST_WORKER" not in os.environ:  # the processes of one run share what they derive of the tracked results
    CACHES = tempfile.TemporaryDirectory(prefix="caches-")
    os.environ["XDG_CACHE_HOME"] = CACHES.name
settings.register_profile("project", deadline=None, derandomize=True)  # the same every time, however slow the machine
settings.load_profile("project")


class Compiled(jinja2.BytecodeCache):
    """Keep each template compiled: the layout is the same in all tests, and a third of what a small site takes."""

    def __init__(self):
        self.buckets: dict[tuple, Bucket] = {}

    def get_bucket(self, environment, name, filename, source) -> Bucket:
        key = environment.finalize, tuple(environment.extensions), name, filename, source
        return self.buckets.setdefault(key, Bucket(environment, str(key), ""))

    def set_bucket(self, bucket: Bucket) -> None:
        """Nothing: it is kept already."""


jinja2.Environment.__init__ = partialmethod(jinja2.Environment.__init__, bytecode_cache=Compiled())

BY_HAND = {
    "machine": {"device": "cpu", "gpu": None, "driver": None, "cpu": "A processor", "python": "3.12.1"},
    "measured": {"date": "2026-01-02T03:04:05+00:00", "commit": "abc", "command": "make", "seconds": 1.5},
}
"""What a record made here says of who measured it."""

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

ROBOT = "assets/robot.urdf"


def slip():
    """How far it slips."""
    return 1.0 if ROBOT else 0.0
'''
needs_boxes_in_c = pytest.mark.skipif(
    INSTALLED["mujoco"].startswith("3.11."),
    reason="MuJoCo 3.11 in C finds contacts 75 mm deep between boxes that are 30 mm apart",
)
"""For a shake through MuJoCo's C engine. Release 1.5 comes with it; seen in fixed_scene.py, as the hand comes down."""
REPORT = """
import sys
from pathlib import Path
from measured_report.editions.project import Project, own_release
from measured_report.site.build import build

build(Project(sys.argv[2], root=Path(sys.argv[1]), own_release=own_release()))
sys.exit(bool({"warp", "newton", "mujoco"} & set(sys.modules)))
"""
"""Builds the site of a folder and a release; what builds it must not import the simulator."""
EXPERIMENT = """from experiments.scene import slip


def measure(conditions):
    return slip()
"""
SOURCES = ("packages", "experiments", "report", "templates", "assets", "pyproject.toml", "report.toml")
ROWS = ({"case": "soft", "slip_mm": 6.3617, "dropped": False}, {"case": "stiff", "slip_mm": 0.3124, "dropped": False})


@dataclass(frozen=True)
class Toy:
    """The project and what the tests do with it."""

    project: Project

    @property
    def record_path(self) -> Path:
        return self.project.record_path("toy")

    @property
    def packages(self) -> dict[str, str]:
        return {**INSTALLED, "newton": self.project.release}

    @property
    def page_path(self) -> Path:
        """The page of its section; the front page where that is left out."""
        path = self.project.site / "cause.html"
        return path if path.is_file() else self.project.site / "index.html"

    @property
    def page(self) -> str:
        return self.page_path.read_text(encoding="utf-8")

    @property
    def front(self) -> str:
        return (self.project.site / "index.html").read_text(encoding="utf-8")

    def write(self, name: str, text: str) -> None:
        path = self.project.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        forget_sections()

    def record(self, rows=ROWS, **changes) -> Record:
        fields = {
            "section": "toy",
            "identity": identity_of("toy", self.project.profile, self.project.root, self.packages),
            "units": units_of(rows),
            "rows": list(rows),
        }
        return Record(**{**BY_HAND, **fields, **changes})

    def measure(self, rows=ROWS, end_mm=0.3) -> None:
        traces = {"stiff": packed(self.record_path, "stiff", {"time_s": [0.0, 1.0], "x_mm": [0.0, end_mm]})}
        write_record(self.record_path, self.record(rows), traces)

    def state(self):
        return next(state for state in states_of(self.project) if state.section == "toy")

    def of(self, release: str) -> "Toy":
        """The same project with another Newton release."""
        return replace(self, project=self.project.of(release))

    def build(self) -> None:
        build(self.project)


def forget_sections() -> None:
    """Let the modules of sections be imported anew."""
    for name in [name for name in sys.modules if name.startswith("report.sections.")]:
        del sys.modules[name]
    importlib.invalidate_caches()


@pytest.fixture
def toy(tmp_path, monkeypatch) -> Iterator[Toy]:
    """The project; its sections are imported before the real ones of the same name."""
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # a file changes here within the second that a cache tells
    folder = str(tmp_path / "project" / "report" / "sections")
    monkeypatch.setattr(report.sections, "__path__", [folder, *report.sections.__path__])
    toy = Toy(Project("1.4.0", root=tmp_path / "project"))
    toy.write("experiments/__init__.py", "")
    toy.write("experiments/scene.py", SCENE)
    toy.write("experiments/toy.py", EXPERIMENT)
    toy.write("report/sections/toy.py", MODULE)
    toy.write("templates/sections/toy.md.j2", TEMPLATE)
    toy.write("templates/front.md.j2", "# A report\n\n{% for name in sections %}{{ name }}{% endfor %}\n")
    toy.write("templates/story.md.j2", "# The story\n")
    toy.write("assets/robot.urdf", "<robot/>")
    shutil.copytree(ROOT / "templates" / "pages", toy.project.templates / "pages")
    toy.measure()
    yield toy
    forget_sections()


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


def made_once(factory: pytest.TempPathFactory, name: str, make: Callable[[Path], None]) -> Path:
    """The folder ``name`` that ``make`` fills, for all processes of this run of the tests together."""
    own = factory.getbasetemp()
    base = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own
    (base / f"{name}.lock").mkdir(exist_ok=True)
    with locked(base / f"{name}.lock"):
        if not (base / name).exists():
            (base / name).mkdir()
            try:  # in its own place, by which the cache knows what was derived there
                make(base / name)
            except BaseException:
                shutil.rmtree(base / name)
                raise
    return base / name


SIMULATING = ("tests/experiments", "tests/newton_lint/newton_models")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the files whose tests are the slowest, so that no process ends long after the others.

    Of those that simulate one is the first: the others wait until it has compiled the kernels; so do those that read
    the tracked site, which it builds.
    """
    slow = Counter(item.path for item in items for _ in item.iter_markers("slow"))
    simulating = {path for path in slow if any(path.is_relative_to(ROOT / each) for each in SIMULATING)}
    waiting = simulating | {item.path for item in items if "site" in item.fixturenames}
    first = max(sorted(simulating), key=slow.get, default=None)
    items.sort(key=lambda item: (item.path != first, not slow[item.path], item.path in waiting, -slow[item.path]))
    for item in items:
        if any(item.path.is_relative_to(ROOT / path) for path in SIMULATING):
            item.fixturenames.insert(0, "kernels")


@pytest.fixture(scope="session")
def kernels(tmp_path_factory) -> None:
    """Those of the scene, compiled once for all processes of this run of the tests."""

    def make(_: Path) -> None:
        from experiments.simulation.host import compile_first

        compile_first(wp.get_device("cpu"))

    made_once(tmp_path_factory, "kernels", make)


@pytest.fixture(scope="session")
def site(tmp_path_factory) -> Path:
    """The site of what is tracked, apart from the checkout's own."""

    def make(root: Path) -> None:
        link(root, "results", *SOURCES)
        done = program("-c", REPORT, root, own_release())
        assert done.returncode == 0, done.stderr

    return made_once(tmp_path_factory, "tracked", make) / "site"


@pytest.fixture(scope="session")
def editions(site) -> Mapping[str, WordedEdition]:
    """What the tracked results of every release make, as it was kept when their site was built."""
    project = Project(own_release(), root=site.parent)
    with cached_sources(project.root), unchanged_files():
        return worded_editions(project, Templates(project.templates), DerivedCache(project.root))


@pytest.fixture(scope="module")
def unchanged() -> Iterator[None]:
    """Look at each source once for all tests of a module, of which none changes any."""
    with unchanged_files():
        yield


@pytest.fixture(scope="session")
def poses_path(tmp_path_factory) -> Path:
    """A copy of the tracked record of section poses, with its traces."""
    results = tmp_path_factory.mktemp("project") / f"results/newton-{own_release()}"
    results.mkdir(parents=True)
    for path in Project(own_release()).results.glob("poses.*"):
        shutil.copy(path, results)
    return results / "poses.json"


def program(*arguments: str | Path, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess:
    """What a program in Python says, and how it ends."""
    command, environment = [sys.executable, *arguments], {**os.environ, **environment}
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False)


def tracked_mm(folder: Path, case: str, frame_count: int) -> float:
    """How far a tracked run had slipped after so many frames."""
    from experiments.simulation.measurement import SETUP_FRAME_COUNT  # most tests need no simulator

    moved = load_trace(folder / f"reproduction.{case}.csv.gz")[["x_mm", "y_mm", "z_mm"]]
    return float((moved.loc[frame_count - SETUP_FRAME_COUNT - 1] ** 2).sum() ** 0.5)


def link(root: Path, *names: str) -> None:
    """Give a folder what the checkout has of these names."""
    for name in names:
        (root / name).symlink_to(ROOT / name)


def killed_at(stop: int, changes: Callable[[str, tuple], bool], work: Callable[[], object]) -> int:
    """Do something in a process that is killed before one of its steps that change something; how it ended."""
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


def contents(editions: Mapping[str, Edition], templates: Templates, release: str) -> list[Content]:
    """The pages of one release as they are without a site."""
    return contents_of(editions[release], templates, links_of(editions, dict.fromkeys(editions, ""), release))


def undrawn(parts: Sequence[Prose]) -> str:
    """The words of some parts; of a figure those below it."""
    figure = Markup("<figure><figcaption>{}</figcaption></figure>")
    shown = (
        {each.anchor: figure.format(each.wording("caption", each.numbers)) for each in part.figures} for part in parts
    )
    return "".join(f"<h2>{part.title}</h2>{part.html(figures)}" for part, figures in zip(parts, shown, strict=True))


def compared(*projects: Project) -> Comparison:
    with unchanged_files():
        return compare(*map(derive_edition, projects))


@pytest.fixture
def log(tmp_path) -> Path:
    """The log of the batches without physics."""
    path = tmp_path / "log"
    path.touch()
    return path


def git(folder: Path, *command: str) -> str:
    who = ["-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"]
    done = subprocess.run(["git", "-C", folder, *who, *command], capture_output=True, text=True, check=True)
    return done.stdout.strip()


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
