"""``--fix``: what findings say to change, tried in MuJoCo C before it is written, and left out where it does harm."""

import difflib
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from xml.parsers import expat

import mujoco
import numpy as np

from newton_lint.advice import ways_of
from newton_lint.findings import Change, Finding, distinct
from newton_lint.fix import Unwritable, edited, undo, write
from newton_lint.law import M
from newton_lint.report import Report, Request, report_of
from newton_lint.source import Source, Texts, parse
from newton_lint.step_rules import THROWN_M_S
from newton_lint.stepped import Run, runs_of
from newton_lint.target import Target, TargetError, compiled, read_target, tried

MEASURED_S = 2.0
"""Time that a scene is stepped before and after a change, by each of its starts."""
DEEPER = 1.1
DEEPER_M = 5e-5
FASTER = 1.05
FASTER_M_S = 2e-3
# How much deeper contacts may get, what rests may move faster, and how much more effort or time it may take.
SLOWER = 1.8
SLOWEST = 3.0
# Depth that a body may have which no longer falls through, and the speed of what does.
SHALLOW_M = 2e-3
FALLS_M_S = 3.0
FREES = ("lost", "stiff", "thrown", "unstable")
"""Rules of what costs little, and has no contacts, only because it falls or flies."""
# Changes that are tried in one pass, and times that scenes which share files are gone over.
MOST_TRIES = 40
PASSES = 4


def measured(target: Target) -> list[Run]:
    """Step a scene from each of its starts, for as long as changes are judged by."""
    return runs_of(target.model, target, MEASURED_S)


def harm(before: Sequence[Run], after: Sequence[Run], rules: Collection[str]) -> str:
    """Say in what changes of these rules' findings made a scene worse; empty where they did in nothing."""
    for old, new in zip(before, after, strict=True):
        if new.bad:
            return f"the simulation blows up after {new.time_s:.3g} s from {new.start}"
        if not old.bad and (reason := _motion_harm(old, new, rules)):
            return reason
    for name, most in (
        () if {*FREES} & {*rules} else (("effort", SLOWER), ("cost_s", SLOWEST))
    ):
        old_cost, new_cost = (
            sum(getattr(run, name) for run in runs) for runs in (before, after)
        )
        if new_cost > most * old_cost:
            return f"a simulated second costs {new_cost / max(old_cost, 1e-9):.2g} times as much"
    return ""


def _motion_harm(old: Run, new: Run, rules: Collection[str]) -> str:
    """Say whether contacts are deeper than before, or what rests moves faster."""
    old_thrown, new_thrown = (run.thrown_m_s.max(initial=0.0) for run in (old, new))
    # What flew or fell touched nothing: that it lies now is no harm.
    lies = old_thrown > THROWN_M_S > 2.0 * new_thrown and new.deepest_m <= old.deepest_m
    lies |= "lost" in rules and new.deepest_m < SHALLOW_M
    old_fall, new_fall = (run.speeds_m_s.max(initial=0.0) for run in (old, new))
    lies |= old_fall > FALLS_M_S > 2.0 * new_fall and new.late_m < SHALLOW_M
    for name, field in (
        ("deepest contact", "deepest_m"),
        ("deepest contact at the end", "late_m"),
    ):
        old_depth = getattr(old, field)
        new_depth = getattr(new, field)
        if new_depth > DEEPER * old_depth + DEEPER_M and not lies:
            return (
                f"{name} {M * old_depth:.3g} → {M * new_depth:.3g} mm from {new.start}"
            )
    old_speed, new_speed = (
        np.abs(run.data.qvel).max(initial=0.0) for run in (old, new)
    )
    if new_speed > FASTER * old_speed + FASTER_M_S:
        return f"what moves fastest after {new.time_s:.3g} s: {old_speed:.3g} → {new_speed:.3g} m/s or rad/s"
    return ""


def _measures(runs: Sequence[Run]) -> str:
    depth = max((run.deepest_m for run in runs), default=0.0)
    cost = sum(run.cost_s for run in runs)
    return f"deepest contact {M * depth:.3g} mm, {cost / max(len(runs), 1):.2g} s a simulated second"


class Mending:
    """A scene whose findings are mended one after the other, each on top of those before it."""

    def __init__(self, target: Target, request: Request, paths: Sequence[Path]):
        self.target = target
        self.request = request
        self.paths = paths
        self.report = self.first = report_of(target, request)
        self.runs = self.first_runs = measured(target)
        self.texts: dict[Path, bytes] = dict(target.texts)
        self.outcomes: dict[str, str] = {}
        """Of each change that was tried, by its line, why it is not written; empty where it is."""
        self.idle: set[str] = set()
        """Those that change no motion."""
        self.rules: set[str] = set()
        while self._pass():
            pass
        # Small harms of many changes add up, although none alone was too large.
        if reason := harm(self.first_runs, self.runs, self.rules):
            self.texts = dict(target.texts)
            self.report = self.first
            self.runs = self.first_runs
            self.outcomes = {
                line: why or f"with the others {reason}"
                for line, why in self.outcomes.items()
            }

    def _pass(self) -> bool:
        """Try each change once, and tell whether one did good and no harm: the last pass finds nothing to write."""
        written = {line: why for line, why in self.outcomes.items() if why == ""}
        self.outcomes = dict(written)
        for _ in range(MOST_TRIES):
            # Asked anew after each: what is written changes the findings.
            untried = (
                candidate
                for candidate in self._candidates()
                if candidate[0] not in self.outcomes
            )
            if not (candidate := next(untried, None)):
                break
            line, findings, changes = candidate
            runs = self.runs
            self.outcomes[line] = self._outcome(findings, changes)
            ends = [[run.data.qpos for run in group] for group in (runs, self.runs)]
            if runs is not self.runs and all(map(np.array_equal, *ends)):
                self.idle.add(line)
        return list(self.outcomes.values()).count("") > len(written)

    def _candidates(self) -> Iterator[tuple[str, list[Finding], Sequence[Change]]]:
        """Yield findings with changes that may mend them: all of a rule at once, then each by each of its ways."""
        findings = [
            item
            for item in self.report.findings
            if item.severity != "note" and ways_of(item.advice)
        ]
        for rule in dict.fromkeys(finding.rule for finding in findings):
            of_rule = [finding for finding in findings if finding.rule == rule]
            changes = distinct(
                change
                for finding in of_rule
                for change in ways_of(finding.advice)[0].changes
            )
            ways = [(of_rule, changes)] if len(changes) > 1 else []
            ways += [
                ([finding], way.changes)
                for finding in of_rule
                for way in ways_of(finding.advice)
            ]
            yield from (
                (", ".join(map(str, changes)), mended, changes)
                for mended, changes in ways
            )

    def _outcome(self, findings: Sequence[Finding], changes: Sequence[Change]) -> str:
        """Take changes over, or say why not."""
        try:
            return self._harm(
                findings, self.texts | edited(changes, self.report.source, self.texts)
            )
        except Unwritable as error:
            return str(error)
        except (ValueError, OSError, expat.ExpatError, mujoco.FatalError) as error:
            return f"MuJoCo refuses it: {' '.join(str(error).split())[:200]}"

    def _harm(self, findings: Sequence[Finding], texts: dict[Path, bytes]) -> str:
        """Take texts over that mend findings of one rule, or say why not."""
        rules = [findings[0].rule]
        target = tried(self.target, texts)
        report = report_of(target, self.request)
        before = _counted(self.report)
        after = _counted(report)
        notes = {_key(finding) for finding in self.report.findings}
        if any(after[_key(finding)] >= before[_key(finding)] for finding in findings):
            return "it does not change what is found"
        if more := [
            key
            for key, count in after.items()
            if key not in notes or 0 < before[key] < count
        ]:
            return f"another is found then: {' '.join(filter(None, more[0]))}"
        runs = measured(target)
        if reason := harm(self.runs, runs, rules) or self._harm_elsewhere(texts, rules):
            return reason
        self.texts = texts
        self.report = report
        self.runs = runs
        self.rules |= {*rules}
        return ""

    def _harm_elsewhere(self, texts: Texts, rules: Collection[str]) -> str:
        """Say what harm a change of an included file does to other scenes that are mended."""
        included = {file for file in texts if file != self.target.path}
        for path in self.paths if included else ():
            if path != self.target.path and included & {
                element.file for element in parse(path).walk()
            }:
                scene = Target(path.name, compiled(path), path=path)
                if reason := harm(
                    measured(scene), measured(tried(scene, texts)), rules
                ):
                    return f"{path.name}: {reason}"
        return ""

    def lines(self, written: bool) -> Iterator[str]:
        """Yield a line for each change that was tried."""
        for line, why in self.outcomes.items():
            line += ", which changes no motion" if line in self.idle else ""
            yield f"{line}: {f'is not written: {why}' if why else 'written' if written else 'can be written'}"

    def patch(self) -> Iterator[str]:
        """Yield the change of the files as a patch."""
        for file, text in self.texts.items():
            old, new = (
                version.decode(errors="replace").splitlines(keepends=True)
                for version in (file.read_bytes(), text)
            )
            for line in difflib.unified_diff(old, new, f"a/{file}", f"b/{file}"):
                yield line.rstrip("\r\n")


def _key(finding: Finding) -> tuple[str, str, str]:
    return finding.rule, finding.shape, finding.parameter


def _counted(report: Report) -> Counter[tuple[str, str, str]]:
    return Counter(
        _key(finding) for finding in report.findings if finding.severity != "note"
    )


def fixed(
    target: Target, request: Request, paths: Sequence[Path], dry: bool
) -> tuple[Report, list[str], str]:
    """Mend a scene's files; return its report as it was, lines of what was done, and why files can't be written."""
    mending = Mending(target, request, paths)
    backups = []
    why = ""
    if mending.texts and not dry:
        try:
            backups = _written(target, mending.texts)
        except TargetError as error:
            why = str(error)
    lines = [
        *(mending.patch() if dry else ()),
        *mending.lines(not dry and not why),
        *backups,
    ]
    if mending.texts:
        before = _measures(mending.first_runs)
        after = _measures(mending.runs)
        lines.append(f"{target.name}: measured before: {before}; after: {after}")
    return mending.first, lines, why


def fixed_again(
    targets: Sequence[str], request: Request, paths: Sequence[Path]
) -> list[str]:
    """Go over scenes that may share files until none has more to write."""
    lines: list[str] = []
    for _ in range(PASSES):
        scenes = (
            scene
            for scene in map(read_target, targets)
            if scene.path and scene.model is not None
        )
        written = [
            line for scene in scenes for line in fixed(scene, request, paths, False)[1]
        ]
        written = [line for line in written if line.endswith(": written")]
        if not written:
            break
        lines += written
    return lines


def fix(changes: Sequence[Change], source: Source, target: Target) -> list[str]:
    """Write changes that have been measured, and return a line for each."""
    try:
        backups = _written(target, edited(changes, source, {})) if changes else []
    except Unwritable as error:
        raise TargetError(f"{target.name}: is not written: {error}") from error
    return [*(f"{change}: written" for change in changes), *backups]


def _written(target: Target, texts: Texts) -> list[str]:
    assert target.path is not None  # only what a file describes is changed
    expected = compiled(target.path, texts)
    try:
        replaced = write(texts)
    except OSError as error:
        raise TargetError(f"{target.name}: is not written: {error}") from error
    try:
        is_expected = are_same(expected, compiled(target.path))
    except ValueError:
        is_expected = False
    if not is_expected:
        undo(replaced)
        raise TargetError(
            f"{target.name}: is not written: MuJoCo makes another model of the file than was tried"
        )
    return [
        f"{file}: as it was it is {backup.name}"
        for file, (_, backup) in zip(texts, replaced, strict=True)
    ]


def are_same(*models: mujoco.MjModel) -> bool:
    """Tell whether models are the same to the last bit."""
    buffers = [np.empty(mujoco.mj_sizeModel(model), np.uint8) for model in models]
    for model, buffer in zip(models, buffers, strict=True):
        mujoco.mj_saveModel(model, None, buffer)
    return np.array_equal(*buffers)
