"""Values and claims: numbers that say where they come from, and sentences that follow the data."""

import math
from dataclasses import replace

import pytest
from markupsafe import Markup

from measured_report.claims.claim import (
    FAILS,
    HOLDS,
    Claim,
    Outcome,
    all_of,
    at_least,
    at_most,
    beyond,
    decreases,
    greater,
    increases,
    within,
)
from measured_report.claims.words import Wording
from measured_report.editions.project import Project
from measured_report.records.reading import load_record
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, ResultsError
from report.sections import fix
from report.sections.stiffness.runs import is_held
from report.shared.arithmetic import (
    SETTLES,
    cell_or_absent,
    departure,
    difference,
    other_cell,
    ratio,
    share,
    size_share,
    spread,
)
from report.shared.variants import beyond_noise


@pytest.mark.parametrize(("value", "text"), [(1000.0, "1000"), (1, "1"), (1e-10, "1e-10"), (0.02, "0.02")])
def test_numbers_as_one_types_them(value, text):
    assert quantity(value).code.striptags() == text


def quantity(value, reason="", noise=0.01) -> Quantity:
    return Quantity(value, "mm", "newton-1.4.0/toy.json#/rows/0/slip_mm", reason, noise=noise)


def test_a_quantity_says_its_source():
    assert str(quantity(6.3617).__html__()) == (
        '<data value="6.3617" data-src="newton-1.4.0/toy.json#/rows/0/slip_mm">6.36</data>&nbsp;mm'
    )
    assert str(quantity(-2.0)) == "−2.00 mm"


def test_a_missing_number_says_why():
    html = quantity(None, 'it "fell" & broke').__html__()
    assert 'title="it &#34;fell&#34; &amp; broke"' in html
    assert html.endswith(">n/a</data>")


NOISE = quantity(0.1)


@pytest.mark.parametrize(("a", "b", "outcome"), [(2.0, 1.0, "holds"), (1.0, 2.0, "fails"), (1.0, 1.05, "unknown")])
def test_a_difference_within_the_noise_cannot_tell(a, b, outcome):
    assert greater(quantity(a), quantity(b), noise=NOISE).name == outcome


@pytest.mark.parametrize(
    ("size", "outcome"), [(-3.0, "holds"), (1.0, "holds"), (1.01, "unknown"), (2.0, "unknown"), (2.01, "fails")]
)
def test_what_is_near_the_noise_cannot_tell(size, outcome):
    found = within(quantity(size), quantity(1.0))
    assert found.name == outcome
    assert found.is_near == (outcome == "unknown")
    assert ("data-src" in found.reason) == found.is_near, "its numbers lead back to where they are from"


def test_beyond_the_noise_is_beyond_either_way():
    assert beyond(quantity(-3.0), quantity(1.0)) == FAILS
    assert beyond(quantity(-1.5), quantity(1.0)).is_near


def test_bounds_are_inclusive():
    assert at_least(quantity(1.0), quantity(1.0)) == at_most(quantity(1.0), quantity(1.0)) == HOLDS
    assert at_least(quantity(0.9), quantity(1.0)) == at_most(quantity(1.1), quantity(1.0)) == FAILS


def test_a_bound_that_is_a_plain_number_is_kept_with_its_unit_and_why():
    found = at_most(quantity(0.4), 0.5, why="hardly any")
    assert found == HOLDS and found.bounds == ("0.5 mm (hardly any)",)
    assert 'data-outcome="holds" title="Chosen: 0.5 mm (hardly any)">' in make_claim(found).html("toy")
    assert all_of(found, greater(quantity(2.0), 1.0, noise=NOISE, why="much")).bounds == (*found.bounds, "1 mm (much)")
    assert "the noise of 0.1 mm, but" in within(quantity(0.15), 0.1, why="the same").reason
    assert greater(quantity(3.0), quantity(1.0), noise=NOISE).bounds == ()
    with pytest.raises(AssertionError, match="needs its why"):
        at_least(quantity(0.4), 0.5)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ((1.0, 2.0, 3.0), "holds"),
        ((1.0, 3.0, 2.95), "holds"),
        ((1.0, 3.0, 2.0), "not shown"),
        ((3.0, 2.0, 1.0), "the opposite"),
        ((1.0, 5.0, 1.05), "cannot tell"),
        ((1.0,), "cannot tell"),
    ],
)
def test_a_trend_turns_nowhere_by_more_than_the_noise(values, said):
    sequence = [quantity(value) for value in values]
    assert increases(sequence, noise=NOISE).said == decreases(sequence[::-1], noise=NOISE).said == said


def test_an_outcome_without_numbers_is_unknown_and_says_why():
    gone = quantity(None, "non-finite in frame 12")
    for outcome in (at_least(gone, NOISE), at_most(NOISE, gone), greater(NOISE, NOISE, noise=gone)):
        assert outcome == Outcome("unknown", "non-finite in frame 12")


def make_claim(outcome) -> Claim:
    words = {"holds": "It is {}.", "fails": "It is not {}.", "asks": "whether it is", "because": "Since it is soft."}
    wording = Wording("a place", words, frozenset({"slip"}), lambda text, numbers: Markup(text).format(numbers["slip"]))
    return Claim("slips", outcome, {"slip": quantity(6.3617)}, wording)


def test_each_outcome_has_its_wording():
    assert make_claim(HOLDS).text == "It is 6.36 mm."
    assert make_claim(FAILS).text == "It is not 6.36 mm."
    assert make_claim(Outcome("unknown", "a < b")).text == "Whether it is cannot be told (a < b)."


def test_an_explanation_stands_only_where_the_claim_holds():
    html = make_claim(HOLDS).html("toy")
    assert html.startswith('<span class="claim" data-claim="toy.slips" data-outcome="holds">It is <data ')
    assert html.endswith("Since it is soft.")
    assert "Since it is soft." not in make_claim(FAILS).html("toy") + make_claim(Outcome("unknown")).html("toy")


@pytest.fixture
def results(toy) -> Results:
    return Results(toy.record(), toy.record_path)


def test_a_derived_value_says_how(results):
    a, b = (results.row[case].slip_mm for case in ("soft", "stiff"))
    gain = results.value("gain", "soft over stiff", lambda a, b: a / b, a, b)
    assert gain.source == "newton-1.4.0/values.json#/toy/gain"
    assert gain.entry == {
        "value": 6.3617 / 0.3124,
        "unit": "1",
        "noise": None,
        "formula": "soft over stiff",
        "sources": ["newton-1.4.0/toy.json#/rows/0/slip_mm", "newton-1.4.0/toy.json#/rows/1/slip_mm"],
    }


def test_a_value_needs_its_sources(results):
    gone = quantity(None, "it fell")
    value = results.value("gain", "half of it", lambda a: a / 2, gone)
    assert (value.value, value.reason) == (None, "it fell")


@pytest.mark.parametrize("function", [lambda: 1 / 0, lambda: math.nan, lambda: math.inf])
def test_a_value_that_is_not_finite_does_not_exist(results, function):
    value = results.value("gain", "nonsense", function)
    assert value.value is None
    assert value.reason


def test_a_value_is_derived_once(results):
    results.value("gain", "one", lambda: 1.0)
    with pytest.raises(ResultsError, match="derived twice"):
        results.value("gain", "two", lambda: 2.0)


def test_a_name_that_does_not_exist_is_an_error(results):
    with pytest.raises(ResultsError, match="toy: soft has no column drift_mm_s"):
        _ = results.row["soft"].drift_mm_s


def test_a_row_that_is_not_there_has_nothing_and_says_so(results):
    firm = results.row["firm"]
    assert firm.case == "firm" and not firm
    assert firm.slip_mm == absent("mm", "there is no single row of case firm")


def test_a_lost_trace_says_so(results):
    trace = results.trace("soft")
    assert trace.value is None
    assert "toy.soft.csv.gz" in trace.reason


def test_a_chosen_value_says_why(results):
    bound = results.chosen("bound", "far from it", 0, unit="mm")
    assert bound.entry == {"value": 0, "unit": "mm", "noise": 0.0, "formula": "chosen: far from it", "sources": []}
    assert results.chosen("gain_bound", *SETTLES).formula == "chosen: a change that settles the matter"


def test_ratios_shares_and_differences(results):
    cells = [quantity(value) for value in (2.0, 8.0, 5.0)]
    assert (ratio(results, "a", "", *cells[:2]).value, ratio(results, "b", "", *cells[:2]).unit) == (0.25, "1")
    assert str(share(results, "c", "", *cells[:2])) == "25.0 %"
    assert str(spread(results, "d", "", cells, unit="mm")) == "6.00 mm"
    assert spread(results, "e", "", cells[:1]).value == 0.0
    assert spread(results, "none", "", []).value is None
    assert size_share(results, "g", "", quantity(-1.0), quantity(4.0)).value == 25.0
    assert departure(results, "h", "", quantity(3.0), quantity(4.0)).value == 25.0
    assert difference(results, "i", "", quantity(3.0), quantity(4.0)).value == -1.0
    assert ratio(results, "f", "", cells[0], quantity(0.0)).value is None


@pytest.mark.parametrize("choose", [max, min])
def test_the_largest_and_smallest_of_one_and_of_none(results, choose):
    assert results.value("one", "", choose, quantity(2.0)).value == 2.0
    assert results.value("none", "", choose).value is None


def test_a_cell_that_is_not_there_says_why(results):
    soft = results.row["soft"]
    assert cell_or_absent(soft, "slip_mm", "mm") == soft.slip_mm
    for row, column in ((soft, "drift_mm"), (None, "slip_mm")):
        assert cell_or_absent(row, column, "mm", "it fell") == absent("mm", "it fell")
    later = replace(results, others={"toy": results})
    assert other_cell(later, "toy", "soft", "slip_mm", unit="mm") == soft.slip_mm
    for section, case, reason in (("toy", "firm", "does not say"), ("noise", "soft", "has no results here")):
        assert other_cell(later, section, case, "slip_mm", unit="mm").reason == f"section {section} {reason}"


def test_only_what_is_clearly_beyond_the_noise_is_named():
    found = {"a": quantity(0.21), "b": quantity(-0.3), "c": quantity(0.2), "d": quantity(None, "it fell")}
    assert beyond_noise(found, NOISE).striptags() == "a by 0.21\xa0mm, b by −0.30\xa0mm"
    assert beyond_noise(found, quantity(None, "it fell")) == Markup()


def test_a_script_is_not_compared_with_what_was_not_measured():
    def results_of(section: str, **others: Results) -> Results:
        path = Project("1.4.0").record_path(section)
        return Results(load_record(path), path, others)

    measured = results_of("reproduction")
    rows = [row for row in measured.record.rows if row["case"] != "stiff-pads"]
    incomplete = Results(replace(measured.record, rows=rows), measured.path)
    for others, reason in (({}, "has no results here"), ({"reproduction": incomplete}, "does not say")):
        claims = {claim.name: claim for claim in fix.derive(results_of("fix", **others)).claims}
        assert claims["same_as_report"].outcome == Outcome("unknown", f"section reproduction {reason}")


def test_what_gets_through_no_cycle_of_its_shake_keeps_no_cube():
    path = Project("1.4.0").record_path("stiffness")
    record = load_record(path)
    index = next(index for index, row in enumerate(record.rows) if row["case"] == "pad-ke-2.5e5")

    def is_held_with(**changed) -> bool:
        rows = [*record.rows[:index], record.rows[index] | changed, *record.rows[index + 1 :]]
        return is_held(Results(replace(record, rows=rows), path).row["pad-ke-2.5e5"])

    assert is_held_with()
    assert not is_held_with(cycle_count=None, cycle_count_reason="the shake is shorter than one cycle")
    assert not is_held_with(dropped=True)
