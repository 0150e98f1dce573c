"""Deriving: a section's module is found, asked what it is, and given the results that it makes a section of."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from traceback import extract_tb
from typing import Any

from measured_report import ReportError
from measured_report.deriving.chapters import Releases
from measured_report.pages.pages import DEFAULT, Page, page_named
from measured_report.parts.parts import Section
from measured_report.records.identity import source_at
from measured_report.values.results import Results

NAMES = "*"
"""In the place of a name: all names that there are."""


class LostError(ReportError):
    """A record from which nothing of its section can be derived; the message is one line."""


@dataclass(frozen=True)
class Outline:
    """What a section's module says of itself, known without running it."""

    file: Path
    root: Path
    """The folder that ``report/sections/`` is in."""
    order: int
    page: Page
    compares: bool
    """Whether it compares releases: its ``derive`` then takes them as a second argument."""
    leads: bool
    """Whether its page begins with it, wherever its order has it: it says what the others there come to."""
    label: str
    """What figures and tables call the section; the name of its file where it does not say."""

    @property
    def source(self) -> str:
        """The module, or the folder of modules, as it is named to people."""
        return self.file.relative_to(self.root).as_posix().removesuffix("__init__.py")


def outline_of(section: str) -> Outline:
    """ReportError, one line, for a module that is missing, or does not say what it must."""
    folders = import_module("report.sections").__path__
    places = [Path(folder) / name for folder in folders for name in (section, f"{section}.py")]
    place = next((place for place in places if place.exists()), None)
    if place is None:
        raise ReportError(f"there is no report/sections/{section}.py, nor a folder of that name")
    file, root = place / "__init__.py" if place.is_dir() else place, place.parents[2]
    name = file.relative_to(root).as_posix()
    says = source_at(file, name).top
    if not isinstance(says.get("order"), int):
        raise ReportError(f"{name} has no line such as order = 125, its place on the page")
    if "derive" not in says:
        raise ReportError(f"{name} has no function derive(results)")
    page = page_named(says.get("page", DEFAULT), name)
    compares, leads = says["derive"] > 1, says.get("leads", False)
    return Outline(file, root, says["order"], page, compares, leads, str(says.get("label", section.replace("_", " "))))


def derive_section(results: Results, releases: Releases) -> Section:
    """What a section makes of its results, its words not yet said; one that compares releases has them as well."""
    outline = outline_of(results.record.section)
    try:
        derive = import_module(f"report.sections.{results.record.section}").derive
        section = derive(results, releases) if outline.compares else derive(results)
    except (ReportError, OSError):
        raise
    except (AssertionError, ImportError, NameError) as error:  # whatever was measured, this is none of it
        raise ReportError(f"{outline.source}: {' '.join(str(error).split())} ({_line_of(error)})") from error
    except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError) as error:
        if isinstance(error, AttributeError | TypeError) and "NoneType" not in str(error):
            raise  # no missing number makes these of anything else: the section's code is wrong
        what = f"{type(error).__name__}: {' '.join(str(error).split())}, {_line_of(error)}"
        raise LostError(f"its record lacks what the section is about ({what})") from error
    if not isinstance(section, Section):
        raise ReportError(f"{outline.source}: derive returns a {type(section).__name__}, and not a Section")
    return section.tabled()


def _line_of(error: Exception) -> str:
    """Where an error was raised, for whoever has to mend it."""
    where = extract_tb(error.__traceback__)[-1]
    return f"{Path(where.filename).name}:{where.lineno}"


@dataclass
class Reads:
    """What others have that a section may read; what it does read is noted."""

    places: Mapping[str, Mapping[str, Any]]
    """Things by name, by place."""
    digests: Mapping[tuple[str, str], str] = field(default_factory=dict)
    """Of what each was made from, by place and name."""
    notes: dict[tuple[str, str], str] = field(default_factory=dict)
    """Digests of what was read."""
    is_closed: bool = False
    """Whether the section is derived: what its figures read has been noted then."""

    def digest(self, place: str, name: str) -> str:
        """Of one thing, which need not be there, or of the names of all."""
        return " ".join(self.places.get(place, ())) if name == NAMES else self.digests.get((place, name), "")

    def note(self, place: str, name: str) -> None:
        if self.is_closed and (place, name) not in self.notes:
            what = f"{place} {name}".strip()
            raise ReportError(f"a figure reads {what} only while it is drawn; derive has to read it as well")
        self.notes[place, name] = self.digest(place, name)


@dataclass(frozen=True)
class Noted(Mapping[str, Any]):
    """The things of one place."""

    reads: Reads
    place: str = ""

    def __getitem__(self, name: str) -> Any:
        self.reads.note(self.place, name)
        return self.reads.places[self.place][name]

    def __iter__(self) -> Iterator[str]:
        self.reads.note(self.place, NAMES)
        return iter(self.reads.places[self.place])

    def __len__(self) -> int:
        self.reads.note(self.place, NAMES)
        return len(self.reads.places[self.place])


@dataclass(frozen=True)
class Earlier(Mapping[str, Any]):
    """The sections that stand before one on the page, for it: what asks for a later one would never find it."""

    those: Noted
    outline: Outline

    def __getitem__(self, name: str) -> Any:
        if outline_of(name).order >= self.outline.order:
            raise ReportError(f"{self.outline.source} reads {name}, which stands after it: give it a higher order")
        return self.those[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.those)

    def __len__(self) -> int:
        return len(self.those)
