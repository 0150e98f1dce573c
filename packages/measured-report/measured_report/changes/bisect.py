"""Bisect: between which two editions a claim or a value changes, and which package did it; measures what that takes."""

import re
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TypeVar

from measured_report.changes.query import Answer, Query
from measured_report.editions.project import Project
from measured_report.editions.release import Release, release_of, releases_between
from measured_report.editions.status import state_of
from measured_report.files.atomic import locked
from measured_report.files.config import config
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring.measure import measure
from measured_report.pages.editions import Edition, editions_of
from measured_report.pages.prose import Templates
from measured_report.records.identity import sections as all_sections
from measured_report.records.provenance import MISSING
from measured_report.records.reading import load_record
from measured_report.values.noise import NOISE

Point = TypeVar("Point")
FIRST = re.compile(r"^([0-9a-f]{40}) is the first bad commit", re.MULTILINE)
ASIDE = "bisect"
"""The folder below ``results`` of what a search measured."""
CLONE = ".venv-bisect"
"""The clone that git bisects in."""
ONLY_SKIPPED = "only 'skip'ped commits left"
"""Said by git where no more can be told."""


class Alike(UsageError):
    """Ends of a search that do not differ, or can't tell."""


@dataclass(frozen=True)
class Bisection:
    """A search for where the answer to a query changes."""

    project: Project
    query: Query
    device: str
    templates: Templates
    answers: dict[tuple[str, ...], Answer | None] = field(default_factory=dict)
    """Found before, by what was asked of which edition."""

    def _answer(self, release: Release) -> Answer | None:
        """Return what a release answers, measured unless that was done before."""
        label = str(release)
        asked = (self.query.text, self.project.profile, label)
        if asked not in self.answers:
            edition = self._edition(release, [self.query.section])
            answer = self.query.answer(edition.chapters)
            # Without its noise most differences can't be told.
            if answer is None and NOISE not in edition.chapters and NOISE in all_sections(self.project.root):
                answer = self.query.answer(self._edition(release, [self.query.section, NOISE]).chapters)
            self.answers[asked] = answer
            print(f"step {len(self.answers)}: {label}: {self.query.text} {said(answer)}", flush=True)
        return self.answers[asked]

    def _edition(self, release: Release, sections: Sequence[str]) -> Edition:
        """Derive these sections; what has no record is measured, and kept apart from those of the editions.

        A section that compares editions has this one alone, which is all that its claims about each of them take.
        """
        side = self.side(release, sections)
        lacking = _lacking(side, sections)
        side = measure(side, release, lacking, self.device) if lacking else side
        return editions_of(side, self.templates, among=[side.release])[side.release]

    def side(self, release: Release, sections: Sequence[str] = ()) -> Project:
        """Return where a release's records of these sections, by default the one asked for, are or will be."""
        own = self.project.of(str(release))
        return replace(own, aside=ASIDE) if _lacking(own, sections or [self.query.section]) else own

    def is_first(self, ends: tuple[Answer, Answer], release: Release) -> bool | None:
        """Tell whether a release answers as the first end does; None, and say why, where it can't."""
        try:
            answer = self._answer(release)
        except ReportError as error:
            print(f"{release}: cannot be measured: {error}".rstrip(": "), flush=True)
            return None
        return None if answer is None else self.query.is_first(answer, *ends)

    def ends(self, first: Release, last: Release) -> tuple[Answer, Answer]:
        """Return what both ends answer, which must be measured; Alike when there is nothing to find between them."""
        a, b = self._answer(first), self._answer(last)
        if a is None or b is None or a == b:
            raise Alike(f"{self.query.text} is {said(a)} at A and {said(b)} at B")
        return a, b


def _lacking(project: Project, sections: Sequence[str]) -> list[str]:
    """Name those without a record of what would be measured; one of older code will do."""
    states = [state_of(project, section) for section in sections]
    return [
        each.section for each in states if not each.record or any(note.startswith("packages") for note in each.notes)
    ]


def said(answer: Answer | None) -> str:
    return "cannot tell" if answer is None else answer if isinstance(answer, str) else f"{answer:.4g}"


def first_change(points: Sequence[Point], is_first: Callable[[Point], bool | None]) -> tuple[Point, Point, list[Point]]:
    """Return the neighbours between which the answer changes, and what lies between them that can't tell.

    The first point and the last are known to differ; ``is_first`` is None for one that can't tell.
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


def bisect_releases(search: Bisection, first: Release, last: Release) -> str:
    """Say which release is the first that answers otherwise, and which of its packages does it."""
    is_first = partial(search.is_first, search.ends(first, last))
    between = releases_between(first, last)
    before, after, skipped = first_change([first, *between, last], is_first)
    said = f"{search.query.text} changes between {before} and {after}\n"
    if skipped:
        said += f"between them cannot tell: {', '.join(str(release) for release in skipped)}\n"
    return said + _which_package(search, before, after, is_first)


def _which_package(
    search: Bisection, before: Release, after: Release, is_first: Callable[[Release], bool | None]
) -> str:
    """Say which package did it: the first alone, with the others as they were, or one of those, with the first so."""
    package, together = config().package, config().changes.together
    others = [name for names in together for name in names]
    paths = (search.side(release).record_path(search.query.section) for release in (before, after))
    old, new = (load_record(path).identity.packages for path in paths)
    if not others:
        return f"{package} {after.version} did it: it is the only package"
    if any(old[name] == MISSING for name in others):
        return "which package did it cannot be told: one of them is not there in all"
    if all(old[name] == new[name] for name in others):
        return f"{package} {after} did it: the other packages are the same"
    alone = is_first(_pinned(after, old, others))
    if alone is False:
        kept = ", ".join(f"{name} {old[name]}" for name in others)
        return f"{package} {after.version} did it: it is so with {kept} as well, which {before} has"
    # A newer edition may not run with older packages, but an older one with newer.
    if alone is None and is_first(_pinned(before, new, others)):
        return f"{package} {after.version} did it: {before} stays as it is with all others of {after}"
    found = [
        " and ".join(names)
        for names in together
        if any(old[name] != new[name] for name in names) and is_first(_pinned(before, new, names)) is False
    ]
    if found:
        so = f"{package} {before.version} does so too with that of {after}"
        return f"{' or '.join(found)} did it: {so}"
    return "which package did it cannot be told: no one of them does it alone"


def _pinned(release: Release, versions: Mapping[str, str], packages: Sequence[str]) -> Release:
    return release_of(str(release), " ".join(f"{package}=={versions[package]}" for package in packages))


def bisect_commits(repository: Path, first: str, last: str, clone: Path, is_first: Callable[[], bool | None]) -> str:
    """Find the first commit of a repository that is not as ``first`` is, by ``git bisect`` in a clone at ``clone``.

    ``is_first`` says whether the commit that the clone has now is as the first is; None where it can't tell.
    """
    if not clone.exists():
        _git(clone.parent, "clone", "--quiet", str(repository), str(clone))
    with locked(clone):
        _git(clone, "remote", "set-url", "origin", str(repository))  # it may be left of a search in another one
        _git(clone, "fetch", "--quiet", "--tags", "origin")
        known = [_git(repository, "rev-parse", f"{name}^{{commit}}").strip() for name in (last, first)]
        _git(clone, "bisect", "reset")  # it may be left of a search that was stopped
        said = _git(clone, "bisect", "start", *known)
        while not (found := FIRST.search(said)):
            if ONLY_SKIPPED in said:
                raise ReportError(f"no first commit was found: {said.strip().splitlines()[-1]}")
            said = _git(clone, "bisect", {True: "good", False: "bad", None: "skip"}[is_first()])
        _git(clone, "bisect", "reset")
        return _git(clone, "show", "-s", "--format=%h %cs %s", found[1]).strip()


def _git(folder: Path, *command: str) -> str:
    done = subprocess.run(["git", "-C", folder, *command], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode and ONLY_SKIPPED not in done.stdout:
        raise UsageError(f"git {' '.join(command[:2])} failed in {folder}")
    return done.stdout


def commit_count(repository: Path, first: str, last: str) -> int:
    """Count the commits that a search between two may have to look at."""
    return int(_git(repository, "rev-list", "--count", f"{first}..{last}"))


def common_repository(first: Release, last: Release) -> tuple[Path, str, str] | None:
    """Return the local repository that both are commits of, and their references; None where they are not."""
    (path, _, old), (other, _, new) = (release.asked.rpartition("@") for release in (first, last))
    return (Path(path), old, new) if path and path == other and Path(path).is_dir() else None
