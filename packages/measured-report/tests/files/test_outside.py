"""Test external input: records, manifests, traces and partial work that somebody else
may have written.
"""

import gzip
import json
import os
import re
import resource
from argparse import Namespace

import pytest
from toys import MODULE, ROWS

from measured_report.changes.compare import faults_of
from measured_report.commands import page, status
from measured_report.editions.project import Manifest, write_manifest
from measured_report.editions.release import release_of
from measured_report.files.atomic import RecordError
from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError
from measured_report.findings.editions import derive_edition
from measured_report.records import traces
from measured_report.records.record import trace_path, write_record
from measured_report.records.replicas import FOLDER, archive_of
from measured_report.records.traces import load_trace
from measured_report.site.check import check_site


def test_a_site_that_is_a_link_costs_nothing_where_it_leads(toy, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/letter.txt").write_text("dear")
    toy.project.site.symlink_to(tmp_path / "mine")
    with pytest.raises(ReportError, match="files that no build wrote"):
        toy.build()
    (tmp_path / "mine/letter.txt").unlink()
    for end_mm in (
        0.4,
        0.5,
    ):  # an empty folder, or one from a build, may be built again
        toy.measure(end_mm=end_mm)
        toy.build()
    assert check_site(tmp_path / "mine") == []


@pytest.mark.parametrize(
    "text",
    [b"\xff", b"x = " + b"[" * 5_000, b"sections = 3\n"],
    ids=["byte", "deep", "kind"],
)
def test_finding_2_a_damaged_manifest_is_named_and_silences_no_alarm(toy, text):
    manifest = toy.record_path.with_name("edition.toml")
    write_manifest(manifest.parent, Manifest("1.4.0", "", ("toy", "lost")))
    manifest.write_bytes(manifest.read_bytes() + text)
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    edition = derive_edition(toy.project)
    assert [(fault.kind, fault.section) for fault in faults_of(edition)] == [
        ("damaged", "edition.toml")
    ]
    assert 'id="toy"' in toy.page


@pytest.mark.parametrize(
    ("count", "said"), [(12_000_000, "cells"), (33 << 20, "is larger than 64 MiB")]
)
def test_finding_7_a_small_trace_that_unpacks_to_a_large_one_is_refused_before_it_fills_the_memory(
    toy, count, said, monkeypatch
):
    assert count > traces.CELL_LIMIT
    monkeypatch.setattr(
        traces, "CELL_LIMIT", traces.CELL_LIMIT // 8
    )  # the line is reached after a second
    trace = trace_path(toy.record_path, "stiff")
    trace.write_bytes(gzip.compress(b"a\n" + b"1\n" * count, compresslevel=1))
    before_kb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(RecordError, match=said):
        load_trace(trace)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kb < 400 << 10


@pytest.mark.parametrize("text", ["\u202e", "\x1b[2J", "\u2028"])
def test_finding_8_names_reasons_and_commands_are_printed_without_what_moves_a_terminal(
    toy, text, capsys
):
    rows = [{**ROWS[0], "case": f"so{text}ft"}, ROWS[1]]
    with pytest.raises(
        RecordError, match=r"^newton-1\.4\.0/toy\.json is not a valid record: "
    ):
        write_record(toy.record_path, toy.record(rows))
    data = toy.record_path.read_text().replace(
        '"command": "make"', f'"command": {json.dumps("make" + text)}'
    )
    toy.record_path.write_text(data)
    manifest = toy.record_path.with_name("edition.toml")
    write_manifest(manifest.parent, Manifest(f"1.4.0{text}", "", ("toy",)))
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    said = capsys.readouterr().err
    assert len(said.splitlines()) == 2 and not any(
        text in line for line in said.splitlines()
    )
    assert (
        "newton-1.4.0/toy.json is not a valid record" in said
        and "newton-1.4.0/edition.toml is not a valid manifest" in said
    )


LOST = [{**row, "slip_mm": None, "slip_mm_reason": "lost"} for row in ROWS]


@pytest.mark.parametrize(
    ("rows", "breaks"),
    [
        (LOST, "math.sqrt(stiff.slip_mm.value)"),
        ([{**row, "slip_mm": 0.0} for row in ROWS], "math.log(soft.slip_mm.value)"),
        (ROWS[1:], "assert rows[1]"),
        (ROWS, "rows[0].slip_mm.value.unknown"),
    ],
    ids=["null", "zero", "one row", "attribute"],
)
def test_finding_4_what_nobody_thought_of_leaves_one_section_out_and_the_others_stand(
    toy, rows, breaks, capsys
):
    toy.write(
        "report/sections/toy.py",
        f"import math\n{MODULE}".replace(
            "    return Sec", f"    {breaks}\n    return Sec"
        ),
    )
    toy.measure(rows)
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    [line] = capsys.readouterr().err.splitlines()
    assert re.match(
        r"not shown: newton-1.4.0/toy.json: report/sections/toy.py:23: \w+Error", line
    )
    assert check_site(toy.project.site) == ["index.html: there is no claim on any page"]


def test_finding_4_a_page_text_that_cannot_be_said_of_a_record_is_left_out_and_its_section_stands(
    toy, capsys
):
    toy.write(
        "templates/front.md.j2",
        '# A report\n\n{% if measured %}{{ sections.toy.row["stiff"].note.code }}{% endif %}\n',
    )
    toy.measure([{**row, "note": "as text"} for row in ROWS])
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    [line] = capsys.readouterr().err.splitlines()
    assert line.startswith(
        "not shown: templates/front.md.j2:3: 'str object' has no attribute"
    )
    assert check_site(toy.project.site) == [] and 'id="toy"' in toy.page


ODD = {
    "a pipe": os.mkfifo,
    "a link to no end": lambda path: path.symlink_to("/dev/zero"),
    "a link to nowhere": lambda path: path.symlink_to("nowhere"),
    "a folder": lambda path: path.mkdir(),
    "three gigabytes": lambda path: (path.touch(), os.truncate(path, 3 << 30)),
    "a name that is no text": lambda path: path.with_name("\udcff.tgz").touch(),
}


@pytest.mark.parametrize(
    "place", ["replicas/x.tgz", "x.tgz", "edition.toml", "toy.json", "toy.stiff.csv.gz"]
)
@pytest.mark.parametrize("odd", ODD.values(), ids=ODD)
def test_one_odd_thing_costs_itself_alone(
    toy, odd, place, capsys, monkeypatch, tmp_path_factory
):
    monkeypatch.setattr(
        Cache, "folder", tmp_path_factory.getbasetemp() / "odd"
    )  # the drawings that all editions share are drawn once
    (folder := toy.project.results / FOLDER).mkdir()
    (folder / "good.tgz").write_bytes(
        archive_of([toy.record([{**row, "slip_mm": 2.0} for row in ROWS])])
    )
    (toy.project.results / place).unlink(missing_ok=True)
    odd(toy.project.results / place)
    is_damage = place == "replicas/x.tgz" or (
        place != "x.tgz" and odd is not ODD["a name that is no text"]
    )
    is_damage |= place == "toy.stiff.csv.gz"
    asked = Namespace(release=release_of("1.4.0"), address="")
    assert (
        status.run(toy.project, asked) == page.run(toy.project, asked) == int(is_damage)
    )
    assert ("damaged: " in capsys.readouterr().err) == is_damage
    assert (toy.project.site / "index.html").is_file()
    if not place.startswith("toy"):
        assert (
            'id="toy"' in toy.page
            and len(list(toy.project.site.rglob("replicas/*.tgz"))) == 1
        )
