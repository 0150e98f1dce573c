"""Test that every command that reads an unreadable input names it and returns status 1."""

import os
import shutil
import time
from argparse import Namespace
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from damage import as_a_plain_user, unsealed
from toys import IS_WEEKLY, ROWS

from measured_report.commands import (
    audit,
    carry,
    check,
    command_line,
    diff,
    history,
    page,
    status,
    trace,
)
from measured_report.commands.command_line import status_of
from measured_report.commands.new import main as measured_report
from measured_report.editions.project import Manifest, Project, write_manifest
from measured_report.editions.release import release_of
from measured_report.files.atomic import remove, short_path
from measured_report.files.cache import Cache
from measured_report.files.config import report_in
from measured_report.records.replicas import FOLDER, archive_of

COMMANDS = {
    "page": page,
    "status": status,
    "check": check,
    "history": history,
    "trace": trace,
    "diff": diff,
    "carry": carry,
    "audit": audit,
}


def instead(make) -> object:
    """Put another object in the place of a file or folder."""
    return lambda path: (remove(path), make(path))


FOLDER_KINDS = {
    "unreadable": lambda path: path.chmod(0),
    "a file": instead(lambda path: path.write_text("text")),
    "a pipe": instead(os.mkfifo),
    "a link to nowhere": instead(lambda path: path.symlink_to("nowhere")),
    "a link to itself": instead(lambda path: path.symlink_to(path.name)),
}
FILE_KINDS = {
    "unreadable": lambda path: path.chmod(0),
    "a folder": instead(Path.mkdir),
    "a pipe": instead(os.mkfifo),
    "a link to nowhere": instead(lambda path: path.symlink_to("nowhere")),
    "a link to a copy": lambda path: path.symlink_to(path.rename(f"{path}.moved")),
    "not UTF-8": lambda path: path.write_bytes(b"\xff" + path.read_bytes()),
    "cut off": lambda path: path.write_bytes(path.read_bytes()[:-9]),
    "huge": lambda path: os.truncate(path, 1 << 40),
}
ALIKE = {"a file", "a link to itself", "a folder", "huge"}
"""Kinds that the suite leaves out, because test_every_damage_to_a_record_is_named_in_one_line
tries them with the function that reads all files. The weekly workflow tries them.
"""
PLACES = {
    "": FOLDER_KINDS,
    FOLDER: FOLDER_KINDS,
    "toy.json": {
        **FILE_KINDS,
        "without a seal": lambda path: path.write_text(unsealed(path.read_text())),
    },
    "toy.stiff.csv.gz": FILE_KINDS,
    "edition.toml": FILE_KINDS,
    f"{FOLDER}/a.tgz": FILE_KINDS,
}
"""Kinds of damage to each input of an edition, by its name in the edition's folder."""


def run(toy, name: str, a: str = "1.4.0", b: str = "1.5.0") -> int:
    """Return the status of a command."""
    asked = Namespace(
        release=release_of("1.4.0"),
        address="",
        format="text",
        strict=False,
        claim="",
        section="",
        value="toy.soft.slip_mm",
        a=release_of(a),
        b=release_of(b),
    )
    if name == "audit":
        return measured_report()
    return status_of(partial(COMMANDS[name].run, toy.project, asked))


def measure(toy, release: str) -> Path:
    """Fill the folder of an edition with everything that one can contain."""
    edition = toy.of(release)
    edition.measure()
    results = edition.project.results
    (results / FOLDER).mkdir(exist_ok=True)
    again = [{**row, "slip_mm": row["slip_mm"] * 1.01} for row in ROWS]
    (results / FOLDER / "a.tgz").write_bytes(archive_of([edition.record(again)]))
    write_manifest(results, Manifest(release, "", ("toy",)))
    return results


@pytest.fixture
def asked(toy, monkeypatch):
    """Return the toy with a text without marks for the audit."""
    pytest.importorskip("number_audit", reason="the audit is a package of its own")
    text = toy.project.root / "README.md"
    text.write_text("No marks.\n")
    monkeypatch.setattr("sys.argv", ["measured-report", "audit", str(text)])
    with as_a_plain_user():
        yield toy


@pytest.mark.parametrize("place", PLACES)
def test_every_damage_to_an_edition_is_named_by_every_command(asked, place, capsys):
    """Return a project whose editions are damaged in different ways, except two
    undamaged ones.
    """
    for release in ("1.4.0", "1.5.0"):
        measure(asked, release)
    damaged = {}
    kinds = {
        kind: spoil
        for kind, spoil in PLACES[place].items()
        if IS_WEEKLY or kind not in ALIKE
    }
    for number, (kind, spoil) in enumerate(kinds.items()):
        path = measure(asked, f"1.6.{number}") / place
        spoil(path)
        damaged[kind] = path
    for name in COMMANDS:
        assert run(asked, name) == 1, name
        errors = capsys.readouterr().err
        unnamed = [
            kind for kind, path in damaged.items() if short_path(path) not in errors
        ]
        assert unnamed == [], (name, errors)
        assert "Traceback" not in errors
    assert 'id="toy"' in asked.page
    numbers = range(len(damaged)) if IS_WEEKLY else (0, len(damaged) - 1)
    for number in numbers:
        assert run(asked, "diff", a=f"1.6.{number}", b="1.4.0") == 1, number
    for path in damaged.values():
        if not path.is_symlink() and path.exists():
            path.chmod(0o700)


@pytest.mark.parametrize("kind", FOLDER_KINDS)
def test_results_that_cannot_be_read_at_all_are_named(asked, kind, capsys):
    measure(asked, "1.5.0")
    results = asked.project.results.parent
    FOLDER_KINDS[kind](results)
    for name in COMMANDS.keys() - {"trace"}:
        assert run(asked, name) == 1, name
        assert "results" in capsys.readouterr().err, name
    if kind == "unreadable":
        results.chmod(0o700)


TEXT_KINDS = {
    kind: FILE_KINDS[kind] for kind in ("unreadable", "a folder", "a pipe", "not UTF-8")
}


@pytest.mark.parametrize("kind", TEXT_KINDS)
@pytest.mark.parametrize(
    "name",
    [
        "pyproject.toml",
        "CITATION.cff",
        "templates/sources.toml",
        "templates/front.md.j2",
    ],
)
def test_a_text_of_the_report_that_cannot_be_read_is_one_line(
    asked, kind, name, capsys
):
    asked.write("templates/sources.toml", '[sea]\nurl = "https://example.org"\n')
    path = asked.project.root / name
    TEXT_KINDS[kind](path)
    is_optional = name == "templates/sources.toml" and kind in ("a folder", "a pipe")
    command = "audit" if name == "pyproject.toml" else "page"
    assert run(asked, command) == int(not is_optional)
    errors = capsys.readouterr().err
    assert is_optional or (path.name in errors and errors.count("\n") == 1), errors
    if kind == "unreadable":
        path.chmod(0o600)


def test_toml_that_is_not_toml_is_one_line(asked, capsys):
    for text in ("[sea]\nurl = ", "x = " + "[" * 5_000):
        asked.write("templates/sources.toml", text)
        assert run(asked, "page") == 1
        assert capsys.readouterr().err.startswith("sources.toml: ")


def test_sections_that_cannot_be_listed_are_named(asked, capsys):
    sections = asked.project.root / "report/sections"
    shutil.rmtree(sections)
    sections.write_text("no folder")
    for name in ("page", "status", "check", "history", "diff", "audit"):
        assert run(asked, name) == 1, name
        assert capsys.readouterr().err == (
            "report/sections cannot be read: Not a directory\n"
        )


PARTS = {
    "a pipe": os.mkfifo,
    "a folder": lambda path: (path.mkdir(), (path / "more").mkdir()),
    "a link": lambda path: path.symlink_to("/"),
}


@pytest.mark.parametrize("part", PARTS)
def test_what_is_in_the_way_of_a_build_neither_stops_it_nor_is_followed(toy, part):
    """Test objects in the way of a build.

    Opening a pipe would block it, and the cache may contain one as well.
    """
    toy.build()
    names = (".site-new", ".site-new-before", "site/.index.html.part")
    for name in names:
        PARTS[part](toy.project.root / name)
    folder = Cache(toy.project.root).folder
    for name in ("site", "full.1.4.0.toy"):
        (folder / name).unlink()
        PARTS[part](folder / name)
    toy.write("templates/story.md.j2", "# Another story\n")
    toy.build()
    assert "Another story" in toy.front
    assert not any((toy.project.root / name).exists() for name in names)


@pytest.mark.parametrize(
    ("file", "passage", "filling"),
    [
        ("report/sections/toy.py", "    soft, stiff =", "    raise MemoryError\n"),
        ("report/sections/toy.py", "    axes.legend()", "    raise MemoryError\n"),
        ("templates/story.md.j2", "", "{{ 'x' * 10**18 }}\n"),
    ],
)
def test_a_build_without_enough_memory_stops_instead_of_leaving_a_part_out(
    toy, file, passage, filling, capsys
):
    toy.build()
    before = toy.page
    text = (toy.project.root / file).read_text()
    toy.write(file, text.replace(passage, filling + passage, 1))
    capsys.readouterr()
    assert run(toy, "page") == 1
    assert capsys.readouterr().err == (
        "there is not enough memory: close other programs\n"
    )
    assert toy.page == before


def test_a_folder_whose_name_is_not_utf_8_is_one_line(toy, tmp_path, capsys):
    folder = tmp_path / "f\udcff"
    shutil.copytree(toy.project.root, folder)
    with report_in(folder):
        project = Project("1.4.0", root=folder)
        assert run(replace(toy, project=project), "page") == 1
    errors = capsys.readouterr().err
    assert "cannot be written as utf-8: rename the file or folder" in errors
    assert errors.count("\n") == 1


def test_a_clock_before_2000_is_named_instead_of_every_record(toy, monkeypatch, capsys):
    monkeypatch.setattr(time, "time", lambda: 5.0)
    monkeypatch.setattr("sys.argv", ["build.py", "status"])
    assert command_line.main() == 2
    assert capsys.readouterr().err.startswith("the clock of this machine shows")
