"""Carry: a record outlives a change of code if quick runs of the old and of the new code give the same bits.

Both run on the CPU, where simulations repeat to the last bit, each in a worktree of its commit. ``program.py`` decides
whether the runs cover all that changed.
"""

import os
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from measured_report.changes import executed
from measured_report.changes.program import Place, Program, uncovered
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.release import Release
from measured_report.editions.status import expected_packages
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.git import environment, git, run_git
from measured_report.measuring.batch import now
from measured_report.measuring.measure import MODULE
from measured_report.records.identity import identity_of
from measured_report.records.record import Carried, Record, basis_of, load_record

COMMIT_LIMIT = 200  # so many commits back the old code is looked for
SHORT = 12  # characters of a commit


def carried(
    project: Project, release: Release, names: Sequence[str]
) -> Iterator[tuple[str, str]]:
    """Carry the records of sections; yield each with the reason why it could not be carried, or empty."""
    with worktree(project.root) as old, worktree(project.root) as new:
        python = python_of(release, expected_packages(project), project.root)
        for name in names:
            sides = [
                replace(project, profile="quick", root=root) for root in (old, new)
            ]
            try:
                carry(project, name, sides, python)
                yield name, ""
            except ReportError as error:
                yield name, str(error)


def carry(project: Project, name: str, sides: Sequence[Project], python: Path) -> None:
    """Carry one record; ReportError if that is not proven, and then nothing is written."""
    old, new = sides
    path = project.record_path(name)
    basis = basis_of(
        name, path, project.profile, project.root, expected_packages(project)
    )
    record = load_record(path)
    recorded = record.identity
    if basis.identity.code == recorded.code:
        raise ReportError("its code did not change")
    if replace(basis.identity, code=recorded.code, files=recorded.files) != recorded:
        raise ReportError(f"more than its code changed: make rerun SECTION={name}")
    columns = [project.report.columns[name] for name in record.units]
    # The time of a whole batch is a cost that nothing compares.
    if any(each.is_cost and "uncompared" not in each.kinds for each in columns):
        raise ReportError(
            f"it has times, which are not carried: make rerun SECTION={name}"
        )
    new_code = identity_of(name, project.profile, new.root, recorded.packages).code
    if new_code != basis.identity.code:
        raise ReportError("its code has changes without a commit; commit them first")
    old_commit = _check_out_measured(record, old.root)
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "executed"
        log.touch()
        with ThreadPoolExecutor() as pool:
            before, after = pool.map(partial(_run, name, python, log), sides)
        called = _places(log)
    if reason := first_difference(before, after) or uncovered(
        Program(name, old.root), Program(name, new.root), called
    ):
        raise ReportError(reason)
    commits = old_commit[:SHORT], git(new.root, "rev-parse", "HEAD")[:SHORT]
    cell_count = sum(map(len, after.rows))
    change = Carried(
        recorded.code, *commits, now().isoformat(timespec="seconds"), cell_count
    )
    basis.write(
        replace(record, identity=basis.identity, carried=(*record.carried, change))
    )


@contextmanager
def worktree(root: Path) -> Iterator[Path]:
    """Check the newest commit out in a folder for a while; return the folder that the project has in it."""
    if not git(root, "rev-parse", "HEAD"):
        raise UsageError(
            f"{root} is not in a git repository with commits; make carry needs the commit that was measured"
        )
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder).resolve() / "tree"
        run_git(root, "worktree", "add", "--quiet", "--detach", str(tree))
        try:
            tree_root = tree / git(root, "rev-parse", "--show-prefix")
            for made in root.glob(
                ".venv-*"
            ):  # environments, which take minutes to make
                (tree_root / made.name).symlink_to(made)
            yield tree_root
        finally:
            git(root, "worktree", "remove", "--force", str(tree))


def _check_out_measured(record: Record, root: Path) -> str:
    """Check out the newest commit with the code of a record; return its name."""
    files = [f":(top,glob)**/{file}" for file in record.identity.files]
    head = git(root, "rev-parse", "HEAD")
    limit = f"--max-count={COMMIT_LIMIT}"
    parents = git(
        root, "log", "--format=%P", limit, head, "--", *files
    ).split()  # before each change of a file
    noted = [carried.new for carried in record.carried[-1:]] + [
        str(record.measured["commit"])
    ]
    for commit in dict.fromkeys([*noted, head, *parents]):
        with suppress(ReportError):  # the commit is not here, or has no such section
            run_git(
                root,
                "checkout",
                "--quiet",
                "--force",
                "--detach",
                commit.removesuffix("-dirty"),
            )
            found = identity_of(
                record.section, record.identity.profile, root, record.identity.packages
            )
            if found.code == record.identity.code:
                return git(root, "rev-parse", "HEAD")
    raise ReportError(
        f"none of the {COMMIT_LIMIT} newest commits that change its files has the code that was measured"
    )


def _run(name: str, python: Path, log: Path, side: Project) -> Record:
    """Measure a section by the code of a worktree, noting in ``log`` which of its functions are called."""
    path = side.record_path(name)
    path.unlink(missing_ok=True)
    start = log.with_name("start")
    start.mkdir(exist_ok=True)
    with suppress(FileExistsError):
        (start / "sitecustomize.py").symlink_to(executed.__file__)
    packages = map(str, sorted((side.root / "packages").glob("*")))
    paths = [str(start), *packages, *filter(None, [os.environ.get("PYTHONPATH")])]
    settings = {
        "PYTHONPATH": os.pathsep.join(paths),
        "TQDM_DISABLE": "1",
        executed.VARIABLE: os.pathsep.join([str(log), f"{side.root}/"]),
        **side.report.accelerator.NONE,
    }
    command = [
        str(python),
        "-m",
        MODULE,
        name,
        "--device",
        "cpu",
        "--profile",
        side.profile,
        "--edition",
        side.release,
    ]
    env = environment(**settings)
    process = subprocess.run(
        command, cwd=side.root, env=env, capture_output=True, text=True, check=False
    )
    if process.returncode or not path.exists():
        reason = [*filter(None, process.stderr.splitlines()), "no reason was given"][
            -1 if process.returncode else 0
        ]
        raise ReportError(f"both codes could not be measured: {reason}")
    return load_record(path)


def _places(log: Path) -> set[Place]:
    """Return the functions that were called."""
    fields = (line.split("\t") for line in log.read_text(encoding="utf-8").splitlines())
    return {(file, int(line), name) for file, line, name in fields}


def first_difference(before: Record, after: Record) -> str:
    """Name the first cell or trace that differs between two runs; empty if all are the same."""
    if len(before.rows) != len(after.rows):
        return f"there were {len(before.rows)} rows, and are {len(after.rows)}"
    for old, new in zip(before.rows, after.rows, strict=True):
        for column in {**old, **new}:
            if repr(old.get(column, ...)) != repr(new.get(column, ...)):
                cells = f"{old.get(column, 'nothing')!r} and is {new.get(column, 'nothing')!r}"
                return f"{column} of {new['case']} was {cells}"
    for case in {**before.traces, **after.traces}:
        if before.traces.get(case) != after.traces.get(case):
            return f"the trace of {case} differs"
    return ""
