"""Test which end an answer is nearer to, how a sequence of answers is marked, and when
a threshold cannot detect a change.
"""

import random
from types import SimpleNamespace

import pytest

from measured_report.changes import query
from measured_report.changes.bisect import answer_text, first_change
from measured_report.changes.checks import blind_spots
from measured_report.changes.query import Query, history, points
from measured_report.files.config import report
from measured_report.files.settings import Changes, Config
from measured_report.parts.claim import FAILS, HOLDS, OPPOSITE, Claim, Outcome
from measured_report.values.quantities import Quantity


def chapters(value=None, noise=None, outcome=None):
    """Return the chapter of one section: a value and a claim."""
    slip = Quantity(
        value,
        "mm",
        "values.json#/s/slip_mm",
        "" if value is not None else "it fell",
        noise=noise,
    )
    record = SimpleNamespace(units={"slip_mm": "mm"})
    columns = report().columns
    results = SimpleNamespace(
        derived={"slip_mm": slip}, row={}, rows=[], record=record, columns=columns
    )
    section = SimpleNamespace(claims=[Claim("c", outcome)] if outcome else [])
    return {"s": SimpleNamespace(results=results, section=section)}


def test_a_number_is_as_the_first_where_it_is_nearer_to_it_and_halfway_it_is_not():
    nearer = {
        1.0: True,
        1.25: True,
        1.5: False,
        1.75: False,
        2.0: False,
        -9.0: True,
        9.0: False,
    }
    assert {each: Query("s.v").is_first(each, 1.0, 2.0) for each in nearer} == nearer
    assert [Query("s.v").is_first(each, -1.0, -3.0) for each in (0.0, -1.5, -2.5)] == [
        True,
        True,
        False,
    ]
    claim = Query("s.c", is_claim=True)
    assert claim.is_first("holds", "holds", "fails") and not claim.is_first(
        "fails", "holds", "fails"
    )
    parts = [
        (each.section, each.case, each.column)
        for each in map(Query, ("s.gap_m", "s.at-0.5.slip_mm"))
    ]
    assert parts == [("s", "", "gap_m"), ("s", "at-0.5", "slip_mm")]


MARKS = [
    ((2.0, 0.25), (3.0, 0.125), "worse"),
    ((3.0, 0.125), (2.0, 0.25), "better"),
]  # less slip is better
MARKS += [
    ((2.0, 1.0), (3.0, 0.125), ""),
    ((2.0, 0.125), (3.0, 1.0), ""),
    ((2.0, None), (3.0, 0.25), "worse"),
]


@pytest.mark.parametrize(("first", "second", "mark"), MARKS)
def test_what_moves_by_far_more_than_the_larger_noise_is_marked_by_which_way_is_better(
    first, second, mark
):
    curve = points(
        {"1.0": chapters(*first), "2.0": chapters(*second)}, Query("s.slip_mm")
    )
    assert [point.mark for point in curve] == ["", mark]


def test_a_series_of_many_editions_says_where_it_changed_and_rings_for_no_noise():
    false = missed = 0
    for seed in range(100):
        chance = random.Random(seed)
        for steps in ([], [13], [9, 17]):
            numbers = [
                chance.gauss(1.0 + 0.4 * sum(step <= index for step in steps), 0.1)
                for index in range(24)
            ]
            for noise in (0.2, None):
                changed = query.changes_in(numbers, [noise] * 24, 0.0)
                false += not steps and bool(changed)
                missed += any(
                    min((abs(step - each) for each in changed), default=9) > 1
                    for step in steps
                )
    assert false <= 6 and missed <= 20, "of 200 and 400"
    assert query.changes_in([1.0, 1.0, 2.0, 2.0, 1.0, 3.0], [0.0] * 6, 0.0) == [2, 4, 5]


def test_a_history_says_numbers_in_four_digits_with_their_noise_and_why_there_is_none():
    releases = {
        "1.0": chapters(6.36174, 0.0123),
        "2.0": chapters(),
        "3.0": chapters(1234.56),
        "4.0": {},
    }
    lines = [
        " ".join(line.split())
        for line in history(releases, Query("s.slip_mm")).splitlines()
    ]
    assert lines == [
        "s.slip_mm",
        "1.0 6.362 ± 0.012",
        "2.0 cannot tell it fell",
        "3.0 1235 worse",
    ]
    outcomes = {
        "1.0": HOLDS,
        "2.0": HOLDS,
        "3.0": Outcome("unknown", "near"),
        "4.0": FAILS,
        "5.0": OPPOSITE,
    }
    releases = {
        release: chapters(outcome=outcome) for release, outcome in outcomes.items()
    }
    lines = [
        " ".join(line.split())
        for line in history(releases, Query("s.c", is_claim=True)).splitlines()
    ]
    assert lines[1:] == [
        "1.0 holds",
        "2.0 holds",
        "3.0 cannot tell near",
        "4.0 fails flipped",
        "5.0 the opposite",
    ]
    assert [answer_text(answer) for answer in (None, "holds", 6.36174)] == [
        "cannot tell",
        "holds",
        "6.362",
    ]


HIDDEN = "s.slip_mm has the threshold {} %, but noise hides changes below {} %"
LATE = [
    (4.0, 0.5, 0.18, ""),
    (-4.0, 0.5, 0.17, HIDDEN.format(17, 18)),
]  # √2 · 0.5 relative to 4
LATE += [
    (4.0, None, 0.09, HIDDEN.format(9, 10)),
    (4.0, None, 0.1, ""),
    (None, None, 0.2, "s.slip_mm cannot raise an alarm: it fell"),
]


@pytest.mark.parametrize(("value", "noise", "threshold", "late"), LATE)
def test_a_threshold_rings_late_where_the_noise_of_two_is_a_larger_share(
    value, noise, threshold, late
):
    settings = Config(changes=Changes(thresholds={"s.slip_mm": threshold}))
    project = SimpleNamespace(report=SimpleNamespace(settings=settings))
    spots = blind_spots(
        SimpleNamespace(chapters=chapters(value, noise), project=project)
    )
    assert spots == ([late] if late else [])


def test_a_search_halves_what_is_left_and_passes_over_what_cannot_tell():
    tried = []
    first = first_change(
        range(17),
        lambda point: tried.append(point) or (None if point == 8 else point < 11),
    )
    assert first == (10, 11, []) and tried == [8, 9, 13, 11, 10]
    assert first_change(range(8), lambda point: None if point == 4 else point < 2) == (
        1,
        2,
        [],
    ), "4 is no neighbour"
    assert first_change(range(3), lambda _: None) == (0, 2, [1]) and first_change(
        "ab", None
    ) == ("a", "b", [])
