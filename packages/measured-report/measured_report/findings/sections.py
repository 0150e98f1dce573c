"""Section modules and the pages that they are on: a module is found, asked what it is, and given its results."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

from measured_report.files.atomic import RecordError, short_path
from measured_report.files.config import Page, config
from measured_report.files.errors import ReportError, bug_of
from measured_report.parts.section import Section
from measured_report.records.code import WORKED_OUT, read_source
from measured_report.values.results import Results, ResultsError

SAYINGS = ("order", "page", "first", "label", "labels", "reads")  # what a module may say of its section


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


def outline_of(section: str) -> Outline:
    """Read what a section's module says; ReportError, one line, where that is not what it must be, or there is none."""
    if (file := file_of("report.sections", section)) is None:
        raise ReportError(f"there is no report/sections/{section}.py, nor a folder of that name")
    name = file.relative_to(file.parents[3 if file.name == "__init__.py" else 2]).as_posix()
    says = read_source(file, name).top
    if worked_out := [name for name in SAYINGS if says.get(name) == WORKED_OUT]:
        raise ReportError(f"{name}: {worked_out[0]} is read without running it: write it out, and work nothing out")
    if not isinstance(says.get("order"), int):
        raise ReportError(f"{name} has no line such as order = 125, its place on the page")
    if "derive" not in says:
        raise ReportError(f"{name} has no function derive(results)")
    pages = {page.name: page for page in config().pages[1:]}
    page, label = says.get("page", next(iter(pages), "")), says.get("label", section.replace("_", " "))
    if page not in pages:
        raise ReportError(f"{name} names the page {page!r}; there are: {', '.join(pages)}")
    first, labels, reads = says.get("first", False), says.get("labels", {}), says.get("reads", ())
    if not (isinstance(labels, Mapping) and isinstance(reads, tuple | list) and isinstance(label, str)):
        hint = 'labels is a dict, as {"case": "words"}, and reads a tuple, as ("noise",), label text'
        raise ReportError(f"{name}: {hint}")
    if unknown := [read for read in reads if not file_of("report.sections", read)]:
        raise ReportError(f"{name} reads {unknown[0]!r}, and there is no such section")
    source, compares = name.removesuffix("__init__.py"), says["derive"] > 1
    return Outline(file, source, says["order"], pages[page], compares, first, label, labels, tuple(reads))


@dataclass(frozen=True)
class Read(Mapping[str, Results]):
    """Give the results that a section reads, where they were measured; ReportError for one that it does not name."""

    outline: Outline
    results: Mapping[str, Results]

    def __getitem__(self, name: str) -> Results:  # which ``in`` and ``get`` ask as well
        if name not in self.outline.reads and not self.outline.compares:
            raise ReportError(f"{self.outline.source} reads {name}, which its line reads = (...) does not name")
        if outline_of(name).order >= self.outline.order:
            raise ReportError(f"{self.outline.source} reads {name}, which stands after it: give it a higher order")
        return self.results[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.results)

    def __len__(self) -> int:
        return len(self.results)


def file_of(package: str, name: str) -> Path | None:
    """Return the file of a module of a package, of which a folder may be made as well; None where there is none."""
    folders = import_module(package).__path__
    paths = (Path(folder) / path for folder in folders for path in (f"{name}/__init__.py", f"{name}.py"))
    if len(modules := [path for path in paths if path.is_file()]) > 1 and modules[0].stem != modules[1].stem:
        raise ReportError(f"{name} in {package.replace('.', '/')}/ is a file and a folder: one of them is never read")
    return modules[0] if modules else None


def derive_section(results: Results, releases: Mapping[str, Any]) -> Section:
    """Derive a section of its results, its words not yet said; one that compares releases has them as well."""
    name = results.record.section
    return derive_by(f"report.sections.{name}", results, *([releases] if outline_of(name).compares else []))


def derive_by(name: str, *inputs: Any) -> Section:
    """Return what ``derive`` of the module ``name`` makes of what it is given, its claims checked."""
    try:
        module = import_module(name)
        section = module.derive(*inputs)
    except RecordError:
        raise
    except (ImportError, NameError) as error:  # whatever was measured, this is none of it
        raise ReportError(bug_of(error)) from error
    except Exception as error:
        raise ResultsError(bug_of(error)) from error
    if not isinstance(section, Section):
        kind = type(section).__name__
        raise ReportError(f"{short_path(Path(str(module.__file__)))}: derive returns a {kind}, and not a Section")
    return replace(section, claims=[claim.checked() for claim in section.claims])
