"""Marks in any text: what is stale, false or missing is told, what is fresh is not, and a fix changes nothing else."""

import json
import os
import time

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
    "odd.json": {"rows": 1, "units": 2, "identity": 3, "a": 1e308},
    "twice.json": {"a_ms": 12.3, "b_ms": 12.3},
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
    ("1.23e+06", "7.20e-04", "plain.json#/big"),
    ("1.23×10⁶", "7.20×10⁻⁴", "plain.json#/big"),
    ("$1.23\\times 10^{6}$", "$7.20\\times 10^{-4}$", "plain.json#/big"),
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
    words = "{}<!-- faster if new < old else slower --> {}<!-- not so if ratio < 1.5 else so --> "
    words += "{}<!-- if old > 1 else small -->"
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


MEAN = "pytest.json#/benchmarks/a[1/2]/mean"
FORMS = {
    "a.tex": "\\audited{%s\\,ms}{= pytest.json\\#/benchmarks/0/mean} % \\audited{7}{= no.json\\#/x}",
    "a.rst": f":audit:`%s ms <= {MEAN}>`, ``:audit:`7 <= no.json#/x>` ``::\n\n   :audit:`7 <= no.json#/x>`\n",
    "a.myst": f"{{audit}}`%s ms <= {MEAN}>` `{{audit}}`7 <= no.json#/x>`",
    "a.html": f"<b>%s</b>&nbsp;ms<!-- = {MEAN} -->",
    "a.md": f"```\n7<!-- = no.json#/x -->\n```\n`7<!-- = no.json#/x -->`\n\n"
    f"    7<!-- = no.json#/x -->\n\n- %s\nms<!-- = {MEAN} -->",
}


@pytest.mark.parametrize("name", FORMS)
def test_each_kind_of_text_has_its_marks_and_code_has_none(audit, name):
    right, wrong = (FORMS[name].replace("%s", number) for number in ("12.3", "14.3"))
    assert audit(right, "--check", name=name) == (0, [], right)
    assert audit(wrong, "--fix", "--check", name=name) == (0, [], right)


def test_suggestions_mark_what_is_one_number_of_the_results_and_leave_a_choice(audit):
    old, big = "<!-- = plain.json#/old -->", "<!-- = plain.json#/big -->"
    text = "It takes 12.3 ms, or `12.3 ms`; 4.0, 10 and 1,234,567 of v12.5."
    status, _, marked = audit(text, "--suggest", "plain.json")
    assert (status, marked) == (0, text.replace("4.0", f"4.0{old}").replace("567", f"567{big}"))
    status, _, marked = audit(marked, "--suggest", "pytest.json")
    assert (status, "12.3 ms<!-- = pytest.json#/benchmarks/a[1/2]/stats/mean -->, or `" in marked) == (0, True)
    assert audit(marked, "--check") == (0, [], marked) and audit(marked, "--suggest", "pytest.json")[1:] == ([], marked)
    (choice,) = audit("12.5", "--suggest", "table.csv")[1]
    assert choice == "a.md:1: fresh: 12.5<!-- = table.csv#/x/time_ms -->"
    assert "or" in audit("12.3 ms", "--suggest", "twice.json")[1][0]


def test_a_build_server_gets_annotations_or_json(audit):
    text = f"\n14.3 ms<!-- = {MEAN} -->"
    assert audit(text, "--format", "github")[1][0].startswith(
        "::error file=a.md,line=2::stale: 14.3 ms is 12.3 ± 0.072 ms"
    )
    [finding] = json.loads("".join(audit(text, "--format", "json")[1]))
    assert (finding["kind"], finding["value"], finding["unit"], finding["line"]) == ("stale", 12.3, "ms", 2)


HOSTILE = {
    "bytes that are no text": b"\xff\xe9 12.9 ms<!-- = " + MEAN.encode() + b" -->\xff\r\n",
    "a comment in a comment": b"7<!-- a <!-- = no.json#/x -->",
    "no end": b"7<!-- = no.json#/x" + b"<!--" * 9999,
    "ticks": b"`" * 99999 + b"7<!-- = no.json#/x",
    "no code": b"5<!-- = __import__('os') --> 5<!-- a = a --> 5<!-- = odd.json#/rows/0/a --> 5<!-- = odd.json#/a -->",
    "a year": b"2024 we were<!-- = plain.json#/old -->, 16 384<!-- = plain.json#/old -->",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_whatever_a_file_has_is_a_line_or_works(audit, name):
    status, lines, after = audit(HOSTILE[name], "--fix")
    assert len(lines) == HOSTILE[name].count(b" -->") - name.startswith("a comment") and status == int(len(lines) > 1)
    right = HOSTILE[name].replace(b"12.9", b"12.3").decode("utf-8", "replace")
    assert after == right or "odd.json#/a" in after


def test_a_thousand_marks_take_no_longer_than_a_second(audit, folder):
    runs = [{"name": f"t{i}", "stats": {"mean": i + 1, "stddev": 0.01, "rounds": 5 + i % 20}} for i in range(1000)]
    (folder / "many.json").write_text(json.dumps({"machine_info": {}, "benchmarks": runs}))
    audit("1 s<!-- = many.json#/benchmarks/t0/mean -->")  # what is imported once is
    began = time.process_time()
    assert audit("".join(f"{i + 1} s<!-- = many.json#/benchmarks/t{i}/mean -->\n" for i in range(1000)), "--check")[
        :2
    ] == (0, [])
    assert time.process_time() - began < 1
