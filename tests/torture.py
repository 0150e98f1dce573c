"""What is too slow for the tests: kills, full disks, damage, hostile words and odd places, on a copy of the project.

``python -m tests.torture`` writes how it went into docs/reliability.md; ``--moments`` says how many kills there are of
each kind, ``--only`` which trials are run. What was tried of this commit is kept: a run that is stopped goes on where
it was, and the page has what was tried so far, of this commit or before. ``--again`` begins anew.
"""

import argparse
import itertools
import os
import platform
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from datetime import datetime, timezone
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), *map(str, (ROOT / "packages").iterdir()), str(ROOT / "tests")]

from alterations import alterations  # noqa: E402
from batches import is_running  # noqa: E402
from damage import RECORD_WAYS, TRACE_WAYS, damage  # noqa: E402
from torture_study import studies  # noqa: E402

from measured_report.files.atomic import RecordError, is_own_file, remove  # noqa: E402
from measured_report.files.cache import FOLDER as CACHE  # noqa: E402
from measured_report.files.cache import Cache  # noqa: E402
from measured_report.records.identity import files_digest  # noqa: E402
from measured_report.records.reading import load_record  # noqa: E402
from measured_report.site.check import check_site  # noqa: E402

KEPT = "torture"
"""What was tried so far is kept as this, each trial by itself, so that several processes can try at once."""
REPORT = ROOT / "docs" / "reliability.md"
FOLDERS = ("experiments", "report", "packages", "templates", "assets", "tests", "docs")
RELEASE = "1.5.0"
SECTIONS = ("noise", "reproduction", "gap")
"""Its records that the copy has: of each kind of thing that a page shows there is one, and it is built in seconds."""
PROBE = {
    "experiments/probe.py": """import time
from experiments.simulation.measurement import Conditions, Measurement


def measure(conditions: Conditions) -> Measurement:
    time.sleep(1.0)
    rows = [{"case": "probe", "slip_mm": 1.0}]
    return Measurement(rows, {f"probe-{number}": {"time_s": [0.0, 1.0], "x_mm": [0.0, 1.0]} for number in range(20)})
""",
    "report/sections/probe.py": """from measured_report.parts.section import Section

order = 999


def derive(results):
    return Section()
""",
    "templates/sections/probe.md.j2": "# A probe\\n\\nIt slips {{ rows[0].slip_mm }}.\\n",
}
"""A section that takes a second to measure, with traces enough to be hit while they are put in place."""


@dataclass
class Trial:
    """How often something was tried, and what went wrong."""

    name: str
    tried: int = 0
    wrong: list[str] = field(default_factory=list)
    of: int = 0
    """How often it is to be tried, where that is known before."""
    commit: str = ""
    date: str = ""
    is_whole: bool = True
    """Whether nothing is left to try."""

    def __call__(self, what: str, *problems: str) -> None:
        self.tried += 1
        found = ["; ".join(problem.split("\n")) for problem in problems if problem]
        self.wrong += [f"{what}: {', '.join(found)}"] if found else []


@dataclass(frozen=True)
class World:
    """A copy of the project."""

    root: Path

    @classmethod
    def made(cls, root: Path, records: Mapping[str, Collection[str]], files: Mapping[str, str]) -> "World":
        """Copy it, with these records of each release, of which none named are all, and further files by their text."""
        root.mkdir(parents=True)
        for name in FOLDERS:
            shutil.copytree(ROOT / name, root / name)
        for path in ROOT.glob("[!.]*"):
            if path.is_file():
                shutil.copy(path, root / path.name)
        for release, sections in records.items():
            results = f"results/newton-{release}"
            (root / results).mkdir(parents=True)
            for path in (ROOT / results).iterdir():
                if path.suffix == ".toml" or not sections or path.name.partition(".")[0] in sections:
                    shutil.copy(path, root / results)
        (root / "site").mkdir()
        for name, text in files.items():
            (root / name).write_text(text.replace("\\n", "\n"), encoding="utf-8")
        return cls(root)

    def command(self, *arguments: str) -> list[str]:
        return [sys.executable, "build.py", *arguments]

    def execute(self, *command: str | Path, **options) -> subprocess.CompletedProcess:
        """Run it to its end, or to the end of its time, which is a status of its own: 124, as timeout(1) has it."""
        usual = {"cwd": self.root, "capture_output": True, "text": True, "check": False, "timeout": 600}
        try:
            return subprocess.run(command, **usual | options)
        except subprocess.TimeoutExpired as late:
            return subprocess.CompletedProcess(command, 124, "", f"no end after {late.timeout:g} s")

    def run(self, *arguments: str, **options) -> subprocess.CompletedProcess:
        return self.execute(*self.command(*arguments), **options)

    def mounted(self, script: str, *arguments: str, **options) -> subprocess.CompletedProcess:
        """Run a script of the shell that ends in the command, with mounts of its own."""
        return self.execute("unshare", "-m", "sh", "-c", script, "sh", *self.command(*arguments), **options)

    def start(self, *arguments: str) -> subprocess.Popen:
        """Start it as a group of processes of its own."""
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        return subprocess.Popen(self.command(*arguments), cwd=self.root, start_new_session=True, **pipes)

    def records(self) -> Iterator[Path]:
        return (self.root / "results" / f"newton-{RELEASE}").glob("*.json")

    def problems(self) -> list[str]:
        """What is not whole: the site, and the records with their traces."""
        found = check_site(self.root / "site") if (self.root / "site" / "index.html").exists() else ["there is no site"]
        for path in self.root.glob("results/**/newton-*/*.json"):
            try:
                load_record(path)
            except RecordError as error:
                found.append(str(error))
        # The page of the probe alone, which is quick, has no claims.
        return [problem for problem in found if "no claim" not in problem][:2]

    def site(self) -> str:
        """Digest of all that the site has."""
        return files_digest((self.root / "site").rglob("*"), self.root)

    def leftovers(self) -> list[str]:
        """Files and processes that a run has left behind."""
        hidden = [*self.root.glob(".site-*"), *self.root.glob("results/**/.*"), *self.root.glob(f"{CACHE}/*.part")]
        hidden += self.root.parent.glob(".www.versions/*-*")
        found = [str(path.relative_to(self.root.parent)) for path in hidden]
        return [f"left: {name}" for name in found] + [f"process {number} still runs" for number in self.processes()]

    def processes(self) -> list[int]:
        found = []
        for place in Path("/proc").glob("[0-9]*/cwd"):
            number = int(place.parent.name)
            with suppress(OSError):
                found += [number] * (place.resolve() == self.root and number != os.getpid() and is_running(number))
        return found


PAGE = ("page", "--newton", RELEASE)
RERUN = ("rerun", "--section", "probe", "--device", "cpu", "--profile", "quick")


def one_line(done: subprocess.CompletedProcess, status: int | None = None) -> list[str]:
    """What is wrong with how a program ended that had to refuse something."""
    lines = [line for line in done.stderr.splitlines() if line.strip() and not line.startswith(("make: ", "waiting"))]
    found = ["traceback"] if "Traceback" in done.stderr + (done.stdout or "") else []
    found += [f"status {done.returncode}, not {status}"] if status is not None and done.returncode != status else []
    return found + ([] if len(lines) == 1 else [f"{len(lines)} lines: {' / '.join(lines)[:200]}"])


def kills(world: World, trial: Trial, moments: int, arguments: Sequence[str], after: Sequence[str]) -> Iterator[Trial]:
    """Of a command, at moments spread over the time that it takes; ``after`` is what finishes it."""
    name = arguments[0]
    trial.name = f"{name}{' from nothing' * (name == 'page')}, killed "
    trial.name += "(SIGKILL, SIGTERM, SIGINT; the whole group or the main process alone)"
    world.run(*PAGE)
    whole, took = world.site(), 0.0
    for number in range(trial.tried, moments):
        if number % 10 == 0 or not took:  # how long it takes depends on what else this machine does
            start = time.monotonic()
            world.run(*_begun(world, arguments))
            took = time.monotonic() - start
            world.run(*after)
        sent, group = WAYS[number % len(WAYS)]
        share = (number + 0.5) / moments
        running, took = at_its_moment(lambda: world.start(*_begun(world, arguments)), took, share)
        stopped = time.monotonic()
        os.killpg(running.pid, sent) if group else running.send_signal(sent)
        said = running.communicate()[1]
        slow = time.monotonic() - stopped
        found = ["traceback"] if "Traceback" in said else []
        found += [f"Ctrl-C took {slow:.1f} s"] if sent == signal.SIGINT and slow > 2.0 else []
        found += [f"half: {problem}" for problem in world.problems()] if name != "rerun" else []
        finished = world.run(*after)
        time.sleep(0.2)
        found += [f"next run: {finished.stderr[-200:]}"] if finished.returncode else []
        found += world.leftovers() + world.problems()
        found += [] if world.site() == whole else ["another site"]
        found += check_site(world.root.parent / "www")[:1] if name == "publish" else []
        trial(f"{name} {sent.name} after {share:.0%} of it{' (group)' if group else ''}", *found)
        yield trial


WAYS = tuple(itertools.product((signal.SIGKILL, signal.SIGTERM, signal.SIGINT), (True, False)))
"""How a process is ended, and whether all that it started is as well."""


def at_its_moment(begin: Callable[[], subprocess.Popen], took: float, share: float) -> tuple[subprocess.Popen, float]:
    """Begin what takes so long until it runs after that share of it; what ends before was not hit, and took less."""
    while True:
        running, start = begin(), time.monotonic()
        try:
            running.communicate(timeout=took * share)
            took = time.monotonic() - start
        except subprocess.TimeoutExpired:
            return running, took


def _begun(world: World, arguments: Sequence[str]) -> Sequence[str]:
    """The command; where it is a page nothing is kept of what was made before, so that there is more to be hit."""
    if arguments == PAGE:
        remove(world.root / CACHE)
    return arguments


def publish_to(world: World) -> tuple[str, ...]:
    return "publish", "--target", f"dir:{world.root.parent / 'www'}"


def writers(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """Two at once."""
    trial.name = "two writers at once (the same, report beside rerun, publish beside report)"
    publish = publish_to(world)
    for pair in ((PAGE, PAGE), (RERUN, RERUN), (PAGE, RERUN), (PAGE, publish), (publish, publish)):
        world.run(*PAGE)
        both = [world.start(*one) for one in pair]
        said = [one.communicate()[1] for one in both]
        ended = zip(both, said, strict=True)
        found = [f"status {one.returncode}: {text[-200:]}" for one, text in ended if one.returncode]
        trial(" beside ".join(one[0] for one in pair), *found, *world.leftovers(), *world.problems())
    world.run(*PAGE)
    yield trial


MOUNTS = {
    # A file of its own that leaves no room, found by whoever writes below the place.
    "full": "mount -t tmpfs -o size=256k none /mnt && mkdir /mnt/u /mnt/w && "
    "mount -t overlay none -o lowerdir={0},upperdir=/mnt/u,workdir=/mnt/w {0} && "
    "{{ dd if=/dev/zero of=/mnt/fill bs=1k 2>/dev/null; cd $PWD; }}",
    "read-only": "mount --bind {0} {0} && mount -o remount,ro,bind {0} && cd $PWD",
}
"""How a place is made so, in a shell that has its own mounts."""


def disks(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """Full and read-only places, each a file system of its own in a namespace of mounts."""
    trial.name = "disk full, and read-only (results, site, publishing target, TMPDIR)"
    if world.execute("unshare", "-m", "true").returncode:
        trial.name += ": not tried, for that takes the right to mount"
        yield trial
        return
    target, temporary = world.root.parent / "full", world.root.parent / "tmp"
    results = world.root / "results/quick"
    publish = ("publish", "--target", f"dir:{target}/www")
    world.run(*PAGE)
    for folder in (target, temporary, results):
        folder.mkdir(exist_ok=True)
    for (kind, mount), (place, arguments) in itertools.product(
        MOUNTS.items(), ((results, RERUN), (world.root, PAGE), (target, publish), (temporary, publish))
    ):
        _begun(world, arguments)
        before, environment = world.site(), {**os.environ, "TMPDIR": str(temporary)}
        done = world.mounted(f'{mount.format(place)}; exec "$@"', *arguments, env=environment)
        found = [*one_line(done), "" if done.returncode else "status 0"]
        found += [] if world.site() == before else ["another site"]
        if place == temporary and not done.returncode:
            found = []  # Python has found another folder for what is temporary
        trial(f"{kind} {place.name}, {arguments[0]}", *found, *world.problems(), *world.leftovers())
    yield trial


WORDS = (
    "'", '"', "$(touch {0})", "`touch {0}`", "$$(touch {0})", "$(shell touch {0})", "; touch {0}", "&& touch {0}",
    "| touch {0}", "\n touch {0}", "../../etc/passwd", "--help", "-x", "\u202etext", "x" * 5000,
)  # fmt: skip
VARIABLES = {
    "SECTION": ("rerun", "DEVICE=cpu"),
    "CLUSTER": ("report", "DEVICE=cpu", "PROFILE=quick"),
    "NEWTON": ("status",),
    "DEVICE": ("report",),
    "PROFILE": ("status",),
    "A": ("diff", "B=1.5.0"),
    "B": ("diff", "A=1.5.0"),
    "TARGET": ("publish",),
    "PORT": ("serve",),
}


def inputs(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """Words that no variable of make should be."""
    trial.name = "bad words for make's variables: status 2, one line, nothing executed"
    canary = world.root.parent / "canary"
    for (variable, (target, *others)), word in itertools.product(VARIABLES.items(), WORDS):
        given = f"{variable}={word.format(canary)}"
        done = world.execute("make", "--silent", target, f"PYTHON={sys.executable}", given, *others, timeout=120)
        executed = ["executed"] if canary.exists() else []
        canary.unlink(missing_ok=True)
        trial(given[:60].replace("\n", " "), *one_line(done, 2), *executed)
    yield trial


@contextmanager
def damaged(path: Path, way: str) -> Iterator[bool]:
    """Damage a record or a trace for a while; false where it has nothing to damage in that way."""
    content = path.read_bytes()
    try:
        damage(path, way)
        is_damaged = not (is_own_file(path) and path.stat().st_size == len(content) and path.read_bytes() == content)
    except (KeyError, TypeError):
        is_damaged = False
    yield is_damaged
    remove(path)
    path.write_bytes(content)


NOT_SEALED = ("traces", "seal", "digest", "row count", "unit of no", "number without")
SEALED_WAYS = [way for way in RECORD_WAYS if not way.startswith(tuple(f"field: {name}" for name in NOT_SEALED))]
"""Ways to damage a record from before traces were sealed: it has no seals, and lacks what others may not."""


def shown_damages(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """Some of them, and damaged traces, on the page."""
    trial.name = "pages with damaged records and traces: the rest stands, status 1"
    records = itertools.cycle(path for path in sorted(world.records()) if path.name != "noise.json")
    shown = list(zip(records, random.Random(1).sample(SEALED_WAYS, 6), strict=False))
    trace = next((world.root / "results" / f"newton-{RELEASE}").glob("reproduction.*.gz"))
    names = ("half", "not packed", "a pipe", "a link to a password file")
    shown += [(trace, way) for way in TRACE_WAYS if way.endswith(names)]
    for path, way in shown:
        with damaged(path, way) as is_damaged:
            if is_damaged:
                done = world.run(*PAGE)
                found = check_site(world.root / "site")[:1] + (["traceback"] if "Traceback" in done.stderr else [])
                trial(f"{path.name}, {way}", *found, "" if done.returncode == 1 else f"status {done.returncode}")
    yield trial


def places(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """Odd ones."""
    trial.name = "odd places and settings: the page is built from nothing"
    odd = World(world.root.parent / "a b é ´' $x" / "project")
    odd.root.parent.mkdir()
    shutil.copytree(world.root, odd.root)
    settings = {
        "spaces, quotes and non-ASCII in the path": (odd, {}),
        "LC_ALL=C, output in ASCII": (odd, {"LC_ALL": "C", "PYTHONIOENCODING": "ascii"}),
        "no git, no PATH": (world, {"PATH": "/nowhere"}),
        "PYTHONSAFEPATH": (world, {"PYTHONSAFEPATH": "1"}),
        "another time zone": (world, {"TZ": "Pacific/Kiritimati"}),
        "another hash seed": (world, {"PYTHONHASHSEED": "7"}),
        "no HOME": (world, {"HOME": "/proc/nowhere"}),
    }
    rc = world.root.parent / "matplotlibrc"
    rc.write_text("text.usetex: True\nfont.size: 40\n")
    settings["a matplotlibrc with usetex"] = (world, {"MATPLOTLIBRC": str(rc)})
    pages = set()
    for name, (place, changed) in settings.items():
        done = place.run(*_begun(place, PAGE), env={**os.environ, **changed})
        pages.add((place.root / "site/index.html").read_bytes())
        trial(name, "" if not done.returncode else done.stderr[-200:])
    trial("all these pages are the same bytes", "" if len(pages) == 1 else f"{len(pages)} different ones")
    for name, script in {
        "site/ is a mount point": 'mount -t tmpfs none site; exec "$@"',
        "the output is closed": 'exec "$@" >&-',
        "umask 077": 'umask 077; exec "$@"',
    }.items():
        done = world.mounted(script, *PAGE)
        trial(name, "" if not done.returncode else done.stderr[-200:])
    with open("/dev/full", "w") as full:  # noqa: PTH123
        done = world.run("status", capture_output=False, stdout=full, stderr=subprocess.PIPE)
    trial("the output is full", *one_line(done, 1))
    yield trial


def setups(world: World, trial: Trial, moments: int) -> Iterator[Trial]:
    """The first set-up, killed."""
    trial.name = "the first set-up, killed (SIGKILL, SIGTERM, SIGINT of the whole group): the next make finishes it"
    place = World(world.root.parent / "setup")
    shutil.copytree(world.root, place.root)
    command = ["make", "--silent", "status"]

    def begun() -> subprocess.Popen:
        remove(place.root / ".venv")
        nowhere = subprocess.DEVNULL
        return subprocess.Popen(command, cwd=place.root, start_new_session=True, stdout=nowhere, stderr=nowhere)

    start = time.monotonic()
    begun().wait()
    took = time.monotonic() - start
    whole = installed(place.root)
    place.execute(place.root / ".venv/bin/python", "-c", "import newton, matplotlib", check=True)
    for number in range(trial.tried, moments):
        sent = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)[number % 3]
        share = (number + 0.5) / moments
        running, took = at_its_moment(begun, took, share)
        os.killpg(running.pid, sent)
        running.wait()
        done = place.execute(*command, timeout=None)
        left = [path.name for path in place.root.glob(".venv.*")]
        lacking = whole.items() - installed(place.root).items()
        lacks = f"{len(lacking)} files are missing or others: {min(lacking)[0]}" if lacking else ""
        trial(f"{sent.name} after {share:.0%} of it", done.stderr[-200:] if done.returncode else "", *left, lacks)
        yield trial


def installed(root: Path) -> dict[str, int]:
    """Sizes of the files of the environment, but for what Python writes when it runs."""
    folder = root / ".venv"
    paths = (path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return {str(path.relative_to(folder)): path.stat().st_size for path in paths}


TRIALS: dict[str, Callable[[World, Trial, int], Iterator[Trial]]] = {
    "publish": lambda world, *rest: kills(world, *rest, publish_to(world), publish_to(world)),
    "page": lambda *rest: kills(*rest, PAGE, PAGE),
    "setups": setups,
    "rerun": lambda *rest: kills(*rest, RERUN, PAGE),
    "writers": writers,
    "disks": disks,
    "shown": shown_damages,
    "alterations": lambda *rest: alterations(*rest, RELEASE),
    "places": places,
    "studies": studies,
    "inputs": inputs,
}
"""Each goes on where a trial is, and yields it whenever it got farther."""
COUNTED = {"page": 1, "rerun": 1, "publish": 1, "setups": 1, "studies": 1, "alterations": 20}
"""Those that go on in the middle, and how often each is tried for a moment; the others begin anew."""


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.torture", description=__doc__)
    parser.add_argument("--moments", type=int, default=50, help="kills of each kind")
    parser.add_argument("--only", nargs="*", choices=TRIALS, default=list(TRIALS), help="trials to run")
    parser.add_argument("--again", action="store_true", help="forget what was tried of this commit before")
    arguments = parser.parse_args()
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # what is started is started a thousand times
    key = commit()
    with tempfile.TemporaryDirectory(prefix="torture-") as folder:
        world = World.made(Path(folder).resolve() / "project", {RELEASE: SECTIONS}, PROBE)
        for name in arguments.only:
            trial = None if arguments.again else _kept(name)
            if not trial or trial.commit != key or not (trial.is_whole or name in COUNTED):
                trial = Trial(name, commit=key)
            elif trial.is_whole and trial.tried >= arguments.moments * COUNTED.get(name, 0):
                continue
            trial.is_whole, trial.of = False, arguments.moments * COUNTED.get(name, 0)
            for _ in TRIALS[name](world, trial, arguments.moments):
                _keep(name, trial)
            trial.is_whole = True
            _keep(name, trial)
            print(f"{trial.tried - len(trial.wrong):4} of {trial.tried:4}  {trial.name}", flush=True)
            for wrong in trial.wrong:
                print(f"      {wrong}", flush=True)
    print(f"wrote {REPORT.relative_to(ROOT)}")
    return int(any(trial.wrong for name in TRIALS if (trial := _kept(name))))


def commit() -> str:
    """The commit, and whether anything but the page of these trials differs from it."""
    head = _git("rev-parse", "--short=12", "HEAD") or "unknown"
    changed = _git("status", "--porcelain", "--", ".", ":!docs/reliability.md")
    return f"{head}-dirty" if changed else head


def _git(*arguments: str) -> str:
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()


def _kept(name: str) -> Trial | None:
    return Cache(ROOT).get(f"{KEPT}.{name}", KEPT)


def _keep(name: str, trial: Trial) -> None:
    """Keep how far a trial is, and say on the page how far all are."""
    trial.date = f"{datetime.now(timezone.utc):%Y-%m-%d %H:%M}"
    Cache(ROOT).put(f"{KEPT}.{name}", KEPT, trial)
    write_report()


HEAD = """# Reliability

What was tried against the project from outside, and how often it held. `python -m tests.torture` writes this page;
each line says of which commit it is.

{machine}.

| trial | tried | times | wrong | commit | until (UTC) |
|---|---|---|---|---|---|"""


def write_report() -> None:
    """Write the page: what is kept of each trial, and of the others what the page said before."""
    kept = {name: _kept(name) for name in TRIALS}
    rows, wrong = [], []
    for name, trial in kept.items():
        rows += [_row(name, trial)] if trial else _said(f"| {name} ")[:1]
        wrong += [f"- {name}: {each} ({trial.commit})" for each in trial.wrong] if trial else _said(f"- {name}: ")
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}"
    foot = ["", "What went wrong:", "", *wrong] if wrong else []
    REPORT.write_text("\n".join([HEAD.format(machine=machine), *rows, *foot, ""]), encoding="utf-8")


def _said(begin: str) -> list[str]:
    """The lines of the page, as it is, that begin so."""
    lines = REPORT.read_text(encoding="utf-8").splitlines() if REPORT.exists() else []
    return [line for line in lines if line.startswith(begin)]


def _row(name: str, trial: Trial) -> str:
    what = trial.name + "; not yet through" * (not trial.is_whole)
    times = f"{trial.tried} of {trial.of}" if trial.of else trial.tried
    cells = (name, what, times, len(trial.wrong), trial.commit, trial.date)
    return f"| {' | '.join(map(str, cells))} |"


if __name__ == "__main__":
    sys.exit(main())
