"""Remove an edition, or, where none is named, what searches left."""

import argparse
import shutil
from dataclasses import replace

from measured_report.changes.bisect import ASIDE
from measured_report.commands.options import shared
from measured_report.commands.page import build_site
from measured_report.editions.environment import environment_of
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import read_label
from measured_report.files.config import config
from measured_report.files.errors import UsageError

OPTIONS = shared("edition", "address")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Remove results and environment and build the site."""
    root, rules = project.root, config()
    if project.is_own:
        # An environment whose name is no label is that of a checkout, and may be in use.
        places = {path: path.name.removeprefix(".venv-") for path in root.glob(f".venv-{rules.edition_folder('*')}")}
        lone = (path for path, place in places.items() if not any((root / "results" / place).glob("*.json")))
        folders = [root / "results" / ASIDE, *(path for path in lone if read_label(rules.edition_in(places[path])))]
        lacks = f"no search left anything; {rules.package} {project.release} is the project's own and stays"
    else:
        sides = [replace(project, profile=profile, aside=aside) for aside in ("", ASIDE) for profile in PROFILES]
        folders = [*(side.results for side in sides), environment_of(arguments.release, root)]
        lacks = f"{rules.option}={arguments.release.asked} has neither results nor an environment"
    gone = [folder for folder in folders if folder.is_dir()]
    if not gone:
        raise UsageError(lacks)
    for folder in gone:
        shutil.rmtree(folder)
        print(f"removed {folder.relative_to(root)}/")
    return int(build_site(project.of(project.own_release or project.release), arguments.address)[0])
