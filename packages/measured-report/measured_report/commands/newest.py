"""Print the release that a workflow should measure next.

This is a newer release if there is one. Otherwise it is the newest release again, until
its measurements show how much its numbers scatter.
"""

from dataclasses import replace
from operator import attrgetter

from measured_report.commands.options import Arguments
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of, releases_of
from measured_report.editions.status import records_of
from measured_report.files.errors import ReportError
from measured_report.findings.replicas import read_replicas

ENOUGH = 3  # chosen: three measurements show how much the numbers of a release scatter


def run(project: Project, arguments: Arguments) -> int:
    settings = project.settings
    package = settings.edition
    sides = [replace(project, profile=profile) for profile in PROFILES]
    projects = [side.of(release) for side in sides for release in side.releases]
    newest = max((each.named for each in projects), key=attrgetter("order"))
    releases = releases_of(package, settings)
    if not releases:
        raise ReportError(
            f"No releases of {package} found on the package index (are you offline?)"
        )
    found = None
    if releases[-1].order > newest.order:
        found = str(releases[-1]), ""
    for partner, *_ in settings.changes.package_groups:
        latest = releases_of(partner, settings)[-1:]
        used = {
            record.identity.packages[partner]
            for edition in projects
            for record in records_of(edition)
        }
        if not found and latest and str(latest[0]) not in used:
            found = newest.version, f"{partner}=={latest[0]}"
    again = ""
    if not found and _lacks_measurements(project.of(str(newest))):
        found = newest.version, " ".join(f"{name}=={pin}" for name, pin in newest.pins)
        again = "true"
    if found:
        release, pins = found
        label = release_of(release, pins, report=project.report)
        # The release is printed twice: under the name of the package, and under a name
        # that does not depend on the report.
        answer = {
            package: release,
            "with": pins,
            "option": settings.flag,
            "release": release,
            "label": label,
            "again": again,
        }
        print("\n".join(f"{name}={value}" for name, value in answer.items()))
    return 0


def _lacks_measurements(project: Project) -> bool:
    """Return whether a deciding section was measured fewer than `ENOUGH` times."""
    names = {record.section for record in records_of(project)}
    deciding = names.intersection(project.settings.changes.upgrade_sections) or names
    replicas, _ = read_replicas(project)
    counts = [sum(name in each for each in replicas.values()) + 1 for name in deciding]
    return min(counts, default=ENOUGH) < ENOUGH
