"""Options that several commands share. Each refuses what makes no sense, in one line."""

import re
from argparse import Namespace
from functools import partial
from typing import Any

from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of
from measured_report.files.errors import UsageError, suggestion
from measured_report.measuring.machine import read_device
from measured_report.records.identity import sections

Arguments = Namespace  # the options of a command, and the `release` that is asked for


def read_cluster(cluster: str) -> str:
    if not re.fullmatch(r"(tcp|tls)://[^\s/@]+:[0-9]{1,5}", cluster):
        raise UsageError(
            f"CLUSTER={cluster:.80} is no Dask scheduler; use one as tls://HOST:8786"
        )
    return cluster


def read_address(address: str) -> str:
    if address and not re.fullmatch(r"https?://[^/@\s]+(/[^\s?]*)?", address):
        raise UsageError(
            f"ADDRESS={address} is no address of a site; use one as https://example.org/report/"
        )
    return f"{address.rstrip('/')}/" if address else ""


def read_section(section: str) -> str:
    names = sections()
    if section not in names:
        raise UsageError(
            f"SECTION={section} is no section{suggestion(section, names)}; use one of: {', '.join(names)}"
        )
    return section


SHARED: dict[str, dict[str, Any]] = {
    "edition": {  # which is typed as the report calls it
        "dest": "edition",
        "default": "",
        "help": "edition other than the project's own: a release, git+https://HOST/NAME.git@COMMIT, "
        "FOLDER@COMMIT, or the label of what has results, as 1.2.3@cpu",
    },
    "with": {
        "dest": "pins",
        "default": "",
        "help": "other packages than it comes with, as PACKAGE==1.2.3",
    },
    "profile": {
        "choices": PROFILES,
        "default": "full",
        "help": "quick: small grids, short runs, in results/quick/",
    },
    "device": {
        "type": read_device,
        "help": "kind of device to measure on; a CPU, which is cpu, only when asked",
    },
    "cluster": {
        "type": read_cluster,
        "help": "a Dask scheduler whose workers measure, as tls://HOST:8786",
    },
    "address": {
        "type": read_address,
        "default": "",
        "help": "where the site will lie: https://example.org/report/",
    },
    "a": {
        "type": partial(release_of, option="A"),
        "required": True,
        "help": "edition to compare from",
    },
    "b": {
        "type": partial(release_of, option="B"),
        "required": True,
        "help": "edition to compare with it",
    },
    "claim": {"default": "", "help": "claim to follow, as SECTION.NAME"},
    "value": {
        "default": "",
        "help": "value, as SECTION.NAME of the page, or SECTION.CASE.COLUMN of a row",
    },
    "format": {
        "choices": ("text", "markdown", "json"),
        "default": "text",
        "help": "text, markdown or json (docs/alarm.md)",
    },
}


def shared(*names: str) -> dict[str, dict[str, Any]]:
    """Return shared options by their names; ``edition`` brings ``with``."""
    options = {}
    for name in names:
        options[name] = SHARED[name]
        if name == "edition":
            options["with"] = SHARED["with"]
    return options


def refuse_unmeasured(project: Project, name: str) -> None:
    """Raise UsageError for an edition without results, unless it is the project's own."""
    paths = map(project.record_path, sections(project.root))
    if not project.is_own and not any(path.exists() for path in paths):
        others = [each for each in project.releases if each != project.release]
        name = f"{project.settings.option}={name}"
        raise UsageError(
            f"{name} has no results (there are: {', '.join(others) or 'none'}); make upgrade {name} measures it"
        )


def refuse_itself(project: Project, before: str, after: str) -> None:
    if before == after:
        settings = project.settings
        raise UsageError(
            f"{settings.name_of(after)} would be compared with itself; {settings.option}= names another edition, as make newest does"
        )
