"""Test that a name without a match in report.toml is refused in one line before the
build.
"""

from dataclasses import replace

import pytest
from toys import EXPERIMENT, MODULE, ROWS

from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.files.settings import Changes, Columns
from measured_report.measuring.run import plausible_row
from measured_report.site.build import build

RULES = Changes(
    upgrade_sections=["toy"],
    thresholds={"toy.soft.slip_mm": 0.05},
    headlines={"gain": "toy.gain"},
    explanation="toy.helps",
)


@pytest.fixture
def settle(toy, monkeypatch):
    """Gives other settings to the toy report."""

    def settle(rules: Changes = RULES, **settings) -> None:
        columns = [
            *report().settings.columns,
            *settings.pop("columns", [Columns(names=["slip_mm"])]),
        ]
        changed = {
            "noise_section": "toy",
            **settings,
            "columns": columns,
            "changes": rules,
        }
        monkeypatch.setitem(
            vars(report()), "settings", replace(report().settings, **changed)
        )
        vars(report()).pop("columns", None)

    return settle


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({}, ""),
        (
            {"noise_section": "tay"},
            "noise_section names tay, which is not a section of this report: correct the name \\(similar: toy",
        ),
        (
            {"columns": [Columns(names=["slap_mm"])]},
            "columns names slap_mm, which is not a column of this report: correct the name \\(similar: slip_mm",
        ),
        (
            {"upgrade_sections": ["noise"]},
            "changes.upgrade_sections names noise, which is not a section",
        ),
        (
            {"thresholds": {"toy.saft.slip_mm": 1.0}},
            "toy.saft.slip_mm, which is not a value of this report: correct the name \\(similar: toy.soft.slip_mm",
        ),
        (
            {"thresholds": {"toy.soft.case": 1.0}},
            "changes.thresholds names toy.soft.case, which is not a value of this report",
        ),
        (
            {"package_groups": [["warp"]]},
            "changes.package_groups names warp, which is not a package of this report",
        ),
        (
            {"explanation": "toy.help"},
            "changes.explanation names toy.help, which is not a value of this report: correct the name \\(similar: toy.helps",
        ),
    ],
)
def test_a_name_of_nothing_stops_the_build(toy, settle, wrong, said):
    changes = {name: wrong[name] for name in wrong if name in vars(RULES)}
    settings = {name: wrong[name] for name in wrong if name not in changes}
    settle(replace(RULES, **changes), **settings)
    if not said:
        toy.build()
        return
    with pytest.raises(ReportError, match=f"^report.toml: .*{said}"):
        toy.build()


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        (
            "experiments/toy/__init__.py",
            EXPERIMENT,
            "experiments/ has both toy.py and toy/, and only one of them is read",
        ),
        (
            "report/sections/toy/__init__.py",
            MODULE,
            "report/sections/ has both toy.py and toy/",
        ),
    ],
)
def test_a_section_of_two_modules_stops_the_build(toy, file, text, said):
    toy.write(file, text)
    with pytest.raises(ReportError, match=said):
        toy.build()


def gaps_of(toy) -> list[str]:
    """Return the output of a build from the toy's results, without settings."""
    _, notes = build(toy.project)
    return [note for note in notes if note.startswith("toy")]


def test_what_is_no_number_and_rows_that_nothing_tells_apart_are_said_when_the_site_is_built(
    toy,
):
    nan = plausible_row(
        {"case": "firm", "slip_mm": float("nan"), "dropped": False}, report().columns
    )
    toy.measure((ROWS[0], nan, ROWS[1], {**ROWS[1], "slip_mm": 0.4}))
    assert gaps_of(toy) == [
        "toy: case stiff has several rows that cannot be distinguished",
        "toy: firm has no slip_mm: the measurement gave nan",
        "toy.helps cannot tell: there are 2 rows of case stiff",
        "toy: its text prints a missing number: there are 2 rows of case stiff",
    ]


def test_rows_that_repeat_no_case_or_differ_only_in_numbers_are_said(toy):
    toy.measure(
        (
            *ROWS,
            {**ROWS[1], "case": "firm"},
            {**ROWS[1], "case": "firm", "dropped": True},
            *({**ROWS[1], "case": name, "of": "stiff"} for name in "ab"),
            {**ROWS[1], "case": "c", "of": "stif"},
            {**ROWS[1], "case": "d", "of": "a"},
        )
    )
    assert gaps_of(toy)[:3] == [
        "toy: case firm has several rows that cannot be distinguished",
        "toy: case c repeats stif, which is not a case, or repeats another one",
        "toy: case d repeats a, which is not a case, or repeats another one",
    ]


def test_runs_of_the_noise_section_may_repeat_a_case_of_a_section_that_was_not_measured(
    toy, settle
):
    toy.measure((*ROWS, {**ROWS[1], "case": "a", "of": "loose"}))
    settle(Changes())
    said = "toy: case a repeats loose, which is not a case, or repeats another one"
    assert said in gaps_of(toy)
    toy.write("experiments/other.py", EXPERIMENT)
    toy.write("report/sections/other.py", MODULE)
    assert said not in gaps_of(toy)


def test_a_number_that_a_claim_prints_and_its_test_has_not_read_is_said_when_the_site_is_built(
    toy,
):
    toy.write(
        "report/sections/toy.py",
        MODULE.replace("at_least(gain, bound)", "at_least(bound, bound)"),
    )
    assert gaps_of(toy) == ["toy.helps is given gain, which its test does not read"]


@pytest.mark.parametrize(
    ("sources", "reason"),
    [
        ("[]", "no sources"),
        ("[results.trace('stif')]", "there is no toy.stif.csv.gz"),
        ("[results.row['stif'].slip_mm]", "there is no single row of case stif"),
    ],
)
def test_a_figure_without_data_is_said_when_the_site_is_built(toy, sources, reason):
    module = MODULE.replace("draw(trace), [trace]", f"draw(trace), {sources}")
    toy.write("report/sections/toy.py", module)
    assert gaps_of(toy) == [f"toy: figure way is left out: {reason}"]


def test_a_setting_that_matches_no_row_is_named_when_the_site_is_built(toy):
    _, notes = build(toy.project)
    idle = [
        f"report.toml: no row has {name}"
        for name in ("growth_per_s", "classes", "worlds", "case = c")
    ]
    assert {*idle} < {*notes}
    assert "report.toml: no row has slip_mm" not in notes


def test_a_page_without_a_section_is_named_when_the_site_is_built(toy):
    _, notes = build(toy.project)
    assert [note for note in notes if " page " in note] == [
        "report.toml: page limits has no section and is left out: set always = true, "
        "or name the page in a section"
    ]
