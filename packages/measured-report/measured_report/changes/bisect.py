"""Bisect: between which two editions a claim or a value changes, and which package did it; measures what that takes."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from measured_report.changes.query import Answer, Query
from measured_report.editions.project import Project
from measured_report.editions.release import (
    Release,
    folder_at,
    release_of,
    releases_between,
)
from measured_report.editions.status import expected_packages, states_of
from measured_report.files.errors import ReportError, UsageError, suggestion
from measured_report.files.git import git
from measured_report.findings.editions import editions_of
from measured_report.measuring.measure import measure
from measured_report.records.identity import MISSING, package_changes, sections
from measured_report.records.record import load_record

ASIDE = "bisect"  # the folder below `results` of what a search measured


@dataclass(frozen=True)
class Bisection:
    project: Project
    query: Query
    device: str

    def answer(self, release: Release) -> Answer | None:
        """Return what a release answers, measured unless it has records of that."""
        answer = self._measured(release, [self.query.section])
        noise = self.project.report.settings.noise_section
        # Without the section on noise most differences cannot be told.
        if answer is None and noise in sections(self.project.root):
            answer = self._measured(release, [self.query.section, noise])
        print(f"{release}: {self.query.text} {answer_text(answer)}", flush=True)
        return answer

    def _measured(self, release: Release, names: Sequence[str]) -> Answer | None:
        """Ask what a release has of these sections, by itself; what has no record is measured, and kept apart."""
        side = self.side(release, names)
        edition = editions_of(side, among=[side.release])[side.release]
        claims = [*self.query.names(edition.chapters)]
        if (
            self.query.is_claim
            and self.query.section in edition.chapters
            and self.query.text not in claims
        ):
            raise UsageError(
                f"there is no claim {self.query.text}{suggestion(self.query.text, claims)}"
            )
        return self.query.answer(edition.chapters)

    def side(self, release: Release, names: Sequence[str]) -> Project:
        """Return where a release has records of these sections; what is missing is
        measured, and kept apart."""
        side = self.project.of(str(release))
        if _lacking(side, names):
            side = replace(side, aside=ASIDE)
        lacking = _lacking(side, names) if side.aside else []
        return measure(side, release, lacking, self.device) if lacking else side

    def packages(self, release: Release) -> Mapping[str, str]:
        section = self.query.section
        path = self.side(release, [section]).record_path(section)
        return load_record(path).identity.packages


def _lacking(project: Project, names: Sequence[str]) -> list[str]:
    """Return the sections that have to be measured: those without a record, and those
    whose record is of other packages, or, if a search measured it, of older code."""
    states = states_of(project)
    packages = expected_packages(
        project, [state.record for state in states if state.record]
    )
    lacking = []
    for state in states:
        record = state.record
        is_other = not record or package_changes(record.identity.packages, packages)
        is_old = project.aside and state.kind == "stale"
        if state.section in names and (is_other or is_old):
            lacking.append(state.section)
    return lacking


def answer_text(answer: Answer | None) -> str:
    return (
        "cannot tell"
        if answer is None
        else answer
        if isinstance(answer, str)
        else f"{answer:.4g}"
    )


def first_change(
    points: Sequence[Any], is_first: Callable[[Any], bool | None]
) -> tuple[Any, Any, list[Any]]:
    """Return the neighbours between which the answer changes, which first and last differ in, and what can't tell."""
    low = 0
    high = len(points) - 1
    skipped = set[int]()
    while inner := [index for index in range(low + 1, high) if index not in skipped]:
        middle = inner[len(inner) // 2]
        if (is_old := is_first(points[middle])) is None:
            skipped.add(middle)
        elif is_old:
            low = middle
        else:
            high = middle
    return (
        points[low],
        points[high],
        [points[index] for index in sorted(skipped) if low < index < high],
    )


def points_between(first: Release, last: Release) -> list[str]:
    """Name what a search may look at, as a command would: commits of one local repository, or else releases."""
    (path, _, old), (new_path, _, new) = (
        release.asked.rpartition("@") for release in (first, last)
    )
    if path and path == new_path and folder_at(path).is_dir():
        commits = git(
            folder_at(path), "rev-list", "--reverse", "--first-parent", f"{old}..{new}"
        ).split()
        return [
            first.asked,
            *(f"{path}@{commit}" for commit in commits[:-1]),
            last.asked,
        ]
    return [first.asked, *map(str, releases_between(first, last)), last.asked]


def bisect(search: Bisection, first: Release, last: Release) -> str:
    """Say which edition is the first that answers otherwise, and which package did it; UsageError where none does."""
    b, a = (
        search.answer(last),
        search.answer(first),
    )  # the newer one is often measured, and names what there is not
    if a is None or b is None or a == b:
        hint = (
            "; PROFILE=full looks closer" if search.project.profile == "quick" else ""
        )
        raise UsageError(
            f"{search.query.text} is {answer_text(a)} at A and {answer_text(b)} at B{hint}"
        )

    def is_first(release: Release) -> bool | None:
        try:
            answer = search.answer(release)
        except ReportError as error:
            print(f"{release}: cannot be measured: {error}".rstrip(": "), flush=True)
            return None
        return None if answer is None else search.query.is_first(answer, a, b)

    names = first_change(
        points_between(first, last), lambda name: is_first(release_of(name))
    )
    before, after = map(release_of, names[:2])
    lines = [
        f"{search.query.text} changes between {before} and {after}: {answer_text(a)} → {answer_text(b)}"
    ]
    if names[2]:  # each may be the one that differs
        lines += [
            f"no answer from {', '.join(names[2])}: the first that answers otherwise is one of these and {after}"
        ]
    return "\n".join([*lines, _which_package(search, before, after, is_first)])


def _which_package(
    search: Bisection, before: Release, after: Release, is_first: Callable[..., Any]
) -> str:
    """Say which package did it: the older edition takes the newer one's others in turn, as it may run with newer."""
    settings = search.project.report.settings
    old = search.packages(before)
    new = search.packages(after)
    groups = [
        names
        for names in settings.changes.package_groups
        if any(old[name] != new[name] for name in names)
    ]
    pins = [f"{name}=={new[name]}" for names in groups for name in names]
    if any(MISSING in pin for pin in pins):
        return "which package did it cannot be told: one of them is not there in all"
    ways = [sum(map(len, groups[:count])) for count in range(1, len(groups) + 1)]
    steps = [
        before,
        *(release_of(before.asked, " ".join(pins[:count])) for count in ways),
        after,
    ]
    low, high, skipped = first_change(steps, is_first)
    changed = [*groups, (settings.edition,)][steps.index(low) : steps.index(high)]
    names = " or ".join(" and ".join(names) for names in changed)
    return (
        f"it is one of {names}"
        if skipped
        else f"{names} did it: {low} is as before, {high} is not"
    )
