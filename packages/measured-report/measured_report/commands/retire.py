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

OPTIONS = {
    **shared("edition", "address"),
    "list": {"action": "store_true", "help": "1: only list what there is, with sizes"},
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Remove results and environment and build the site; with LIST=1 only say how much there is."""
    root = project.root
    if arguments.list:
        sizes = {folder: _bytes_in(folder) for folder in [*_folders(root), *_left_by_searches(root)]}
        for folder, size in sizes.items():
            print(f"{size / 1e6:9.1f} MB  {folder.relative_to(root)}/")
        print(f"{sum(sizes.values()) / 1e6:9.1f} MB  in all")
        return 0
    if project.is_own:
        gone = _left_by_searches(root)
        lacks = f"no search left anything; {config().package} {project.release} is the project's own and stays"
        lacks += f"; {config().option}=1.5.0 names another"
    else:
        sides = [replace(project, profile=profile, aside=aside) for aside in ("", ASIDE) for profile in PROFILES]
        folders = [*(side.results for side in sides), environment_of(arguments.release, root)]
        gone = [folder for folder in folders if folder.is_dir()]
        lacks = f"{config().option}={arguments.release.asked} has neither results nor an environment"
    if not gone:
        raise UsageError(lacks)
    for folder in gone:
        with locked(folder.parent):
            shutil.rmtree(folder)
        print(f"removed {folder.relative_to(root)}/")
    return int(build_site(project.of(project.own_release or project.release), arguments.address)[0])


def _folders(root: Path) -> list[Path]:
    """Find the folders of editions: their environments and results."""
    name = config().edition_folder("*")
    return sorted([*root.glob(f".venv-{name}"), *root.glob(f"results/{name}"), *root.glob(f"results/quick/{name}")])


def _left_by_searches(root: Path) -> list[Path]:
    """Find what bisect made: its records, its clone, environments of what has no records, and empty folders."""
    folders = _folders(root)
    kept = {f".venv-{folder.name}" for folder in folders if any(folder.glob("*.json"))}
    lone = [
        folder
        for folder in folders
        if (folder.parent == root and folder.name not in kept and _is_of_search(folder.name))
        or not any(folder.iterdir())
    ]
    return [folder for folder in (root / "results" / ASIDE, root / CLONE) if folder.is_dir()] + lone


def _is_of_search(name: str) -> bool:
    """Tell whether an environment of that name is of a release or of the clone; a checkout's may be in use."""
    place = name.removeprefix(".venv-")
    return place.startswith(config().edition_folder(CLONE)) or read_label(config().edition_in(place)) is not None


def _bytes_in(folder: Path) -> int:
    return sum(path.lstat().st_size for path in folder.rglob("*"))
