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
from measured_report.parts.words import Wording
from measured_report.records.record import Origin
from measured_report.values.quantities import Quantity


def mm(value, noise=0.0, source="a.json#/rows/0/slip_mm", **others) -> Quantity:
    return Quantity(value, "mm", source, noise=noise, **others)


def said(outcome: Outcome) -> str:
    """Say one of four, and of what cannot tell whether it may once it is measured again."""
    return "near" if outcome.is_inconclusive else outcome.answer


BOUNDED = [
    (mm(1.0), mm(1.0), "holds", "holds"),
    (mm(1.0, None), mm(1.0, None), "holds", "holds"),
]
BOUNDED += [
    (mm(1.0, 0.5), mm(1.5), "holds", "fails"),
    (mm(1.5), mm(1.0, 0.5), "fails", "holds"),
]  # by just the noise
BOUNDED += [
    (mm(1.0, 0.5), mm(1.25), "near", "near"),
    (mm(-2.0, 0.5), mm(-1.0), "holds", "fails"),
]
BOUNDED += [(mm(10.0, 3.0), mm(15.0, 4.0), "holds", "fails")]  # 3² + 4² = 5²
BOUNDED += [(mm(10.0, 3.0), mm(14.5, 4.0), "near", "near")]  # by more than either noise
BOUNDED += [(mm(16.0, 3.0), mm(10.0, 4.0), "fails", "holds")]  # by less than their sum


@pytest.mark.parametrize(("a", "bound", "most", "least"), BOUNDED)
def test_a_bound_is_kept_where_it_is_met_and_noises_of_both_add_in_squares(
    a, bound, most, least
):
    assert (said(at_most(a, bound)), said(at_least(a, bound))) == (most, least)


UNSURE = [
    (mm(1.75, 0.25), mm(1.0, 0.75), None),
    (mm(1.75, 0.75), mm(1.0, 0.25), None),
]  # by just the larger noise
UNSURE += [
    (mm(2.0, None), mm(1.0, 0.75), None),
    (mm(2.0), 2.0, None),
    (mm(2.0), mm(1.0), mm(1.0)),
]
SURE = [(mm(2.0, 0.25), mm(1.0, 0.75), None), (mm(1.75, 0.25), mm(1.0, 0.25), None)]
SURE += [(mm(2.0, None), mm(1.0, None), mm(0.5)), (mm(2.0, 0.25), 1.0, None)]


@pytest.mark.parametrize(("a", "b", "noise"), [*SURE, *UNSURE])
def test_greater_is_by_more_than_the_larger_noise_and_less_is_the_opposite(a, b, noise):
    found = [
        said(greater(*pair, noise=noise, why="chosen")) for pair in ((a, b), (b, a))
    ]
    assert found == (
        ["cannot tell", "cannot tell"]
        if (a, b, noise) in UNSURE
        else ["holds", "the opposite"]
    )
    assert greater(mm(2.0, None), mm(1.0)).reason == "nobody measured its noise"
    assert greater(mm(None, None, reason="it fell"), mm(1.0)).reason == "it fell"


FALLS = {
    (5.0, 4.0, 3.0): "holds",
    (3.0, 4.0, 5.0): "the opposite",
    (5.0, 4.0): "cannot tell",
    (4.0, 5.0): "cannot tell",
}
FALLS |= {(5.0,): "cannot tell", (5.25, 4.0): "holds", (9.0, 2.0, 7.0): "fails"}
FALLS |= {
    (5.0, 3.0, 4.0, 2.0): "holds",
    (5.0, 3.0, 4.25, 2.0): "fails",
}  # rises by just the noise, or by more
FALLS |= {
    (9.0, 5.0, 5.75, 6.5, 2.0): "fails"
}  # in two steps, of which neither is more than the noise
FALLS |= {(2.0, 4.0, 3.0, 5.0): "the opposite", (2.0, 4.25, 3.0, 5.0): "fails"}


def test_what_decreases_rises_nowhere_by_more_than_the_noise():
    assert {
        each: said(module.decreases([*map(mm, each)], noise=mm(1.0))) for each in FALLS
    } == FALLS


APART = {
    2.0: "holds",
    1.5: "near",
    1.0: "near",
    0.9375: "the opposite",
    0.0: "the opposite",
}


@pytest.mark.parametrize(("noise", "expected"), APART.items())
def test_what_is_equal_is_so_up_to_the_noise_and_what_is_up_to_twice_as_far_apart_is_near(
    noise, expected
):
    assert (
        said(module.equal_within([*map(mm, (1.0, 3.0, 2.0))], noise=mm(noise)))
        == expected
    )
    assert said(module.within(mm(2.0), noise, why="chosen")) == expected
    if expected != "holds":
        assert (
            said(module.beyond(mm(-2.0), mm(noise)))
            == said(module.beyond(mm(2.0), mm(noise)))
            == expected
        )
    assert said(module.beyond(mm(None, reason="it fell"), mm(noise))) == "cannot tell"


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
    found = greater(mm(2.0, origins=here), mm(1.0, origins=there), noise=mm(0.0))
    assert found.answer == "cannot tell" and found.reason.startswith(
        "it would compare Newton 1.4.0 on A processor"
    )
    assert greater(mm(2.0, origins=here), mm(1.0, origins=here), noise=mm(0.0)) == HOLDS
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
    (Outcome("unknown", "by 2"), "Whether D cannot be told (by 2)."),
]


@pytest.mark.parametrize(
    ("outcome", "text"), [*TEXTS, (Outcome("unknown"), "Whether D cannot be told.")]
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
        wording = Wording(words, lambda text, _: text)
        return Claim("c", outcome, {}, wording, **others)

    assert claim().sentence == text and ("E" in claim().html("s")) == (outcome == HOLDS)
    assert "E" not in claim(effect=FAILS).html("s")
    words["opposite"] = ""
    assert claim().sentence == ("B" if text == "C" else text)
    words["fails"] = ""
    assert claim().sentence == ("Whether D is not shown." if text in "BC" else text)
