"""Test that each value has a source, and that sentences follow the outcomes of claims."""

import math

import pandas as pd
import pytest
from markupsafe import Markup

from measured_report.files.errors import ReportError
from measured_report.parts import claim as claims
from measured_report.parts.claim import (
    FAILS,
    HOLDS,
    Claim,
    Outcome,
    all_of,
    at_least,
    at_most,
    greater,
)
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, ResultsError


def quantity(value, reason="", noise=0.01) -> Quantity:
    return Quantity(
        value, "mm", "newton-1.4.0/toy.json#/rows/0/slip_mm", reason, noise=noise
    )


def test_a_quantity_says_its_source_or_why_it_is_missing():
    assert str(quantity(6.3617).__html__()) == (
        '<data value="6.3617" data-src="newton-1.4.0/toy.json#/rows/0/slip_mm" title="±0.01">6.36</data>&nbsp;mm'
    )
    assert str(quantity(-2.0)) == "−2.00 mm"
    html = quantity(None, 'it "fell" & broke').__html__()
    assert 'title="it &#34;fell&#34; &amp; broke"' in html and html.endswith(
        ">n/a</data>"
    )
    for value, text in ((1000.0, "1000"), (1, "1"), (1e-10, "1e-10"), (0.02, "0.02")):
        assert quantity(value).code.striptags() == text, "as one types it"


INTERVALS = {
    (0.0421, 0.0097): "0.0421 ± 0.0097 mm",
    (0.003, 0.010): "0.003 ± 0.010 mm",
    (-23.082, 0.47): "−23.08 ± 0.47 mm",
    (1234.0, 250.0): "1 230 ± 250 mm",
    (5.0, 0.0): "5 mm",
}


@pytest.mark.parametrize(("given", "text"), INTERVALS.items())
def test_an_interval_is_written_to_two_digits_of_the_noise(given, text):
    value, noise = given
    html = quantity(value, noise=noise).interval
    assert html.striptags().replace("\xa0", " ") == text
    assert 'data-as="interval"' in html
    assert quantity(value, noise=noise).is_distinct == (abs(value) > noise)
    assert quantity(None, "it fell").interval.striptags() == "n/a"


NOISE = quantity(0.1)


IN_MS, IN_S, COUNT = (
    Quantity(value, unit, "", noise=0.0)
    for value, unit in ((1500.0, "ms"), (2.0, "s"), (3, "1"))
)


@pytest.mark.parametrize("other", [IN_S, COUNT])
@pytest.mark.parametrize("test", [greater, at_least, at_most])
def test_numbers_of_several_units_are_refused_and_never_compared(test, other):
    for pair in ((IN_MS, other), (other, IN_MS)):
        with pytest.raises(
            ReportError, match=r"a test compares .*: derive them in one unit"
        ):
            test(*pair)
    with pytest.raises(ReportError, match=r"1.*500 ms with"):
        claims.decreases([IN_MS, IN_MS], by=other)
    assert claims.decided(True, IN_MS, other) == HOLDS
    table = Table(pd.DataFrame({"time": [IN_MS, other]}))
    if other == IN_S:
        with pytest.raises(
            ReportError,
            match="the column time of a table has ms and s: give it one unit",
        ):
            table.rendered()
    else:  # cells of one row need not be comparable
        assert "ms" in table.rendered().frame


def test_a_bound_that_is_a_plain_number_is_kept_with_its_unit_and_why():
    found = at_most(quantity(0.4), 0.5, why="hardly any")
    assert found == HOLDS and found.bounds == ("0.5 mm (hardly any)",)
    assert 'data-outcome="holds" title="Chosen: 0.5 mm (hardly any)">' in make_claim(
        found
    ).html("toy")
    bounds = all_of(found, greater(quantity(2.0), 1.0, why="much")).bounds
    assert bounds == (*found.bounds, "1 mm (much)")
    near = at_most(quantity(0.105), 0.1, why="the same").reason.striptags()
    assert near.replace("\xa0", " ") == (
        "the bound of 0.1 mm lies within the interval 0.105 ± 0.010 mm"
    )
    assert greater(quantity(3.0), quantity(1.0)).bounds == ()
    for bound, why in ((0.5, " "), ("0.5 mm", "hardly any")):
        with pytest.raises(
            ReportError,
            match=r"0\.5.* was not measured: give the reason for a chosen number as why",
        ):
            at_least(quantity(0.4), bound, why=why)
    with pytest.raises(ReportError, match="'far' is not a number or a series"):
        _ = quantity(0.4) - "far"


def test_an_outcome_without_numbers_is_unknown_and_says_why():
    gone = quantity(None, "non-finite in frame 12")
    for outcome in (
        at_least(gone, NOISE),
        at_most(NOISE, gone),
        greater(NOISE, gone),
    ):
        assert outcome == Outcome("unknown", "non-finite in frame 12")
    with pytest.raises(ReportError, match="with itself"):
        greater(NOISE, NOISE)


def make_claim(outcome) -> Claim:
    words = {
        "holds": "It is {}.",
        "fails": "It is not {}.",
        "asks": "whether it is",
        "because": "Since it is soft.",
    }
    wording = {
        part: lambda numbers, text=text: Markup(text).format(numbers["slip"])
        for part, text in words.items()
    }
    return Claim("slips", outcome, {"slip": quantity(6.3617)}, wording)


def test_each_outcome_has_its_wording_and_an_explanation_only_where_it_holds():
    assert make_claim(HOLDS).text == "It is 6.36 mm."
    assert make_claim(FAILS).text == "It is not 6.36 mm."
    assert (
        make_claim(Outcome("unknown", "a < b")).text
        == "We cannot tell whether it is (a < b)."
    )
    html = make_claim(HOLDS).html("toy")
    assert html.startswith(
        '<span class="claim" data-claim="toy.slips" data-outcome="holds">It is <data '
    )
    assert html.endswith("Since it is soft.")
    assert "Since it is soft." not in make_claim(FAILS).html("toy") + make_claim(
        Outcome("unknown")
    ).html("toy")


@pytest.fixture
def results(toy) -> Results:
    return Results(toy.record(), toy.record_path)


def test_a_value_says_how_it_is_derived_or_why_it_is_chosen(results):
    a, b = (results.row[case].slip_mm for case in ("soft", "stiff"))
    gain = results.value("gain", "soft over stiff", a / b)
    assert gain.source == "newton-1.4.0/values.json#/toy/gain"
    assert gain.entry == {
        "value": 6.3617 / 0.3124,
        "unit": "1",
        "noise": None,
        "formula": "soft over stiff",
        "sources": [
            "newton-1.4.0/toy.json#/rows/0/slip_mm",
            "newton-1.4.0/toy.json#/rows/1/slip_mm",
        ],
    }
    bound = results.chosen("bound", "far from it", 0, unit="mm")
    assert bound.entry == {
        "value": 0,
        "unit": "mm",
        "noise": 0.0,
        "formula": "chosen: far from it",
        "sources": [],
    }


def test_a_row_is_dropped_for_nothing_that_others_have(toy):
    repeats = [
        {"case": f"repeat-{n}", "of": "soft", "slip_mm": 1.0 + n, "note": "again"}
        for n in range(8)
    ]
    rows = [{"case": "soft", "slip_mm": 1.0}, *repeats]
    assert Results(toy.record(rows), toy.record_path).row["soft"].slip_mm.value == 1.0
    rows += [{"case": "soft", "slip_mm": 2.0}]
    assert (
        Results(toy.record(rows), toy.record_path).row["soft"].slip_mm.reason
        == "there are 2 rows of case soft"
    )


def test_what_has_no_value_says_why(results):
    gone = results.value("half", "half of it", quantity(None, "it fell") / 2)
    assert (gone.value, gone.reason) == (None, "it fell")
    for number, function in enumerate(
        (lambda: 1 / 0, lambda: math.nan, lambda: math.inf)
    ):
        value = results.value(f"nonsense{number}", "nonsense", function)
        assert value.value is None and value.reason
    firm, trace = results.row["firm"], results.trace("soft")
    assert firm.case == "firm" and not firm
    assert firm.slip_mm == absent("mm", "there is no single row of case firm")
    assert trace.value is None and "toy.soft.csv.gz" in trace.reason
    with pytest.raises(ResultsError, match="derived twice"):
        results.value("half", "two", lambda: 2.0)
    with pytest.raises(
        AssertionError,
        match="the value least has no formula: describe in words how",
    ):
        results.chosen("least", "", 2.0)
    with pytest.raises(ReportError, match="'2' is not a number or a series"):
        results.chosen("least", "two", "2")
    with pytest.raises(
        ResultsError, match="toy: there is no single row of case nobody"
    ):
        _ = results.row["nobody"].has_old  # a text would count as true here
    with pytest.raises(ResultsError, match="toy: soft has no column drift_mm_s"):
        _ = results.row["soft"].drift_mm_s


def test_claims_have_names_of_their_own_and_a_test_takes_yes_or_no():
    with pytest.raises(AssertionError, match="two claims have the same name: a, b, a"):
        Section(claims=[Claim(name, HOLDS) for name in "aba"])
    for is_so in (quantity(1.0), "no"):
        with pytest.raises(AssertionError, match="instead of True or False"):
            claims.decided(is_so, quantity(1.0))
    with pytest.raises(AssertionError, match="1 mm cannot bound a change"):
        claims.decreases([quantity(1.0)], by=-1.0, why="a slip")
