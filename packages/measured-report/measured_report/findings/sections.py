"""Section modules: each is found, read for what it says of itself, and given results."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import Page, Report
from measured_report.files.config import report as current_report
from measured_report.files.errors import ReportError, bug_of
from measured_report.parts.section import Section
from measured_report.records.code import COMPUTED, read_source
from measured_report.values.results import Results, ResultsError

PACKAGE = "report.sections"
FACTS: Mapping[str, tuple[type, str]] = {
    "order": (int, "a number such as 125, its place on the page"),
    "first": (bool, "True or False"),
    "label": (str, "a text"),
    "labels": (Mapping, 'a dict, as {"case": "words"}'),
    "reads": (tuple, 'a tuple, as ("noise",)'),
}
"""What a module says of its section, read without running it."""


@dataclass(frozen=True)
class Outline:
    """Hold what a section's module, or folder of modules, says of itself, known without running it."""

    file: Path
    source: str
    order: int  # place on its page; sections can read those of a lower one
    page: Page  # the page that it names, or else the first that takes sections
    compares: bool
    """Set where it compares releases: its ``derive(results, releases)`` then takes them as well, as
    ``releases["1.4.0"]["friction"].results``."""
    first: bool  # set for the section that its page begins with, whatever its order
    label: str  # what figures and tables call the section; the name of its file where it does not say
    labels: Mapping[str, str]  # what they call its cases; `label_of` reads it
    reads: tuple[str, ...]  # sections before it whose results it reads as well


def outline_of(section: str, report: Report | None = None) -> Outline:
    """Read the facts of a section's module; ReportError, one line, where one is wrong."""
    if (file := file_of(PACKAGE, section)) is None:
        raise ReportError(
            f"there is no report/sections/{section}.py, nor a folder of that name"
        )
    is_folder = file.name == "__init__.py"
    name = file.relative_to(file.parents[3 if is_folder else 2]).as_posix()
    label = section.replace("_", " ")
    facts: dict[str, Any] = {"first": False, "label": label, "labels": {}, "reads": ()}
    facts |= read_source(file, name).top
    for fact, (kind, words) in FACTS.items():
        value = facts.get(fact)
        if value == COMPUTED or not isinstance(value, kind):
            raise ReportError(f"{name}: {fact} is not {words}, written out")
    if "derive" not in facts:
        raise ReportError(f"{name} has no function derive(results)")
    settings = (report or current_report()).settings
    pages = {page.name: page for page in settings.pages[1:]}
    page = facts.get("page", next(iter(pages), ""))
    if page not in pages:
        raise ReportError(
            f"{name} names the page {page!r}; there are: {', '.join(pages)}"
        )
    for read in facts["reads"]:
        if not file_of(PACKAGE, read):
            raise ReportError(f"{name} reads {read!r}, and there is no such section")
    return Outline(
        file,
        name.removesuffix("__init__.py"),
        facts["order"],
        pages[page],
        compares=facts["derive"] > 1,
        **{fact: facts[fact] for fact in ("first", "label", "labels", "reads")},
    )


def file_of(package: str, name: str) -> Path | None:
    """Return the file of a module, or of a folder of modules; None where there is none."""
    found = []
    for folder in import_module(package).__path__:
        for path in (Path(folder, name, "__init__.py"), Path(folder, f"{name}.py")):
            if path.is_file():
                found.append(path)
    if len({path.stem for path in found[:2]}) > 1:
        place = package.replace(".", "/")
        raise ReportError(
            f"{name} in {place}/ is a file and a folder: one of them is never read"
        )
    return found[0] if found else None


def derive_section(results: Results, releases: Mapping[str, Any]) -> Section:
    """Derive a section from its results; one that compares releases has them as well."""
    name = results.record.section
    compared = [releases] if outline_of(name).compares else []
    return derive_by(f"{PACKAGE}.{name}", results, *compared)


def derive_by(name: str, *inputs: Any) -> Section:
    """Return what ``derive`` of the module ``name`` makes, its claims checked."""
    try:
        module = import_module(name)
        section = module.derive(*inputs)
    except RecordError:
        raise
    except (ImportError, NameError) as error:  # the code is wrong whatever was measured
        raise ReportError(bug_of(error)) from error
    except Exception as error:
        raise ResultsError(bug_of(error)) from error
    if not isinstance(section, Section):
        place = short_path(Path(str(module.__file__)))
        kind = type(section).__name__
        raise ReportError(f"{place}: derive returns a {kind}, and not a Section")
    return replace(section, claims=[claim.checked() for claim in section.claims])
