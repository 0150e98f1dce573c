"""Implements ``--fix``: tries changes in MuJoCo C and writes those that do no harm."""

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
"""Time for which a scene is stepped before and after a change, from each start."""
# Contacts may become this many times as deep, and this much deeper [m].
DEEPER = 1.1
DEEPER_M = 5e-5
# Motions may become this many times as fast, and this much faster [m/s or rad/s].
FASTER = 1.05
FASTER_M_S = 2e-3
# A simulated second may take this many times the solver's effort.
SLOWER = 1.8
# It may take this many times the processor time.
SLOWEST = 3.0
# A body whose contacts are below this depth no longer falls through [m].
SHALLOW_M = 2e-3
# A body falls if it reaches this speed.
FALLS_M_S = 3.0
FREES = ("lost", "stiff", "thrown", "unstable")
"""Rules on bodies that fall or fly, which cost little only because nothing touches."""
# At most this many changes are tried in one pass.
MOST_TRIES = 40
# Scenes that share files are mended in at most this many passes.
PASSES = 4


def measured(target: Target) -> list[Run]:
    """Step a scene from each of its starts, long enough to judge a change."""
    return runs_of(target.model, target, MEASURED_S)


def harm(before: Sequence[Run], after: Sequence[Run], rules: Collection[str]) -> str:
    """Return the harm that a change for these rules does, or an empty string."""
    for old, new in zip(before, after, strict=True):
        if new.bad:
            start = new.start.name
            return f"the simulation blows up after {new.time_s:.3g} s from {start}"
        if not old.bad and (reason := _motion_harm(old, new, rules)):
            return reason
    if {*FREES} & {*rules}:
        return ""
    for name, most in (("effort", SLOWER), ("cost_s", SLOWEST)):
        old_cost = sum(getattr(run, name) for run in before)
        new_cost = sum(getattr(run, name) for run in after)
        if new_cost > most * old_cost:
            ratio = new_cost / max(old_cost, 1e-9)
            return f"a simulated second costs {ratio:.2g} times as much"
    return ""


def _motion_harm(old: Run, new: Run, rules: Collection[str]) -> str:
    """Return how contacts get deeper or resting bodies faster, or an empty string."""
    old_thrown = old.thrown_m_s.max(initial=0.0)
    new_thrown = new.thrown_m_s.max(initial=0.0)
    # A body that flew or fell touched nothing, so it may rest in a contact now.
    lies = old_thrown > THROWN_M_S > 2.0 * new_thrown and new.deepest_m <= old.deepest_m
    lies |= "lost" in rules and new.deepest_m < SHALLOW_M
    old_fall = old.speeds_m_s.max(initial=0.0)
    new_fall = new.speeds_m_s.max(initial=0.0)
    lies |= old_fall > FALLS_M_S > 2.0 * new_fall and new.late_m < SHALLOW_M
    for name, field in (
        ("deepest contact", "deepest_m"),
        ("deepest contact at the end", "late_m"),
    ):
        old_depth = getattr(old, field)
        new_depth = getattr(new, field)
        if new_depth > DEEPER * old_depth + DEEPER_M and not lies:
            return (
                f"the {name} goes from {M * old_depth:.3g} to {M * new_depth:.3g} mm"
                f" from {new.start.name}"
            )
    old_speed = np.abs(old.data.qvel).max(initial=0.0)
    new_speed = np.abs(new.data.qvel).max(initial=0.0)
    if new_speed > FASTER * old_speed + FASTER_M_S:
        return (
            f"the fastest speed after {new.time_s:.3g} s goes from {old_speed:.3g} to"
            f" {new_speed:.3g} m/s or rad/s"
        )
    return ""


def _measures(runs: Sequence[Run]) -> str:
    depth = max((run.deepest_m for run in runs), default=0.0)
    cost = sum(run.cost_s for run in runs)
    seconds = cost / max(len(runs), 1)
    return (
        f"the deepest contact is {M * depth:.3g} mm and a simulated second takes"
        f" {seconds:.2g} s"
    )


class Mending:
    """Tries changes for the findings of a scene, each one on top of those before it."""

    def __init__(self, target: Target, request: Request, paths: Sequence[Path]):
        self.target = target
        self.request = request
        self.paths = paths
        self.first = report_of(target, request)
        self.report = self.first
        self.first_runs = measured(target)
        self.runs = self.first_runs
        self.texts: dict[Path, bytes] = dict(target.texts)
        self.outcomes: dict[str, str] = {}
        """For each tried change, the reason why it is not written; empty if it is."""
        self.idle: set[str] = set()
        """Changes that affect no motion."""
        self.rules: set[str] = set()
        while self._pass():
            pass
        # Each change alone does little harm, but many of them may add up.
        if reason := harm(self.first_runs, self.runs, self.rules):
            self.texts = dict(target.texts)
            self.report = self.first
            self.runs = self.first_runs
            self.outcomes = {
                line: why or f"together with the other changes, {reason}"
                for line, why in self.outcomes.items()
            }

    def _pass(self) -> bool:
        """Try each change once. Return whether any of them was taken over."""
        self.outcomes = {line: why for line, why in self.outcomes.items() if not why}
        written = len(self.outcomes)
        for _ in range(MOST_TRIES):
            # An accepted change alters the findings, so list the candidates again.
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
        return list(self.outcomes.values()).count("") > written

    def _candidates(self) -> Iterator[tuple[str, list[Finding], Sequence[Change]]]:
        """Yield the text of changes, the findings that they may mend, and the changes.

        Changes for all findings of a rule come first, then each finding by itself.
        """
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
            candidates = [(of_rule, changes)] if len(changes) > 1 else []
            candidates += [
                ([finding], way.changes)
                for finding in of_rule
                for way in ways_of(finding.advice)
            ]
            yield from (
                (", ".join(map(str, changes)), mended, changes)
                for mended, changes in candidates
            )

    def _outcome(self, findings: Sequence[Finding], changes: Sequence[Change]) -> str:
        """Apply changes, or return why they do harm."""
        try:
            return self._harm(
                findings, self.texts | edited(changes, self.report.source, self.texts)
            )
        except Unwritable as error:
            return str(error)
        except (ValueError, OSError, expat.ExpatError, mujoco.FatalError) as error:
            return f"MuJoCo refuses it: {' '.join(str(error).split())[:200]}"

    def _harm(self, findings: Sequence[Finding], texts: dict[Path, bytes]) -> str:
        """Apply texts that mend findings of one rule, or return why they do harm."""
        rules = [findings[0].rule]
        target = tried(self.target, texts)
        report = report_of(target, self.request)
        before = _counted(self.report)
        after = _counted(report)
        notes = {_key(finding) for finding in self.report.findings}
        if any(after[_key(finding)] >= before[_key(finding)] for finding in findings):
            return "it does not remove the finding"
        if more := [
            key
            for key, count in after.items()
            if key not in notes or 0 < before[key] < count
        ]:
            return f"it causes another finding: {' '.join(filter(None, more[0]))}"
        runs = measured(target)
        if reason := harm(self.runs, runs, rules) or self._harm_elsewhere(texts, rules):
            return reason
        self.texts = texts
        self.report = report
        self.runs = runs
        self.rules |= {*rules}
        return ""

    def _harm_elsewhere(self, texts: Texts, rules: Collection[str]) -> str:
        """Return how a change of an included file harms the other scenes."""
        included = texts.keys() - {self.target.path}
        for path in self.paths if included else ():
            if path != self.target.path and included & {
                element.file for element in parse(path).walk()
            }:
                scene = Target(path.name, compiled(path), path=path)
                if reason := harm(
                    measured(scene), measured(tried(scene, texts)), rules
                ):
                    return f"in {path.name}, {reason}"
        return ""

    def lines(self, written: bool) -> Iterator[str]:
        """Yield a line for each change that was tried."""
        outcome = "written" if written else "can be written"
        for line, why in self.outcomes.items():
            line += " (no effect on the motion)" if line in self.idle else ""
            yield f"{line}: {f'not written because {why}' if why else outcome}"

    def patch(self) -> Iterator[str]:
        """Yield the lines of a patch from the old files to the new ones."""
        for file, text in self.texts.items():
            old = file.read_bytes().decode(errors="replace").splitlines()
            new = text.decode(errors="replace").splitlines()
            yield from difflib.unified_diff(
                old, new, f"a/{file}", f"b/{file}", lineterm=""
            )


def _key(finding: Finding) -> tuple[str, str, str]:
    return finding.rule, finding.shape, finding.parameter


def _counted(report: Report) -> Counter[tuple[str, str, str]]:
    return Counter(
        _key(finding) for finding in report.findings if finding.severity != "note"
    )


def fixed(
    target: Target, request: Request, paths: Sequence[Path], dry: bool
) -> tuple[Report, list[str], str]:
    """Mend the files of a scene.

    Args:
        dry: Whether to print a patch instead of writing the files.

    Returns:
        The report before the changes, lines on each change, and the reason why the
        files cannot be written, which is empty if they can.
    """
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
        lines.append(
            f"{target.name}: before the changes, {before}; after them, {after}"
            " (measured)"
        )
    return mending.first, lines, why


def fixed_again(
    targets: Sequence[str], request: Request, paths: Sequence[Path]
) -> list[str]:
    """Mend scenes that may share files until no scene changes any more."""
    lines: list[str] = []
    for _ in range(PASSES):
        written = []
        for scene in map(read_target, targets):
            if scene.path and scene.model is not None:
                _, changes, _ = fixed(scene, request, paths, dry=False)
                written += [line for line in changes if line.endswith(": written")]
        if not written:
            break
        lines += written
    return lines


def fix(changes: Sequence[Change], source: Source, target: Target) -> list[str]:
    """Write changes that were measured before. Return a line for each of them."""
    try:
        backups = _written(target, edited(changes, source, {})) if changes else []
    except Unwritable as error:
        raise TargetError(f"{target.name}: not written because {error}") from error
    return [*(f"{change}: written" for change in changes), *backups]


def _written(target: Target, texts: Texts) -> list[str]:
    assert target.path is not None  # Only scenes that come from a file are changed.
    expected = compiled(target.path, texts)
    try:
        replaced = write(texts)
    except OSError as error:
        raise TargetError(f"{target.name}: not written: {error}") from error
    try:
        is_expected = are_same(expected, compiled(target.path))
    except ValueError:
        is_expected = False
    if not is_expected:
        undo(replaced)
        raise TargetError(
            f"{target.name}: not written, because MuJoCo compiles the new file to"
            " another model than the one that was measured"
        )
    return [
        f"{file}: the old file is kept as {backup.name}"
        for file, (_, backup) in zip(texts, replaced, strict=True)
    ]


def are_same(*models: mujoco.MjModel) -> bool:
    """Return whether models are equal to the last bit."""
    buffers = [np.empty(mujoco.mj_sizeModel(model), np.uint8) for model in models]
    for model, buffer in zip(models, buffers, strict=True):
        mujoco.mj_saveModel(model, None, buffer)
    return np.array_equal(*buffers)
