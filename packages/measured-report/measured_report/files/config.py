"""Config: what ``report.toml`` says, all that has to be known of a report besides its rooms."""

import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from measured_report.files.errors import ReportError, suggestion
from measured_report.files.root import ROOT

FILE = "report.toml"


@dataclass(frozen=True)
class Told:
    """Describes what ``report.toml`` may tell of a column."""

    better: str = ""
    """``less`` or ``more``."""
    resolution: float = 0.0
    """Least difference that counts, however well a machine repeats itself."""
    rate_of: str = ""
    """The column of the time that makes this rate, whose share of noise it has."""
    known_within: str = ""
    """The column that says within what share of it a number is known, where that is not 0: its noise, whatever else."""
    grows_with: str = ""
    """The column that says how long it added up; in a longer run it is noisier in proportion."""
    trials: str = ""
    """The column that says of how many trials this many, or this share, succeeded: its noise is binomial."""
    unless: str = ""
    """The column that says of a run that it was lost, and then has no such number."""


@dataclass(frozen=True)
class Declared(Told):
    """Describes the columns that one table ``columns`` names, or all of whose name its pattern matches."""

    names: Collection[str] = ()
    """The columns that it is of."""
    pattern: str = ""
    """A regular expression that matches all of the name of any other."""
    kind: str = ""
    """``parameter`` (like a field of the case), ``setting`` (set before a run as well), ``given`` (made from settings),
    ``cost``, ``chance`` (compared between no two editions) or ``loss`` (makes the row's numbers chance)."""
    signed: bool | None = None
    """Whether its numbers have a sign; None: its unit says so."""


@dataclass(frozen=True)
class Changes:
    """Holds the table ``changes``: what comparing editions takes to know of this report's sections and rows."""

    deciding: Sequence[str] = ()
    """Sections that tell most in least time, the longest first, which ends soonest with several at once; none: all."""
    headlines: Mapping[str, str] = field(default_factory=dict)
    """Values that the history shows, by what they are called."""
    thresholds: Mapping[str, float] = field(default_factory=dict)
    """Numbers that raise an alarm, as ``section.case.column``, by the change that does, a share of the older one."""
    setting_threshold: float = 0.05
    """The same for any setting."""
    settings: Mapping[str, str] = field(default_factory=dict)
    """Kinds of rows that are defaults and options, with what each is called: their values are compared exactly."""
    cause: str = ""
    """The claim that says why editions differ, where it holds."""
    same_runs: Sequence[str] = ()
    """Sections that have runs alike, so that a number of a case can be taken from any of them."""
    together: Sequence[Sequence[str]] = ()
    """Other packages of which each release takes its own versions, those that come out, and are changed, together."""
    keys: Sequence[str] = ("case",)
    """Columns that tell the rows of one section apart, where they are there."""
    classes: str = ""
    """The column that lists how the repeats of a run ended; where they differ, the row is not compared."""


@dataclass(frozen=True)
class Page:
    """Describes one page of every release."""

    name: str
    label: str = ""
    """What links to it say; empty: its name."""
    texts: tuple[str, ...] = ()
    """Its templates of prose, of which the first begins with the title of the page; none: ``pages/NAME.md.j2``."""

    @property
    def file(self) -> str:
        return f"{self.name}.html"


@dataclass(frozen=True)
class Config:
    """Holds the fields of ``report.toml``, as they are without it."""

    edition: str = ""
    """The package whose releases are editions."""
    packages: Sequence[str] = ()
    """Other packages whose versions are part of what a record depends on; it is read with ``edition`` before them."""
    requirement: str = ""
    """That package as pyproject.toml asks for it, with its extras and without a version."""
    edition_name: str = ""
    """What people call it."""
    short_names: Mapping[str, str] = field(default_factory=dict)
    """What other packages are called in the label of an edition, where not by their names."""
    host: str = "measured_report.measuring.host"
    """The module that says how this report measures on a host; this one measures on the CPU."""
    case: str = ""
    """The dataclass, as ``module:name``, whose fields are what a run was set to."""
    noise_section: str = ""
    """The section that has repeats: rows that are runs of one and the same case, as ``of`` says."""
    repeating: Mapping[str, Sequence[str | bool | int]] = field(default_factory=dict)
    """What columns say of runs that repeat to the last bit, all but times."""
    units: Mapping[str, str] = field(default_factory=dict)
    """Units by the end of a column's name, besides those that ``records/columns.py`` knows."""
    cost_terms: Sequence[str] = ()
    """Columns that two rows must share for their costs to be compared."""
    columns: Sequence[Declared] = ()
    """What is to be known of columns besides their units."""
    baseline: str = "the baseline"
    """What people call the case that all others are changed from."""
    changes: Changes = field(default_factory=Changes)
    """The table of that name."""
    title: str = "A report"
    """What its data are of, where nothing else of it is at hand."""
    name: str = "report"
    """What it is called where it is cited."""
    repository: str = ""
    """The page of its sources on the web; where nothing is said, pages lead to none."""
    pages: Sequence[Page] = (Page("index", texts=("front.md.j2",)), Page("results"))
    """The pages in their order, the front page first."""
    story: str = ""
    """The package whose modules derive what texts of pages tell: ``front`` for ``front.md.j2``."""
    plugins: str = "measured_report.pages.plugins"
    """The module that says what else this report shows; the one named here says what it may have."""
    formulas: Sequence[str] = ()
    """Patterns of names and formulas in drawings and table cells, whose numbers lead to no record."""

    @property
    def sources(self) -> Sequence[str]:
        """Name the files that this is read from, below the root: with the case's, they say what columns hold."""
        module = self.case.partition(":")[0]
        return (FILE, f"{module.replace('.', '/')}.py") if module else (FILE,)

    @property
    def needs_gpu(self) -> bool:
        """Tell whether what a section measures depends on the device, where it does not say."""
        return self.host != Config.host

    @property
    def option(self) -> str:
        """Name the variable of make that names an edition."""
        return self.edition.upper().replace("-", "_")

    def name_of(self, release: str) -> str:
        """Write what people call an edition."""
        return f"{self.edition_name} {release}".strip()

    def edition_folder(self, release: str) -> str:
        """Name the folder that has the results of an edition."""
        return f"{self.edition}-{release}"

    def edition_in(self, folder: str) -> str:
        """Return the label of the edition whose results are in a folder of that name."""
        return folder.removeprefix(f"{self.edition}-")

    def requirement_of(self, package: str) -> str:
        """Write a package as it is asked for, with its extras."""
        return self.requirement if package == self.edition and self.requirement else package


def read_toml(path: Path) -> dict[str, Any]:
    """Read a TOML file; ValueError or OSError where it is none."""
    return parse_toml(path.read_text(encoding="utf-8-sig"))


def parse_toml(text: str) -> dict[str, Any]:
    """Read a text of TOML; ValueError where it is none."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    return tomllib.loads(text)


@cache
def config(root: Path = ROOT) -> Config:
    """Read ``report.toml``; ReportError, one line, where it is not whole."""
    path = root / FILE
    try:
        found = read_toml(path) if path.is_file() else {}
        tables: list[tuple] = [("", found, Config), ("changes.", found.get("changes", {}), Changes)]
        tables += [("columns.", each, Declared) for each in found.get("columns", ())]
        for place, table, kind in [*tables, *(("pages.", each, Page) for each in found.get("pages", ()))]:
            names = {each.name for each in fields(kind)}
            for name in table if isinstance(table, dict) else ():
                if name not in names:
                    raise ValueError(f"there is no setting {place}{name}{suggestion(name, names)}")
        told = msgspec.convert(found, Config)
    except (OSError, ValueError, TypeError) as error:  # which msgspec's are
        raise ReportError(f"{FILE}: {' '.join(str(error).split())}") from None
    if not (package := told.edition):
        return told
    return replace(told, packages=[package, *told.packages], edition_name=told.edition_name or package)
