"""Read the settings of a report from ``report.toml``."""

import re
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Annotated, Any, Literal

from msgspec import Meta, ValidationError, convert

from measured_report.files.atomic import read_text
from measured_report.files.errors import ReportError, suggestion

if sys.version_info >= (3, 11):
    import tomllib as tomllib  # other modules import it from here
else:
    import tomli as tomllib
FILE = "report.toml"
Address = Annotated[str, Meta(pattern="^$|^https?://")]
ClassName = Annotated[str, Meta(pattern="^$|:")]


@dataclass(frozen=True)
class Columns:
    """Describe the columns that a table ``columns`` lists or matches by pattern."""

    names: Collection[str] = ()  # names of columns
    pattern: str = ""
    """A regular expression that matches the whole name of further columns."""
    kind: Literal[
        "", "parameter", "setting", "computed", "cost", "uncompared", "failure"
    ] = ""
    """The kind of the columns.

    ``parameter`` is set before a run, like a field of the case. ``setting`` is also set
    before a run. ``computed`` is computed from settings. ``cost`` depends on the
    machine. ``uncompared`` is not compared between editions. ``failure`` is true if a
    run failed, so that its other numbers are arbitrary.
    """
    signed: bool | None = None
    """Whether numbers can be negative. If this is missing, the unit determines it."""
    better: Literal["", "less", "more"] = ""
    """Whether less or more is better; empty if neither is better."""
    resolution: Annotated[float, Meta(ge=0.0)] = 0.0
    """The smallest difference that counts, even if the noise is smaller."""
    rate_of: str = ""
    """The column with the time of this rate; both have the same relative noise."""
    known_within: str = ""
    """The column with the relative uncertainty.

    It replaces the measured noise unless it is 0.
    """
    grows_with: str = ""
    """The column with the duration over which this number accumulates.

    The noise grows with the duration.
    """
    trials: str = ""
    """The column with the number of trials, if this column counts successes or contains
    their share. The noise is then binomial.
    """
    unless: str = ""
    """The column that marks a failed run, for which this number does not exist."""


@dataclass(frozen=True)
class Changes:
    """Settings for the comparison of editions, the table ``changes``."""

    upgrade_sections: Sequence[str] = ()
    """The sections that make upgrade measures, the longest first; empty for all."""
    headlines: Mapping[str, str] = field(default_factory=dict)
    """Values that the history shows, by their names."""
    thresholds: Mapping[str, float] = field(default_factory=dict)
    """Thresholds of the alarm for numbers named ``section.case.column``.

    A threshold is a change relative to the older number: 0.05 means 5 %.
    """
    threshold: float = 0.1
    """The threshold for all other numbers."""
    # The threshold for times and costs.
    cost_threshold: float = 0.2
    # The threshold for settings.
    setting_threshold: float = 0.05
    settings: Mapping[str, str] = field(default_factory=dict)
    """Kinds of rows that contain defaults and options, with the name of each kind.

    Their values are compared exactly.
    """
    explanation: str = ""
    """The claim that explains the difference between editions if it holds."""
    equivalent_sections: Sequence[str] = ()
    """Sections that measure the same runs.

    If one of them lacks a case, it is taken from another.
    """
    package_groups: Sequence[Sequence[str]] = ()
    """Groups of packages that bisect always changes together."""
    keys: Sequence[str] = ("case",)
    """The columns that distinguish the rows of one section, if they exist."""
    endings: str = ""
    """The column that lists how the repeats of a run ended.

    Rows are compared only if this is equal.
    """

    @property
    def named(self) -> frozenset[str]:
        """Return the numbers that have a specific threshold or are headlines."""
        return frozenset((*self.thresholds, *self.headlines.values()))


@dataclass(frozen=True)
class Page:
    """Describe a page. A release has the page if it has one of its sections."""

    name: str
    label: str = ""  # the text of links to it; by default its name
    texts: tuple[str, ...] = ()
    """Its templates, the one with its title first; by default `pages/NAME.md.j2`."""
    always: bool = False  # whether an edition always has it, even without its sections

    def __post_init__(self) -> None:
        object.__setattr__(
            self, "label", self.label or self.name.replace("_", " ").capitalize()
        )
        object.__setattr__(self, "texts", self.texts or (f"pages/{self.name}.md.j2",))

    @property
    def file(self) -> str:
        return f"{self.name}.html"


@dataclass(frozen=True)
class Config:
    """The fields of ``report.toml`` with their defaults."""

    edition: str = ""  # the package whose releases are compared
    packages: Sequence[str] = ()
    """Other packages whose versions a record depends on; `edition` is added in front.
    """
    implied: Mapping[str, str] = field(default_factory=dict)
    """Packages that another package requires in the same version, with that package.

    A record without such a package was measured with this version, or without it.
    """
    requirement: str = ""
    """The package as pyproject.toml requires it: with its extras, without a version."""
    edition_name: str = ""  # the name of the package in sentences
    short_names: Mapping[str, str] = field(default_factory=dict)
    """Short names of other packages in labels."""
    trials: Mapping[str, str] = field(default_factory=dict)
    """Names that sentences use for labels with other packages."""
    host: str = "measured_report.measuring.host"
    """The module that measures on a host; the default measures on the CPU."""
    accelerator: str = "measured_report.measuring.host"
    """The module of the host's accelerators; the default has none."""
    case: ClassName = ""
    """The dataclass, as `module:name`, whose fields are the parameters of a run."""
    noise_section: str = ""
    """The section whose repeats show the noise of sections without repeats.

    Repeats are rows that run the same case again, which the column `of` names.
    """
    repeating: Mapping[str, Sequence[str | bool | int]] = field(default_factory=dict)
    """Values that mark a row as deterministic.

    Such rows have zero noise, except in columns of the kind ``cost``.
    """
    units: Mapping[str, str] = field(default_factory=dict)
    """Further units by the end of a column's name."""
    cost_terms: Sequence[str] = ()
    """Columns that must be equal in two rows before their costs are compared."""
    columns: Sequence[Columns] = ()  # the tables ``columns``
    baseline: str = "the baseline"
    """The name of the case that has the default of every parameter."""
    changes: Changes = field(default_factory=Changes)  # the table ``changes``
    title: str = "A report"
    """The title of the data if there is no other title."""
    name: str = "report"  # the name of the report in citations
    repository: Address = ""
    """The address of the sources on the web; if it is empty, pages do not link to them.
    """
    synonyms: Mapping[str, str] = field(default_factory=dict)
    """Words that readers may search for, with words that the pages use instead."""
    pages: Sequence[Page] = (Page("index", texts=("front.md.j2",)), Page("results"))
    """The pages in order, the front page first."""
    text_modules: str = ""
    """The package with a module for each template of a page: `front` derives the values
    in `front.md.j2`.
    """
    plugins: str = "measured_report.pages.plugins"
    """The module with further content of pages; the default lists the possible
    functions.
    """

    @property
    def front(self) -> Page:
        return self.pages[0]

    @property
    def sources(self) -> Sequence[str]:
        """Return the files that determine the columns.

        These are ``report.toml`` and the module of the case.
        """
        module = self.case.partition(":")[0]
        return (FILE, f"{module.replace('.', '/')}.py") if module else (FILE,)

    @property
    def needs_device(self) -> bool:
        """Return whether sections depend on the device by default."""
        return self.accelerator != Config.accelerator

    @property
    def option(self) -> str:
        """Return the variable of make that names an edition."""
        return self.edition.upper().replace("-", "_")

    @property
    def flag(self) -> str:
        """Return the name of the same option of ``build.py``."""
        return self.option.lower().replace("_", "-") or "edition"

    def name_of(self, release: str) -> str:
        """Return the name of an edition for use within a sentence."""
        return (
            f"the {self.trials[release]}"
            if release in self.trials
            else f"{self.edition_name} {release}".strip()
        )

    def short_name(self, release: str) -> str:
        return self.trials.get(release, release)

    def edition_folder(self, release: str) -> str:
        return f"{self.edition}-{release}"

    def edition_in(self, folder: str) -> str:
        return folder.removeprefix(f"{self.edition}-")

    def requirement_of(self, package: str) -> str:
        """Return the requirement of a package with its extras, without a version."""
        return (
            self.requirement
            if package == self.edition and self.requirement
            else package
        )


def read_toml(path: Path) -> dict[str, Any]:
    """Read a TOML file; raise ReportError if it cannot be read."""
    try:
        return tomllib.loads(read_text(path))
    except (ValueError, RecursionError) as error:
        raise ReportError(f"{path.name}: {error}") from None


def read_settings(root: Path) -> Config:
    """Read ``report.toml``; raise ReportError with one line if it is invalid."""
    path = root / FILE
    try:
        settings = read_toml(path) if path.is_file() else {}
        tables: list[tuple[Any, ...]] = [
            ("", settings, Config),
            ("changes.", settings.get("changes", {}), Changes),
        ]
        for table_name, kind in (("columns", Columns), ("pages", Page)):
            tables += [
                (f"{table_name}.", table, kind)
                for table in settings.get(table_name, ())
            ]
        for table_name, table, kind in tables:
            names = {field.name for field in fields(kind)}
            for name in table if isinstance(table, dict) else ():
                if name not in names:
                    raise ValueError(
                        f"unknown setting {table_name}{name}: use a setting of "
                        f"REFERENCE.md{suggestion(name, names)}"
                    )
        config = convert(settings, Config)
        for pattern in (table.pattern for table in config.columns):
            re.compile(pattern)
        if not all(table.names or table.pattern for table in config.columns):
            raise ValueError(
                "a table of columns has neither names nor a pattern: add one of them"
            )
        shares = {
            name: getattr(config.changes, name)
            for name in ("threshold", "cost_threshold", "setting_threshold")
        }
        for name, share in {**shares, **config.changes.thresholds}.items():
            if not 0 < share <= 1:
                raise ValueError(
                    f"the threshold of {name} is {share:g}, but a share is above 0 and "
                    "at most 1: write 0.05 for 5 %"
                )
        if not 0 < len(config.pages) == len({page.name for page in config.pages}):
            raise ValueError(
                "pages is empty or contains a name twice "
                f"({[page.name for page in config.pages]}): give each page a unique "
                "name"
            )
    except re.error as error:
        raise ReportError(
            f"{FILE}: {error.pattern!r} is not a regular expression: {error}"
        ) from None
    except (ValueError, TypeError) as error:  # msgspec raises these
        hint = "; see REFERENCE.md" if isinstance(error, ValidationError) else ""
        raise ReportError(f"{FILE}: {' '.join(str(error).split())}{hint}") from None
    if not (package := config.edition):
        return config
    return replace(
        config,
        packages=[package, *config.packages],
        edition_name=config.edition_name or package,
    )


def module_named(setting: str, name: str) -> ModuleType:
    """Import the module ``name``, which a setting of ``report.toml`` names.

    Raise ReportError if it does not exist.
    """
    try:
        return import_module(name)
    except ImportError as error:
        raise ReportError(f"{FILE}: {setting} = {name!r}: {error}") from error
