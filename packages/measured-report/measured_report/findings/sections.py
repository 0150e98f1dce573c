"""Find section modules, read their outlines, and derive sections from results."""

import math
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
LAST = math.inf  # the order of sections without one, which are sorted by their names
FACTS: Mapping[str, tuple[Any, str]] = {
    "order": (int | float, "a number such as 125"),
    "first": (bool, "True or False"),
    "folded": (bool, "True or False"),
    "label": (str, "a text"),
    "labels": (Mapping, 'a dict, as {"case": "words"}'),
    "reads": (tuple, 'a tuple, as ("noise",)'),
}
"""The constants of a section module, with their type and a description. They are read
without running the module."""


@dataclass(frozen=True)
class Outline:
    """The constants of a section's module, read without running it."""

    file: Path
    source: str
    order: float  # position on its page; a section can read those before it
    page: Page  # the page that it names, or else the first page with sections
    compares: bool
    """Whether it compares releases. Its ``derive(results, releases)`` then takes them as
    well, as ``releases["1.4.0"]["friction"].results``."""
    first: bool  # whether it is the first section of its page, regardless of its order
    folded: bool  # whether it shows only its title until a reader opens it
    label: str  # its name in figures and tables; by default the name of its file
    labels: Mapping[str, str]  # the names of its cases there, see `label_of`
    reads: tuple[str, ...]  # earlier sections whose results it reads as well


def outline_of(section: str, report: Report | None = None) -> Outline:
    """Read the outline of a section's module; raise ReportError if it is wrong."""
    if (file := file_of(PACKAGE, section)) is None:
        raise ReportError(
            f"report/sections/{section}.py does not exist, and neither does a folder "
            "of this name: write one of them"
        )
    is_folder = file.name == "__init__.py"
    name = file.relative_to(file.parents[3 if is_folder else 2]).as_posix()
    label = section.replace("_", " ")
    facts: dict[str, Any] = {
        "order": LAST,
        "first": False,
        "folded": False,
        "label": label,
        "labels": {},
        "reads": (),
    }
    facts |= read_source(file, name).top
    for fact, (kind, words) in FACTS.items():
        value = facts.get(fact)
        if value == COMPUTED or not isinstance(value, kind):
            raise ReportError(f"{name}: {fact} must be {words}, as a literal")
    if "derive" not in facts:
        raise ReportError(f"{name} has no function derive(results): add it")
    settings = (report or current_report()).settings
    pages = {page.name: page for page in settings.pages[1:]}
    page = facts.get("page", next(iter(pages), ""))
    if page not in pages:
        raise ReportError(
            f"{name} names the page {page!r}: use one of {', '.join(pages)}"
        )
    for section_read in facts["reads"]:
        if not file_of(PACKAGE, section_read):
            raise ReportError(
                f"{name} reads {section_read!r}, which is not a section: correct the name"
            )
    return Outline(
        file,
        name.removesuffix("__init__.py"),
        facts["order"],
        pages[page],
        compares=facts["derive"] > 1,
        **{fact: facts[fact] for fact in FACTS if fact != "order"},
    )


def file_of(package: str, name: str) -> Path | None:
    """Return the file of a module or of a package, or None if there is none."""
    files = []
    for folder in import_module(package).__path__:
        for path in (Path(folder, name, "__init__.py"), Path(folder, f"{name}.py")):
            if path.is_file():
                files.append(path)
    if len({path.stem for path in files[:2]}) > 1:
        folder_name = package.replace(".", "/")
        raise ReportError(
            f"{folder_name}/ has both {name}.py and {name}/, and only one of them "
            "is read: remove the other"
        )
    return files[0] if files else None


def derive_section(results: Results, releases: Mapping[str, Any]) -> Section:
    """Derive a section from its results, and from releases if it compares them."""
    name = results.record.section
    compared = [releases] if outline_of(name).compares else []
    return derive_by(f"{PACKAGE}.{name}", results, *compared)


def derive_by(name: str, *inputs: Any) -> Section:
    """Return the section that ``derive`` of the module ``name`` returns, with checked claims."""
    try:
        module = import_module(name)
        section = module.derive(*inputs)
    except RecordError:
        raise
    except (ImportError, NameError) as error:
        # The code is wrong for any measurements.
        raise ReportError(bug_of(error)) from error
    except Exception as error:
        raise ResultsError(bug_of(error)) from error
    if not isinstance(section, Section):
        path = short_path(Path(str(module.__file__)))
        kind = type(section).__name__
        raise ReportError(f"{path}: derive returns a {kind}: return a Section")
    return replace(section, claims=[claim.checked() for claim in section.claims])
