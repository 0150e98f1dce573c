"""Marks in any text: what is stale, false or missing is told, what is fresh is not, and a fix changes nothing else."""

import json
import os

import pytest

from measured_report.commands.new import main

RUNS = [9.0, 9.5, 10.0, 10.5, 11.0]
RESULTS = {
    "pytest.json": {
        "machine_info": {},
        "benchmarks": [{"name": "a[1/2]", "stats": {"mean": 0.0123, "stddev": 1e-4, "rounds": 10}}],
    },
    "hyperfine.json": {
        "results": [{"command": "sleep 1 (b)", "mean": 0.01, "stddev": 0.00079, "times": [x / 1e3 for x in RUNS]}]
    },
    "criterion.json": {
        "mean": {
            "point_estimate": 12345.6,
            "confidence_interval": {"confidence_level": 0.95, "lower_bound": 12000, "upper_bound": 12700},
        }
    },
    "google.json": {
        "context": {},
        "benchmarks": [
            {"name": "BM/1", "real_time": x, "time_unit": "us", "repetition_index": i} for i, x in enumerate(RUNS)
        ],
    },
    "asv.json": {
        "result_columns": ["result", "params", "stats_ci_99_a", "stats_ci_99_b"],
        "results": {"m.time_x": [[0.5, 0.25], [["1", "2"]], [0.4, 0.2], [0.6, 0.3]], "m.track_n": None},
    },
    "plain.json": {
        "old": 4.0,
        "new": 2.0,
        "wall_ms": 1500.0,
        "big": 1234567,
        "list": [1.0, 2.0, 3.0],
        "share": 12.5,
        "none": None,
    },
    "table.csv": "case;time_ms;n\nx;12.5;10\ny;13.5;20\ny;14.5;30\n",
    "values.json": {"section": {"drag": {"value": 2.5, "unit": "mm", "noise": 0.1}}},
}
FRESH = [  # each with the number that would be stale, which a fix makes of it again
    ("12.3 ms", "12.9 ms", "pytest.json#/benchmarks/a[1/2]/mean"),
    ("0.0123 s", "0.0133 s", "pytest.json#/benchmarks/0/stats/mean"),
    ("**12,3** ms", "**14,3** ms", "pytest.json#/benchmarks/a[1/2]/mean ms"),
    ("10 ms", "20 ms", '"hyperfine.json#/results/sleep 1 (b)/mean"'),
    ("12.3 µs", "13.3 µs", "criterion.json#/mean"),
    ("10.0 us", "12.0 us", "google.json#/benchmarks/BM/1/real_time"),
    ("250 ms", "380 ms", "asv.json#/results/m.time_x/result/1"),
    ("1.5 s", "1.8 s", "plain.json#/wall_ms"),
    ("1,234,567", "1,234,568", "plain.json#/big"),
    ("1\u202f200\u202f000", "1\u202f300\u202f000", "plain.json#/big digits 2"),
    ("1.2×10⁶", "1.3×10⁶", "plain.json#/big"),
    ("1.23e6", "1.24e6", "plain.json#/big"),
    ("12.5 %", "12.6 %", "plain.json#/share"),
    ("2.0", "7.0", "plain.json#/list"),
    ("50 %", "40 %", "(plain.json#/old - plain.json#/new) / plain.json#/old"),
    ("12.5 ms", "12.6 ms", "table.csv#/x/time_ms"),
    ("2.5 mm", "2.7 mm", "values.json#/section/drag"),
]
MISSING = {
    "nothing.json#/a": "there is no",
    "plain.json#/ald": "there is no ald; there are old, new",
    "plain.json#/none": "no number",
    "table.csv#/y/time_ms": "y is there 2 times: use its index",
    "../out.json#/a": "out.json is outside",
    "link.json#/a": "outside",
    "pipe.json#/a": "no regular file",
    "x + 1": "x is the name of no mark",
    "plain.json#/old / 0": "division by zero",
    "((plain.json#/old": "never closed",
    "plain.json#/old (plain.json#/new)": "not callable",
    "pytest.json#/benchmarks/0/mean MB": "MB is printed, and the source is in s",
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (folder := tmp_path / "project").mkdir()
    (folder / ".git").mkdir()
    (tmp_path / "out.json").write_text('{"a": 5}')
    (folder / "link.json").symlink_to(tmp_path / "out.json")
    os.mkfifo(folder / "pipe.json")
    for name, result in RESULTS.items():
        (folder / name).write_text(result if isinstance(result, str) else json.dumps(result))
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def audit(folder, monkeypatch, capsys):
    """Write a text, audit it and return the status, what was printed and the text as it then is."""

    def run(text: str | bytes, *options: str, name: str = "a.md") -> tuple[int, list[str], str]:
        (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        monkeypatch.setattr("sys.argv", ["measured-report", "audit", name, *options])
        status = main()
        return status, capsys.readouterr().out.splitlines(), (folder / name).read_bytes().decode("utf-8", "replace")

    return run


@pytest.mark.parametrize(("fresh", "stale", "source"), FRESH)
def test_a_number_is_fresh_or_stale_by_any_source_and_a_fix_ends_at_its_own_bytes(audit, fresh, stale, source):
    right, wrong = (f"In 2024\r\nit takes {number}<!-- = {source} -->, 3 times.\r\n" for number in (fresh, stale))
    assert audit(right, "--check") == (0, [], right)
    status, [line], _ = audit(wrong)
    assert status == 1 and line.startswith("a.md:2: stale: ")
    assert audit(wrong, "--fix", "--check") == (0, [], right)


def test_names_make_arithmetic_and_words_that_turn(audit):
    marks = "4.0<!-- old = plain.json#/old --> 2.0<!-- new = plain.json#/new --> 2×<!-- ratio = old / new --> "
    words = "{}<!-- faster if new < old else slower --> {}<!-- not so if ratio < 1.5 else so --> {}<!-- if old > 1 else small -->"
    right, wrong = marks + words.format("Faster", "so", "large"), marks + words.format("Slower", "not so", "large")
    assert audit(right, "--check") == (0, [], right)
    status, lines, _ = audit(wrong, "--check")
    assert (status, [line.split(": ")[1] for line in lines]) == (1, ["false", "false"])
    assert audit(wrong, "--fix", "--check") == (0, [], right)


def test_within_its_noise_nothing_is_stale_and_no_word_false(audit):
    google = "google.json#/benchmarks/BM/1/real_time"
    text = (
        f"10.9 us<!-- a = {google} --> 10<!-- = {google} µs ± 20 % --> slower<!-- slower if a > 10.1us else faster -->"
    )
    status, lines, _ = audit(text)
    assert (status, [line.split(": ")[1] for line in lines]) == (0, ["fresh", "fresh", "unclear"])
    assert "± 0.98 us" in lines[0]


@pytest.mark.parametrize(("source", "message"), MISSING.items())
def test_what_leads_nowhere_or_out_of_the_project_is_one_line(audit, source, message):
    status, [line], _ = audit(text := f"5<!-- = {source} -->", "--fix")
    assert status == 1 and line.startswith("a.md:1: missing: ") and message in line
    assert audit(text)[2] == text


def test_a_folder_outside_is_read_when_allowed(audit):
    assert audit("5<!-- = ../out.json#/a --> 5<!-- = link.json#/a -->", "--check", "--allow", "..")[0] == 0
