"""Print, for a workflow, the newest release in the index, or of one other package, if newer than all here."""

from dataclasses import replace

from measured_report.commands.options import Arguments
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of, releases_of
from measured_report.editions.status import records_of
from measured_report.files.errors import ReportError


def run(project: Project, arguments: Arguments) -> int:
    settings = project.settings
    package = settings.edition
    sides = [replace(project, profile=profile) for profile in PROFILES]
    projects = [side.of(release) for side in sides for release in side.releases]
    newest = max((each.named for each in projects), key=lambda named: named.order)
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
    if found:  # under the package's name, and for a workflow that knows none
        release, pins = found
        label = release_of(release, pins, report=project.report)
        print(
            f"{package}={release}\nwith={pins}\noption={settings.flag}\nrelease={release}\nlabel={label}"
        )
    return 0
