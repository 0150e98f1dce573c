"""Find the two neighbouring editions between which a claim or a value changes.

The search also finds the package that caused the change. It measures missing records.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from typing import Any

from measured_report.changes.query import Answer, Query
from measured_report.editions.project import Project
from measured_report.editions.release import (
    Release,
    folder_at,
    release_of,
    releases_between,
)
from measured_report.editions.status import Kind, expected_packages, states_of
from measured_report.files.config import Report
from measured_report.files.errors import ReportError, UsageError, suggestion
from measured_report.files.git import git
from measured_report.findings.editions import editions_of
from measured_report.measuring.measure import measure
from measured_report.records.identity import MISSING, package_changes, sections
from measured_report.records.record import load_record

ASIDE = "bisect"  # the folder below `results` for the measurements of a search


@dataclass(frozen=True)
class Bisection:
    project: Project
    query: Query
    device: str

    def answer(self, release: Release) -> Answer | None:
        """Return the answer of a release.

        If records are missing, the release is measured first.
        """
        answer = self._measured(release, [self.query.section])
        noise = self.project.settings.noise_section
        # Most claims need the section that measures the noise.
        if answer is None and noise in sections(self.project.root):
            answer = self._measured(release, [self.query.section, noise])
        print(f"{release}: {self.query.text} {answer_text(answer)}", flush=True)
        return answer

    def _measured(self, release: Release, names: Sequence[str]) -> Answer | None:
        """Return the answer of a release from these sections only."""
        side = self.side(release, names)
        chapters = editions_of(side, among=[side.release])[side.release].chapters
        if self.query.is_claim and self.query.section in chapters:
            claims = [*self.query.names(chapters)]
            if self.query.text not in claims:
                similar = suggestion(self.query.text, claims)
                raise UsageError(
                    f"claim {self.query.text} does not exist: use the name of a "
                    f"claim{similar}"
                )
        return self.query.answer(chapters)

    def side(self, release: Release, names: Sequence[str]) -> Project:
        """Return the project that has records of these sections for a release.

        Missing records are measured and kept in a separate folder.
        """
        side = self.project.of(str(release))
        if not _lacking(side, names):
            return side
        side = replace(side, aside=ASIDE)
        lacking = _lacking(side, names)
        return measure(side, release, lacking, self.device) if lacking else side

    def packages(self, release: Release) -> Mapping[str, str]:
        section = self.query.section
        path = self.side(release, [section]).record_path(section)
        return load_record(path).identity.packages


def _lacking(project: Project, names: Sequence[str]) -> list[str]:
    """Return the sections that must be measured.

    These are sections without a record or with other packages. A record of an earlier
    search must also have the current code.
    """
    states = states_of(project)
    records = [state.record for state in states if state.record]
    packages = expected_packages(project, records)
    lacking = []
    for state in states:
        record = state.record
        is_other = not record or package_changes(record.identity.packages, packages)
        is_old = project.aside and state.kind == Kind.STALE
        if state.section in names and (is_other or is_old):
            lacking.append(state.section)
    return lacking


def answer_text(answer: Answer | None) -> str:
    if answer is None:
        return "cannot tell"
    return answer if isinstance(answer, str) else f"{answer:.4g}"


def first_change(
    points: Sequence[Any], is_first: Callable[[Any], bool | None]
) -> tuple[Any, Any, list[Any]]:
    """Return the two neighbours between which the answer changes.

    The first and the last point must have different answers. Also return the points
    between them whose answer is unknown.
    """
    low = 0
    high = len(points) - 1
    skipped = set[int]()
    while inner := [index for index in range(low + 1, high) if index not in skipped]:
        middle = inner[len(inner) // 2]
        is_old = is_first(points[middle])
        if is_old is None:
            skipped.add(middle)
        elif is_old:
            low = middle
        else:
            high = middle
    between = [points[index] for index in sorted(skipped) if low < index < high]
    return points[low], points[high], between


def points_between(project: Project, first: Release, last: Release) -> list[str]:
    """Return the editions from the first to the last, named as on the command line.

    They are commits if both ends are commits of one local repository, and otherwise
    releases.
    """
    path, _, old = first.spec.rpartition("@")
    new_path, _, new = last.spec.rpartition("@")
    folder = folder_at(path, project.report.root)
    if path and path == new_path and folder.is_dir():
        order = ("--reverse", "--first-parent")
        commits = git(folder, "rev-list", *order, f"{old}..{new}").split()
        points = [f"{path}@{commit}" for commit in commits[:-1]]
    else:
        points = [str(release) for release in releases_between(first, last)]
    return [first.spec, *points, last.spec]


def bisect(search: Bisection, first: Release, last: Release) -> str:
    """Return a text that names the neighbours of the change and its cause."""
    report = search.project.report
    # Start with the newer edition: it is often measured, and its claims are the names
    # that exist.
    b = search.answer(last)
    a = search.answer(first)
    if a is None or b is None or a == b:
        is_quick = search.project.profile == "quick"
        hint = "; PROFILE=full measures more precisely" if is_quick else ""
        raise UsageError(
            f"{search.query.text} does not change from A ({answer_text(a)}) to B "
            f"({answer_text(b)}): use editions with different answers{hint}"
        )

    def is_first(release: Release) -> bool | None:
        try:
            answer = search.answer(release)
        except ReportError as error:
            print(
                f"{release} cannot be measured: {error}".rstrip(": "),
                flush=True,
            )
            return None
        return None if answer is None else search.query.is_first(answer, a, b)

    points = points_between(search.project, first, last)

    def is_first_at(name: str) -> bool | None:
        return is_first(release_of(name, report=report))

    old, new, undecided = first_change(points, is_first_at)
    before = release_of(old, report=report)
    after = release_of(new, report=report)
    lines = [
        f"{search.query.text} changes between {before} and {after}: "
        f"{answer_text(a)} → {answer_text(b)}"
    ]
    if undecided:
        lines.append(
            f"no answer from {', '.join(undecided)}: the first edition with the new "
            f"answer is one of these or {after}"
        )
    return "\n".join([*lines, _which_package(search, before, after, is_first)])


def _which_package(
    search: Bisection, before: Release, after: Release, is_first: Callable[..., Any]
) -> str:
    """Return a text that names the package which caused the change.

    To find it, the newer versions of the other packages are installed beside the older
    edition, one group after another. If it does not run with them, the older versions are
    installed beside the newer edition.
    """
    settings = search.project.settings
    old = search.packages(before)
    new = search.packages(after)
    groups = [
        names
        for names in settings.changes.package_groups
        if any(old.get(name, MISSING) != new.get(name, MISSING) for name in names)
    ]
    own = [(settings.edition,)]
    counts = range(len(groups) + 1)
    report = search.project.report
    newer = [_with(before, new, groups[:count], report) for count in counts]
    older = [_with(after, old, groups[count:], report) for count in counts]
    paths = ([*newer, after], [*groups, *own]), ([before, *older], [*own, *groups])
    candidates = []
    for steps, parts in paths:
        low, high, skipped = first_change(steps, is_first)
        changed = parts[steps.index(low) : steps.index(high)]
        names = " or ".join(" and ".join(group) for group in changed)
        if not skipped:
            return (
                f"the cause is {names}: {low} has the old answer, and {high} the new "
                "one"
            )
        candidates.append(f"the cause is one of {names}")
    return min(candidates, key=len)


def _with(
    release: Release,
    versions: Mapping[str, str],
    groups: Sequence[Sequence[str]],
    report: Report,
) -> Release:
    """Return a release with these versions of the packages in some groups."""
    pins = [
        f"{name}=={versions[name]}"
        for name in chain(*groups)
        if versions.get(name, MISSING) != MISSING
    ]
    return release_of(release.spec, " ".join(pins), report=report)
