"""Remove an edition, or, where none is named, what searches left."""

import argparse
import shutil
from dataclasses import replace
from pathlib import Path

from measured_report.changes.bisect import ASIDE, CLONE
from measured_report.commands.options import shared
from measured_report.commands.page import build_site
from measured_report.editions.environment import environment_of
from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import read_label
from measured_report.files.atomic import locked
from measured_report.files.config import config
from measured_report.files.errors import UsageError

OPTIONS = shared("edition", "address")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Remove results and environment and build the site."""
    root = project.root
    if project.is_own:
        folders = [root / "results" / ASIDE, root / CLONE, *_lone_environments(root)]
        lacks = f"no search left anything; {config().package} {project.release} is the project's own and stays"
        lacks += f"; {config().option}=1.5.0 names another"
    else:
        sides = [replace(project, profile=profile, aside=aside) for aside in ("", ASIDE) for profile in PROFILES]
        folders = [*(side.results for side in sides), environment_of(arguments.release, root)]
        lacks = f"{config().option}={arguments.release.asked} has neither results nor an environment"
    gone = [folder for folder in folders if folder.is_dir()]
    if not gone:
        raise UsageError(lacks)
    for folder in gone:
        with locked(folder.parent):
            shutil.rmtree(folder)
        print(f"removed {folder.relative_to(root)}/")
    return int(build_site(project.of(project.own_release or project.release), arguments.address)[0])


def _lone_environments(root: Path) -> list[Path]:
    """Find the environments of the clone, and of releases without results; a checkout's may be in use."""
    places = {path: path.name.removeprefix(".venv-") for path in root.glob(f".venv-{config().edition_folder('*')}")}
    lone = {path: place for path, place in places.items() if not any((root / "results" / place).glob("*.json"))}
    return [path for path, place in lone.items() if CLONE in place or read_label(config().edition_in(place))]
