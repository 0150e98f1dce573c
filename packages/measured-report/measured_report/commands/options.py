"""Options that several commands share. Each refuses what makes no sense, in one line."""

import re
from argparse import Namespace
from functools import partial
from typing import Any

from measured_report.editions.project import PROFILES, Project
from measured_report.editions.release import release_of
from measured_report.files.config import Config
from measured_report.files.config import report as current
from measured_report.files.errors import UsageError
from measured_report.measuring.accelerator import read_device
from measured_report.records.identity import sections

Arguments = Namespace  # what a command is given: its options by their names, and the `release` that is asked for


def read_cluster(cluster: str) -> str:
    if cluster != "local" and not re.fullmatch(
        r"(tcp|tls)://[^\s/@]+:[0-9]{1,5}", cluster
    ):
        raise UsageError(
            f"CLUSTER={cluster:.80} names no workers; use local, or a scheduler as tls://HOST:8786"
        )
    return cluster


def read_address(address: str) -> str:
    if address and not re.fullmatch(r"https?://[^/@\s]+(/[^\s?]*)?", address):
        raise UsageError(
            f"ADDRESS={address} is no address of a site; use one as https://example.org/report/"
        )
    return f"{address.rstrip('/')}/" if address else ""


FORMATS = ("text", "markdown", "json")
SHARED: dict[str, dict[str, Any]] = {
    "edition": {  # which is typed as the report calls it
        "dest": "edition",
        "default": "",
        "help": "edition where not the project's own: a release, a checkout, a wheel, "
        "git+https://HOST/NAME.git@ref, or the label of what has results, as 1.2.3@cpu",
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
        "help": "who measures: local (all devices of this host) or tls://scheduler:8786",
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
        "choices": FORMATS,
        "default": "text",
        "help": "text, markdown or json (docs/alarm.md)",
    },
}


def shared(*names: str) -> dict[str, dict[str, Any]]:
    """Pick shared options by their names; ``edition`` brings ``with``."""
    options = (
        option
        for name in names
        for option in ((name, "with") if name == "edition" else (name,))
    )
    return {option: SHARED[option] for option in options}


def refuse_unmeasured(project: Project, name: str) -> None:
    """Refuse an edition without results where nothing is to be measured, but for the project's own."""
    if not project.is_own and not any(
        project.record_path(section).exists() for section in sections(project.root)
    ):
        measured = (
            ", ".join(
                release for release in project.releases if release != project.release
            )
            or "none"
        )
        name = f"{project.settings.option}={name}"
        raise UsageError(
            f"{name} has no results (there are: {measured}); make upgrade {name} measures it"
        )


def refuse_itself(before: str, after: str, settings: Config | None = None) -> None:
    if before == after:
        settings = settings or current().settings
        name, option = settings.name_of(after), settings.option
        raise UsageError(
            f"{name} would be compared with itself; {option}= names another edition, as make newest does"
        )
