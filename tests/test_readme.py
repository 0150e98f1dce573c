"""Test that the commands of the README exist, and that the section that it adds works."""

import json
import re
import subprocess
import sys
import textwrap

import pytest

from experiments.facts.case import differences
from measured_report.commands.audit import noise_of_record
from measured_report.commands.new import main
from measured_report.commands.reference import reference
from measured_report.files.config import report
from measured_report.files.root import ROOT
from measured_report.findings.sections import outline_of
from measured_report.records.identity import sections
from measured_report.site.check import check_site
from number_audit.command import main as number_audit

pytestmark = pytest.mark.words
README = (ROOT / "README.md").read_text(encoding="utf-8")
FILE = re.compile(
    r"^[0-9]\. `([^`]+)`.*\n(?: {3}\S.*\n)*\n((?: {7}.*\n|\n)+)", re.MULTILINE
)


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """Return the files of the section that the README adds, by folder."""
    return {
        path.partition("/")[0]: textwrap.dedent(text).strip() + "\n"
        for path, text in FILE.findall(README)
    }


MAKEFILES = (
    ROOT / "Makefile",
    ROOT / "packages/measured-report/measured_report/skeleton/report.mk",
)


def text_of(section: str) -> str:
    path = ROOT / "report/sections" / f"{section}.py"
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def test_what_it_names_is_there_and_needs_no_uv_but_the_own():
    targets = set(
        re.findall(
            r"^([a-z]+):",
            "\n".join(path.read_text() for path in MAKEFILES),
            re.MULTILINE,
        )
    )
    named = set(re.findall(r"(?:`|^ {4})make ([a-z]+)", README, re.MULTILINE))
    assert named and named <= targets
    texts = [
        README,
        *(path.read_text(encoding="utf-8") for path in (ROOT / "docs").glob("*.md")),
    ]
    own = re.findall(r"(\S*)\buv (?:sync|pip)", "\n".join(texts))
    assert {before.lstrip("`") for before in own} == {".venv/bin/"}
    places = re.findall(r"^\| (`.*`) \|", README, re.MULTILINE)
    assert len(places) > 5
    assert all(
        (ROOT / name).exists()
        for place in places
        for name in re.findall(r"`([^`]+)`", place)
    )


@pytest.mark.usefixtures("site", "unchanged")
def test_numbers_that_have_a_mark_are_what_was_measured(monkeypatch, capsys):
    monkeypatch.setattr(
        "sys.argv",
        [
            "",
            "audit",
            *map(str, [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]),
        ],
    )
    assert main() == 0, capsys.readouterr().out
    assert capsys.readouterr().out.count("contact-bias.md") > 2


def test_the_noise_of_a_number_is_that_of_its_record(tmp_path, monkeypatch, capsys):
    """Test that the noise comes from the record, because the tracked file itself does
    not contain it.
    """
    path = ROOT / "results/newton-1.4.0/cure.json"
    rows = json.loads(path.read_text(encoding="utf-8"))["rows"]
    index = [row["case"] for row in rows].index(
        "newton-implicitfast-50-shipped-3cm-plain-rounded"
    )
    slip, noise = rows[index]["slip_mm"], noise_of_record(path, index, "slip_mm")
    text = tmp_path / "a.md"
    text.write_text(
        f"{slip + noise:.5f} mm<!-- = {path}#/rows/{rows[index]['case']}/slip_mm -->"
    )
    arguments = [str(text), "--allow", str(ROOT)]
    monkeypatch.setattr("sys.argv", ["", "audit", *arguments])
    assert (main(), number_audit(arguments)) == (0, 1), capsys.readouterr().out


def test_the_documents_are_a_site_without_a_dead_link(tmp_path):
    mkdocs = pytest.importorskip("mkdocs", reason="make docs installs it").__name__
    command = [
        sys.executable,
        "-m",
        mkdocs,
        "build",
        "--strict",
        "--quiet",
        "--site-dir",
        str(tmp_path),
    ]
    done = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout + done.stderr) == (0, "")
    names = {path.stem for path in (ROOT / "docs").glob("*.md")} - {"index"}
    assert {path.parent.name for path in tmp_path.glob("*/index.html")} == names


def test_the_reference_is_that_of_the_code():
    text = (ROOT / "docs/REFERENCE.md").read_text(encoding="utf-8")
    assert text == reference(report()), "make docs writes it"


def test_the_section_that_is_added_works(toy, files):
    measuring: dict = {}
    exec(files["experiments"], measuring)
    cases = measuring["CASES"]
    assert all(
        "cube_density_kg_m3" in differences(case) for case in (cases[0], cases[-1])
    )
    toy.write("report/sections/toy.py", files["report"])
    toy.write("templates/sections/toy.md.j2", files["templates"])
    toy.measure(
        [
            {"case": case.name, "slip_mm": 1.0 + index}
            for index, case in enumerate(cases)
        ]
    )
    toy.build()
    assert check_site(toy.project.site) == []
    left = {section for section in sections() if text_of(section) == files["report"]}
    labels = [
        outline_of(section).label
        for section in {*sections(), *sections(toy.project.root)} - left
    ]
    assert "weight" in labels, "a section is named nowhere but in its own files"
    assert len(set(labels)) == len(labels), "two sections are called alike"
    assert 'data-claim="toy.heavier_slips_more" data-outcome="unknown"' in toy.page, (
        "there is no section on noise"
    )
