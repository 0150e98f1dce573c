"""Tests of the command on whole files: findings, exit status and fixes."""

import json
import os
import shutil
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

import number_audit
from number_audit.command import main

RESULTS = {
    "pytest.json": {
        "machine_info": {},
        "benchmarks": [
            {"name": "a[1/2]", "stats": {"mean": 0.0123, "stddev": 1e-4, "rounds": 10}}
        ],
    },
    "hyperfine.json": {
        "results": [
            {
                "command": "sleep 1 (b)",
                "mean": 0.01,
                "stddev": 0.00079,
                "times": [9e-3, 9.5e-3, 0.01, 0.0115],
            }
        ]
    },
    "criterion.json": {"mean": {"point_estimate": 12345.6, "standard_error": 170.0}},
    "google.json": {
        "context": {},
        "benchmarks": [{"name": "BM/1_mean", "real_time": 10.0, "time_unit": "us"}],
    },
    "asv.json": {
        "result_columns": ["result", "params"],
        "results": {"m.time_x": [[0.5, 0.25], [["1", "2"]]]},
    },
    "plain.json": {"old": 4.0, "new": 2.0, "big": 1234567, "none": None},
    "wide.csv": f"case,a\nx,{'5' * 200_000}\n",
    "odd.json": {
        "rows": 1,
        "units": 2,
        "identity": 3,
        "a": 1e308,
        "times": 1,
        "mean": 7,
        "huge": 10**308,
    },
    "twice.json": {"a_ms": 12.3, "b_ms": 12.3},
    "table.csv": "case;time_ms;n\nx;12.5;10\ny;13.5;20\ny;14.5;30\n",
    "values.json": {"section": {"drag": {"value": 2.5, "unit": "mm", "noise": 0.1}}},
}
on_posix = pytest.mark.skipif(os.name != "posix", reason="Windows has no such files")

FRESH = [  # A fix restores each fresh number from the stale one beside it.
    ("12.3 ms", "12.9 ms", "pytest.json#/benchmarks/a[1/2]/stats/mean"),
    ("**0.0123** s", "**0.0133** s", "pytest.json#/benchmarks/a[1/2]/stats/mean ms"),
    ("10 ms", "20 ms", "hyperfine.json#/results/sleep%201%20(b)/times"),
    ("12.3 µs", "13.3 µs", "criterion.json#/mean/point_estimate"),
    ("10.0 us", "12.0 us", "google.json#/benchmarks/BM/1_mean/real_time"),
    ("250 ms", "380 ms", "asv.json#/results/m.time_x/0/1 s"),
    ("1,234,567", "1,234,568", "plain.json#/big"),
    ("1\u202f200\u202f000", "1\u202f300\u202f000", "plain.json#/big digits 2"),
    ("50 %", "40 %", "100 * (1 - n / plain.json#/old ) %"),
    ("50 %", "49 %", "1 - n / plain.json#/old ratio"),
    ("1.2M", "1.3M", "plain.json#/big count"),
    ("1235K", "1300K", "plain.json#/big count"),
    ("1.23 MB", "1.33 MB", "plain.json#/big bytes"),
    ("12.5 ms", "12.6 ms", "table.csv#/x/time_ms"),
    ("2.5 mm", "2.7 mm", "values.json#/section/drag/value"),
]
MISSING = {
    "nothing.json#/a": "does not exist",
    "table.csv#/z/time_ms": "similar: /x/time_ms",
    "plain.json#/none": "no number at",
    "../out.json#/a": "out.json is outside",
    "plain.json#/old / 0": "divides by zero",
    "((plain.json#/old": "never closed",
    "plain.json#/old (plain.json#/new )": "expected FILE#/PLACE",
    "9 ** 9 ** 9": "expected FILE#/PLACE",
    "pytest.json#/benchmarks/a[1/2]/stats/mean + plain.json#/old": "cannot add the units",
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (folder := tmp_path / "project").mkdir()
    (folder / ".git").mkdir()
    (tmp_path / "out.json").write_text('{"a": 5}')
    if os.name == "posix":
        (folder / "link.json").symlink_to(tmp_path / "out.json")
        os.mkfifo(folder / "pipe.json")
    for name, result in RESULTS.items():
        (folder / name).write_text(
            result if isinstance(result, str) else json.dumps(result)
        )
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def audit(folder, capsys):
    """Return a function that audits a text.

    It returns the exit status, the printed lines and the text afterwards.
    """

    def run(
        text: str | bytes, *options: str, name: str = "a.md"
    ) -> tuple[int, list[str], str]:
        (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        status = main([name, *options])
        return (
            status,
            capsys.readouterr().out.splitlines(),
            (folder / name).read_bytes().decode("utf-8", "replace"),
        )

    return run


@pytest.mark.parametrize(("fresh", "stale", "source"), FRESH)
def test_a_number_is_fresh_or_stale_by_any_source_and_a_fix_ends_at_its_own_bytes(
    audit, fresh, stale, source
):
    named = "2.0<!-- n = plain.json#/new -->"
    right, wrong = (
        f"{named} 2024\r\nit takes {number}<!-- = {source} -->, 3.\r\n"
        for number in (fresh, stale)
    )
    assert audit(right, "--check") == (0, [], right)
    status, [line], _ = audit(wrong, "--check")
    assert status == 1 and line.startswith("a.md:2: stale: ")
    assert audit(wrong, "--fix", "--check") == (0, [], right)


@pytest.mark.parametrize(
    ("fresh", "stale"),
    [("1.2×10⁶", "1.3×10⁶"), ("1.23e+06", "1.23e+05"), ("1.23e6", "1.23e-6")],
)
def test_a_number_with_a_power_of_ten_is_audited_and_left_as_it_is(audit, fresh, stale):
    assert audit(f"{fresh}<!-- = plain.json#/big -->", "--check")[:2] == (0, [])
    status, [line], text = audit(wrong := f"{stale}<!-- = plain.json#/big -->", "--fix")
    assert (status, text) == (1, wrong) and "stale: " in line


def test_names_make_arithmetic_and_words_that_turn(audit):
    marks = (
        "4.0<!-- old = plain.json#/old --> 2.0<!-- new = plain.json#/new --> "
        "2×<!-- ratio = old / new --> "
    )
    words = (
        "{}<!-- Faster if new < old else Slower --> "
        "{}<!-- not so if ratio < 1.5 else so -->"
    )
    right = marks + words.format("Faster", "so")
    wrong = marks + words.format("Slower", "not so")
    assert audit(right, "--check") == (0, [], right)
    status, lines, _ = audit(wrong, "--check")
    assert (status, [line.split(": ")[1] for line in lines]) == (1, ["false", "false"])
    assert audit(wrong, "--fix", "--check") == (0, [], right)
    assert (
        "the name old is used for another mark"
        in audit(f"{marks} 5<!-- old = plain.json#/new -->", "--check")[1][0]
    )


def test_within_its_noise_nothing_is_stale_and_no_word_false(audit):
    way = "hyperfine.json#/results/sleep%201%20(b)"
    text = f"12.3 ms<!-- a = {way}/times --> 13 ms<!-- b = {way}/mean ± 30 % --> "
    status, lines, _ = audit(f"{text}slower<!-- slower if a > b else faster -->")
    assert (status, [line.split(": ")[1] for line in lines]) == (
        0,
        ["fresh", "fresh", "unclear"],
    )
    assert "± 1.7 ms" in lines[0]


@pytest.mark.parametrize(("source", "message"), MISSING.items())
def test_what_leads_nowhere_or_out_of_the_project_is_one_line(audit, source, message):
    status, [line], after = audit(text := f"5<!-- = {source} -->", "--fix")
    assert (
        (status, after) == (1, text)
        and line.startswith("a.md:1: missing: ")
        and message in line
    )


@on_posix
def test_a_pipe_is_not_read(audit):
    status, [line], _ = audit("5<!-- = pipe.json#/a -->")
    assert (
        status == 1
        and line.startswith("a.md:1: missing: ")
        and "not a regular file" in line
    )


@on_posix
def test_a_folder_outside_is_read_when_allowed(audit):
    assert (
        audit(
            "5<!-- = ../out.json#/a --> 5<!-- = link.json#/a -->",
            "--check",
            "--allow",
            "..",
        )[0]
        == 0
    )


SLEEP = "hyperfine.json#/results/sleep%201%20(b)/mean"
MEAN = "pytest.json#/benchmarks/a[1/2]/stats/mean"
FORMS = {
    "a.tex": f"``a'' ``\\audited{{%s\\,ms}}{{= {MEAN}}}''".replace("#", "\\#"),
    "a.rst": f"~~~~\n:audit:`%s ms <= {MEAN}>`, ``:audit:`7 <= no.json#/x>` ``\n",
    "a.html": f"<b>%s</b>&nbsp;ms<!-- = {MEAN} -->",
    "a.md": (
        "```\n7<!-- = no.json#/x -->\n```\n`7<!-- = no.json#/x -->`\n\n"
        f"- %s\nms<!-- = {MEAN} --> <!-- a == b -->"
    ),
}


@pytest.mark.parametrize("name", FORMS)
def test_each_kind_of_text_has_its_marks_and_code_has_none(audit, name):
    right, wrong = (FORMS[name].replace("%s", number) for number in ("12.3", "14.3"))
    assert audit(right, "--check", name=name) == (0, [], right)
    assert audit(wrong, "--fix", "--check", name=name) == (0, [], right)


@pytest.mark.parametrize(
    ("text", "source", "marked"),
    [
        (
            "12.3 ms, or `12.3 ms`; 10 of v12.3.",
            "pytest.json",
            f"12.3 ms<!-- = {MEAN} -->, or `12.3 ms`; 10 of v12.3.",
        ),
        (
            "1 234 567 runs in 5 100 ms",
            "plain.json",
            "1 234 567<!-- = plain.json#/big --> runs in 5 100 ms",
        ),
        ("4.0 of 1,234", "plain.json", "4.0<!-- = plain.json#/old --> of 1,234"),
        ("It takes 10.0 ms.", "hyperfine.json", f"It takes 10.0 ms<!-- = {SLEEP} -->."),
        (
            "**10.0 ms** 12.5<!-- = x -->",
            "hyperfine.json",
            f"**10.0 ms<!-- = {SLEEP} -->** 12.5<!-- = x -->",
        ),
        ("12.3 ms", "twice.json", "12.3 ms"),
    ],
)
def test_suggestions_mark_what_is_one_number_of_the_results_and_leave_a_choice(
    audit, text, source, marked
):
    status, lines, after = audit(text, "--suggest", source)
    assert (status, after) == (0, marked)
    has_choice = "unclear: 12.3 ms may be twice.json#/a_ms or" in lines[0]
    assert has_choice == (text == marked)
    assert audit(marked, "--suggest", source)[2] == marked


def test_a_suggestion_in_latex_and_in_restructuredtext_is_audited_as_it_is(audit):
    for name in ("a.tex", "a.rst"):
        marked = audit("takes 10.0 ms", "--suggest", "hyperfine.json", name=name)[2]
        assert "audit" in marked
        assert audit(marked, "--check", name=name) == (0, [], marked)


def test_a_build_server_gets_annotations_or_json(audit):
    text = f"\n14.3 ms<!-- = {MEAN} -->"
    annotation = "::error file=a.md,line=2::stale: the text has 14.3 ms, but pytest.json#/benchmarks"
    assert audit(text, "--format", "github")[1][0].startswith(annotation)
    finding = json.loads(*audit(text, "--format", "json")[1])
    expected = {"file": "a.md", "line": 2, "kind": "stale", "replacement": "12.3"}
    assert finding.items() >= expected.items()


HOSTILE = {  # Each text has the kinds of its findings.
    b"\xff\xe9 12.9 ms<!-- = " + MEAN.encode() + b" -->\xff\r\n": [
        "fresh"
    ],  # not UTF-8
    b"7<!-- a <!-- = no.json#/x -->": ["invalid"],  # a comment in a comment
    b"7<!-- = no.json#/x" + b"<!--" * 9999: ["invalid"],
    b"`" * 99999 + b"7<!-- = no.json#/x": [],  # a fence
    b"5<!-- = __import__('os') --> 7<!-- = odd.json#/mean -->": ["missing", "fresh"],
    b"5<!-- a = b --> 5<!-- b = a --> 4.0<!-- c = plain.json#/old -->": [
        "missing",
        "missing",
        "fresh",
    ],
    b"2024 we were<!-- = plain.json#/old -->": ["missing"],
    b"16 384<!-- = plain.json#/old --> 1,5<!-- = plain.json#/old -->": ["missing"] * 2,
    b"10^6<!-- = plain.json#/old -->": ["missing"],
    b"10<sup>6</sup><!-- = plain.json#/big -->": ["missing"],
    b"5<!-- = odd.json#/huge -->": ["stale"],  # A fix cannot have 309 digits.
    b"5<!-- = odd.json#/infinite --> 5<!-- = odd.json#/nan -->": ["missing"] * 2,
    b"5<!-- = " + b"9" * 309 + b" --> " + b"9" * 309 + b"<!-- = plain.json#/old -->": [
        "missing",
        "stale",
    ],
    b"5<!-- = wide.csv#/x/a -->": ["missing"],  # a field that is too long for Python
    b"5<!-- = " + b"(" * 250 + b"plain.json#/old " + b")" * 250 + b" -->": ["missing"],
    "5<!-- = plain.json#/old -->".encode("utf-16"): ["missing"],
}


@pytest.mark.parametrize("text", HOSTILE)
def test_whatever_a_file_contains_is_a_finding_of_its_own(audit, text):
    status, lines, after = audit(text, "--fix")
    kinds = [line.split(": ")[1] for line in lines]
    assert kinds == HOSTILE[text]
    assert status == int(kinds not in ([], ["fresh"]))
    if "stale" not in kinds:
        right = text.replace(b"12.9 ms", b"12.3 ms")
        assert after == right.decode("utf-8", "replace")


@pytest.mark.parametrize(
    "comment",
    [
        "= plain.json#/new.",
        "= plain.json#/new,",
        "= plain.json#/new;",
        "= plain.json#/new!",
        "== plain.json#/new",
        "plain.json#/new",
        "see plain.json#/new for it",
        "=",
        "= ?",
        "1a = plain.json#/new",
        "a = b / c.",
        "2.0 if a < b",
        "so if a < b else",
        "so if a = b else not so",
        "= plain.json#/new " + "+ 1 " * 200,
    ],
)
def test_a_comment_that_looks_like_a_mark_and_is_none_is_an_error(audit, comment):
    status, [line], _ = audit(f"2024\n\n2.0<!-- {comment} -->")
    assert status == 1 and line.startswith("a.md:3: invalid: ")


@pytest.mark.parametrize(
    "comment",
    ["a == b", "", "===== Results =====", "https://x.org/#/a", "if in doubt", "- / #"],
)
def test_any_other_comment_is_none_of_its_business(audit, comment):
    assert audit(f"5<!-- {comment} -->") == (0, [], f"5<!-- {comment} -->")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.tex", "\\audited{\\textbf{5}}{= plain.json\\#/old}"),
        ("a.tex", "\\audited{5}{plain.json\\#/old}"),
        ("a.rst", ":audit:`5`"),
        ("a.tex", "\\audited {5}{= plain.json\\#/old}"),
        ("a.rst", ":audit: `5 <= plain.json#/old>`"),
        ("a.md", "5<!-- = plain.json#/old"),
        ("a.md", "5<! -- = plain.json#/old -->"),
        ("a.html", "5<!- = plain.json#/old ->"),
    ],
)
def test_a_role_that_is_not_complete_is_an_error(audit, name, text):
    status, [line], after = audit(text, "--fix", name=name)
    assert (status, after) == (1, text) and line.startswith(f"{name}:1: invalid: ")


@pytest.mark.parametrize(
    "text",
    [
        "```12``` and\n\n{}<!-- = plain.json#/old -->\n```\n",
        "\\`{}<!-- = plain.json#/old -->\\`",
        "`a\n\n{}<!-- = plain.json#/old -->`",
        "[{}](a 5)<!-- = plain.json#/old -->",
    ],
)
def test_code_and_links_hide_no_more_than_themselves(audit, text):
    right = text.format("4.0")
    assert audit(text.format("3.0"), "--fix", "--check") == (0, [], right)


def test_a_thousand_marks_take_no_longer_than_a_second(audit, folder):
    runs = [
        {
            "name": f"t{i}",
            "stats": {"mean": i + 1, "stddev": 0.01, "rounds": 5 + i % 20},
        }
        for i in range(1000)
    ]
    (folder / "many.json").write_text(
        json.dumps({"machine_info": {}, "benchmarks": runs})
    )
    audit(
        "1 s<!-- = many.json#/benchmarks/t0/stats/mean -->"
    )  # The first call imports modules.
    began = time.process_time()
    marks = "".join(
        f"{i + 1} s<!-- = many.json#/benchmarks/t{i}/stats/mean -->\n"
        for i in range(1000)
    )
    assert audit(marks, "--check")[:2] == (0, [])
    assert time.process_time() - began < 1


CHAIN = 5_000


@pytest.mark.parametrize(
    "text",
    [
        "".join(f"1<!-- n{i} = n{i + 1} + n{i + 1} --> " for i in range(CHAIN)),
        "".join(f"1<!-- n{i} = n{i + 1} - plain.json#/old --> " for i in range(CHAIN))
        + "4<!-- n5000 = plain.json#/old -->",
        "```a\n" * 100_000 + "```a",
        "~~~ `\n````\n" * 50_000,
        "`" * 50_000 + "` `` ``` " * 50_000,
        "<!-- = plain.json#/old " * 50_000,
        "\\audited{" * 20_000,
        " > " * 100_000 + "5<!-- = plain.json#/old -->",
        "<! = x " * 50_000,
        "| a | b |\n|--|--|\n"
        + "| r | 5 |\n" * 20_000
        + "\n<!-- = plain.json#/{row}/{column} -->",
        "|" + " " * 200_000 + "x",
        "5<!-- = broken.json#/a -->" * 2_000,
        "1-" * 100_000 + "1<!-- = plain.json#/old -->",
        "{{" * 100_000 + "$" * 100_000 + "<a" * 100_000,
        "12.5 " * 20_000,
    ],
    ids=[
        *("chain", "sum", "fences", "mixed", "ticks", "comments", "roles", "quotes"),
        *("misspelled", "table", "rule", "damage", "ranges", "templates", "numbers"),
    ],
)
def test_a_long_text_takes_a_time_proportional_to_its_length(audit, folder, text):
    (folder / "broken.json").write_text("[" + "1," * 1_000_000)
    began = time.process_time()
    audit(text, "--check")
    audit(text, "--suggest", "plain.json")
    assert time.process_time() - began < 6


def test_a_chain_of_names_is_as_long_as_it_is(audit):
    names = "".join(f"9<!-- n{i} = n{i + 1} + n{i + 1} --> " for i in range(61))
    _, lines, _ = audit(names + "2.0<!-- n61 = plain.json#/new -->", "--check")
    assert len(lines) == 61 and lines[0].startswith(
        "a.md:1: stale: the text has 9, but n1 + n1 has 4.61169e+18"
    )


def test_a_fix_never_overwrites_what_was_saved_in_the_meantime(audit, monkeypatch):
    """Test that an editor may save the file after it was read and before it is fixed."""
    edited = "a new sentence"

    def edit_and_copy(path, temporary, copymode=shutil.copymode):
        path.write_text(edited)
        copymode(path, temporary)

    monkeypatch.setattr("shutil.copymode", edit_and_copy)
    status, [line], after = audit(f"14.3 ms<!-- = {MEAN} -->", "--fix")
    assert (status, after) == (1, edited) and "modified in the meantime" in line


@on_posix
def test_a_fix_keeps_mode_and_neighbours_and_refuses_a_file_that_is_read_only(
    audit, folder
):
    neighbour = folder / ".a.md.part"
    neighbour.write_text("mine")
    before = {path.name for path in folder.iterdir()}
    path = folder / "a.md"
    path.touch()
    path.chmod(0o640)
    assert audit(f"14.3 ms<!-- = {MEAN} -->", "--fix")[0] == 0
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert neighbour.read_text() == "mine"
    assert {each.name for each in folder.iterdir()} == before | {"a.md"}
    path.write_text(text := f"14.3 ms<!-- = {MEAN} -->")
    path.chmod(0o444)
    assert main(["a.md", "--fix"]) == 1
    assert path.read_text() == text


@on_posix
def test_a_name_of_a_file_writes_no_command_of_github_and_no_second_line(audit):
    name = "a,b:%\n::error::x.md"
    status, lines, _ = audit(
        "5<!-- = plain.json#/old -->", "--format", "github", name=name
    )
    assert status == 1
    assert lines == [
        "::error file=a%2Cb%3A%25%0A%3A%3Aerror%3A%3Ax.md,line=1"
        "::stale: the text has 5, but plain.json#/old has 4"
    ]
    assert len(audit("5<!-- = plain.json#/old -->", name=name)[1]) == 1


ABSENT = ("fcntl", "grp", "pwd", "resource", "termios")
"""Python modules that do not exist on Windows."""


def test_it_needs_no_other_package_and_nothing_that_windows_does_not_have(folder):
    (folder / "a.md").write_text("5.0<!-- = plain.json#/old -->")
    package = str(Path(number_audit.__file__).parents[1])
    lines = [
        "import runpy, sys",
        f"sys.path.insert(0, {package!r})",
        f"sys.modules.update(dict.fromkeys({ABSENT!r}))",
        "runpy.run_module('number_audit', run_name='__main__')",
    ]
    # In isolated mode without site, only the standard library can be imported.
    command = [sys.executable, "-I", "-S", "-c", "\n".join(lines), "a.md", "--fix"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == (
        "a.md:1: fresh: the text has 4.0, and plain.json#/old has 4\n"
    )


def test_the_program_that_measured_a_record_tells_its_noise(folder, capsys):
    record = {"identity": {}, "rows": [{"case": "a", "slip_mm": 2.0}]}
    (folder / "record.json").write_text(json.dumps(record))
    (folder / "a.md").write_text("2.3 mm<!-- = record.json#/rows/a/slip_mm -->")
    assert main(["a.md"]) == 1
    asked = []

    def noise_of_record(*place):
        asked.append(place)
        return 0.3

    assert main(["a.md"], noise_of_record=noise_of_record) == 0
    assert asked == [(folder / "record.json", 0, "slip_mm")]
    assert "slip_mm has 2 ± 0.3 mm" in capsys.readouterr().out
