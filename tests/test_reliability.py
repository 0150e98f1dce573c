"""Test that docs/reliability.md and SECURITY.md name existing tests, and state how many
cases these try.
"""

import re

from altered import SCENARIOS
from commands.test_publish import DAMAGES as OF_SITES
from damage import RECORD_WAYS, TRACE_WAYS
from records.test_replicas import DAMAGES as OF_REPLICAS

from measured_report.files.root import ROOT


def test_reliability_counts_what_is_tried():
    text = (ROOT / "docs/reliability.md").read_text(encoding="utf-8")
    counted = [[*RECORD_WAYS, *TRACE_WAYS], SCENARIOS, OF_REPLICAS, OF_SITES]
    assert re.findall(r"(\d+) (?:ways|scenarios|damages)", text) == [
        str(len(each)) for each in counted
    ]


def test_every_promise_names_the_test_that_holds_it():
    rows = [
        row
        for row in (ROOT / "docs/reliability.md").read_text().splitlines()
        if row.startswith("| ")
    ][1:]
    promises = (
        (ROOT / "SECURITY.md")
        .read_text()
        .partition("## Not trusted\n")[2]
        .split("\n- ")[1:]
    )
    assert len(rows) > 15 and len(promises) > 6
    folders = (ROOT / "tests", ROOT / "packages/measured-report/tests")
    sources = [
        path.read_text() for folder in folders for path in folder.rglob("test_*.py")
    ]
    there = {
        name
        for source in sources
        for name in re.findall(r"^def (test_\w+)\(", source, re.MULTILINE)
    }
    assert all(re.search("`test_", promise) for promise in (*rows, *promises))
    named = re.findall(
        r"`(test_\w+)`",
        (ROOT / "docs/reliability.md").read_text() + (ROOT / "SECURITY.md").read_text(),
    )
    assert {*named} <= there, {*named} - there
