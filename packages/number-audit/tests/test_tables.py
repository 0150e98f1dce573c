"""Tests marks that serve a whole table, and suggestions from earlier results."""

import json
import subprocess

import pytest

from number_audit.command import main

OLD = {
    "runs": [
        {"name": "sort", "stats": {"mean_ms": 12.3, "size_MB": 40.0}},
        {"name": "a [1/2]", "stats": {"mean_ms": 20.5, "size_MB": 80.0}},
    ]
}
NEW = json.loads(json.dumps(OLD).replace("12.3", "14.1"))
TABLE = """# Speed
| case    | Mean [ms] | size_MB | note |
|---------|----------:|--------:|------|
| **sort**  | **{}** | 40 MB | fast |
| a [1/2] | 20.5      | 80.0   | `7`  |

<!-- = r.json#/runs/{{row}}/stats/{{column}} -->
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "r.json").write_text(json.dumps(NEW))
    return tmp_path


@pytest.fixture
def audit(folder, capsys):
    """Return a function that audits a text: it returns the status, lines and text."""

    def run(text: str, *options: str) -> tuple[int, list[str], str]:
        path = folder / "a.md"
        path.write_text(text)
        status = main(["a.md", *options])
        return status, capsys.readouterr().out.splitlines(), path.read_text()

    return run


def test_one_mark_serves_a_whole_table(audit):
    right = TABLE.format("14.1")
    status, lines, _ = audit(right)
    assert status == 0
    assert [line.split(":")[1] for line in lines] == ["4", "4", "5", "5"]
    status, [line], _ = audit(TABLE.format("12.3"), "--check")
    assert status == 1 and line.startswith("a.md:4: stale: the text has 12.3")
    assert audit(TABLE.format("12.3"), "--fix", "--check") == (0, [], right)


def test_lines_may_end_as_on_windows(audit, folder):
    (folder / "a.md").write_bytes(TABLE.format("12.3").replace("\n", "\r\n").encode())
    assert main(["a.md", "--fix"]) == 0
    right = TABLE.format("14.1").replace("\n", "\r\n").encode()
    assert (folder / "a.md").read_bytes() == right


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (TABLE.format("14.1").replace("size_MB", "count"), "a.md:4: missing: "),
        (TABLE.format("14.1").replace("**sort**", "walk"), "a.md:4: missing: "),
        ("5<!-- = r.json#/runs/{row}/stats/{column} -->", "a.md:1: invalid: "),
        (TABLE.format("14.1").replace("<!-- =", "<!-- a ="), "a.md:7: invalid: "),
        (TABLE.format("14.1").replace("40 MB", "40,5"), "a.md:4: missing: "),
    ],
)
def test_a_cell_without_a_source_is_an_error(audit, text, line):
    status, [first, *_], _ = audit(text, "--check")
    assert status == 1 and first.startswith(line)


def test_a_cell_with_a_mark_of_its_own_is_audited_by_that_one(audit):
    own = "15<!-- = 1.5 * 10 -->"
    text = TABLE.format("14.1").replace("40 MB", own)
    assert audit(text, "--check") == (0, [], text)


def test_a_table_is_marked_by_the_names_of_its_rows_and_columns(audit):
    """Test a stale number that has a mark after the fix, although no result contains
    it.
    """
    right = TABLE.format("99.9").replace("a [1/2]", "`a [1/2]`")
    unmarked = right.partition("\n<!--")[0]
    status, [line], marked = audit(unmarked, "--suggest", "r.json")
    assert (status, marked) == (0, right)
    assert line == "a.md:2: fresh: <!-- = r.json#/runs/{row}/stats/{column} -->"
    assert audit(marked, "--suggest", "r.json") == (0, [], marked)
    assert audit(marked, "--check")[0] == 1


@pytest.mark.parametrize("column", ["| 5 |", "| 40 |\n| walk | 7.25 | 8 |"])
def test_a_table_of_something_else_is_not_marked(audit, column):
    text = f"| case | other | size |\n|--|--|--|\n| sort | 6.25 {column}\n"
    assert "{row}" not in audit(text, "--suggest", "r.json")[2]


@pytest.mark.parametrize(
    "text",
    [
        "---\ntitle: 12.34 ms\n---\nfine",
        '<img alt="12.34 ms" width="1234">',
        "[fine](https://x.y/12.34 ms)",
        "[1]: https://x.y/12.34 ms",
        "{{ 12.34 }} {% if 12.34 %}",
        "it takes $12.34$",
        "as here:\n\n    sleep 12.34\n    sleep 12.34\n",
        "`12.34`\n```\n12.34\n```\n",
    ],
)
def test_no_mark_is_put_where_readers_would_see_it(audit, folder, text):
    (folder / "r.json").write_text('{"a": 12.34}')
    assert audit(text, "--suggest", "r.json") == (0, [], text)


def test_a_row_may_have_a_bar_in_its_name(audit, folder):
    (folder / "r.json").write_text('{"a|b": {"t": 12.34}, "c": {"t": 0.5}}')
    text = "| case | t |\n|--|--|\n| a\\|b | 12.34 |\n| c | 0.5 |\n\n"
    mark = "<!-- = r.json#/{row}/{column} -->"
    assert audit(text + mark, "--check") == (0, [], text + mark)


def commit(folder, results: object) -> None:
    (folder / "r.json").write_text(json.dumps(results))
    identity = ["-c", "user.name=a", "-c", "user.email=a@b.c"]
    for command in (["init", "-q"], ["add", "."], ["commit", "-qm", "Add results"]):
        subprocess.run(["git", *identity, *command], cwd=folder, check=True)


def test_a_number_of_earlier_results_is_marked_and_stale(audit, folder):
    commit(folder, OLD)
    commit(folder, NEW)
    text = "It takes 12.3 ms, or 20.5 ms.\n\nThe year 2024 and 3.75 are not results."
    status, lines, marked = audit(text, "--suggest", "r.json")
    place = "r.json#/runs/sort/stats/mean_ms"
    assert status == 1
    assert lines[0].startswith(
        f"a.md:1: stale: 12.3 ms<!-- = {place} --> was right until commit "
    )
    assert lines[2:] == [
        "a.md:3: unclear: 2024 is not in r.json",
        "a.md:3: unclear: 3.75 is not in r.json",
    ]
    assert f"12.3 ms<!-- = {place} -->, or" in marked
    assert audit(marked, "--fix", "--check")[2].startswith("It takes 14.1 ms<!--")


@pytest.mark.parametrize(
    ("results", "text", "mark"),
    [
        ({"a": 12.34}, "12.34 ms", "12.34 ms<!-- = r.json#/a ms -->"),
        ({"a": 0.913}, "91.3 %", "91.3 %<!-- = r.json#/a ratio -->"),
        ({"a": 91.3}, "91.3 %", "91.3 %<!-- = r.json#/a % -->"),
        ({"a": 0.913}, "91.3 percent", "91.3 percent<!-- = r.json#/a ratio -->"),
        ({"a": 1234567}, "1.23M", "1.23M<!-- = r.json#/a count -->"),
        (
            {"a_s": 0.01234},
            "| x | time [ms] |\n|---|---|\n| y | 12.34 |",
            "| x | time [ms] |\n|---|---|\n| y | 12.34<!-- = r.json#/a_s ms --> |",
        ),
        ({"a_ms": 12.34}, "12.34 ms", "12.34 ms<!-- = r.json#/a_ms -->"),
        ({"a": 12.34}, "12.34×", "12.34×<!-- = r.json#/a -->"),
    ],
)
def test_a_suggested_mark_states_the_unit_that_a_fix_needs(
    audit, folder, results, text, mark
):
    (folder / "r.json").write_text(json.dumps(results))
    assert audit(text, "--suggest", "r.json")[2] == mark
    wrong = mark.replace("3", "5", 1)
    assert audit(wrong, "--fix", "--check") == (0, [], mark)
