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
        sides = [replace(project, profile="quick", root=root) for root in (old, new)]
        for name in names:
            try:
                carry(project, name, sides, python)
                yield name, ""
            except ReportError as error:
                yield name, str(error)


def carry(project: Project, name: str, sides: Sequence[Project], python: Path) -> None:
    """Carry one record; raise ReportError, and write nothing, unless it is proven that no number changes."""
    old, new = (side.root for side in sides)
    path = project.record_path(name)
    packages = expected_packages(project)
    basis = basis_of(name, path, project.profile, project.root, packages)
    record = load_record(path)
    recorded = record.identity
    if basis.identity.code == recorded.code:
        raise ReportError("its code did not change")
    if replace(basis.identity, code=recorded.code, files=recorded.files) != recorded:
        raise ReportError(f"more than its code changed: make rerun SECTION={name}")
    columns = [project.report.columns[each] for each in record.units]
    # The time of a whole batch is a cost that nothing compares.
    if any(each.is_cost and "uncompared" not in each.kinds for each in columns):
        raise ReportError(
            f"it has times, which are not carried: make rerun SECTION={name}"
        )
    committed = identity_of(name, project.profile, new, recorded.packages)
    if committed.code != basis.identity.code:
        raise ReportError("its code has changes without a commit; commit them first")
    old_commit = _check_out_measured(record, old)[:SHORT]
    new_commit = git(new, "rev-parse", "HEAD")[:SHORT]
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "executed"
        log.touch()
        with ThreadPoolExecutor() as pool:
            before, after = pool.map(partial(_run, name, python, log), sides)
        called = _places(log)
    reason = first_difference(before, after)
    reason = reason or uncovered(Program(name, old), Program(name, new), called)
    if reason:
        raise ReportError(reason)
    change = Carried(
        recorded.code,
        old_commit,
        new_commit,
        date=now().isoformat(timespec="seconds"),
        cells=sum(map(len, after.rows)),
    )
    changes = (*record.carried, change)
    basis.write(replace(record, identity=basis.identity, carried=changes))


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
            # Environments take minutes to make.
            for made in root.glob(".venv-*"):
                (tree_root / made.name).symlink_to(made)
            yield tree_root
        finally:
            git(root, "worktree", "remove", "--force", str(tree))


def _check_out_measured(record: Record, root: Path) -> str:
    """Check out the newest commit with the code of a record; return its name."""
    identity = record.identity
    files = [f":(top,glob)**/{file}" for file in identity.files]
    head = git(root, "rev-parse", "HEAD")
    limit = f"--max-count={COMMIT_LIMIT}"
    # Commits before each change of a file.
    parents = git(root, "log", "--format=%P", limit, head, "--", *files).split()
    noted = [change.new for change in record.carried[-1:]]
    noted.append(str(record.measured["commit"]).removesuffix("-dirty"))
    check_out = partial(run_git, root, "checkout", "--quiet", "--force", "--detach")
    for commit in dict.fromkeys([*noted, head, *parents]):
        with suppress(ReportError):  # the commit is not here, or has no such section
            check_out(commit)
            found = identity_of(
                record.section, identity.profile, root, identity.packages
            )
            if found.code == identity.code:
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
    env = environment(
        PYTHONPATH=os.pathsep.join(paths),
        TQDM_DISABLE="1",
        **{executed.VARIABLE: os.pathsep.join([str(log), f"{side.root}/"])},
        **side.report.accelerator.NONE,
    )
    options = ["--device", "cpu", "--profile", "quick", "--edition", side.release]
    command = [str(python), "-m", MODULE, name, *options]
    process = subprocess.run(
        command, cwd=side.root, env=env, capture_output=True, text=True, check=False
    )
    if process.returncode or not path.exists():
        lines = process.stderr.strip().splitlines() or ["no reason was given"]
        raise ReportError(f"both codes could not be measured: {lines[-1]}")
    return load_record(path)


def _places(log: Path) -> set[Place]:
    """Return the functions that were called."""
    places = set()
    for text in log.read_text(encoding="utf-8").splitlines():
        file, line, name = text.split("\t")
        places.add((file, int(line), name))
    return places


def first_difference(before: Record, after: Record) -> str:
    """Name the first cell or trace that differs between two runs; empty if all are the same."""
    if len(before.rows) != len(after.rows):
        return f"there were {len(before.rows)} rows, and are {len(after.rows)}"
    for old, new in zip(before.rows, after.rows, strict=True):
        for column in {**old, **new}:
            was = repr(old.get(column, "nothing"))
            now = repr(new.get(column, "nothing"))
            if was != now:
                return f"{column} of {new['case']} was {was} and is {now}"
    for case in {**before.traces, **after.traces}:
        if before.traces.get(case) != after.traces.get(case):
            return f"the trace of {case} differs"
    return ""
