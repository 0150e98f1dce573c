"""Settings: what ``report.toml`` may say of a report."""

import re
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Annotated, Any, Literal

from msgspec import Meta, ValidationError, convert

from measured_report.files.errors import ReportError, suggestion

if sys.version_info >= (3, 11):
    import tomllib as tomllib  # which others read here too
else:
    import tomli as tomllib
FILE = "report.toml"
Address = Annotated[str, Meta(pattern="^$|^https?://")]
ClassName = Annotated[str, Meta(pattern="^$|:")]


@dataclass(frozen=True)
class Columns:
    """Describes the columns that one table ``columns`` names, or all of whose name its pattern matches."""

    names: Collection[str] = ()  # the columns that it is of
    pattern: str = ""  # a regular expression that matches all of the name of any other
    kind: Literal[
        "", "parameter", "setting", "computed", "cost", "uncompared", "failure"
    ] = ""
    """``parameter`` (like a field of the case), ``setting`` (set before a run as well), ``computed`` (of
    settings), ``cost``, ``uncompared`` (between editions) or ``failure`` (of a run, whose numbers are then chance)."""
    signed: bool | None = None
    """Whether its numbers have a sign; None: its unit says so."""
    better: Literal["", "less", "more"] = ""  # which numbers are better; empty: neither
    resolution: Annotated[float, Meta(ge=0.0)] = 0.0
    """The least difference that counts, whatever the noise."""
    rate_of: str = ""
    """The column of the time that makes this rate, whose share of noise it has."""
    known_within: str = ""  # the column with its relative uncertainty, which replaces the measured noise unless it is 0
    grows_with: str = ""  # the column with the duration over which it accumulates; noise is scaled by it
    trials: str = ""  # the column that says of how many trials this many, or this share, succeeded: noise is binomial
    unless: str = ""  # the column that says that a run failed, where this number then does not exist


@dataclass(frozen=True)
class Changes:
    """Holds the table ``changes``: what comparing editions takes to know of this report's sections and rows."""

    upgrade_sections: Sequence[str] = ()
    """Sections that make upgrade measures, the longest first; none: all."""
    headlines: Mapping[str, str] = field(
        default_factory=dict
    )  # values that the history shows, by what they are called
    thresholds: Mapping[str, float] = field(default_factory=dict)
    """Numbers that raise an alarm, as ``section.case.column``, by the change that does, a share of the older one."""
    threshold: Annotated[float, Meta(gt=0.0)] = 0.1
    """The same for every other number that is compared."""
    cost_threshold: Annotated[float, Meta(gt=0.0)] = 0.2  # the same for times and costs
    setting_threshold: Annotated[float, Meta(gt=0.0)] = 0.05  # the same for any setting
    settings: Mapping[str, str] = field(default_factory=dict)
    """Kinds of rows that are defaults and options, with what each is called: their values are compared exactly."""
    explanation: str = ""
    """The claim that, where it holds, explains why editions differ."""
    equivalent_sections: Sequence[str] = ()
    """Sections of the same runs: where one lacks a case, another's is taken."""
    package_groups: Sequence[Sequence[str]] = ()
    """Groups of packages that bisect swaps as one."""
    keys: Sequence[str] = ("case",)
    """Columns that tell the rows of one section apart, where they are there."""
    endings: str = ""  # the column that lists how the repeats of a run ended; where they differ, no row is compared

    @property
    def named(self) -> frozenset[str]:
        """Return the numbers that have a threshold of their own or are headlines."""
        return frozenset((*self.thresholds, *self.headlines.values()))


@dataclass(frozen=True)
class Page:
    """Describes one page of every release."""

    name: str
    label: str = ""  # what links to it say; empty: its name
    texts: tuple[
        str, ...
    ] = ()  # its templates of prose, the first with its title; none: `pages/NAME.md.j2`

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
    """Holds the fields of ``report.toml``, as they are without it."""

    edition: str = ""  # the package whose releases the report compares
    packages: Sequence[str] = ()
    """Others whose versions a record depends on; it is read with `edition` before them."""
    requirement: str = ""  # that package as pyproject.toml asks for it, with its extras and without a version
    edition_name: str = ""  # what people call it
    short_names: Mapping[str, str] = field(
        default_factory=dict
    )  # what labels call other packages
    trials: Mapping[str, str] = field(
        default_factory=dict
    )  # what people call labels with other packages
    host: str = "measured_report.measuring.host"  # the module that measures on a host; this one on the CPU
    accelerator: str = "measured_report.measuring.host"  # the module of what accelerates it; this one of nothing
    case: ClassName = ""
    """The dataclass, as `module:name`, whose fields are what a run was set to."""
    noise_section: str = ""  # the section that has repeats: rows that are runs of one and the same case, as `of` says
    repeating: Mapping[str, Sequence[str | bool | int]] = field(default_factory=dict)
    """Rows with one of these values are deterministic: noise 0, except columns of the kind ``cost``."""
    units: Mapping[str, str] = field(
        default_factory=dict
    )  # by the end of a column's name, besides the known ones
    cost_terms: Sequence[str] = ()
    """Columns that two rows must share for their costs to be compared."""
    columns: Sequence[Columns] = ()  # the tables ``columns``
    baseline: str = "the baseline"
    """What people call the case that all others are changed from."""
    changes: Changes = field(default_factory=Changes)  # the table of that name
    title: str = "A report"  # what its data are of, where nothing else of it is at hand
    name: str = "report"  # its name in citations
    repository: Address = ""  # the page of its sources on the web; where nothing is said, pages lead to none
    pages: Sequence[Page] = (Page("index", texts=("front.md.j2",)), Page("results"))
    """In order, the front page first."""
    text_modules: str = ""  # the package with a module for each text of a page: `front` derives what `front.md.j2` says
    plugins: str = "measured_report.pages.plugins"  # the module of what else it shows; this says what it may

    @property
    def front(self) -> Page:
        return self.pages[0]

    @property
    def sources(self) -> Sequence[str]:
        """Name the files that this is read from, below the root: with the case's, they say what columns hold."""
        module = self.case.partition(":")[0]
        return (FILE, f"{module.replace('.', '/')}.py") if module else (FILE,)

    @property
    def needs_device(self) -> bool:
        """Tell whether what a section measures depends on the device, where it does not say."""
        return self.accelerator != Config.accelerator

    @property
    def option(self) -> str:
        """Name the variable of make that names an edition."""
        return self.edition.upper().replace("-", "_")

    @property
    def flag(self) -> str:
        """Name the same option of ``build.py``."""
        return self.option.lower().replace("_", "-") or "edition"

    def name_of(self, release: str) -> str:
        """Name an edition within a sentence."""
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
        """Write a package as it is asked for, with its extras."""
        return (
            self.requirement
            if package == self.edition and self.requirement
            else package
        )


def read_toml(path: Path) -> dict[str, Any]:
    """Read a TOML file; ValueError or OSError where it is none."""
    return tomllib.loads(path.read_text(encoding="utf-8-sig"))


def read_settings(root: Path) -> Config:
    """Read ``report.toml``; ReportError, one line, where it is not whole."""
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
                        f"there is no setting {table_name}{name}{suggestion(name, names)}"
                    )
        config = convert(settings, Config)
        for pattern in (table.pattern for table in config.columns):
            re.compile(pattern)
        if not all(table.names or table.pattern for table in config.columns):
            raise ValueError("a table of columns has neither names nor a pattern")
        if wrong := [
            name for name, share in config.changes.thresholds.items() if not share > 0
        ]:
            raise ValueError(f"changes.thresholds has {wrong[0]}, which is not above 0")
        if not 0 < len(config.pages) == len({page.name for page in config.pages}):
            raise ValueError(
                f"pages has none, or two of one name: {[page.name for page in config.pages]}"
            )
    except re.error as error:
        raise ReportError(
            f"{FILE}: {error.pattern!r} is no regular expression: {error}"
        ) from None
    except (OSError, ValueError, TypeError) as error:  # which msgspec's are
        hint = (
            "; REFERENCE.md says what it takes"
            if isinstance(error, ValidationError)
            else ""
        )
        raise ReportError(f"{FILE}: {' '.join(str(error).split())}{hint}") from None
    if not (package := config.edition):
        return config
    return replace(
        config,
        packages=[package, *config.packages],
        edition_name=config.edition_name or package,
    )


def module_named(setting: str, name: str) -> ModuleType:
    """Import the module ``name``, which a setting of ``report.toml`` names; ReportError where there is none."""
    try:
        return import_module(name)
    except ImportError as error:
        raise ReportError(f"{FILE}: {setting} = {name!r}: {error}") from error
