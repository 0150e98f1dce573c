"""Print the release that a workflow should measure next.

If a newer release exists, this is that release. Otherwise it is the newest measured
release again, until there are enough measurements of it to show how much they scatter.
"""

from dataclasses import replace
from operator import attrgetter

from measured_report.commands.options import Arguments
from measured_report.commands.status import print_damage_of
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of, releases_of
from measured_report.editions.status import records_of
from measured_report.files.errors import ReportError
from measured_report.findings.replicas import read_replicas

ENOUGH = 3  # chosen: the number of measurements that show how much the numbers scatter


def run(project: Project, arguments: Arguments) -> int:
    settings = project.settings
    package = settings.edition
    sides = [replace(project, profile=profile) for profile in PROFILES]
    projects = [side.of(release) for side in sides for release in side.releases]
    newest = max((edition.named for edition in projects), key=attrgetter("order"))
    releases = releases_of(package, settings)
    if not releases:
        raise ReportError(
            f"No releases of {package} found on the package index (are you offline?)"
        )
    next_release = None  # the release and its pins
    if releases[-1].order > newest.order:
        next_release = str(releases[-1]), ""
    for partner, *_ in settings.changes.package_groups:
        latest = releases_of(partner, settings)[-1:]
        measured_versions = {
            record.identity.packages.get(partner)
            for edition in projects
            for record in records_of(edition)
        }
        if not next_release and latest and str(latest[0]) not in measured_versions:
            next_release = newest.version, f"{partner}=={latest[0]}"
    is_repeat = False
    if not next_release and _lacks_measurements(project.of(str(newest))):
        pins = " ".join(f"{name}=={pin}" for name, pin in newest.pins)
        next_release = newest.version, pins
        is_repeat = True
    if next_release:
        release, pins = next_release
        label = release_of(release, pins, report=project.report)
        # The release is printed twice: under the name of the package, and under a name
        # that does not depend on the report.
        outputs = {
            package: release,
            "with": pins,
            "option": settings.flag,
            "release": release,
            "label": label,
            "again": "true" if is_repeat else "",
        }
        print("\n".join(f"{name}={value}" for name, value in outputs.items()))
    return int(print_damage_of(project))


def _lacks_measurements(project: Project) -> bool:
    """Return whether a deciding section was measured fewer than `ENOUGH` times."""
    names = {record.section for record in records_of(project)}
    deciding = names.intersection(project.settings.changes.upgrade_sections) or names
    replicas, _ = read_replicas(project)
    counts = [
        sum(name in records for records in replicas.values()) + 1 for name in deciding
    ]
    return min(counts, default=ENOUGH) < ENOUGH
