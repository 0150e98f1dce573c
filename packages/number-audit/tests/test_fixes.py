"""Tests that a fix changes a number only if the result can be right."""

import json

import pytest

from number_audit.command import main

RESULTS = {
    "users": 1234567,
    "share": 0.913,
    "wait_ms": 3.2,
    "plain": 14.1,
    "tiny": 0.004,
    "name_B": 3.0,
}


@pytest.fixture
def audit(tmp_path, monkeypatch, capsys):
    """Return a function that audits a text: it returns the kinds and the text."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "r.json").write_text(json.dumps(RESULTS))

    def run(text: str, *options: str) -> tuple[list[str], str]:
        path = tmp_path / "a.md"
        path.write_text(text, encoding="utf-8")
        main(["a.md", *options])
        lines = capsys.readouterr().out.splitlines()
        kinds = [line.split(": ")[1] for line in lines]
        return kinds, path.read_text(encoding="utf-8")

    return run


REFUSED = [
    ("unknown suffix", "1.3M", "users"),
    ("unknown suffix of thousands", "1300k", "users"),
    ("unknown word", "1.3 million", "users"),
    ("percent of a ratio", "95.2 %", "share"),
    ("unit of a source without one", "15.0 ms", "plain"),
    ("number without the unit of its source", "15.0", "wait_ms"),
    ("upper bound", "< 3 ms", "wait_ms"),
    ("upper bound in words", "less than 3 ms", "wait_ms"),
    ("upper bound in HTML", "&lt; 3 ms", "wait_ms"),
    ("upper bound in bold", "at most **3 ms**", "wait_ms"),
    ("negated lower bound", "no more than 3 ms", "wait_ms"),
    ("negated upper bound", "not below 4 ms", "wait_ms"),
    ("upper bound before a unit", "up to 3 ms", "wait_ms"),
    ("largest number", "a maximum of 3 ms", "wait_ms"),
    ("smallest number", "a minimum of 4 ms", "wait_ms"),
    ("prefix", "sub-3 ms", "wait_ms"),
    ("bound without a direction", "faster than 4 ms", "wait_ms"),
    ("choice", "2 or 4 ms", "wait_ms"),
    ("lower bound", "it takes > 4 ms", "wait_ms"),
    ("lower bound in brackets", "(≥ 4 ms", "wait_ms"),
    ("range", "4–5 ms", "wait_ms"),
    ("range with a hyphen", "4-5 ms", "wait_ms"),
    ("range in words", "between 4 and 5 ms", "wait_ms"),
    ("range or change", "4 to 5 ms", "wait_ms"),
    ("range with units", "4 ms – 5 ms", "wait_ms"),
    ("plus and minus", "5.0 ± 0.2 ms", "wait_ms"),
    ("power of ten", "3×10⁻³ s", "plain s"),
    ("zero", "12", "tiny"),
    ("digits that may be several numbers", "9 234 567", "users"),
]


@pytest.mark.parametrize(
    ("text", "place"), [case[1:] for case in REFUSED], ids=[case[0] for case in REFUSED]
)
def test_a_stale_number_that_only_its_author_can_correct_is_not_replaced(
    audit, text, place
):
    marked = f"{text}<!-- = r.json#/{place} -->"
    assert audit(marked, "--fix") == (["stale"], marked)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("1.2M", "users count"),
        ("1.23 million", "users count"),
        ("14.1×", "plain"),
        ("14 times", "plain ratio"),
        ("< 4 ms", "wait_ms"),
        ("up to 3.2 ms", "wait_ms"),
        ("at least 3 ms", "wait_ms"),
        ("not exceeding 4 ms", "wait_ms"),
        ("within 4 ms", "wait_ms"),
        ("no less than 3 ms", "wait_ms"),
        ("3–4 ms", "wait_ms"),
        ("between 3 and 4 ms", "wait_ms"),
        ("3.1 ± 0.2 ms", "wait_ms"),
        ("91.3 %", "share ratio"),
        ("14.1 ms", "plain ms"),
        ("14.1 ms", "plain"),
    ],
)
def test_a_bound_or_range_is_fresh_if_it_contains_the_number(audit, text, place):
    assert audit(f"{text}<!-- = r.json#/{place} -->")[0] == ["fresh"]


@pytest.mark.parametrize(
    "text",
    [
        "> {} ms",
        "it fell\n> {} ms",
        "<b>{} ms",
        "3 and {} ms",
        "step 1: {} ms",
        "p90 {} ms",
        "~{} ms",
    ],
)
def test_a_quote_or_tag_is_not_a_bound(audit, text):
    wrong, right = (
        f"{text.format(number)}<!-- = r.json#/wait_ms -->" for number in ("9.9", "3.2")
    )
    assert audit(wrong, "--fix") == (["fresh"], right)


@pytest.mark.parametrize(
    "text", ["case_3", "5/3", "v3", "12:03", "1.2.3", "a-b", "10^3", "14.3(4)"]
)
def test_digits_that_are_no_number_of_their_own_are_not_replaced(audit, text):
    marked = f"{text}<!-- = r.json#/plain -->"
    assert audit(marked, "--fix") == (["missing"], marked)
