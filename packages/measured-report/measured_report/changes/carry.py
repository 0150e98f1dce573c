"""Carry: a record outlives a change of code where quick runs of the old and of the new code give the same numbers.

Simulations repeat to the last bit on a CPU. What no run executed is not proven: see ``records/proof.py``.
"""

import json
import os
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from measured_report.changes.moves import few
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.release import Release
from measured_report.editions.status import expected_packages, states_of
from measured_report.files.atomic import RecordError
from measured_report.files.errors import UsageError
from measured_report.measuring import reach
from measured_report.measuring.accelerator import accelerator
from measured_report.measuring.batch import now
from measured_report.measuring.machine import commit as commit_here
from measured_report.measuring.measure import MODULE
from measured_report.records.code import Graph, roots_of
from measured_report.records.columns import REASON, column_of, columns_of
from measured_report.records.identity import git, identity_of
from measured_report.records.proof import Code, Place
from measured_report.records.record import Carried, Record, load_record, write_record
from measured_report.values.evidence import is_cost, key_of

ASIDE = "carry"  # the folder below `results` of the quick runs of the new code
SHORT = 12  # characters of a commit, as those of `commit_here`
GONE = ()  # stands for a cell that is not there
COMMIT_LIMIT = 200  # so many commits back an old code is looked for


@dataclass(frozen=True)
class Run:
    """Hold a code of a section, and what a quick run of it gave and executed."""

    code: Code
    record: Record | None  # None where it could not be measured
    executed: Set[Place]
    timed: Set[Place]  # what of it was executed while times were measured
    work: Mapping[str, str]  # digests of what a device was given to do meanwhile, by batch


Codes = tuple[Code, Code]  # the old and the new one, as the next
Runs = tuple[Run, Run]


def carried(project: Project, release: Release, names: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Carry the records of sections that are stale by code alone; yield each with why not, or else empty."""
    states = {state.section: state for state in states_of(project) if state.section in names}
    records, after = {}, commit_here() or ""  # before a record that is written makes the tree another
    for name, state in states.items():
        if state.record and state.kind == "stale" and all(note.startswith("code") for note in state.notes):
            records[name] = state.record
        elif state.kind != "fresh":
            yield name, f"it is {state.summary}, which is not its code alone"
    with worktree(project.root) as tree:
        commits = commits_of(tree, records)
        for name in (name for name in records if name not in commits):
            yield name, f"none of the newest {COMMIT_LIMIT} commits has the code that measured it"
        for commit in dict.fromkeys(commits.values()):
            git(tree, "checkout", "--quiet", "--detach", commit)
            pairs = {name: _codes(name, tree, project.root) for name in commits if commits[name] == commit}
            for name, runs in _run_both(project, release, tree, pairs).items():
                if not (reasons := _reasons(runs, records[name])):
                    _write(project, records[name], runs, (commit[:SHORT], after))
                yield name, few(reasons, 2)


def _codes(name: str, *roots: Path) -> Codes:
    old, new = (Code(name, root) for root in roots)
    old.compare(new)
    new.compare(old)
    return old, new


@contextmanager
def worktree(root: Path) -> Iterator[Path]:
    """Check the newest commit out beside the repository for a while; return the folder that the project has in it."""
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder).resolve() / "tree"
        git(root, "worktree", "add", "--quiet", "--detach", str(tree))
        if not tree.is_dir():
            raise UsageError(f"{root} is in no git repository, which has the code that was measured")
        tree_root = tree / git(root, "rev-parse", "--show-prefix")
        for environment in root.glob(".venv-*"):  # of programs that are measured: to make one takes minutes
            (tree_root / environment.name).symlink_to(environment)
        try:
            yield tree_root
        finally:
            git(root, "worktree", "remove", "--force", str(tree))


def commits_of(tree: Path, records: Mapping[str, Record]) -> dict[str, str]:
    """Find the newest commit with the code of each record; checks them out in turn."""
    files = {f":(top,glob)**/{file}" for record in records.values() for file in record.identity.files}
    newest = git(tree, "rev-parse", "HEAD")
    before_changes = git(tree, "log", "--format=%P", f"--max-count={COMMIT_LIMIT}", "--", *sorted(files)).splitlines()
    commits_by_section: dict[str, str] = {}
    for commit in [newest, *(parents.split()[0] for parents in before_changes if parents)] if records else ():
        git(tree, "checkout", "--quiet", "--detach", commit)
        graph = Graph(roots_of(tree))
        for name in (name for name in records if name not in commits_by_section):
            if graph.summary(f"experiments.{name}.measure")[0] == records[name].identity.code:
                commits_by_section[name] = commit
        if len(commits_by_section) == len(records):
            break
    return commits_by_section


def _run_both(project: Project, release: Release, tree: Path, pairs: Mapping[str, Codes]) -> dict[str, Runs]:
    """Run sections of both codes quick, beside one another, on a CPU."""
    python = python_of(release, expected_packages(project), project.root)
    sides = [replace(project, profile="quick", root=tree), replace(project, profile="quick", aside=ASIDE)]
    with tempfile.TemporaryDirectory() as name:
        folders, running = [Path(name) / str(place) for place in range(len(sides))], []
        for place, (side, folder) in enumerate(zip(sides, folders, strict=True)):
            for section in pairs:
                side.record_path(section).unlink(missing_ok=True)
            command = _command(python, side, folder, [codes[place] for codes in pairs.values()], list(pairs))
            running.append(subprocess.Popen(command, cwd=side.root, env=_settings(side.root, folder)))
        for process in running:
            process.wait()
        notes = [[json.loads(path.read_bytes()) for path in folder.glob("*.json")] for folder in folders]
    runs = {section: list(map(_run_of, codes, sides, notes)) for section, codes in pairs.items()}
    return {section: (old, new) for section, (old, new) in runs.items()}


def _run_of(code: Code, side: Project, notes: Sequence[Any]) -> Run:
    """Return what a run gave, and what was noted of a section and of importing it."""
    record, section = None, code.section
    with suppress(RecordError):
        record = load_record(side.record_path(section))
    places = [place for note in notes for name, *place in note["executed"] if name in ("", section)]
    executed = {tuple(place) for _, *place in places}
    timed = {tuple(place) for is_timed, *place in places if is_timed}
    work = {batch: digest for note in notes for batch, digest in note["work"].get(section, {}).items()}
    return Run(code, record, executed, timed, work)


def _command(python: Path, side: Project, folder: Path, codes: Sequence[Code], names: Sequence[str]) -> list[str]:
    """Return the command that runs a side and follows what changed of its codes, as it notes in ``folder``."""
    spans: dict[str, list[tuple[int, int]]] = {}
    for file, lines in (pair for code in codes for pair in code.spans.items()):
        spans.setdefault(file, []).extend(lines)
    folder.mkdir()
    spans_file = folder.with_suffix(".json")
    spans_file.write_text(json.dumps(spans), encoding="utf-8")
    options = ["--device", "cpu", "--profile", side.profile, "--edition", side.release, "--aside", side.aside]
    return [str(python), "-P", reach.__file__, str(spans_file), str(folder), MODULE, *names, *options]


def _settings(root: Path, folder: Path) -> dict[str, str]:
    """Return the settings of a process; what it times waits for nobody else, as these times are not looked at."""
    packages = [str(each) for each in sorted((root / "packages").glob("*"))]
    settings = {"PYTHONPATH": os.pathsep.join([*packages, os.environ.get("PYTHONPATH", "")]), "TQDM_DISABLE": "1"}
    settings["TMPDIR"] = str(folder)
    return {**os.environ, **settings, **accelerator().NONE}


def _reasons(runs: Runs, record: Record) -> list[str]:
    """Say what keeps a record from being carried."""
    old, new = runs
    if not (old.record and new.record):
        return ["it could not be measured by both codes"]
    if reason := first_difference(old.record, new.record):
        return [reason]
    reasons = [*new.code.unexecuted(old.code, new.executed), *old.code.unexecuted(new.code, old.executed)]
    reasons += new.code.unread(old.code)
    if not _gone_columns(old.record, new.record):  # with a column goes what it was made of
        reasons += old.code.unread(new.code, is_old=True)
    # Which work is given to a device, the same code decides on each: what only a GPU executes is unchanged by then.
    if any(map(is_cost, record.units)) and not (old.work and old.work == new.work):
        reasons += new.code.timed(new.timed)
    return reasons


def first_difference(before: Record, after: Record) -> str:
    """Name the first cell or trace that two codes give differently, but for times and chance; empty for none."""
    old, new, gone = _rows(before), _rows(after), _gone_columns(before, after)
    for key in {**new, **old}:
        case = key[0][0]
        if not (key in old and key in new):
            return f"{case} is a row of one of both"
        for column in {*old[key], *new[key]} - gone:
            cells = [rows[key].get(column, GONE) for rows in (old, new)]
            is_compared = column_of(column.removesuffix(REASON)).kinds.isdisjoint(("cost", "chance"))
            if is_compared and len({(type(cell), cell) for cell in cells}) > 1:
                return f"{case}.{column}: {cells[0]!r} → {cells[1]!r}"
    different = set(before.traces.items()) ^ set(after.traces.items())
    return f"the trace of {min(case for case, _ in different)}" if different else ""


def _gone_columns(before: Record, after: Record) -> set[str]:
    """Name the columns that no row has any more, and those of their reasons."""
    names = set(columns_of(before.rows)) - set(columns_of(after.rows))
    return names | {name + REASON for name in names}


def _rows(record: Record) -> dict[tuple[Any, ...], Mapping[str, Any]]:
    count: Counter[tuple[Any, ...]] = Counter()
    rows = {}
    for row in record.rows:
        key = key_of(row)
        rows[key, count[key]] = row
        count[key] += 1
    return rows


def _write(project: Project, record: Record, runs: Runs, commits: tuple[str, str]) -> None:
    """Write a record as one of the new code; columns that this has no more are left out."""
    before, after = (run.record for run in runs)
    assert before and after, "there is no reason against it"
    gone = _gone_columns(before, after)
    rows = [{name: cell for name, cell in row.items() if name not in gone} for row in record.rows]
    identity = identity_of(record.section, project.profile, project.root, record.identity.packages)
    change = Carried(
        code=record.identity.code,
        before=commits[0],
        after=commits[1],
        date=now().isoformat(timespec="seconds"),
        row_count=len(after.rows),
        cell_count=sum(map(len, after.rows)),
    )
    units = {name: unit for name, unit in record.units.items() if name not in gone}
    record = replace(record, identity=identity, rows=rows, units=units, carried=(*record.carried, change))
    write_record(project.record_path(record.section), record)
