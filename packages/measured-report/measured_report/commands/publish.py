"""Check site/ and put it at TARGET, or on the branch gh-pages of git's origin."""

from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.site.publish import publish

OPTIONS = {"target": {"default": "", "help": "where to publish: dir:PATH or git:REMOTE"}}


def run(project: Project, arguments: Arguments) -> int:
    print(f"published at {publish(project.site, arguments.target)}")
    return 0
