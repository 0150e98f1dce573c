"""Alter the tracked results as if something else had been measured."""

import re
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from random import Random
from statistics import fmean
from tempfile import TemporaryDirectory
from typing import Any
from unittest import mock

import numpy as np
import pandas as pd
from conftest import contents, undrawn
from current_columns import REASON, column_of, is_number, units_of

from measured_report.editions.project import Project, own_release
from measured_report.files.root import ROOT
from measured_report.findings.editions import Edition
from measured_report.pages.prose import Templates
from measured_report.pages.wording import worded_editions
from measured_report.records.record import Record, load_record, record_text
from measured_report.site.build import build
from measured_report.site.check import check_site
from tests.perturbed import load_trace_once

MOTION = re.compile(
    r"(total_|creep_)?(slip|drift|wander|oscillation|increment|creep|displacement|along)_.*|[xyz]_mm"
)
"""Columns that measure the motion of the cube in the grasp."""
SIGNED = re.compile(
    r"(total_)?(drift|along)_.*|increment_(mean|last)_mm|creep_[xyz]_mm_s|[xyz]_mm"
)
"""Columns of motion whose sign is a direction."""
PERCENTILE = re.compile("_p(5|95)$")
FAILURE = "the state was not finite in frame 300"
SHARE = 0.1
"""Share of the rows that fail."""

Row = dict[str, Any]
Place = tuple[str, str]
"""Release and section."""
Records = Mapping[Place, Record]


def as_measured(records: Records, place: Place) -> list[Row]:
    return [dict(row) for row in records[place].rows]


@dataclass(frozen=True)
class Scenario:
    """Describes how the measurements differ from the tracked ones."""

    name: str
    rows: Callable[[Records, Place], list[Row]] = as_measured
    """Changes the rows of one record."""
    frame: Callable[[Path, pd.DataFrame], pd.DataFrame] = lambda path, frame: frame
    """Changes a trace, given its tracked file."""


def measured(row: Row) -> dict[str, float]:
    """Return the numbers of a row except settings."""
    return {
        column: value
        for column, value in row.items()
        if is_number(value) and not column_of(column).is_setting
    }


def changed(
    rows: Sequence[Row], section: str, change: Callable[[str, float], float]
) -> list[Row]:
    """Return rows with changed numbers.

    The differences between runs of one case stay the same.
    """
    found = []
    for row, mean in zip(rows, _means(rows, section), strict=True):
        middles = {
            column: mean.get(column, value) for column, value in measured(row).items()
        }
        new = {
            column: change(column, middle) + row[column] - middle
            for column, middle in middles.items()
        }
        found.append(
            {**row, **{column: _sized(column, value) for column, value in new.items()}}
        )
    return found


def _sized(column: str, value: float) -> float:
    return (
        abs(value)
        if MOTION.fullmatch(column) and not SIGNED.fullmatch(column)
        else value
    )


def _means(rows: Sequence[Row], section: str) -> list[dict[str, float]]:
    """Return the means of each case for its runs in the section on noise, and an empty
    mapping for other runs.
    """
    if section != "noise":
        return [{}] * len(rows)
    cells: dict[tuple[str, str], list[float]] = {}
    for row in rows:
        for column, value in measured(row).items():
            cells.setdefault((row.get("of"), column), []).append(value)
    return [
        {column: fmean(cells[row["of"], column]) for column in measured(row)}
        if "of" in row
        else {}
        for row in rows
    ]


def moving(name: str, factor: float) -> Scenario:
    """Multiply the motion of the cube by a factor."""

    def moved(column: str, value):
        if not MOTION.fullmatch(column):
            return 1.0 * value
        return value * (factor if SIGNED.fullmatch(column) else abs(factor))

    def rows(records: Records, place: Place) -> list[Row]:
        return changed(records[place].rows, place[1], moved)

    return Scenario(name, rows, lambda path, found: _moved(found, moved))


def _moved(
    frame: pd.DataFrame, change: Callable[[str, pd.Series], pd.Series]
) -> pd.DataFrame:
    return frame.assign(
        **{
            column: change(column, frame[column])
            for column in frame
            if MOTION.fullmatch(column)
        }
    )


def reversed_rows(records: Records, place: Place) -> list[Row]:
    """Exchange large and small numbers.

    Motion is reflected at the middle of shipped and stiff pads on a logarithmic scale,
    and any other number at the middle of its column.
    """
    shipped, stiff = (
        measured(row) for row in records[place[0], "reproduction"].rows[:2]
    )
    products = {
        column: abs(value * stiff[column])
        for column, value in shipped.items()
        if MOTION.fullmatch(column)
    }
    sizes: dict[str, list[float]] = {}
    for row in records[place].rows:
        for column, value in measured(row).items():
            sizes.setdefault(PERCENTILE.sub("", column), []).extend(
                [abs(value)] if value else []
            )

    def turned(column: str, value: float) -> float:
        if not value:
            return value
        found = sizes[PERCENTILE.sub("", column)]
        new = products.get(column, min(found) * max(found)) / value
        return max(1, round(new)) if isinstance(value, int) else new

    rows = changed(records[place].rows, place[1], turned)
    return [
        _with_ends_turned(row, before)
        for row, before in zip(rows, records[place].rows, strict=True)
    ]


def _with_ends_turned(row: Row, before: Row) -> Row:
    """Sort percentiles, exchange the counts of both kinds of pads, and make failed runs
    pass.
    """
    found = dict(row)
    for column in row:
        if column.endswith("_p5") and is_number(row[column]):
            high = column.removesuffix("5") + "95"
            found[column], found[high] = sorted((row[column], row[high]))
        if column.endswith("_as_shipped_count"):
            other = column.replace("as_shipped", "stiff")
            found[column], found[other] = before[other], before[column]
    return found | (
        {"exit_status": 1 - before["exit_status"]} if "exit_status" in row else {}
    )


def reversed_frame(path: Path, frame: pd.DataFrame) -> pd.DataFrame:
    if "side" in frame:
        sides = frame["side"].unique()
        return frame.assign(
            side=frame["side"].map(dict(zip(sides, sides[::-1], strict=True)))
        )
    if "x_mm" not in frame:
        return frame
    end = float(np.linalg.norm(frame[["x_mm", "y_mm", "z_mm"]].iloc[-1]))
    factor = (
        2.0 / end**2 if end else 1.0
    )  # 2 mm² is the product of the slips with shipped and with stiff pads
    return _moved(frame, lambda column, cells: factor * cells)


def noisier(name: str, times: float) -> Scenario:
    """Multiply the differences between runs of one case and between the frames of a run
    by a factor. The noise of ratios grows by the same factor.
    """

    def rows(records: Records, place: Place) -> list[Row]:
        found = records[place].rows
        return [
            {**row, **_farther(row, mean, times)}
            for row, mean in zip(found, _means(found, place[1]), strict=True)
        ]

    return Scenario(name, rows)


def _farther(row: Row, mean: Row, times: float) -> Row:
    new = {
        column: value + times * (row[column] - value) for column, value in mean.items()
    }
    new = {
        column: _sized(column, value)
        for column, value in new.items()
        if isinstance(row[column], float)
    }
    for column, value in measured(row).items():
        middle = row.get(PERCENTILE.sub("", column))
        if PERCENTILE.search(column) and is_number(middle):
            new[column] = max(0.0, middle + times * (value - middle))
        elif column == "ratio_resolution" and is_number(value):
            new[column] = times * value
    return new


def lacking(records: Records, place: Place) -> list[Row]:
    """Remove a row from each record."""
    rows = as_measured(records, place)
    lost = Random(place[1]).randrange(len(rows))
    return [*rows[:lost], *rows[lost + 1 :]] or rows


def failing(records: Records, place: Place) -> list[Row]:
    """Remove a row from each record, and make a tenth of the other runs fail."""
    chance = Random(f"0 {place[1]}")
    return [
        failed(row) if chance.random() < SHARE else row
        for row in lacking(records, place)
    ]


def failed(row: Row) -> Row:
    lost = measured(row)
    ended = {
        "failure": FAILURE,
        "dropped": None,
        "class": "non-finite",
        "finite": False,
    }
    gone = dict.fromkeys(lost) | {column + REASON: FAILURE for column in lost}
    return {
        **row,
        **gone,
        **{column: value for column, value in ended.items() if column in row},
    }


SCENARIOS = (
    Scenario("reversed", reversed_rows, reversed_frame),
    moving("moving-x-minus-0.05", -0.05),
    moving("moving-x-0.05", 0.05),
    moving("moving-x-20", 20.0),
    moving("moving-x-minus-1", -1.0),
    noisier("noise-x-60", 60.0),
    Scenario("failing", failing),
    Scenario("lacking", lacking),
)
CHECKED = "reversed"
"""Scenario whose site is built, with the scenario of the newest release."""
NEWEST = [release for release in Project(own_release()).releases if "+" not in release][
    -1
]


@cache
def tracked_records() -> Records:
    own = Project(own_release())
    paths = [
        path
        for release in own.releases
        for path in own.of(release).results.glob("*.json")
    ]
    records = [
        (path.parent.name.removeprefix("newton-"), load_record(path))
        for path in paths
        if path.stem != "clips"
    ]
    return {(release, record.section): record for release, record in records}


@contextmanager
def project_of(
    scenario: Scenario, releases: Sequence[str], without: Place | None = None
) -> Iterator[Project]:
    """Return a project with the results of a scenario for some releases, except one
    record.
    """
    own, records = Project(own_release()), tracked_records()
    with TemporaryDirectory() as folder:
        project = Project(own.release, root=Path(folder))
        for name in ("experiments", "report", "templates", "assets"):
            (project.root / name).symlink_to(ROOT / name)
        for (release, section), record in records.items():
            if release in releases and (release, section) != without:
                path, rows = (
                    project.of(release).record_path(section),
                    scenario.rows(records, (release, section)),
                )
                path.parent.mkdir(parents=True, exist_ok=True)
                for trace in own.of(release).results.glob(f"{section}.*.csv.gz"):
                    shutil.copy(trace, path.parent)
                path.write_text(
                    record_text(replace(record, rows=rows, units=units_of(rows))),
                    encoding="utf-8",
                )

        def load(path: Path, seal: object = None) -> pd.DataFrame:
            tracked = ROOT / path.relative_to(project.root)
            return scenario.frame(tracked, load_trace_once(tracked))

        with mock.patch(
            "measured_report.values.results.load_trace", load
        ):  # writing a trace is slow
            yield project


TEMPLATES = Templates(ROOT / "templates")
"""Return the results of all scenarios, and parse each file once."""
CLAIM = re.compile(r'data-claim="([^"]*)" data-outcome="([^"]*)"( data-opposite)?')


def text_of(editions: Mapping[str, Edition], release: str) -> str:
    """Return the text of all pages in the release, which must have all sections."""
    lost = [state for state in editions[release].left_out if state.kind != "missing"]
    assert not lost, f"lost: {[state.notes for state in lost]}"
    pages = contents(editions, TEMPLATES, release)
    return undrawn([part for content in pages for part in content.parts])


def outcomes_in(text: str) -> dict[str, str]:
    """Return the outcome of every claim in a text, by section and name."""
    return {
        claim: "opposite" if is_other else said
        for claim, said, is_other in CLAIM.findall(text)
    }


@cache
def said(scenario: Scenario) -> tuple[dict[str, str], list[str]]:
    """Return the outcomes of the release's claims in a scenario, and the faults of its
    site without drawings.
    """
    own = own_release()
    releases = [own, NEWEST] if scenario.name == CHECKED else [own]
    # Drawings take most of the time.
    undraw = mock.patch("measured_report.parts.figures.draw_svgs", _undrawn)
    with project_of(scenario, releases) as project, undraw:
        if scenario.name != CHECKED:
            editions = worded_editions(project, TEMPLATES)
            return outcomes_in(text_of(editions, own)), []
        states, _ = build(project)
        lost = [
            f"{state.section}: {state.notes}"
            for each in states.values()
            for state in each
            if state.kind not in ("missing", "stale")
        ]
        pages = [path.read_text("utf-8") for path in project.site.glob("*.html")]
        return outcomes_in("".join(pages)), lost + check_site(project.site)


def _undrawn(draw: Callable[[], object], *, name: str) -> list[str]:
    return ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>'] * 2
