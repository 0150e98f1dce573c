"""docs/reliability.md: its counts are those of what the tests of today try."""

import re

from altered import SCENARIOS
from commands.test_publish import DAMAGES as OF_SITES
from damage import RECORD_WAYS, TRACE_WAYS
from files.test_outside import WHOLE_DAMAGES
from records.test_replicas import DAMAGES as OF_REPLICAS

from measured_report.files.root import ROOT


def test_reliability_counts_what_is_tried_and_names_tests_that_there_are():
    text = (ROOT / "docs/reliability.md").read_text(encoding="utf-8")
    counted = [[*RECORD_WAYS, *TRACE_WAYS], SCENARIOS, WHOLE_DAMAGES, OF_REPLICAS, OF_SITES]
    assert re.findall(r"(\d+) (?:ways|scenarios|damages)", text) == [str(len(each)) for each in counted]
    assert all((ROOT / path).exists() for path in re.findall("`((?:packages/measured-report/)?tests/[^`]*)`", text))
