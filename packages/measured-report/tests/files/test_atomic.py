"""Test damage, killed processes and hostile text."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import matplotlib
import pytest
from batches import is_running
from damage import FIELDS, RECORD_WAYS, TRACE_WAYS, damage
from markupsafe import Markup
from toys import MODULE, ROWS, TEMPLATE, killed_at

from measured_report.editions.environment import requirements
from measured_report.files.atomic import (
    RecordError,
    locked,
    put_in_place,
    staging_folder,
    write_file,
)
from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.findings.editions import editions_of
from measured_report.pages.prose import Templates
from measured_report.records.record import load_record, trace_path, write_record
from measured_report.records.traces import load_trace, packed
from measured_report.site.check import check_site


def refusal(path: Path, trace: Path | None = None) -> str:
    with pytest.raises(RecordError) as error:
        load_trace(trace) if trace else load_record(path)
    return str(error.value)


def test_every_damage_to_a_record_is_named_in_one_line(toy):
    folder = toy.record_path.parent
    whole = {path.name: path.read_bytes() for path in folder.iterdir()}
    unnamed = []
    for way in RECORD_WAYS:
        damage(toy.record_path, way)
        try:
            load_record(toy.record_path)
            unnamed.append(f"{way}: taken for whole")
        except RecordError as error:
            line = str(error)
            if (
                "newton-1.4.0/toy" not in line
                or "\n" in line
                or len(line) > 500
                or not line.isprintable()
            ):
                unnamed.append(f"{way}: {line!r}")
        toy.record_path.rmdir() if toy.record_path.is_dir() else toy.record_path.unlink()
        for name, content in whole.items():
            (folder / name).write_bytes(content)
    assert unnamed == []
    assert len(RECORD_WAYS) >= 200


@pytest.mark.parametrize("way", TRACE_WAYS)
def test_every_damage_to_a_trace_is_named_with_and_without_its_seal(toy, way):
    trace = trace_path(toy.record_path, "stiff")
    damage(trace, way)
    for line in (refusal(toy.record_path), refusal(toy.record_path, trace)):
        assert line.startswith("newton-1.4.0/toy.stiff.csv.gz ") and "\n" not in line
    if way.startswith("place: "):
        toy.build()
        assert "root:" not in toy.page and not list(toy.project.site.rglob("*.gz"))


def test_a_trace_of_another_measurement_is_named(toy):
    other = packed(
        toy.record_path, "stiff", {"time_s": [0.0, 1.0], "x_mm": [0.0, 0.4]}
    )[1]
    trace_path(toy.record_path, "stiff").write_bytes(other)
    assert refusal(toy.record_path).endswith(
        "toy.stiff.csv.gz is not the trace that was measured with toy.json"
    )


def test_damage_elsewhere_leaves_the_page_and_is_named(toy):
    newer = toy.of("1.8.0")
    newer.measure()
    damage(newer.record_path, "field: unit 'm'")
    line = "the unit of slip_mm is m, but its name implies mm"
    toy.build()
    assert 'id="toy"' in toy.page
    assert check_site(toy.project.site) == [
        "newton-1.8.0/index.html: there is no claim on any page"
    ]
    left_out = editions_of(toy.project)["1.8.0"].left_out
    assert [(state.kind, state.notes) for state in left_out] == [
        ("damaged", (f"newton-1.8.0/toy.json is not a valid record: {line}",))
    ]


def test_a_record_that_does_not_fit_on_the_disk_changes_nothing(toy, monkeypatch):
    before = {path.name: path.read_bytes() for path in toy.record_path.parent.iterdir()}

    def full(descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        write_record(toy.record_path, toy.record([{**ROWS[0], "slip_mm": 1.0}]), {})
    assert {
        path.name: path.read_bytes() for path in toy.record_path.parent.iterdir()
    } == before


WORKERS = """
import os, sys, time
from measured_report.files.processes import workers
def work(number):
    os.write(1, b"%d\\n" % os.getpid())
    time.sleep(60)
with workers(2, "fork") as pool:
    list(pool.map(work, range(8)))
"""


@pytest.mark.parametrize("sent", [signal.SIGKILL, signal.SIGTERM])
def test_no_process_outlives_the_one_that_started_it(sent):
    main = subprocess.Popen(
        [sys.executable, "-c", WORKERS], cwd=ROOT, stdout=subprocess.PIPE, text=True
    )
    started = [int(main.stdout.readline()) for _ in range(2)]
    main.send_signal(sent)
    main.wait()
    main.stdout.close()
    while any(
        map(is_running, started)
    ):  # there is no time limit here, because the test must not depend on speed
        time.sleep(0.05)


IN_THE_WAY = {
    "a link to a file": lambda path, other: path.symlink_to(other / "letter"),
    "a link to a folder": lambda path, other: path.symlink_to(other),
    "a pipe": lambda path, other: os.mkfifo(path),
    "a folder": lambda path, other: shutil.copytree(other, path),
}


@pytest.mark.parametrize("way", IN_THE_WAY)
def test_what_a_killed_process_left_is_removed_and_no_link_is_followed(tmp_path, way):
    """Test a temporary file or folder whose known name somebody else may have used."""
    other = tmp_path / "other"
    other.mkdir()
    (other / "letter").write_text("dear")
    place = tmp_path / "place"
    place.mkdir()
    for name in (".a.txt.part", ".site-new", ".site-new-before"):
        IN_THE_WAY[way](place / name, other)
    write_file(place / "a.txt", "text")
    (place / "site").mkdir()
    (place / "site/old").touch()
    with staging_folder(place / "site") as fresh:
        write_file(fresh / "new", "text")
        put_in_place(place / "site", fresh)
    assert [path.name for path in (place / "site").iterdir()] == ["new"]
    assert (place / "a.txt").read_text() == "text"
    assert (other / "letter").read_text() == "dear"
    left = {path.name for path in place.iterdir()}
    assert left == {"a.txt", "site"}


FORGED = "\ue0000\ue001 [click](javascript:alert(1)) ![](https://example.org/x.png)"


def test_text_of_a_record_is_never_a_token_of_the_page(toy):
    row = {
        **ROWS[0],
        "slip_mm": None,
        "slip_mm_reason": "[click](javascript:alert(1)) <b>&",
    }
    toy.write(
        "templates/sections/toy.md.j2",
        TEMPLATE + "\n{{ rows[0].slip_mm_reason }} {{ rows[0].slip_mm }}\n",
    )
    toy.measure([row, ROWS[1]])
    toy.build()
    assert 'href="javascript' not in toy.page and check_site(toy.project.site) == []
    with pytest.raises(RecordError, match=r"U\+E000"):
        toy.measure([{**row, "slip_mm_reason": FORGED}, ROWS[1]])
    toy.write("templates/forged.md.j2", "# Title\n\n{{ text }} {{ other }}\n")
    templates = Templates(toy.project.templates)
    html = templates.prose(
        "forged.md.j2", "forged", {"text": Markup(FORGED), "other": FORGED}
    ).body
    assert "href" not in html and "<img" not in html


def test_figures_know_nothing_of_the_users_settings_and_no_formulas(toy, monkeypatch):
    toy.write(
        "report/sections/toy.py", MODULE.replace('label="x"', r'label="$\\frac{1}{2}$"')
    )
    toy.build()
    drawing = toy.page_path.parent / "figures/toy-way.svg"
    before = drawing.read_text()
    assert "frac{1}{2}$</text>" in before
    for name, value in {
        "text.usetex": True,
        "font.size": 40.0,
        "axes.grid": False,
    }.items():
        monkeypatch.setitem(matplotlib.rcParams, name, value)
    shutil.rmtree(toy.project.site)
    shutil.rmtree(Cache(toy.project.root).folder)
    toy.build()
    assert drawing.read_text() == before


@pytest.mark.parametrize(
    "name", [way for way in FIELDS if way.startswith(("newton ", "package "))]
)
def test_only_plain_versions_of_the_simulator_are_installed(toy, name):
    data = json.loads(toy.record_path.read_text())
    FIELDS[name](data)
    with pytest.raises((ReportError, TypeError)):
        requirements(
            toy.project.root, data["identity"]["packages"], toy.project.settings
        )


@pytest.mark.parametrize("stop", range(1, 9))
def test_a_kill_while_a_record_is_written_leaves_a_whole_one_or_one_that_is_named(
    toy, stop
):
    """Test a process that is killed before each step that changes the folder."""
    before = [row["slip_mm"] for row in load_record(toy.record_path).rows]
    rows = [{**row, "slip_mm": 2.0} for row in ROWS]
    traces = {
        name: packed(toy.record_path, name, {"time_s": [0.0], "x_mm": [9.0]})
        for name in ("stiff", "soft")
    }

    def changes(event: str, arguments: tuple) -> bool:
        is_written = (
            event == "open"
            and "toy" in str(arguments[0])
            and str(arguments[1]).startswith("w")
        )
        return is_written or event in ("os.rename", "os.remove", "os.replace")

    ended = killed_at(
        stop, changes, lambda: write_record(toy.record_path, toy.record(rows), traces)
    )
    try:
        record = load_record(toy.record_path)
    except RecordError as error:
        assert str(error).endswith(
            "toy.stiff.csv.gz is not the trace that was measured with toy.json"
        )
    else:
        assert [row["slip_mm"] for row in record.rows] in (before, [2.0, 2.0])
        assert ended or record.rows[0]["slip_mm"] == 2.0
    write_record(toy.record_path, toy.record(rows), traces)
    expected = {"toy.json", "toy.stiff.csv.gz", "toy.soft.csv.gz"}
    assert {path.name for path in toy.record_path.parent.iterdir()} == expected


@pytest.mark.skipif(
    not Path("/proc/locks").is_file(), reason="Linux says whose a lock is"
)
def test_whoever_waits_for_a_lock_says_whose_it_is(tmp_path):
    with locked(tmp_path):
        child = subprocess.Popen(
            [
                sys.executable,
                "-c",
                f"{HOLD}\nwith locked(Path({str(tmp_path)!r})): pass",
            ],
            stderr=-1,
        )
        assert (
            child.stderr
            and "waiting for another process" in child.stderr.readline().decode()
        )
    assert child.wait() == 0


HOLD = "from pathlib import Path; from measured_report.files.atomic import locked"
