"""Reads each supported type of file, and compares numbers and noise with known ones."""

import json
import math
import sys
from pathlib import Path

import pytest

from number_audit.command import main
from number_audit.files import AuditError
from number_audit.sources import Repeats, Source

PYPERF = {
    "version": "1.0",
    "metadata": {"unit": "second"},
    "benchmarks": [
        {
            "metadata": {"name": "sort"},
            "runs": [
                {"warmups": [[1, 9.0]]},
                {"values": [2.0, 4.0]},
                {"values": [5.0, 5.0]},
            ],
        }
    ],
}
GOOGLE = {
    "context": {},
    "benchmarks": [
        {"name": f"BM/8_{kind}", "aggregate_name": kind, "repetitions": 4}
        | {"real_time": time, "time_unit": "us", "bytes_per_second": 8.0}
        for kind, time in (("mean", 10.0), ("stddev", 2.0))
    ],
}
ASV = {
    "result_columns": ["result", "params"],
    "results": {"sort.T.time_x": [[0.5], []], "sort.T.peakmem_x": [[4096.0], []]},
    "version": 2,
}
K6 = {
    "root_group": {},
    "metrics": {
        "http_req_duration": {"avg": 144.5, "p(95)": 215.9},
        "http_req_failed": {"rate": 0.25},
        "data_sent": {"count": 64, "rate": 8.0},
    },
}
LM_EVAL = {
    "results": {"hellaswag": {"acc,none": 0.5, "acc_stderr,none": 0.01, "alias": "h"}}
}
JUNIT = """<?xml version="1.0" encoding="utf-8"?>
<testsuites><testsuite name="pytest" tests="1" time="2.5">
<testcase classname="test_a" name="test_b" time="1.5" /></testsuite></testsuites>"""
MARKDOWN = """
| case | *mean* [ms] | speed |
|:-----|-----:|---|
| **new** | 12.5<!-- = x.json#/y --> | 3 MB/s |
"""
T_OF_1, T_OF_3 = 12.7062, 3.1824  # Student's t, 95 %, from a table

CASES = [
    ("pyperf.json", PYPERF, "/benchmarks/sort/value", 4.0, "s", T_OF_1 * 1.0),
    ("google.json", GOOGLE, "/benchmarks/BM/8_mean/real_time", 10.0, "us", T_OF_3),
    ("asv.json", ASV, "/results/sort.T.time_x/0/0", 0.5, "s", 0.0),
    ("asv.json", ASV, "/results/sort.T.peakmem_x/0/0", 4096.0, "B", 0.0),
    ("k6.json", K6, "/metrics/http_req_duration/p(95)", 215.9, "ms", 0.0),
    ("k6.json", K6, "/metrics/http_req_failed/rate", 0.25, "1", 0.0),
    ("k6.json", K6, "/metrics/data_sent/count", 64.0, "B", 0.0),
    ("k6.json", K6, "/metrics/data_sent/rate", 8.0, "B/s", 0.0),
    (
        "google.json",
        GOOGLE,
        "/benchmarks/BM/8_mean/bytes_per_second",
        8.0,
        "B/s",
        4 * T_OF_3,
    ),
    ("lm_eval.json", LM_EVAL, "/results/hellaswag/acc,none", 0.5, "1", 0.0196),
    ("j.xml", JUNIT, "/testsuite/pytest/testcase/test_b/time", 1.5, "s", 0.0),
    ("t.md", MARKDOWN, "/0/new/mean%20[ms]", 12.5, "ms", 0.0),
    ("t.md", MARKDOWN, "/0/new/speed", 3.0, "MB/s", 0.0),
    ("t.tsv", "case\ttime [ms]\nx\t1.5\n", "/x/time%20[ms]", 1.5, "ms", 0.0),
    ("t.csv", "case,time\nx,1.5 ms\n", "/x/time", 1.5, "ms", 0.0),
    ("t.csv", "case,drift_mm_s\nx,1.5\n", "/x/drift_mm_s", 1.5, "mm/s", 0.0),
    ("l.jsonl", '{"name": "x", "t_s": 2}\n\n{"name": "y"}\n', "/x/t_s", 2.0, "s", 0.0),
    ("c.yaml", "a:\n  - {name: x, t_ms: 7}\n", "/a/x/t_ms", 7.0, "ms", 0.0),
    ("c.toml", "[a]\nt_ms = 7\n", "/a/t_ms", 7.0, "ms", 0.0),
]


def source(name: str, content: object) -> Source:
    text = content if isinstance(content, str) else json.dumps(content)
    return Source(Path(name), text.encode())


@pytest.mark.parametrize(
    ("name", "content", "place", "value", "unit", "noise"),
    CASES,
    ids=[f"{case[0]}{case[2]}" for case in CASES],
)
def test_a_number_is_read_with_its_unit_and_noise(
    name, content, place, value, unit, noise
):
    if name == "c.yaml":
        pytest.importorskip("yaml")
    if name == "c.toml" and sys.version_info < (3, 11):
        pytest.importorskip("tomli")
    quantity = source(name, content).quantity(place)
    assert (quantity.value, quantity.unit) == (value, unit)
    assert quantity.noise == pytest.approx(noise, rel=1e-4)


BOMB = "a: &a [1,1]\nb: &b [*a,*a]\nc: [*b,*b]\n"
DAMAGED = {
    "entity.xml": '<!DOCTYPE a [<!ENTITY b "1">]><a b="2">&b;</a>',
    "open.xml": "<a>",
    "bomb.yaml": BOMB,
    "open.yaml": "a: [",
    "open.toml": "a = [",
    "open.jsonl": '{"a": 1}\n{"a"',
    "digits.yaml": "a: 1" + "0" * 400,
    "number.json": "5",
    "empty.csv": "",
    "empty.md": "",
    "runs.json": '{"benchmarks": [{"metadata": {"name": "a"}, "runs": []}]}',
}


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_is_one_line(name, tmp_path, monkeypatch, capsys):
    if name.endswith(".yaml"):
        pytest.importorskip("yaml")
    monkeypatch.chdir(tmp_path)
    (tmp_path / name).write_text(DAMAGED[name])
    (tmp_path / "a.md").write_text(f"5<!-- = {name}#/a -->")
    assert main(["a.md"]) == 1
    [line] = capsys.readouterr().out.splitlines()
    assert line.startswith("a.md:1: missing: ")


def test_a_package_that_is_missing_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "yaml", None)
    with pytest.raises(AuditError, match=r"pip install number-audit\[yaml\]"):
        source("a.yaml", "a: 1")


def test_a_column_is_found_without_its_unit_and_in_small_letters():
    table = source("t.csv", "case,Peak Memory [MB],x_ms,x_s\na,5,1,2\n")
    assert str(table.quantity("/a/peak_memory")) == "5 MB"
    with pytest.raises(
        AuditError, match="no number at /a/x"
    ):  # The column may be x_ms or x_s.
        table.quantity("/a/x")


def test_repeated_files_give_a_mean_and_the_noise_of_their_scatter():
    """Test the mean of 1, 2 and 3, which is 2 ± 4.303 / √3."""
    runs = [source(f"{n}.json", {"a_ms": float(n)}) for n in (1, 2, 3)]
    quantity = Repeats("*.json", runs).quantity("/a_ms")
    assert (quantity.value, quantity.unit) == (2.0, "ms")
    assert quantity.noise == pytest.approx(4.3027 / math.sqrt(3), rel=1e-4)


def test_the_noise_of_repeats_is_not_below_that_of_each_file():
    runs = [source(f"{n}.json", {"value": 5.0, "noise": 3.0}) for n in range(9)]
    assert Repeats("*.json", runs).quantity("/value").noise == pytest.approx(1.0)


def test_a_star_in_the_name_of_a_file_reads_all_repeats(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for number, time in enumerate((10.0, 11.0, 12.0)):
        (tmp_path / f"run[{number}].json").write_text(json.dumps({"t_ms": time}))
    (tmp_path / "a.md").write_text("12.9 ms<!-- = run[*].json#/t_ms -->")
    assert main(["a.md"]) == 0
    assert "run[*].json#/t_ms has 11 ± 2.5 ms" in capsys.readouterr().out
    (tmp_path / "a.md").write_text("15 ms<!-- = run[*].json#/t_ms -->")
    assert main(["a.md"]) == 1
    (tmp_path / "a.md").write_text("12.9 ms<!-- = walk*.json#/t_ms -->")
    assert main(["a.md"]) == 1
    assert "no file matches walk*.json" in capsys.readouterr().out
