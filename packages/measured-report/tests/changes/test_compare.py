"""Test that several releases are derived, shown and compared although none of them is
installed.
"""

import math
from argparse import Namespace
from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
from current_columns import units_of
from scipy import stats
from toys import MODULE, ROWS, Toy, compared, derived

from measured_report.changes.alarm import (
    blind_sections,
    false_alarm_counts,
    settings_text,
)
from measured_report.changes.compare import flips_between
from measured_report.changes.moves import Move, moves_between
from measured_report.commands import diff, page
from measured_report.editions.release import release_of
from measured_report.files.config import report
from measured_report.findings.chapters import Chapter
from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, at_most, greater
from measured_report.parts.section import Section
from measured_report.records.record import load_record
from measured_report.site.check import check_site
from measured_report.values.evidence import Evidence, Several, column_key_of, key_of
from measured_report.values.noise import Scatter
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results

SOFT, STIFF = ROWS
BETTER = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""Release in which stiffer pads do not help."""


@pytest.fixture
def newer(toy) -> Toy:
    newer = toy.of("1.8.0")
    newer.measure(BETTER)
    return newer


def test_every_release_has_a_page_that_leads_to_the_others_and_the_one_asked_for_is_first(
    toy, newer
):
    toy.build()
    site = toy.project.site
    other = (site / "newton-1.8.0/cause.html").read_text()
    assert (
        'href="newton-1.8.0/cause.html#toy"' in toy.page
        and 'href="newton-1.8.0/index.html"' in toy.front
    )
    assert 'href="../cause.html#toy"' in other
    assert 'data-claim="toy.helps" data-outcome="holds"' in toy.page
    assert 'data-claim="toy.helps" data-outcome="fails"' in other
    assert 'data-src="newton-1.8.0/toy.json#/rows/1/slip_mm"' in other
    assert "NEWTON" not in toy.page
    assert (site / "data/newton-1.8.0/toy.json").is_file()
    assert check_site(site) == []
    newer.build()
    assert "<b>Newton 1.8.0</b>" in newer.page.replace(' aria-current="true"', "")
    assert 'href="newton-1.4.0/cause.html"' in newer.page
    assert check_site(site) == []
    path = site / "newton-1.4.0/cause.html"
    path.write_text(
        path.read_text()
        .replace('id="toy"', 'id="other"')
        .replace('href="#toy"', 'href="#other"')
    )
    assert "cause.html: newton-1.4.0/cause.html#toy does not exist" in check_site(site)


@pytest.mark.parametrize(
    ("bug", "said"),
    [
        ("results.rows[5:]; rows[0]", "IndexError: list index"),
        ("results.row['stiff'].slap_mm", "toy: stiff has no column"),
        (
            "results.chosen('x', 'so', 1.0, 'furlong')",
            "the value x has the unknown unit furlong: add it to units",
        ),
    ],
)
def test_a_bug_of_derive_is_no_damage_and_has_its_line_and_no_advice_to_measure(
    toy, bug, said, capsys
):
    toy.write(
        "report/sections/toy.py", MODULE.replace("rows = results.rows", f"rows = {bug}")
    )
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    found = capsys.readouterr()
    assert found.err.startswith(
        f"not shown: newton-1.4.0/toy.json: report/sections/toy.py:20: {said}"
    )
    assert (
        "report/sections/toy.py:20" in toy.page and "rerun" not in toy.page + found.out
    )
    toy.write("experiments/scene.py", "def slip():\n    return 2\n")
    toy.build()
    assert "<b>toy</b> is left out" in toy.page and said in toy.page


def test_a_diff_names_what_moved_and_flipped_and_a_dropped_cube_as_dropped(
    toy, newer, capsys
):
    arguments = Namespace(a=release_of("1.4.0"), b=release_of("1.8.0"), format="text")
    assert diff.run(toy.project, arguments) == 1
    said = capsys.readouterr().out
    flips = said.partition("toy: 1 moved, 1 better")[0]
    assert "toy.helps: holds → fails\n  It helps 20 times.\n  It does not." in flips
    assert (
        "slip 6.36 mm → 0.4 mm, -94 % better (toy soft)" in flips
        and "(toy stiff)" not in said
    )
    newer.measure(ROWS)
    assert diff.run(toy.project, arguments) == 0
    newer.measure([SOFT, {**STIFF, "slip_mm": 900.0, "dropped": True}])
    moves = compared(toy.project, newer.project).moves
    assert [(move.column.name, move.direction) for move in moves] == [
        ("dropped", "worse")
    ]


def test_what_is_near_the_noise_has_not_flipped(toy):
    (chapter,) = derived(toy.project).chapters.values()

    def flip_count(*outcomes: Outcome) -> int:
        sections = [Section(claims=[Claim("same", outcome)]) for outcome in outcomes]
        return len(
            flips_between(
                *({"toy": replace(chapter, section=section)} for section in sections)
            )
        )

    near, unknown = Outcome("unknown", "near", is_inconclusive=True), Outcome("unknown")
    assert (
        flip_count(HOLDS, near)
        == flip_count(near, FAILS)
        == flip_count(HOLDS, HOLDS)
        == 0
    )
    assert flip_count(HOLDS, unknown) == flip_count(HOLDS, FAILS) == 1


@pytest.mark.parametrize(
    ("before", "after", "moved"),
    [
        (
            {"classes": "creeping, creeping", "drift_mm_s": 1.0},
            {"classes": "creeping, creeping", "drift_mm_s": 2.0},
            1,
        ),
        (
            {"classes": "creeping, creeping", "drift_mm_s": 1.0},
            {"classes": "dropped, creeping", "drift_mm_s": 2.0},
            0,
        ),
        ({"failure": "overflow in frame 3"}, {"failure": "overflow in frame 4"}, 0),
        ({"failure": None}, {"failure": "overflow in frame 4"}, 1),
        ({"peak_contact_count": 7}, {"peak_contact_count": 8}, 0),
        ({"peak_contact_count": 7}, {"peak_contact_count": 9}, 1),
        (
            {"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0},
            {"ms_per_s": 109.0},
            0,
        ),
        (
            {"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0},
            {"ms_per_s": 150.0},
            1,
        ),
        ({"drift_mm_s": 1.0}, {"drift_mm_s": 1.03}, 0),
        (
            {"drift_mm_s": 1.0, "case": "c"},
            {"drift_mm_s": 1.03},
            1,
        ),  # its repeats are bit-identical
        ({"substeps": 4, "drift_mm_s": 1.0}, {"substeps": 6, "drift_mm_s": 2.0}, 0),
    ],
)
def test_what_may_be_chance_has_not_moved(toy, newer, before, after, moved):
    toy.measure([SOFT, {**STIFF, **before}])
    newer.measure([SOFT, {**STIFF, **before, **after}])
    assert len(compared(toy.project, newer.project).moves) == moved


DRIFT = "drift_mm_s"
TIME = "frame_ms"


@pytest.fixture
def chapter(toy) -> Chapter:
    return derived(toy.project).chapters["toy"]


def side(
    chapter: Chapter,
    numbers: dict[str, float],
    column: str = DRIFT,
    *,
    deviation: float = 0.1,
    freedom: float = 20.0,
    count: int = 1,
    odd_rows: float | None = 0.0,
    host: float = 0.03,
    **cells: object,
) -> Chapter:
    """Return an edition with these numbers by case and this scatter of its
    measurements.
    """
    rows = [{"case": case, column: value, **cells} for case, value in numbers.items()]
    columns = chapter.results.columns
    keys = [key_of(row, columns) for row in rows]
    several = {
        (key, column): Several(row[column], count * [row[column]], count)
        for key, row in zip(keys, rows, strict=True)
    }
    evidence = Evidence(
        count=count,
        numbers=several if count > 1 else {},
        scatters={
            column_key_of(column, row, columns): Scatter(deviation**2, 0.0, freedom)
            for row in rows
        },
        odd_rows=odd_rows,
        host=(host**2, 10.0),
    )
    record = replace(chapter.results.record, rows=rows, units=units_of(rows))
    results = replace(chapter.results, record=record, evidence=evidence, derived={})
    return replace(chapter, results=results)


def cases(count: int, value: float = 10.0) -> dict[str, float]:
    return {f"c{index}": value for index in range(count)}


@pytest.mark.parametrize(("before", "after"), [(1, 1), (4, 1), (4, 8)])
def test_the_chance_of_a_change_is_that_of_student_s_t(chapter, before, after):
    """Test that the variance of a mean is the variance of one measurement divided by
    their number.
    """
    old = side(chapter, {"a": 2.0}, count=before)
    new = side(chapter, {"a": 2.3}, count=after)
    [move] = moves_between(old, new)
    error = 0.1 * (1 / before + 1 / after) ** 0.5
    rounding = 2.3e-6
    chance = 2 * stats.t.sf((0.3 - rounding) / error, 20)
    assert (move.error, move.freedom) == pytest.approx((error, 20.0))
    assert move.chance == pytest.approx(chance)
    assert move.noise == pytest.approx(stats.t.ppf(0.995, 20) * error, rel=1e-4)


def test_a_change_that_nobody_knows_the_noise_of_has_to_exceed_a_tenth(chapter):
    unknown = Evidence()
    old, new = (
        side(chapter, {"a": 1.0, "b": 1.0}),
        side(chapter, {"a": 1.1, "b": 1.2}),
    )
    sides = [
        replace(each, results=replace(each.results, evidence=unknown))
        for each in (old, new)
    ]
    moves = moves_between(*sides)
    assert [(move.is_real, move.is_chosen) for move in moves] == [
        (False, True),
        (True, True),
    ]
    [lent] = moves_between(side(chapter, {"a": 1.0}), sides[1])[:1]
    assert not lent.is_chosen
    assert lent.error == pytest.approx(0.1 * 2**0.5), "of what the other side knows"


def test_false_changes_are_bounded_within_a_section(chapter):
    """Test the limits of Benjamini and Hochberg for 40 numbers and for one."""
    chance = np.random.default_rng(1)
    shifts = np.where(np.arange(40) < 10, 0.65, 0.0) + chance.normal(0, 0.1, 40)
    after = {f"c{index}": 10.0 + float(shift) for index, shift in enumerate(shifts)}
    moves = moves_between(side(chapter, cases(40)), side(chapter, after))
    adjusted = stats.false_discovery_control([move.chance for move in moves])
    found = [move.is_real for move in moves]
    assert found == [each <= 0.01 for each in adjusted]
    assert sum(found) > sum(move.chance <= 0.01 / 40 for move in moves) > 0
    quiet = moves_between(side(chapter, cases(40)), side(chapter, cases(40)))
    assert {move.limit for move in quiet} == {0.01 / 40}


@pytest.mark.parametrize(
    ("odd_rows", "wild", "listed"),
    [(0.01, 1, 1), (0.5, 1, 0), (0.5, 8, 8), (8.0, 8, 0)],
)
def test_single_runs_count_if_more_end_otherwise_than_chance_explains(
    chapter, odd_rows, wild, listed
):
    """Test the limits of Poisson's distribution for 0.01, 0.5 and 8 expected odd rows."""
    after = cases(40) | cases(wild, 30.0)
    once = side(chapter, cases(40), odd_rows=odd_rows / 2)
    again = side(chapter, after, odd_rows=odd_rows / 2)
    assert sum(move.is_real for move in moves_between(once, again)) == listed
    several = side(chapter, cases(40), odd_rows=odd_rows / 2, count=4)
    both = side(chapter, after, odd_rows=odd_rows / 2, count=4)
    found = moves_between(several, both)
    assert sum(move.is_real for move in found) == wild, "measured again"


def test_a_number_that_is_named_counts_even_if_its_run_may_be_odd(chapter, monkeypatch):
    changes = replace(report().settings.changes, thresholds={"toy.c0.drift_mm_s": 0.05})
    settings = replace(report().settings, changes=changes)
    monkeypatch.setitem(vars(report()), "settings", settings)
    vars(report()).pop("columns", None)
    named = replace(chapter, results=replace(chapter.results, columns=report().columns))
    after = cases(40) | {"c0": 30.0, "c1": 30.0}
    old, new = (side(named, each, odd_rows=1.0) for each in (cases(40), after))
    [real] = [move for move in moves_between(old, new) if move.is_real]
    assert real.name == "toy.c0.drift_mm_s"
    assert real.exceeds_threshold


@pytest.mark.parametrize(("shift", "is_listed"), [(0.5, True), (0.2, False)])
def test_a_number_that_is_named_is_tested_by_itself(
    chapter, monkeypatch, shift, is_listed
):
    """A change of 3.5 standard errors has a probability of 0.2 %, and 1.4 have 17 %."""
    settings = report().settings
    rules = replace(settings.changes, headlines={"drift": "toy.c0.drift_mm_s"})
    monkeypatch.setitem(vars(report()), "settings", replace(settings, changes=rules))
    vars(report()).pop("columns", None)
    named = replace(chapter, results=replace(chapter.results, columns=report().columns))
    after = cases(166) | {"c0": 10.0 + shift, "c1": 10.0 + shift}
    moves = moves_between(side(named, cases(166)), side(named, after))
    listed = [move.name for move in moves if move.is_real]
    assert listed == (["toy.c0.drift_mm_s"] if is_listed else [])


def test_a_small_number_keeps_its_digits_beside_a_large_one(chapter):
    """The noise of 310 is 60, but the text shows the other number."""
    [move] = moves_between(
        side(chapter, {"a": 310.0}, deviation=30.0),
        side(chapter, {"a": 1.6}, deviation=30.0),
    )
    assert move.is_real and move.ends == "300 mm/s → 2 mm/s"


def test_times_that_move_together_are_told_beside_the_scatter_of_hosts(chapter):
    """Test nine rows with a noise of 30 % each, whose common shift is known to 3 %, the
    noise of their host.
    """
    noisy = {"column": TIME, "deviation": 3.0}
    old = side(chapter, cases(9), **noisy)
    slower = side(chapter, cases(9, 13.0), **noisy)
    *rows, shift = moves_between(old, slower)
    assert not any(move.is_real for move in rows)
    assert (shift.row_count, shift.is_real, shift.exceeds_threshold) == (9, True, True)
    assert shift.share == pytest.approx(0.3)
    chance = 2 * stats.t.sf(np.log(1.3) / (0.03 * 2**0.5), 10)
    assert shift.chance == pytest.approx(chance)
    *_, hidden = moves_between(old, side(chapter, cases(9, 10.8), **noisy))
    assert not hidden.is_real
    few = moves_between(
        side(chapter, cases(2), **noisy), side(chapter, cases(2, 13.0), **noisy)
    )
    assert len(few) == 2, "two do not show what they have in common"
    assert (
        len(moves_between(side(chapter, cases(9)), side(chapter, cases(9, 13.0)))) == 9
    )


def test_a_number_close_to_zero_changed_by_a_share_of_its_column(chapter):
    before = cases(9) | {"zero": 0.001}
    after = cases(9) | {"zero": 0.101}
    quiet = {"deviation": 0.001}
    *_, move = moves_between(
        side(chapter, before, **quiet), side(chapter, after, **quiet)
    )
    assert move.is_real
    assert move.share == pytest.approx(0.1 / (0.01 * 10.0)), "and not 100 times"


@pytest.mark.parametrize(
    ("column", "deviation", "is_blind"),
    [(DRIFT, 0.3, True), (DRIFT, 0.2, False), (TIME, 0.48, False), (TIME, 0.6, True)],
)
def test_a_section_is_blind_if_its_noise_exceeds_its_own_threshold(
    chapter, column, deviation, is_blind
):
    """Test t = 2.845 (20 degrees of freedom, 99 %).

    A noise of 0.3 in 10 gives 12 %, and one of 0.48 gives 19 %."""
    noisy = {"column": column, "deviation": deviation}
    moves = moves_between(
        side(chapter, cases(9), **noisy), side(chapter, cases(9), **noisy)
    )
    rows = [move for move in moves if move.rows]
    comparison = SimpleNamespace(cells=rows, report=report())
    assert bool(blind_sections(comparison)) == is_blind


@pytest.mark.parametrize(
    ("column", "share", "exceeds"),
    [
        (DRIFT, 1.09, False),
        (DRIFT, 1.11, True),
        (TIME, 1.19, False),
        (TIME, 1.21, True),
    ],
)
def test_thresholds_are_10_percent_and_20_percent_of_times(
    chapter, column, share, exceeds
):
    precise = {"column": column, "deviation": 0.01}
    after = {"c0": 10.0 * share, "c1": 10.0}
    old, new = (side(chapter, each, **precise) for each in (cases(2), after))
    moved, same = moves_between(old, new)
    assert (moved.is_real, moved.exceeds_threshold) == (True, exceeds)
    assert not same.is_real


def test_relevance_is_the_share_over_its_threshold_whichever_way_it_moves_and_two_of_three_comparisons_tell_a_change():
    """Test a change of 1 with a noise of 0.25758, which is 2.5758 standard errors of
    0.1 and contains 99 % of a normal distribution, and a threshold of 0.05.
    """
    load, value = (report().columns[name] for name in ("load", "value"))
    falls, grows = (
        Move(load, *ends, chance=0.0, error=0.1, least=0.05)
        for ends in ((2.0, 1.0), (-2.0, -1.0))
    )
    assert (falls.share, grows.share, falls.noise) == pytest.approx(
        (-0.5, 0.5, 0.30758), rel=1e-4
    )
    # The threshold of other numbers is 10 %.
    assert falls.relevance == grows.relevance == pytest.approx(5.0)
    assert falls.exceeds_threshold and not replace(falls, chance=0.9).exceeds_threshold
    least, below = (Move(load, 2.0, end, chance=0.0) for end in (2.2, 2.199))
    assert (least.exceeds_threshold, below.exceeds_threshold) == (True, False)
    assert Move(load, 0.0, 1.0, chance=0.0).relevance == math.inf
    setting = partial(Move, value, 1.0, chance=0.0, rules=report().settings.changes)
    some = [
        setting(after=after, place={"case": f"by {after}", "kind": "option"})
        for after in (1.0001, 0.8)
    ]
    assert [each.exceeds_threshold for each in some] == [False, True] and settings_text(
        some
    ).startswith("by 0.8 ")
    evidence = {
        "a": SimpleNamespace(changed=[(40, 0), (40, 1), (0, 0)]),
        "b": SimpleNamespace(changed=[(20, 3)]),
    }
    found = false_alarm_counts(
        SimpleNamespace(measurements=SimpleNamespace(evidence=evidence))
    )
    assert found == {"comparisons": 3, "told": 2, "numbers": 100, "moves": 4}


def test_rows_of_different_releases_or_machines_are_not_compared_by_accident(
    toy, newer
):
    results, other = (
        Results(load_record(each.record_path), each.record_path)
        for each in (toy, newer)
    )
    slips = results.row["soft"].slip_mm, other.row["soft"].slip_mm
    refused = results.value("gain", "one over the other", lambda a, b: a / b, *slips)
    assert refused.value is None
    assert (
        refused.reason
        == "it would compare Newton 1.4.0 on A processor with Newton 1.8.0 on A processor"
    )
    asked = results.value(
        "change",
        "one less the other",
        lambda a, b: b - a,
        *slips,
        unit="mm",
        across=True,
    )
    assert asked.value == pytest.approx(0.4 - 6.3617)
    bound = results.value("bound", "chosen", lambda: 0.1, unit="mm")
    assert greater(*slips).reason == refused.reason
    assert at_most(asked, bound).name == "holds"
    assert Quantity(1.0, "mm", "").bare.striptags() == "n/a", (
        "a number without a place is not shown"
    )
