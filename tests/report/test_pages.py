"""Test the length of the pages, their languages, and the effect of a lost row."""

import re
import sys
from collections.abc import Sequence
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from subprocess import run
from zipfile import ZipFile

import pytest
from conftest import ROOT

from measured_report.editions.project import own_release
from measured_report.files import git
from measured_report.pages.prose import Templates
from report.shared.wheel import wheel
from report.story import cause, investigation
from tests.perturbed import of_editions

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
BLOCKS = {
    "p",
    "td",
    "th",
    "div",
    "figcaption",
    "h1",
    "h2",
    "h3",
    "li",
    "dt",
    "dd",
    "summary",
    "tr",
    "pre",
    "section",
}
VOID = {"meta", "link", "br", "img", "input", "source", "hr", "wbr"}


class Words(HTMLParser):
    """Return the visible text of <main> without drawings, and each caption."""

    def __init__(self, page: Path, but: Sequence[str] = ()):
        super().__init__()
        self.but = {"svg", "script", *but}
        self.open, self.text, self.captions = [], "", []
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        if tag not in VOID:
            self.open.append((tag, dict(attrs)))
            self.text += " " if tag in BLOCKS else ""
            self.captions += [""] if tag == "figcaption" else []

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass
        self.text += " " if tag in BLOCKS else ""

    def handle_data(self, data):
        tags = [tag for tag, _ in self.open]
        folded = "details" in tags and "summary" not in tags[tags.index("details") :]
        hidden = self.but & {*tags} or any(
            "hidden" in attributes for _, attributes in self.open
        )
        if "main" in tags and not folded and not hidden:
            self.text += data
            if "figcaption" in tags and "details" not in tags:
                self.captions[-1] += data


def counts(site: Path) -> dict[str, int]:
    pages = [
        page
        for page in site.glob("*.html")
        if page.stem not in ("lab", "replay", "404")
    ]
    return {page.stem: len(Words(page).text.split()) for page in pages}


def test_no_paragraph_begins_with_a_mark_that_ends_a_sentence(site):
    """Test that no paragraph begins with punctuation.

    A passage with line breaks would become a separate paragraph.
    """
    for path in site.rglob("*.html"):
        assert re.findall(r"<p>\s*[,.;:]", path.read_text(encoding="utf-8")) == [], path


def test_no_passage_within_a_line_begins_with_a_blank():
    """Test that no passage within a line begins with a space.

    The space would be lost; write &nbsp; or a comma instead.
    """
    for path in sorted((ROOT / "templates").rglob("*.j2")):
        text = path.read_text(encoding="utf-8")
        assert re.findall(r"\w\{% passage[^%]*%\} \w+", text) == [], path


def test_the_front_is_words(site):
    front = Words(site / "index.html", but=("td", "th", "pre")).text.split()
    assert 25 * sum(any(map(str.isdigit, word)) for word in front) <= len(front)


def test_each_release_has_its_title_and_a_description_that_is_a_sentence_of_its_values(
    site,
):
    heads = [
        page.read_text(encoding="utf-8").partition("</head>")[0]
        for page in site.glob("**/index.html")
    ]
    titles = [re.search("<title>(.*?)</title>", head)[1] for head in heads]
    said = [re.search('name="description" content="(.*?)"', head)[1] for head in heads]
    assert len({*titles}) == len(titles) > 4 and "4.0 trial" in "".join(titles)
    assert all("shaken" in text and "mm" in text for text in said), said
    pages = "".join(
        page.read_text(encoding="utf-8") for page in site.glob("**/releases.html")
    )
    assert "Newton 1.8.0+mujoco" not in re.sub("<[^>]*>", "", pages)


@pytest.mark.parametrize(
    ("origin", "address"),
    [
        (
            "https://me:secret@git.example/shake/report.git",
            "https://git.example/shake/report",
        ),
        ("git@git.example:shake/report.git", "https://git.example/shake/report"),
        ("ssh://git@git.example:22/shake/report", "https://git.example/shake/report"),
        ("/home/me/report", ""),
    ],
)
def test_sources_are_where_git_has_them_and_no_secret_goes_along(
    monkeypatch, origin, address
):
    monkeypatch.setattr(git, "git", lambda *_: origin)
    assert git.web_address(ROOT) == address


def test_the_lint_is_installed_from_what_the_page_offers(tmp_path):
    name, packed = wheel(ROOT / "packages/newton-lint")
    assert (name, packed) == wheel(ROOT / "packages/newton-lint")
    (tmp_path / name).write_bytes(packed)
    assert ZipFile(tmp_path / name).testzip() is None
    command = [sys.executable, "-m", "newton_lint", "--help"]
    done = run(
        command,
        env={"PYTHONPATH": str(tmp_path / name)},
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_what_the_investigation_said_is_answered_by_what_was_measured(editions):
    found = {
        release: investigation.derive(edition.chapters).claims
        for release, edition in editions.items()
    }
    assert {claim.outcome.name for claim in found[own_release()]} == {"holds"}
    assert {claim.name: claim.outcome.name for claim in found["1.8.0"]}[
        "drifts"
    ] == "fails"


def test_a_suspect_is_out_only_where_its_claims_hold(editions):
    tables = {
        release: cause.derive(editions[release].chapters).tables["suspects"].frame
        for release in ("1.4.0", "1.8.0")
    }
    shipped, newest = (
        dict(zip(frame.index, frame["verdict"], strict=True))
        for frame in tables.values()
    )
    assert all(shipped.values()) and shipped["pads' ke and kd"].startswith("yes: ")
    assert newest["contact points"] == newest["solver"] == "it changes the slip"
    assert newest["pads' ke and kd"] == "not shown"
    assert newest["pads' friction"].startswith("no: ")


def test_a_row_that_is_missing_costs_no_section(editions):
    """Return three rows of each section. The weekly workflow removes every row, one at
    a time.
    """
    perturbation, release = (
        of_editions(editions, Templates(ROOT / "templates"), ()),
        own_release(),
    )
    lost = []
    for name, chapter in editions[release].chapters.items():
        record = chapter.results.record
        for index in range(0, len(record.rows), max(1, len(record.rows) // 3)):
            rows = [*record.rows[:index], *record.rows[index + 1 :]]
            try:
                perturbation.section(
                    release, name, {chapter.results.source: replace(record, rows=rows)}
                )
            except Exception as error:
                lost.append((name, record.rows[index]["case"], repr(error)))
    assert lost == []


def test_a_page_without_its_sections_is_there_only_if_it_always_is(editions):
    names = {page.name for page in editions["1.6.1"].pages}
    assert "advice" in names, "which has no sections"
    assert "step" not in names, "whose sections were not measured with this release"
