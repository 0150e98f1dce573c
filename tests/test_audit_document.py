"""Test that docs/audit.md describes the examples, options and formats of number-audit
correctly.
"""

import json
import re

import pytest

from measured_report.files.root import ROOT
from number_audit.command import main
from number_audit.readers import READERS

DOCUMENT = (ROOT / "docs" / "audit.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```markdown\n(.*?)```", DOCUMENT, re.DOTALL)
BENCHMARKS = [
    {"name": "test_sort", "stats": {"mean": 0.0123, "stddev": 1e-5, "rounds": 9}}
]
CASES = {
    "sort": {"mean_ms": 12.3, "Memory": 40},
    "scan": {"mean_ms": 4.7, "Memory": 12},
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    results = {"machine_info": {}, "benchmarks": BENCHMARKS, "cases": CASES}
    (tmp_path / "bench.json").write_text(json.dumps(results))
    (tmp_path / "old.csv").write_text("case,time\nsort,38\n")
    (tmp_path / "r.json").write_text('{"share": 0.913}')
    return tmp_path


@pytest.mark.parametrize("example", EXAMPLES, ids=["marks", "table"])
def test_each_example_is_fresh_until_its_result_changes(folder, example, capsys):
    (folder / "a.md").write_text(example, encoding="utf-8")
    assert (main(["a.md", "--check"]), capsys.readouterr().out) == (0, "")
    changed = (folder / "bench.json").read_text().replace("12", "19")
    (folder / "bench.json").write_text(changed.replace("0.01", "0.09"))
    assert main(["a.md", "--check"]) == 1


def test_a_share_in_percent_is_compared_as_the_document_says(folder):
    [mark] = re.findall(r"`(91.3 %<!-- .*? -->)`", DOCUMENT)
    (folder / "a.md").write_text(mark, encoding="utf-8")
    assert main(["a.md"]) == 0


def test_all_options_and_formats_are_in_the_document(capsys):
    with pytest.raises(SystemExit):
        main(["--help"])
    options = set(re.findall(r"--[a-z]+", capsys.readouterr().out)) - {"--help"}
    assert options == set(re.findall(r"^\| `(--[a-z]+)", DOCUMENT, re.MULTILINE))
    for suffix in (".json", *READERS):
        assert f"`{suffix}`" in DOCUMENT
