"""Carry: a record outlives a change of code where quick runs of the old and of the new code give the same numbers.

Simulations repeat to the last bit on a CPU. What no run executed is not proven: see ``records/proof.py``.
"""

import json
import os
import tempfile
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence, Set
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from subprocess import Popen
from typing import Any

from measured_report.changes.moves import few
from measured_report.editions.environment import python_of
from measured_report.editions.project import Project
from measured_report.editions.release import Release
from measured_report.editions.status import expected_packages, states_of
from measured_report.files.atomic import RecordError
from measured_report.files.errors import UsageError
from measured_report.files.groups import grouped
from measured_report.measuring import reach
from measured_report.measuring.accelerator import accelerator
from measured_report.measuring.batch import now
from measured_report.measuring.machine import commit as commit_here
from measured_report.measuring.measure import MODULE
from measured_report.records.code import Graph, roots_of
from measured_report.records.columns import (
    REASON,
    column_of,
    columns_of,
    is_cost,
    is_number,
)
from measured_report.records.identity import git, identity_of
from measured_report.records.proof import TIMED, UNEXECUTED, Code, Place
from measured_report.records.record import Carried, Record, load_record, write_record
from measured_report.values.evidence import key_of
from measured_report.values.noise import chance_of, discoveries, welch

ASIDE = "carry"  # the folder below `results` of the quick runs of the new code
REPEAT_COUNT = 3  # chosen: runs of each code on a GPU, where these execute what a CPU does not
SHORT = 12  # characters of a commit, as those of `commit_here`
COMMIT_LIMIT = 200  # so many commits back an old code is looked for


@dataclass(frozen=True)
class Run:
    """Hold a code of a section, and what quick runs of it gave and executed."""

    code: Code
    records: Sequence[Record]  # of one run, or of several that do not repeat to the last bit
    executed: Set[Place]
    timed: Set[Place]  # what of it was executed while times were measured
    work: Mapping[str, str]  # digests of what a device was given to do meanwhile, by batch


Codes = tuple[Code, Code]  # the old and the new one, as the next
Runs = tuple[Run, Run]


def carried(project: Project, release: Release, names: Sequence[str], device: str) -> Iterator[tuple[str, str]]:
    """Carry the records of sections that are stale by code alone; yield each with why not, or else empty."""
    records, after = {}, commit_here() or ""  # before a record that is written makes the tree another
    for state in (state for state in states_of(project) if state.section in names):
        if state.record and state.kind == "stale" and all(note.startswith("code") for note in state.notes):
            records[state.section] = state.record
        elif state.kind != "fresh":
            yield state.section, f"it is {state.summary}, which is not its code alone"
    with worktree(project.root) as tree:
        commits = commits_of(tree, records)
        for name in (name for name in records if name not in commits):
            yield name, f"none of the newest {COMMIT_LIMIT} commits has the code that measured it"
        for commit in dict.fromkeys(commits.values()):
            git(tree, "checkout", "--quiet", "--detach", commit)
            pairs: dict[str, Codes] = {}
            for name in (name for name in commits if commits[name] == commit):
                old, new = pairs[name] = Code(name, tree), Code(name, project.root)
                old.compare(new)
                new.compare(old)
            runs = _run_both(project, release, tree, pairs, "cpu")
            reasons = {name: _reasons(runs[name], records[name]) for name in pairs}
            # Runs on a GPU may settle what a CPU does not execute, and what is timed.
            is_open = {name: any(why.startswith((UNEXECUTED, TIMED)) for why in reasons[name]) for name in pairs}
            beside = [name for name in pairs if device != "cpu" and is_open[name]]
            for name in [name for name in pairs if name not in beside]:  # are kept, whatever becomes of the others
                yield name, _kept(project, records[name], runs[name], (commit[:SHORT], after), reasons[name])
            is_new = {name: any(reason.startswith(UNEXECUTED) for reason in reasons[name]) for name in beside}
            for count in (1, REPEAT_COUNT):
                group = {name: pairs[name] for name in beside if is_new[name] == (count > 1)}
                on_device = _run_both(project, release, tree, group, device, count) if group else {}
                for name, of_device in on_device.items():
                    why = _reasons(runs[name], records[name], of_device)
                    yield name, _kept(project, records[name], runs[name], (commit[:SHORT], after), why)


def _kept(project: Project, record: Record, runs: Runs, commits: tuple[str, str], reasons: Sequence[str]) -> str:
    """Write a record as one of the new code where there are no reasons against it, else sum these up."""
    identity = identity_of(record.section, project.profile, project.root, record.identity.packages)
    is_open = any(why.startswith(UNEXECUTED) for why in reasons)
    elsewhere = _release_with_proof(project, record, identity.code) if is_open else ""
    if reasons := [reason for reason in reasons if not (elsewhere and reason.startswith(UNEXECUTED))]:
        return few(reasons, 2)
    before, after = (run.records[0] for run in runs)
    gone = _gone_columns(before, after)  # which are left out
    rows = [{name: cell for name, cell in row.items() if name not in gone} for row in record.rows]
    date, cell_count = now().isoformat(timespec="seconds"), sum(map(len, after.rows))
    change = Carried(record.identity.code, *commits, date, len(after.rows), cell_count, elsewhere)
    units = {name: unit for name, unit in record.units.items() if name not in gone}
    record = replace(record, identity=identity, rows=rows, units=units, carried=(*record.carried, change))
    write_record(project.record_path(record.section), record)
    return ""


def _release_with_proof(project: Project, record: Record, code: str) -> str:
    """Name a release with packages that execute what those of this one do not: it was carried over the same change."""
    for release in project.releases:
        with suppress(RecordError):
            other = load_record(project.of(release).record_path(record.section))
            last = other.carried[-1] if other.carried and other.identity.code == code else None
            if last and last.code == record.identity.code and not last.executed_in:
                return release
    return ""


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


def _run_both(
    project: Project, release: Release, tree: Path, pairs: Mapping[str, Codes], device: str, repeat_count: int = 1
) -> dict[str, Runs]:
    """Run sections of both codes quick: beside one another on a CPU, in turn on a GPU."""
    python = python_of(release, expected_packages(project), project.root)
    sides = [replace(project, profile="quick", root=tree), replace(project, profile="quick", aside=ASIDE)]
    codes = [{section: pair[index] for section, pair in pairs.items()} for index in range(len(sides))]
    records: list[defaultdict[str, list[Record]]] = [defaultdict(list) for _ in sides]
    with tempfile.TemporaryDirectory() as name:
        folders = [Path(name) / str(index) for index in range(len(sides))]
        for _ in range(repeat_count):
            running = []
            for side, codes_of_side, folder in zip(sides, codes, folders, strict=True):
                running.append(_started(python, side, codes_of_side, device, folder))
                if device != "cpu":
                    running[-1].wait()
            for process, side, records_of_side in zip(running, sides, records, strict=True):
                process.wait()
                for section in pairs:
                    with suppress(RecordError):
                        records_of_side[section].append(load_record(side.record_path(section)))
        old, new = (_runs_of(*of_side) for of_side in zip(codes, records, folders, strict=True))
    return {section: (old[section], new[section]) for section in pairs}


def _started(python: Path, side: Project, codes: Mapping[str, Code], device: str, folder: Path) -> Popen[bytes]:
    """Start quick runs of a side, which note in ``folder`` what they execute of what changed of its codes."""
    spans = defaultdict[str, list[tuple[int, int]]](list)
    for file, lines in (pair for code in codes.values() for pair in code.spans.items()):
        spans[file] += lines
    folder.mkdir(exist_ok=True)
    spans_file = folder.with_suffix(".json")
    spans_file.write_text(json.dumps(spans), encoding="utf-8")
    for section in codes:
        side.record_path(section).unlink(missing_ok=True)
    command = [str(python), "-P", reach.__file__, str(spans_file), str(folder), MODULE, *codes, "--device", device]
    command += ["--profile", side.profile, "--edition", side.release, "--aside", side.aside]
    packages = [*map(str, sorted((side.root / "packages").glob("*"))), os.environ.get("PYTHONPATH", "")]
    # What it times waits for nobody else, by a lock in TMPDIR, as these times are not looked at.
    settings = {"PYTHONPATH": os.pathsep.join(packages), "TQDM_DISABLE": "1", "TMPDIR": str(folder)}
    settings |= accelerator().NONE if device == "cpu" else {}
    return Popen(command, cwd=side.root, env={**os.environ, **settings})


def _runs_of(codes: Mapping[str, Code], records: Mapping[str, Sequence[Record]], folder: Path) -> dict[str, Run]:
    """Return the runs of a side, with what its processes noted of each section and of importing it."""
    executed, timed = defaultdict[str, set[Place]](set), defaultdict[str, set[Place]](set)
    work = defaultdict[str, dict[str, str]](dict)
    for note in (json.loads(path.read_bytes()) for path in folder.glob("*.json")):
        for section, is_timed, *place in note["executed"]:
            for places in (executed, timed) if is_timed else (executed,):
                places[section].add(tuple(place))
        for section, digests in note["work"].items():
            work[section] |= digests
    noted = {name: (executed[""] | executed[name], timed[""] | timed[name]) for name in codes}
    return {name: Run(code, records[name], *noted[name], work[name]) for name, code in codes.items()}


def _reasons(runs: Runs, record: Record, beside: Runs | None = None) -> list[str]:
    """Say what keeps a record from being carried, by runs on a CPU and ``beside`` these on a GPU."""
    old, new = runs
    if not all(each.records for each in (*runs, *(beside or ()))):
        return ["it could not be measured by both codes"]
    repeats = beside if beside and len(beside[0].records) > 1 else None
    for sides in filter(None, (runs, repeats)):
        if reason := first_difference(sides[0].records, sides[1].records):
            return [reason]
    executed = [each.executed for each in (*runs, *(repeats or ()))]
    reasons = [*new.code.unexecuted(old.code, executed[1::2]), *old.code.unexecuted(new.code, executed[0::2])]
    reasons += new.code.unread(old.code)
    if not _gone_columns(old.records[0], new.records[0]):  # with a column goes what it was made of
        reasons += old.code.unread(new.code, is_old=True)
    # Which work is given to a device, the same code decides on each: what only a GPU executes is unchanged by then.
    is_same_work = any(before.work and before.work == after.work for before, after in filter(None, (runs, beside)))
    if any(map(is_cost, record.units)) and not is_same_work:
        reasons += new.code.timed(new.timed)
    return reasons


def first_difference(before: Sequence[Record], after: Sequence[Record]) -> str:
    """Name the first cell or trace that runs of two codes have differently, but for times and chance; empty for none.

    Of several runs of each, which do not repeat to the last bit, numbers are compared by Welch's test, and no traces.
    """
    old, new = ([_rows(record) for record in records] for records in (before, after))
    gone, samples = _gone_columns(before[0], after[0]), dict[str, list[list[float]]]()
    for key in {**new[0], **old[0]}:
        case = key[0][0]
        if not all(key in rows for rows in (*old, *new)):
            return f"{case} is a row of one of both"
        for column in {*old[0][key], *new[0][key]} - gone:
            if not column_of(column.removesuffix(REASON)).kinds.isdisjoint(("cost", "uncompared")):
                continue
            sides = [[rows[key].get(column, ()) for rows in side] for side in (old, new)]  # () is no cell
            if len({(type(cell), cell) for side in sides for cell in side}) > 1:
                if len(before) == 1 or not all(is_number(cell) for side in sides for cell in side):
                    return f"{case}.{column}: {sides[0][0]!r} → {sides[1][0]!r}"
                samples[f"{case}.{column}"] = sides
    seals = before[0].traces, after[0].traces
    if len(before) == 1 and seals[0] != seals[1]:
        return f"the trace of {min(case for case, _ in set(seals[0].items()) ^ set(seals[1].items()))}"
    return _least_likely(samples) if samples else ""


def _least_likely(samples: Mapping[str, list[list[float]]]) -> str:
    """Name the number of which chance makes such a difference least often; empty where that may be chance."""
    import numpy as np

    numbers = np.array([*samples.values()])  # by number, code and run
    count = numbers.shape[2]
    variances = numbers.var(axis=2, ddof=1) / count
    error, freedom = welch(variances, np.full(variances.shape, count - 1.0))
    chances = chance_of(abs(np.diff(numbers.mean(axis=2))[:, 0]), error, freedom)
    least = min(range(len(chances)), key=chances.__getitem__)
    name, (old, new) = list(samples.items())[least]
    return f"{name}: {old} → {new}" if chances[least] <= discoveries(chances) else ""


def _gone_columns(before: Record, after: Record) -> set[str]:
    """Name the columns that no row has any more, and those of their reasons."""
    names = set(columns_of(before.rows)) - set(columns_of(after.rows))
    return names | {name + REASON for name in names}


def _rows(record: Record) -> dict[tuple[Any, ...], Mapping[str, Any]]:
    rows_by_key = grouped((key_of(row), row) for row in record.rows)
    return {(key, index): row for key, rows in rows_by_key.items() for index, row in enumerate(rows)}
