"""Define the options that several commands share, and check their values."""

import os
import re
from argparse import Namespace
from functools import partial
from typing import Any

from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of
from measured_report.editions.status import other_damage
from measured_report.files.errors import UsageError, suggestion
from measured_report.measuring.machine import read_device
from measured_report.records.identity import sections

Arguments = Namespace  # the options of a command, and the requested `release`


def read_cluster(cluster: str) -> str:
    if not re.fullmatch(r"(tcp|tls)://[^\s/@]+:[0-9]{1,5}", cluster):
        raise UsageError(
            f"CLUSTER={cluster:.80} is not the address of a Dask scheduler: use "
            "tls://HOST:8786"
        )
    return cluster


def read_address(address: str) -> str:
    if address and not re.fullmatch(r"https?://[^/@\s]+(/[^\s?]*)?", address):
        raise UsageError(
            f"ADDRESS={address} is not the address of a site: use "
            "https://example.org/report/"
        )
    return f"{address.rstrip('/')}/" if address else ""


def read_section(section: str) -> str:
    names = sections()
    if section not in names:
        raise UsageError(
            f"SECTION={section} is not a section{suggestion(section, names)}: use "
            f"one of {', '.join(names)}"
        )
    return section


SHARED: dict[str, dict[str, Any]] = {
    "edition": {  # its option has the name of the report's package
        "dest": "edition",
        "default": "",
        "help": (
            "edition to use instead of the project's own: a release, "
            "git+https://HOST/NAME.git@COMMIT, FOLDER@COMMIT, "
            "or the label of an edition with results, such as 1.2.3@cpu"
        ),
    },
    "with": {
        "dest": "pins",
        "default": "",
        "help": "packages that replace those of the edition, as PACKAGE==1.2.3",
    },
    "profile": {
        "choices": PROFILES,
        "default": "full",
        "help": "quick: use small grids and short runs, stored in results/quick/",
    },
    "device": {
        "type": read_device,
        "help": "kind of device to measure on; the CPU is used only if you give cpu",
    },
    "cluster": {
        "type": read_cluster,
        "help": "Dask scheduler whose workers measure, such as tls://HOST:8786",
    },
    "address": {
        "type": read_address,
        "default": "",
        "help": "address of the published site, such as https://example.org/report/",
    },
    "a": {
        "type": partial(release_of, option="A"),
        "required": True,
        "help": "older edition of the comparison",
    },
    "b": {
        "type": partial(release_of, option="B"),
        "required": True,
        "help": "newer edition of the comparison",
    },
    "claim": {"default": "", "help": "claim to follow, as SECTION.NAME"},
    "value": {
        "default": "",
        "help": "value to follow, as SECTION.NAME (page) or SECTION.CASE.COLUMN (row)",
    },
    "format": {
        "choices": ("text", "markdown", "json"),
        "default": "text",
        "help": "format of the output: text, markdown or json (docs/alarm.md)",
    },
}


def shared(*names: str) -> dict[str, dict[str, Any]]:
    """Return the shared options with these names; ``edition`` also adds ``with``."""
    options = {}
    for name in names:
        options[name] = SHARED[name]
        if name == "edition":
            options["with"] = SHARED["with"]
    return options


def refuse_unmeasured(project: Project, name: str) -> None:
    """Raise UsageError if an edition, other than the project's own, has no results."""
    paths = map(project.record_path, sections(project.root))
    is_measured = any(other_damage(project)) or any(map(os.path.lexists, paths))
    if not project.is_own and not is_measured:
        other_releases = [
            release for release in project.releases if release != project.release
        ]
        name = f"{project.settings.option}={name}"
        raise UsageError(
            f"{name} has no results (editions with results: "
            f"{', '.join(other_releases) or 'none'}): measure it with make upgrade {name}"
        )


def refuse_itself(project: Project, before: str, after: str) -> None:
    if before == after:
        settings = project.settings
        raise UsageError(
            f"{settings.name_of(after)} would be compared with itself: name another "
            f"edition with {settings.option}=, such as the one that make newest "
            "prints"
        )
