"""``--fix``: what findings say to change, tried in MuJoCo C before it is written, and left out where it does harm."""

import difflib
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from xml.parsers import expat

import mujoco
import numpy as np

from newton_lint.advice import ways_of
from newton_lint.findings import Change, Finding
from newton_lint.fix import Unwritable, edited, undo, write
from newton_lint.law import M
from newton_lint.report import Asked, Report, report_of
from newton_lint.source import Source, Texts, parse
from newton_lint.step_rules import THROWN_M_S
from newton_lint.stepped import Run, runs_of
from newton_lint.target import Target, TargetError, compiled, read_target, tried

MEASURED_S = 1.0
"""Time that a scene is stepped before and after a change, by each of its starts."""
DEEPER, DEEPER_M = 1.1, 5e-5
FASTER, FASTER_M_S = 1.05, 2e-3
SLOWER, SLOWEST = 1.8, 3.0
"""How much deeper contacts may get, what rests may move faster, and how much more effort or time it may take."""
SHALLOW_M = 2e-3
"""Depth that a body may have which no longer falls through."""
FREES = ("lost", "stiff", "thrown", "unstable")
"""Rules of what costs little, and has no contacts, only because it falls or flies."""
MOST_TRIES, PASSES = 40, 4
"""Changes that are tried in one pass, and times that scenes which share files are gone over."""


def measured(target: Target) -> list[Run]:
    """Step a scene from each of its starts, for as long as changes are judged by."""
    return runs_of(target.model, target, MEASURED_S)


def harm(before: Sequence[Run], after: Sequence[Run], rules: Collection[str]) -> str:
    """Say in what changes of these rules' findings made a scene worse; empty where they did in nothing."""
    for old, new in zip(before, after, strict=True):
        if new.bad:
            return f"the simulation blows up after {new.time_s:.3g} s from {new.start}"
        if old.bad:
            continue
        thrown = [float(each.thrown_m_s.max(initial=0.0)) for each in (old, new)]
        lies = thrown[0] > THROWN_M_S > 2.0 * thrown[1] and new.deepest_m <= old.deepest_m
        lies |= "lost" in rules and new.deepest_m < SHALLOW_M
        for name, at in (("deepest contact", "deepest_m"), ("deepest contact at the end", "late_m")):
            depth, other = (getattr(each, at) for each in (old, new))
            if other > DEEPER * depth + DEEPER_M and not lies:
                return f"{name} {M * depth:.3g} → {M * other:.3g} mm from {new.start}"
        speed, other = (float(np.abs(each.data.qvel).max(initial=0.0)) for each in (old, new))
        if other > FASTER * speed + FASTER_M_S:
            return f"what moves fastest after {new.time_s:.3g} s: {speed:.3g} → {other:.3g} m/s or rad/s"
    for name, most in () if {*FREES} & {*rules} else (("effort", SLOWER), ("cost_s", SLOWEST)):
        cost, other = (sum(getattr(each, name) for each in runs) for runs in (before, after))
        if other > most * cost:
            return f"a simulated second costs {other / max(cost, 1e-9):.2g} times as much"
    return ""


def _told(runs: Sequence[Run]) -> str:
    depth, cost = max((each.deepest_m for each in runs), default=0.0), sum(each.cost_s for each in runs)
    return f"deepest contact {M * depth:.3g} mm, {cost / max(len(runs), 1):.2g} s a simulated second"


class Mending:
    """A scene whose findings are mended one after the other, each on top of those before it."""

    def __init__(self, target: Target, asked: Asked, others: Sequence[Path]):
        self.target, self.asked, self.others = target, asked, others
        self.report = self.first = report_of(target, asked)
        self.measured = self.begun = measured(target)
        self.texts: dict[Path, bytes] = dict(target.texts)
        self.said: dict[str, str] = {}
        self.rules: set[str] = set()
        while self._pass():
            pass
        if why := harm(self.begun, self.measured, self.rules):
            self.texts, self.report, self.measured = dict(target.texts), self.first, self.begun
            self.said = {line: end or f"with the others {why}" for line, end in self.said.items()}

    def _pass(self) -> bool:
        """Try each change once, and tell whether one did good and no harm: the last pass finds nothing to write."""
        written = {line: end for line, end in self.said.items() if end == ""}
        self.said, left = dict(written), MOST_TRIES
        while left and (found := next((each for each in self._candidates() if each[0] not in self.said), None)):
            line, findings, changes = found
            left -= 1
            self.said[line] = self._tried(findings, changes)
        return list(self.said.values()).count("") > len(written)

    def _candidates(self) -> Iterator[tuple[str, list[Finding], Sequence[Change]]]:
        """Yield findings with changes that may mend them: all of a rule at once, then each by each of its ways."""
        counted = [each for each in self.report.findings if each.severity != "note" and ways_of(each.advice)]
        for rule in dict.fromkeys(each.rule for each in counted):
            findings = [each for each in counted if each.rule == rule]
            changes = [one for each in findings for one in ways_of(each.advice)[0].changes]
            first = {(one.element or one.subject, one.attributes): one for one in changes}
            ways = [(findings, tuple(first.values()))] if len(first) > 1 else []
            ways += [([finding], way.changes) for finding in findings for way in ways_of(finding.advice)]
            yield from ((", ".join(map(str, changes)), meant, changes) for meant, changes in ways)

    def _tried(self, findings: Sequence[Finding], changes: Sequence[Change]) -> str:
        """Take changes over, or say why not."""
        try:
            return self._does(findings, self.texts | edited(changes, self.report.source, self.texts))
        except Unwritable as error:
            return str(error)
        except (ValueError, OSError, expat.ExpatError, mujoco.FatalError) as error:
            return f"MuJoCo refuses it: {' '.join(str(error).split())[:200]}"

    def _does(self, findings: Sequence[Finding], texts: dict[Path, bytes]) -> str:
        """Take texts over that mend findings of one rule, or say why not."""
        rules, target = [findings[0].rule], tried(self.target, texts)
        report = report_of(target, self.asked)
        before, after, known = _counted(self.report), _counted(report), {_key(each) for each in self.report.findings}
        if any(after[_key(finding)] >= before[_key(finding)] for finding in findings):
            return "it does not change what is found"
        if more := [key for key, count in after.items() if key not in known or 0 < before[key] < count]:
            return f"another is found then: {' '.join(filter(None, more[0]))}"
        after_it = measured(target)
        if why := harm(self.measured, after_it, rules) or self._elsewhere(texts, rules):
            return why
        self.texts, self.report, self.measured = texts, report, after_it
        self.rules |= {*rules}
        return ""

    def _elsewhere(self, texts: Texts, rules: Collection[str]) -> str:
        """Say what harm a change of an included file does to the other scenes that are mended."""
        included = {file for file in texts if file != self.target.path}
        for path in self.others if included else ():
            if path != self.target.path and included & {each.file for each in parse(path).walk()}:
                other = Target(path.name, compiled(path), path=path)
                if why := harm(measured(other), measured(tried(other, texts)), rules):
                    return f"{path.name}: {why}"
        return ""

    def lines(self, written: bool) -> Iterator[str]:
        """Yield a line for each change that was tried."""
        for line, why in self.said.items():
            yield f"{line}: {f'is not written: {why}' if why else 'written' if written else 'can be written'}"

    def patch(self) -> Iterator[str]:
        """Yield the change of the files as a patch."""
        for file, text in self.texts.items():
            old, new = (each.decode(errors="replace").splitlines(keepends=True) for each in (file.read_bytes(), text))
            for line in difflib.unified_diff(old, new, f"a/{file}", f"b/{file}"):
                yield line.rstrip("\r\n")


def _key(finding: Finding) -> tuple[str, str, str]:
    return finding.rule, finding.shape, finding.parameter


def _counted(report: Report) -> Counter[tuple[str, str, str]]:
    return Counter(_key(finding) for finding in report.findings if finding.severity != "note")


def fixed(target: Target, asked: Asked, others: Sequence[Path], dry: bool) -> tuple[Report, list[str], str]:
    """Mend a scene's files; return its report as it was, lines of what was done, and why files can't be written."""
    mending = Mending(target, asked, others)
    told, why = [], ""
    if mending.texts and not dry:
        try:
            told = _written(target, mending.texts)
        except TargetError as error:
            why = str(error)
    lines = [*(mending.patch() if dry else ()), *mending.lines(not dry and not why), *told]
    if mending.texts:
        lines.append(f"{target.name}: measured before: {_told(mending.begun)}; after: {_told(mending.measured)}")
    return mending.first, lines, why


def fixed_again(targets: Sequence[str], asked: Asked, paths: Sequence[Path]) -> list[str]:
    """Go over scenes that may share files until none has more to write."""
    told: list[str] = []
    for _ in range(PASSES):
        reads = (read for read in map(read_target, targets) if read.path and read.model is not None)
        wrote = [line for read in reads for line in fixed(read, asked, paths, False)[1] if line.endswith(": written")]
        if not wrote:
            break
        told += wrote
    return told


def fix(changes: Sequence[Change], source: Source, target: Target) -> list[str]:
    """Write changes that have been measured, and tell each."""
    try:
        kept = _written(target, edited(changes, source, {})) if changes else []
    except Unwritable as error:
        raise TargetError(f"{target.name}: is not written: {error}") from error
    return [*(f"{change}: written" for change in changes), *kept]


def _written(target: Target, texts: Texts) -> list[str]:
    expected = compiled(target.path, texts)
    try:
        kept = write(texts)
    except OSError as error:
        raise TargetError(f"{target.name}: is not written: {error}") from error
    try:
        is_same = same(expected, compiled(target.path))
    except ValueError:
        is_same = False
    if not is_same:
        undo([(file.resolve(), old) for file, old in zip(texts, kept, strict=True)])
        raise TargetError(f"{target.name}: is not written: MuJoCo makes another model of the file than was tried")
    return [f"{file}: as it was it is {old.name}" for file, old in zip(texts, kept, strict=True)]


def same(*models: mujoco.MjModel) -> bool:
    """Tell whether models are the same to the last bit."""
    held = [np.empty(mujoco.mj_sizeModel(model), np.uint8) for model in models]
    for model, into in zip(models, held, strict=True):
        mujoco.mj_saveModel(model, None, into)
    return np.array_equal(*held)
