"""Bisect: between which two editions a claim or a value changes, and which package did it; measures what that takes."""

import re
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from measured_report import ReportError, UsageError
from measured_report.changes.question import Answer, Question
from measured_report.deriving.editions import Edition, derive_edition
from measured_report.editions.project import Project
from measured_report.editions.stack import Stack, releases_between, stack_of
from measured_report.editions.status import state_of
from measured_report.files.files import locked
from measured_report.measuring.measure import measure
from measured_report.pages.page import Templates
from measured_report.records.record import Record
from measured_report.values.noise import NOISE

Point = TypeVar("Point")
FIRST = re.compile(r"^([0-9a-f]{40}) is the first bad commit", re.MULTILINE)
UNITS = {"warp-lang": ("warp-lang",), "mujoco-warp and mujoco": ("mujoco-warp", "mujoco")}
"""Packages that are changed together, besides newton itself: the two of MuJoCo come out together."""
AS_FIRST, AS_LAST, CANNOT_TELL = 0, 3, 125
"""How ``judge`` ends. What breaks, as an import does, ends with 1, which git would take for an answer."""
FOR_GIT = (
    "sh",
    "-c",
    f'"$@"; case $? in {AS_FIRST}) ;; {AS_LAST}) exit 1 ;; 130) exit 130 ;; *) exit 125 ;; esac',
    "sh",
)
"""Runs a judge and ends as ``git bisect run`` wants it: 0, 1, or 125 for what can't be told; Ctrl-C ends the search."""


class Alike(UsageError):
    """The two ends of a search do not differ, or can't tell."""


@dataclass(frozen=True)
class Bisection:
    """One search: what is asked, and how it is measured."""

    project: Project
    question: Question
    device: str
    templates: Templates

    def answer(self, stack: Stack) -> Answer | None:
        """What a stack answers, measured unless that was done before; None, and why is said, where it can't tell."""
        try:
            return self._answer(stack)
        except ReportError as error:
            print(f"{stack.label}: cannot be measured: {error}".rstrip(": "), flush=True)
            return None

    def _answer(self, stack: Stack) -> Answer | None:
        edition = self._edition(stack, [self.question.section])
        answer = self.question.answer(edition.chapters)
        if answer is None and NOISE not in edition.chapters:  # without which most differences can't be told
            answer = self.question.answer(self._edition(stack, [self.question.section, NOISE]).chapters)
        print(f"{stack.label}: {self.question.text} {_said(answer)}", flush=True)
        return answer

    def _edition(self, stack: Stack, sections: Sequence[str]) -> Edition:
        project = self.project.of(str(stack.label))
        lacking = [section for section in sections if not _is_measured(project, section)]
        if lacking:
            project = measure(project, stack, lacking, self.device)
        return derive_edition(project, self.templates)

    def record(self, stack: Stack) -> Record:
        return state_of(self.project.of(str(stack.label)), self.question.section).record

    def ends(self, first: Stack, last: Stack) -> tuple[Answer, Answer]:
        """What both ends answer, which must be measured; Alike when there is nothing to find between them."""
        answers = self._answer(first), self._answer(last)
        if None in answers or answers[0] == answers[1]:
            raise Alike(f"{self.question.text} is {_said(answers[0])} at A and {_said(answers[1])} at B")
        return answers


def _is_measured(project: Project, section: str) -> bool:
    """Whether a record is there of what would be measured; one of older code will do."""
    state = state_of(project, section)
    return bool(state.record) and not any(note.startswith("packages") for note in state.notes)


def _said(answer: Answer | None) -> str:
    return "cannot tell" if answer is None else answer if isinstance(answer, str) else f"{answer:.4g}"


def first_change(points: Sequence[Point], is_first: Callable[[Point], bool | None]) -> tuple[Point, Point, list[Point]]:
    """The neighbours between which the answer changes, and what lies between them that can't tell.

    Args:
        points: In order; the first and the last are known to differ.
        is_first: Whether a point is as the first is; None where it can't tell.
    """
    low, high, skipped = 0, len(points) - 1, set[int]()
    while inner := [place for place in range(low + 1, high) if place not in skipped]:
        middle = inner[len(inner) // 2]
        found = is_first(points[middle])
        if found is None:
            skipped.add(middle)
        elif found:
            low = middle
        else:
            high = middle
    return points[low], points[high], [points[place] for place in sorted(skipped) if low < place < high]


def bisect_releases(search: Bisection, first: Stack, last: Stack) -> str:
    """The first release that answers otherwise, and which of its packages does it."""
    ends = search.ends(first, last)

    def is_first(stack: Stack) -> bool | None:
        answer = search.answer(stack)
        return None if answer is None else search.question.is_as(answer, *ends)

    between = [stack_of(release) for release in releases_between(first.label, last.label)]
    before, after, skipped = first_change([first, *between, last], is_first)
    lines = [f"{search.question.text} changes between {before.label} and {after.label}"]
    if skipped:
        lines.append(f"between them cannot tell: {', '.join(str(stack.label) for stack in skipped)}")
    lines.append(_which_package(search, before, after, is_first))
    return "\n".join(lines)


def _which_package(search: Bisection, before: Stack, after: Stack, is_first: Callable[[Stack], bool | None]) -> str:
    """Newton alone first, with the other packages as they were; then each of those alone, with Newton as it was."""
    old, new = (search.record(stack).identity.packages for stack in (before, after))
    if not all(old[package] != "missing" for unit in UNITS.values() for package in unit):
        return "which package did it cannot be told: one of them is not there in all"
    alone = is_first(stack_of(str(after.label), _pinned(old, [package for unit in UNITS.values() for package in unit])))
    if alone is False:
        kept = ", ".join(f"{package} {old[package]}" for unit in UNITS.values() for package in unit)
        return f"newton {after.label.version} did it: it is so with {kept} as well, which {before.label} has"
    if alone is None:  # a newer Newton may not run with older packages, but an older one with newer
        rest = [package for unit in UNITS.values() for package in unit]
        if is_first(stack_of(str(before.label), _pinned(new, rest))):
            return (
                f"newton {after.label.version} did it: {before.label} stays as it is with all others of {after.label}"
            )
    found = [
        name
        for name, packages in UNITS.items()
        if any(old[package] != new[package] for package in packages)
        and is_first(stack_of(str(before.label), _pinned(new, packages))) is False
    ]
    if found:
        return f"{' or '.join(found)} did it: newton {before.label.version} does so too with that of {after.label}"
    return "which package did it cannot be told: no one of them does it alone"


def _pinned(versions: Mapping[str, str], packages: Sequence[str]) -> str:
    return " ".join(f"{package}=={versions[package]}" for package in packages)


def bisect_commits(repository: Path, first: str, last: str, judge: Sequence[str], clone: Path) -> str:
    """The first commit of a repository that ``judge`` takes for the last, by ``git bisect run`` in a clone.

    Args:
        judge: A command that ends with AS_FIRST where the clone is as ``first``, with AS_LAST where it is as ``last``,
            and in any other way where it can't tell.
    """
    if not clone.exists():
        _git(clone.parent, "clone", "--quiet", str(repository), str(clone))
    with locked(clone):
        _git(clone, "remote", "set-url", "origin", str(repository))  # it may be left of a search in another one
        _git(clone, "fetch", "--quiet", "--tags", "origin")
        known = [_git(repository, "rev-parse", f"{name}^{{commit}}").strip() for name in (last, first)]
        return _bisect_clone(clone, known, judge)


def _bisect_clone(clone: Path, known: Sequence[str], judge: Sequence[str]) -> str:
    _git(clone, "bisect", "reset")
    _git(clone, "bisect", "start", *known)
    said = _git(clone, "bisect", "run", *FOR_GIT, *judge)
    found = FIRST.search(said)
    _git(clone, "bisect", "reset")
    if not found:
        raise ReportError(f"no first commit was found: {said.strip().splitlines()[-1] if said.strip() else 'no word'}")
    return _git(clone, "show", "-s", "--format=%h %cs %s", found[1]).strip()


def _git(folder: Path, *command: str) -> str:
    done = subprocess.run(["git", "-C", folder, *command], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode and command[:2] != ("bisect", "run"):
        raise UsageError(f"git {' '.join(command[:2])} failed in {folder}")
    return done.stdout


def common_repository(first: Stack, last: Stack) -> tuple[Path, str, str] | None:
    """The local repository that both are commits of, and their references; None where they are not."""
    paths = [stack.asked.rpartition("@") for stack in (first, last)]
    if paths[0][0] and paths[0][0] == paths[1][0] and Path(paths[0][0]).is_dir():
        return Path(paths[0][0]), paths[0][2], paths[1][2]
    return None
