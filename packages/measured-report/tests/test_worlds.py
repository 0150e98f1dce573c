"""Test that missing, damaged, equal, swapped or doubled results affect only the
sections that read them. The suite tries a few worlds; WORLDS=1000 tries a thousand.
"""

import contextlib
import io
import os
import re
import shutil
from argparse import Namespace
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

pytest.importorskip("hypothesis", reason="the extra test has it")

from hypothesis import example, given, settings
from hypothesis import strategies as st
from toys import Toy, lay_out, put
from worlds import (
    NON_FINITE,
    RELEASES,
    REPLICAS,
    SECTIONS,
    Said,
    World,
    first_world,
    lay_out_world,
    said_of,
)

from measured_report.changes.compare import compare
from measured_report.commands import audit, check, page, status
from measured_report.editions.project import Project
from measured_report.editions.release import release_of
from measured_report.files.atomic import short_path
from measured_report.files.config import report_in
from measured_report.findings.editions import editions_of
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER
from measured_report.site.check import check_site

COUNT = int(os.environ.get("WORLDS", "0"))
few = settings(max_examples=COUNT or 4)
many = settings(max_examples=COUNT or 15)


@pytest.fixture(scope="module")
def ground(tmp_path_factory) -> Iterator["Ground"]:
    """Return a report without results, into which tests write worlds one after the
    other.
    """
    folder = tmp_path_factory.mktemp("worlds") / "project"
    lay_out(folder)
    lay_out_world(folder)
    with report_in(folder), pytest.MonkeyPatch.context() as patch:
        toy = Toy(Project("1.4.0", own_release="1.4.0"))
        records = {
            (release, section): replace(toy.of(release).record(), section=section)
            for release in RELEASES
            for section in SECTIONS
        }
        put(folder, "README.md", "A text without marks.\n")
        argv = ["measured-report", "audit", str(folder / "README.md")]
        patch.setattr("sys.argv", argv)
        yield Ground(toy, records)


class Ground:
    """Return the report of the worlds and its answers for the first one."""

    def __init__(self, toy: Toy, records: dict[tuple[str, str], Record]):
        self.toy = toy
        self.records = records
        self.write(first_world())
        self.said = said_of(editions_of(toy.project))

    def write(self, world: World) -> None:
        shutil.rmtree(self.toy.project.results.parent, ignore_errors=True)
        world.write(self.toy, self.records)

    def run(self, command: object) -> tuple[int, str]:
        """Return the status of a command and its text on the error stream."""
        asked = Namespace(
            release=release_of("1.4.0"), address="", format="text", strict=False
        )
        errors = io.StringIO()
        with (
            contextlib.redirect_stderr(errors),
            contextlib.redirect_stdout(io.StringIO()),
        ):
            done = (
                audit.main()
                if command is audit
                else command.run(self.toy.project, asked)
            )
        return done, errors.getvalue()


@st.composite
def altered(draw: st.DrawFn, ways: tuple[str, ...] = ()) -> World:
    """Alter the first world one to three times."""
    world = first_world()
    for _ in range(draw(st.integers(1, 3))):
        way = draw(st.sampled_from(ways or (*WAYS, "spoil")))
        if way == "spoil":
            name, spoil = draw(st.sampled_from(SPOILS))
            world.spoiled[name] = spoil
            world.log.append(f"spoil {name}")
            continue
        place = draw(st.sampled_from(sorted(world.rows)))
        others = [other for other in sorted(world.rows) if other[2] == place[2]]
        other = draw(st.sampled_from(others))
        index = draw(st.integers(0, len(world.rows[place]) - 1))
        WAYS[way](world, place, index, other)
        world.log.append(f"{way} {place} {index} {other}")
        if not world.rows.get(place, True):
            del world.rows[place]
    return world


def _drop(world, place, index, other) -> None:
    del world.rows[place]


def _drop_row(world, place, index, other) -> None:
    del world.rows[place][index]


def _break(world, place, index, other) -> None:
    lost = {"slip_mm": None, "slip_mm_reason": NON_FINITE, "failure": NON_FINITE}
    world.rows[place][index] |= lost


def _enlarge(world, place, index, other) -> None:
    world.rows[place][index]["slip_mm"] = 9e9


def _zero(world, place, index, other) -> None:
    world.rows[place][index]["slip_mm"] = 0.0


def _name(world, place, index, other) -> None:
    world.rows[place][index] |= {"of": "nobody"}


def _double(world, place, index, other) -> None:
    world.rows[place].append(dict(world.rows[place][index]))


def _equalize(world, place, index, other) -> None:
    world.rows[place] = [dict(row) for row in world.rows[other]]


def _swap(world, place, index, other) -> None:
    rows = world.rows
    rows[place], rows[other] = rows[other], rows[place]


WAYS = {
    "drop": _drop,
    "drop a row": _drop_row,
    "break": _break,
    "enlarge": _enlarge,
    "zero": _zero,
    "name": _name,
    "double": _double,
    "equalize": _equalize,
    "swap": _swap,
}


def _replace(old: str, new: str):
    def spoil(path: Path) -> None:
        if path.is_file():
            text = path.read_text(encoding="utf-8")
            path.write_text(re.sub(old, new, text, count=1), encoding="utf-8")
        else:
            path.write_text("{", encoding="utf-8")

    return spoil


def _as_file(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    path.write_text("no folder", encoding="utf-8")


def _as_link(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)
    path.symlink_to("nowhere")


SPOILS = [
    *(
        (f"newton-{release}/{section}.json", spoil)
        for release in RELEASES
        for section in SECTIONS
        for spoil in (
            _replace(r"\d+\.\d+", "NaN"),
            _replace(r"\d+\.\d+", "1e999"),
            _replace(r',\n "seal": "\w+"', ""),
            lambda path: path.write_text("{"),
        )
    ),
    *(
        (f"newton-{release}/{FOLDER}/{name}.tgz", lambda path: path.write_bytes(b"x"))
        for release, names in REPLICAS.items()
        for name in names
    ),
    *(
        (f"newton-{release}{place}", spoil)
        for release in RELEASES
        for place in ("", f"/{FOLDER}")
        for spoil in (_as_file, _as_link)
    ),
    *(
        (f"newton-{release}/edition.toml", lambda path: path.write_text("no = 3"))
        for release in RELEASES
    ),
]


def world_after(*changes: tuple) -> World:
    """Return the first world with some changes.

    A change consists of a kind and its cells.
    """
    world = first_world()
    for way, *cells in changes:
        WAYS[way](world, *cells)
        world.log.append(f"{way} {cells}")
    return world


ODD = world_after(
    ("drop", ("1.4.0", "", "pair"), 0, ()), ("enlarge", ("1.8.0", "", "toy"), 1, ())
)
"""A world with a number below its noise. Only the page prints such a number."""


@few
@example(world=ODD)
@given(world=altered())
def test_the_site_builds_and_what_cannot_be_read_is_named_everywhere(ground, world):
    ground.write(world)
    results = ground.toy.project.results.parent
    spoiled = [results / name for name in world.spoiled]
    # If a folder cannot be read, its files are not named individually.
    outer = [path for path in spoiled if not {*path.parents} & {*spoiled}]
    for command in (page, status, check, audit):
        done, errors = ground.run(command)
        assert done == int(bool(spoiled)), (command.__name__, errors)
        for path in outer:
            assert short_path(path) in errors, (command.__name__, errors)
    problems = check_site(ground.toy.project.site)
    assert [each for each in problems if "no claim on any page" not in each] == []


@many
@given(world=altered((*WAYS,)))
def test_every_sentence_that_changed_reads_something_that_changed(ground, world):
    ground.write(world)
    first = first_world()
    changed, scatters = first.changed(world)
    said = said_of(editions_of(ground.toy.project))
    for sentence, before in ground.said.items():
        after = said.get(sentence, Said("", "", {}, frozenset()))
        if before.text == after.text or (before.reads | after.reads) & changed:
            continue
        release, section, _ = sentence
        if sentence not in said:
            lost = {(release, "", section), (release, "", "toy")} - world.rows.keys()
            assert lost, sentence
            continue
        # The scatter of numbers is estimated from all measurements together.
        assert scatters, (sentence, before.text, after.text)
        assert after.numbers == before.numbers, sentence
        assert {before.answer, after.answer} != {"holds", "fails"}, sentence


@many
@given(world=altered((*WAYS,)))
def test_releases_with_equal_rows_are_the_same(ground, world):
    newest, oldest = RELEASES[-1], RELEASES[0]
    world.rows = {
        place: rows for place, rows in world.rows.items() if place[0] != newest
    }
    world.rows |= {
        (newest, replica, section): rows
        for (release, replica, section), rows in world.rows.items()
        if release == oldest
    }
    ground.write(world)
    editions = editions_of(ground.toy.project)
    if newest not in editions:
        return
    comparison = compare(editions[oldest], editions[newest])
    assert (comparison.moves, comparison.flips) == ([], [])
    said = said_of(editions)
    for release in (oldest, newest):
        same = said.get((release, "pair", "same"))
        assert same is None or same.answer != "fails", same
        soft = [
            row
            for row in world.rows.get((oldest, "", "toy"), ())
            if row["case"] == "soft"
        ]
        is_plain = len(soft) == 1 and (soft[0]["slip_mm"] or 1e9) < 1e6
        has_replicas = len({place[1] for place in world.rows if place[0] == oldest}) > 1
        if same and is_plain and not has_replicas:
            assert same.answer == "holds", same
