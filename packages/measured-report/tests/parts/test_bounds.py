"""Tests of claims at their bounds: exactly there, within the noise, near it and beyond."""

import pytest

from measured_report.parts import claim as module
from measured_report.parts.claim import (
    FAILS,
    HOLDS,
    OPPOSITE,
    Claim,
    Outcome,
    all_of,
    at_least,
    at_most,
    decided,
    greater,
)
from measured_report.records.record import Origin
from measured_report.values.quantities import Quantity


def mm(value, noise=0.0, source="a.json#/rows/0/slip_mm", **others) -> Quantity:
    return Quantity(value, "mm", source, noise=noise, **others)


def said(outcome: Outcome) -> str:
    """Return the outcome as a word; ``near`` if another measurement may decide it."""
    return "near" if outcome.is_inconclusive else outcome.answer


BOUNDED = [
    (mm(1.0), mm(1.0), "holds", "holds"),
    (mm(1.0, None), mm(1.0, None), "holds", "holds"),
]
BOUNDED += [
    (mm(1.0, 0.5), mm(1.5), "holds", "fails"),
    (mm(1.5), mm(1.0, 0.5), "fails", "holds"),
]  # by exactly the noise
BOUNDED += [
    (mm(1.0, 0.5), mm(1.25), "near", "near"),
    (mm(-2.0, 0.5), mm(-1.0), "holds", "fails"),
]
BOUNDED += [(mm(10.0, 3.0), mm(15.0, 4.0), "holds", "fails")]  # 3² + 4² = 5²
BOUNDED += [
    (mm(10.0, 3.0), mm(14.5, 4.0), "near", "near")
]  # by more than the noise of either number
BOUNDED += [
    (mm(16.0, 3.0), mm(10.0, 4.0), "fails", "holds")
]  # by less than the sum of the noises


@pytest.mark.parametrize(("a", "bound", "most", "least"), BOUNDED)
def test_a_bound_is_kept_where_it_is_met_and_noises_of_both_add_in_squares(
    a, bound, most, least
):
    assert (said(at_most(a, bound)), said(at_least(a, bound))) == (most, least)


UNSURE = [
    (mm(2.0, 0.6), mm(1.0, 0.8)),  # 0.6² + 0.8² = 1²
    (mm(2.0, 0.9), mm(1.0, 0.9)),
    (mm(2.0, 1.5), mm(1.0)),
    (mm(1.0), mm(1.0)),
]
SURE = [
    (mm(2.0, 0.6), mm(1.0, 0.75)),  # 0.96 and not 1.35
    (mm(2.0, 0.5), 1.0),
    (mm(2.0), mm(1.0)),
]


@pytest.mark.parametrize(("a", "b"), [*SURE, *UNSURE])
def test_greater_is_by_more_than_the_noise_of_the_difference_and_less_is_the_opposite(
    a, b
):
    found = [said(greater(*pair, why="chosen")) for pair in ((a, b), (b, a))]
    expected = ["near", "near"] if (a, b) in UNSURE else ["holds", "the opposite"]
    assert found == expected
    assert greater(mm(2.0, None), mm(1.0)).reason == "its noise was not measured"
    assert greater(mm(None, None, reason="it fell"), mm(1.0)).reason == "it fell"


SAME = {
    (0.042, 0.010): "holds",  # the change is real but too small to matter
    (0.003, 0.010): "holds",
    (0.95, 0.05): "holds",  # 1 is the end of the interval
    (0.95, 0.06): "near",
    (1.05, 0.06): "near",
    (1.06, 0.05): "the opposite",
}


@pytest.mark.parametrize(("change", "expected"), SAME.items())
def test_a_change_is_the_same_but_for_what_matters_if_all_of_its_interval_is_below(
    change, expected
):
    size, noise = change
    for sign in (1, -1):
        moved = Quantity(sign * size, "%", "", noise=noise)
        assert said(module.negligible(abs(moved), 1.0, "what matters")) == expected


FALLS = {
    (5.0, 4.0, 3.0): "holds",
    (3.0, 4.0, 5.0): "the opposite",
    (5.0, 4.0): "near",
    (4.0, 5.0): "near",
}
FALLS |= {(5.0,): "cannot tell", (5.25, 4.0): "holds", (9.0, 2.0, 7.0): "fails"}
FALLS |= {
    (5.0, 3.0, 4.0, 2.0): "holds",
    (5.0, 3.0, 4.25, 2.0): "fails",
}  # rises by exactly the bound, or by more
FALLS |= {
    (9.0, 5.0, 5.75, 6.5, 2.0): "fails"
}  # in two steps, each of them at most the bound
FALLS |= {(2.0, 4.0, 3.0, 5.0): "the opposite", (2.0, 4.25, 3.0, 5.0): "fails"}


def test_what_decreases_rises_nowhere_by_more_than_what_matters():
    assert {
        each: said(module.decreases([*map(mm, each)], by=mm(1.0))) for each in FALLS
    } == FALLS
    noisy = [mm(5.0, 0.3), mm(3.5, 0.4)]  # the change is 1.5 ± 0.5
    assert said(module.decreases(noisy, by=mm(0.99))) == "holds"
    assert said(module.decreases(noisy, by=mm(1.01))) == "near"


def test_what_is_decided_holds_or_fails_and_cannot_tell_without_one_of_its_numbers():
    assert [said(decided(is_so, mm(1.0))) for is_so in (True, False)] == [
        "holds",
        "fails",
    ]
    assert decided(True, mm(1.0), mm(None, reason="it fell")) == Outcome(
        "unknown", "it fell"
    )


def test_of_several_one_that_fails_decides_then_an_opposite_then_one_that_cannot_tell():
    ranked = [FAILS, OPPOSITE, Outcome("unknown", "why"), HOLDS]
    for place, first in enumerate(ranked):
        assert (
            all_of(*ranked[:place:-1], first).answer
            == all_of(first, *ranked[place:]).answer
            == first.answer
        )
    assert (
        all_of() == HOLDS and all_of(*ranked[2:]).reason == "why" and OPPOSITE == FAILS
    )


def test_what_was_measured_elsewhere_is_not_compared_and_all_that_was_read_is_told():
    here, there = (
        frozenset({Origin(release, "A processor")}) for release in ("1.4.0", "1.8.0")
    )
    found = greater(mm(2.0, origins=here), mm(1.0, origins=there))
    assert found.answer == "cannot tell" and found.reason.startswith(
        "it would compare Newton 1.4.0 on A processor"
    )
    assert greater(mm(2.0, origins=here), mm(1.0, origins=here)) == HOLDS
    read = at_most(mm(2.0, source="a#/1"), mm(3.0, source="a#/2"))
    assert all_of(read, decided(True, mm(1.0, source="a#/3"))).reads == {
        "a#/1",
        "a#/2",
        "a#/3",
    }


TEXTS = [
    (HOLDS, "A"),
    (FAILS, "B"),
    (OPPOSITE, "C"),
    (Outcome("unknown", "by 2"), "We cannot tell whether D (by 2)."),
]


@pytest.mark.parametrize(
    ("outcome", "text"), [*TEXTS, (Outcome("unknown"), "We cannot tell whether D.")]
)
def test_each_outcome_has_its_words_and_without_them_it_is_said_by_what_was_asked(
    outcome, text
):
    words = {
        "holds": "A",
        "fails": "B",
        "opposite": "C",
        "asks": "whether D",
        "because": "E",
    }

    def claim(**others) -> Claim:
        wording = {part: lambda _, text=text: text for part, text in words.items()}
        return Claim("c", outcome, {}, wording, **others)

    assert claim().sentence == text and ("E" in claim().html("s")) == (outcome == HOLDS)
    assert "E" not in claim(effect=FAILS).html("s")
    words["opposite"] = ""
    assert claim().sentence == ("B" if text == "C" else text)
    words["fails"] = ""
    assert claim().sentence == ("It is not shown whether D." if text in "BC" else text)
