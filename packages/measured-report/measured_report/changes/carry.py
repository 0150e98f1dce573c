"""Carry a record over a code change if the results of the old and the new code are
bit-identical. Quick runs of both are compared. They run on the CPU, where simulations
are deterministic, each in a worktree of its commit. ``program.py`` checks that the runs
cover all changes.
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
from measured_report.changes.program import (
    Place,
    Program,
    changed_functions,
    refuse_uncalled,
)
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.release import Release
from measured_report.editions.status import expected_packages
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.git import environment, git, run_git
from measured_report.measuring.batch import utc_time
from measured_report.measuring.measure import MODULE
from measured_report.records.identity import identity_of
from measured_report.records.record import Carried, Record, basis_of, load_record

COMMIT_LIMIT = 200  # chosen: the number of commits in which the old code is searched
SHORT = 12  # chosen: the length of an abbreviated commit


def carried(
    project: Project, release: Release, names: Sequence[str]
) -> Iterator[tuple[str, str]]:
    """Carry the records of sections.

    Yield each section with the reason why it could not be carried, or an empty string.
    """
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
    """Carry one record if no number changes; otherwise raise ReportError."""
    old, new = (side.root for side in sides)
    path = project.record_path(name)
    packages = expected_packages(project)
    basis = basis_of(name, path, project.profile, project.root, packages=packages)
    record = load_record(path)
    recorded = record.identity
    if basis.identity.code == recorded.code:
        raise ReportError("its code has not changed: it does not need to be carried")
    if replace(basis.identity, code=recorded.code, files=recorded.files) != recorded:
        raise ReportError(
            f"more than its code has changed: use make rerun SECTION={name}"
        )
    columns = [project.report.columns[name] for name in record.units]
    # The run time of a whole batch is a cost, but it is never compared.
    if any(column.is_cost and "uncompared" not in column.kinds for column in columns):
        raise ReportError(
            f"it measures times, which cannot be carried: use make rerun SECTION={name}"
        )
    committed = identity_of(name, project.profile, new, recorded.packages)
    if committed.code != basis.identity.code:
        raise ReportError("its code has uncommitted changes: commit them first")
    old_commit = _check_out_measured(record, old)[:SHORT]
    new_commit = git(new, "rev-parse", "HEAD")[:SHORT]
    changed = changed_functions(Program(name, old), Program(name, new))
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "executed"
        log.touch()
        with ThreadPoolExecutor() as pool:
            before, after = pool.map(partial(_run, name, python, log), sides)
        called_places = _places(log)
    if reason := first_difference(before, after):
        raise ReportError(reason)
    refuse_uncalled(changed, called_places)
    change = Carried(
        recorded.code,
        old_commit,
        new_commit,
        date=utc_time().isoformat(timespec="seconds"),
        cells=sum(map(len, after.rows)),
    )
    changes = (*record.carried, change)
    basis.write(replace(record, identity=basis.identity, carried=changes))


@contextmanager
def worktree(root: Path) -> Iterator[Path]:
    """Yield the project's folder in a temporary worktree of the newest commit."""
    if not git(root, "rev-parse", "HEAD"):
        raise UsageError(
            f"{root} is not in a git repository with commits: make carry needs the "
            "commit that was measured"
        )
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder).resolve() / "tree"
        run_git(root, "worktree", "add", "--quiet", "--detach", str(tree))
        try:
            tree_root = tree / git(root, "rev-parse", "--show-prefix")
            # Link the environments, because creating them takes minutes.
            for environment_folder in root.glob(".venv-*"):
                (tree_root / environment_folder.name).symlink_to(environment_folder)
            yield tree_root
        finally:
            git(root, "worktree", "remove", "--force", str(tree))


def _check_out_measured(record: Record, root: Path) -> str:
    """Check out the newest commit that contains the code of a record; return its name."""
    identity = record.identity
    files = [f":(top,glob)**/{file}" for file in identity.files]
    head = git(root, "rev-parse", "HEAD")
    limit = f"--max-count={COMMIT_LIMIT}"
    # Commits before one of the files changed.
    parents = git(root, "log", "--format=%P", limit, head, "--", *files).split()
    noted = [change.new for change in record.carried[-1:]]
    noted.append(str(record.measured["commit"]).removesuffix("-dirty"))
    check_out = partial(run_git, root, "checkout", "--quiet", "--force", "--detach")
    for commit in dict.fromkeys([*noted, head, *parents]):
        with suppress(ReportError):  # the commit or its section may not exist
            check_out(commit)
            candidate = identity_of(
                record.section, identity.profile, root, identity.packages
            )
            if candidate.code == identity.code:
                return git(root, "rev-parse", "HEAD")
    raise ReportError(
        f"the code that measured it is not in the {COMMIT_LIMIT} newest commits of its "
        f"files: use make rerun SECTION={record.section}"
    )


def _run(name: str, python: Path, log: Path, side: Project) -> Record:
    """Measure a section with the code of a worktree.

    The functions that it calls are written to ``log``.
    """
    path = side.record_path(name)
    # The record of an earlier run would count if this run failed.
    path.unlink(missing_ok=True)
    start = log.with_name("start")
    start.mkdir(exist_ok=True)
    with suppress(FileExistsError):
        # Python imports this module at its start, before any code that is logged.
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
        raise ReportError(f"the old or the new code could not be measured: {lines[-1]}")
    return load_record(path)


def _places(log: Path) -> set[Place]:
    """Return the functions that ``executed.py`` logged."""
    places = set()
    for text in log.read_text(encoding="utf-8").splitlines():
        file, line, name = text.split("\t")
        places.add((file, int(line), name))
    return places


def first_difference(before: Record, after: Record) -> str:
    """Return the first cell or trace that differs between two runs, if there is one."""
    if len(before.rows) != len(after.rows):
        return (
            f"the number of rows changes from {len(before.rows)} to {len(after.rows)}"
        )
    for old, new in zip(before.rows, after.rows, strict=True):
        for column in {**old, **new}:
            was = repr(old.get(column, "nothing"))
            new_text = repr(new.get(column, "nothing"))
            if was != new_text:
                return f"{column} of {new['case']} changes from {was} to {new_text}"
    for case in {**before.traces, **after.traces}:
        if before.traces.get(case) != after.traces.get(case):
            return f"the trace of {case} changes"
    return ""
