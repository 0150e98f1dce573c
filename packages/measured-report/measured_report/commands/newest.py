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
    sides = (replace(project, profile=profile) for profile in PROFILES)
    projects = [side.of(release) for side in sides for release in side.releases]
    newest = max(
        (edition.named for edition in projects), key=lambda release: release.order
    )
    if not (releases := releases_of(package, settings)):
        raise ReportError(
            f"the index says of no release of {package}; this takes the network"
        )
    new = [(str(releases[-1]), "")] if releases[-1].order > newest.order else []
    for partner, *_ in settings.changes.package_groups:
        used = {
            record.identity.packages[partner]
            for edition in projects
            for record in records_of(edition)
        }
        last = [str(release) for release in releases_of(partner, settings)[-1:]]
        new += [
            (newest.version, f"{partner}=={version}")
            for version in last
            if version not in used
        ]
    for release, pins in new[
        :1
    ]:  # under the package's name, and for a workflow that knows none
        label = release_of(release, pins, report=project.report)
        print(
            f"{package}={release}\nwith={pins}\noption={settings.flag}\nrelease={release}\nlabel={label}"
        )
    return 0
