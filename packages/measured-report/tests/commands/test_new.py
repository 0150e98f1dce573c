"""Test that a new report is named after its folder and does not overwrite an existing
file.
"""

import json
import os
import re
import sys

import pytest
from toys import GENERATOR, program

from measured_report.commands import new as new_command
from measured_report.commands.new import new
from measured_report.files.config import Report
from measured_report.files.errors import ReportError, UsageError
from measured_report.measuring.benchmarks import rows_of


def test_a_new_report_has_the_name_of_its_folder_and_no_mark_left(tmp_path, capsys):
    folder = tmp_path / "in a" / "mine"
    new(folder)
    assert f"cd '{os.path.relpath(folder)}' &&" in capsys.readouterr().out
    files = [path for path in folder.rglob("*") if path.is_file()]
    for path in files:
        if path.suffix != ".whl":
            text = path.read_text()
            assert not any(mark in text for mark in ("@NAME@", "@AUTHOR@", "@SOURCE@"))
    assert "pendulum.py" in {path.name for path in files}
    assert Report(folder).settings.name == "mine"
    upgrade = (folder / ".github/workflows/upgrade.yml").read_text()
    assert "steps.new.outputs.release" in upgrade


def test_a_new_report_pins_a_release_that_runs_on_this_python(tmp_path, monkeypatch):
    new(tmp_path / "mine")
    project = (tmp_path / "mine/pyproject.toml").read_text()
    least = re.search(r"requires-python = \">=3\.(\d+)", project)[1]
    assert int(least) <= sys.version_info.minor
    monkeypatch.setattr(new_command, "OLDER", {"numpy==2.4.6": "numpy==2.2.6"})
    new(tmp_path / "older")
    assert '"numpy==2.2.6"' in (tmp_path / "older/pyproject.toml").read_text()


def test_a_folder_that_holds_something_is_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(UsageError, match="is not empty"):
        new(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["letter.txt"]


ASV = {
    "result_columns": ["result", "params", "samples"],
    "results": {
        "sort": [[0.001, 0.002], [["10", "20"]], [[0.001, 0.003], None]],
        "lost": [[None], []],
    },
}
ROUNDS = [0.001 * n for n in range(1, 41)]
PYTEST = {
    "benchmarks": [
        {"name": "test_a", "stats": {"median": 0.5}},
        {"name": "test_b", "stats": {"median": 9.0, "data": ROUNDS}},
    ]
}
HYPERFINE = {"results": [{"command": "sleep 1", "times": [1.0, 1.25]}]}


@pytest.mark.parametrize(
    ("name", "text", "times"),
    [
        ("a.json", ASV, {"sort(10)": [1.0, 3.0], "sort(20)": [2.0]}),
        ("a.json", HYPERFINE, {"sleep 1": [1000.0, 1250.0]}),
        (
            "a.json",
            PYTEST,
            {"test_a": [500.0], "test_b": [1.5 + 2 * n for n in range(20)]},
        ),
        ("a.csv", "solver,run_ms\nx,1\ny,2.5\nx,3\n", {"x": [1.0, 3.0], "y": [2.5]}),
    ],
    ids=["asv", "hyperfine", "pytest-benchmark", "csv"],
)
def test_the_runs_of_a_benchmark_become_rows_and_their_repeats(
    tmp_path, name, text, times
):
    file = tmp_path / name
    file.write_text(text if isinstance(text, str) else json.dumps(text))
    found: dict[str, list[float]] = {}
    for row in rows_of(str(file)):
        found.setdefault(row.get("of", row["case"]), []).append(row["run_ms"])
    assert found == {case: pytest.approx(runs) for case, runs in times.items()}


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("a.json", "{}", "is not a result of pytest-benchmark, hyperfine or asv"),
        ("a.json", "[1]", "is not a result of pytest-benchmark, hyperfine or asv"),
        ("a.csv", "", "is not a result of pytest-benchmark, hyperfine or asv"),
        ("a.csv", "case,run_ms\na,fast\n", "could not convert string to float"),
        ("a.csv", "case,run_ms\na,1\n", "has less than two cases"),
        ("a.csv", "case\na\nb\n", "'' is not the name of a column"),
        ("a.csv", "case,Run [ms]\na,1\nb,2\n", "'Run \\[ms\\]' is not the name"),
    ],
)
def test_a_file_without_results_is_one_line(tmp_path, name, text, said):
    file = tmp_path / name
    file.write_text(text)
    with pytest.raises(ReportError, match=said) as error:
        new(tmp_path / "mine", file)
    assert "\n" not in str(error.value)
    assert not (tmp_path / "mine").exists()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "outcome"),
    [
        ("case,run_ms\na,10\nb,20\na,11\nb,22\na,10.5\nb,21\n", "holds"),
        ("case,run_ms\na,10\nb,10.1\na,11\nb,9.8\na,10.5\nb,10.2\n", "unknown"),
        ("case,error_m\na,10\nb,20\na,11\nb,22\na,10.5\nb,21\n", "holds"),
    ],
)
def test_a_report_from_a_file_has_a_claim(tmp_path, text, outcome):
    (tmp_path / "bench.csv").write_text(text)
    new(folder := tmp_path / "mine", tmp_path / "bench.csv")
    done = program("build.py", "report", cwd=folder, PYTHONPATH=str(GENERATOR))
    assert "built site/index.html" in done.stdout, done
    assert "Traceback" not in done.stderr and "pendulum" not in done.stdout
    page = (folder / "site/results.html").read_text()
    assert f'data-claim="benchmark.is_best" data-outcome="{outcome}"' in page
    (folder / "assets/bench.csv").write_text(text.replace("a,11", "a,12"))
    status = program("build.py", "status", cwd=folder, PYTHONPATH=str(GENERATOR))
    assert "stale" in status.stdout
