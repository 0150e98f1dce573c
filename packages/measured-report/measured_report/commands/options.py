"""Options of the command line: what each may be. Each refuses what makes no sense, in one line."""

from argparse import Namespace
from collections.abc import Iterable
from functools import partial
from typing import Any

from measured_report.editions.devices import DEVICES
from measured_report.editions.project import PROFILES, own_release
from measured_report.editions.stack import stack_of
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT
from measured_report.files.suggestion import suggestion
from measured_report.measuring.cluster_address import read_cluster
from measured_report.records.identity import sections


def _section(name: str) -> str:
    if name not in sections():
        fault = f"SECTION={name} is no section" if name else "SECTION is missing"
        if name.isidentifier() and (ROOT / "experiments" / f"{name}.py").is_file():
            fault += f": there is no report/sections/{name}.py"
        else:
            fault += suggestion(name, sections())
        raise UsageError(f"{fault}; use one of: {', '.join(sections())}")
    return name


def _pins(text: str) -> str:
    stack_of(own_release(), text)
    return text


def _one_of(option: str, names: Iterable[str], said: str, default: str | None = None) -> dict[str, Any]:
    def read(name: str) -> str:
        if name not in names:
            raise UsageError(f"{option}={name} is no {option.lower()}; use one of: {', '.join(names)}")
        return name

    return {"type": read, "default": default, "help": said}


def _port(text: str) -> int:
    if not (text.isascii() and text.isdigit() and 0 < int(text[:6]) < 65536):
        raise UsageError(f"PORT={text} is no port; use a number from 1 to 65535")
    return int(text)


def _address(address: str) -> str:
    if address and not address.startswith(("https://", "http://")):
        raise UsageError(f"ADDRESS={address} is no address of a site; use one as https://example.org/report/")
    return f"{address.rstrip('/')}/" if address else ""


def flag(value: str) -> str:
    if value != "1":
        raise UsageError(f"a switch is on as =1 or left out, not ={value}")
    return value


def refuse_lacking_ends(arguments: Namespace, command: str) -> None:
    """Refuse to compare unless both editions are named, as ``command`` does it."""
    lacking = [name.upper() for name in ("a", "b") if getattr(arguments, name) is None]
    if lacking:
        raise UsageError(f"{' and '.join(lacking)} {'are' if len(lacking) > 1 else 'is'} missing: {command}")


EDITION = config().package  # the option that names an edition
FORMATS = ("text", "markdown", "json")
# An option's type checks its default as well, so one that must be given has a default that is refused.
OPTIONS: dict[str, dict[str, Any]] = {
    "section": {"type": _section, "default": "", "help": "section to measure"},
    EDITION: {
        "type": stack_of,
        "dest": "edition",
        "help": f"{config().edition_name}, where not the project's own: a release, a checkout, a wheel, "
        "git+https://…@ref or a label",
    },
    "with": {"type": _pins, "dest": "pins", "default": "", "help": "versions of packages, as PACKAGE==1.19.0"},
    "a": {"type": partial(stack_of, option="A"), "help": "edition to compare from"},
    "b": {"type": partial(stack_of, option="B"), "help": "edition to compare with it"},
    "since": {"type": partial(stack_of, option="SINCE"), "help": "edition to compare with; default: the one before"},
    "claim": {"type": str, "default": "", "help": "claim, as SECTION.NAME"},
    "device": _one_of("DEVICE", DEVICES, "cuda or cpu, to measure there on purpose"),
    "cluster": {
        "type": read_cluster,
        "help": "who measures: local (all GPUs of this host), local:2, ssh:hosts.txt or tcp://scheduler:8786",
    },
    "profile": _one_of("PROFILE", PROFILES, "quick: small grids and short runs, kept apart", "full"),
    "value": {"type": str, "default": "", "help": "SECTION.NAME of the page, or SECTION.CASE.COLUMN of a row"},
    "format": _one_of("FORMAT", FORMATS, "markdown (a comment on a pull request) or json (docs/alarm.md)", "text"),
    "values": _one_of("VALUES", ("sums", "all"), "all: each value that moved", "sums"),
    "strict": {"action": "store_true", "help": "status 1 when anything can't be trusted"},
    "yes": {"action": "store_true", "help": "begin what takes hours"},
    "list": {"action": "store_true", "help": "only list what there is, with sizes"},
    "fast": {"action": "store_true", "help": "only those that a change of words or figures needs"},
    "lab": {"action": "store_true", "help": "also with the engine that the page runs, in Node"},
    "target": {"type": str, "default": "", "help": "where to publish: dir:PATH, rsync:HOST:PATH or git:REMOTE"},
    "port": {"type": _port, "default": "8000", "help": "where to serve"},
    "address": {"type": _address, "default": "", "help": "where the site will lie, as https://example.org/report/"},
}
