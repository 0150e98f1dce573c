"""Test that the verdicts on public advice follow from the measured cells."""

import pytest
from deriving import changed, chapters_with, found_in, only, read

from measured_report.parts.claim import Outcome
from report.shared.arithmetic import Sections
from report.story import advice
from report.story.public_advice import ADVICE, SOURCES
from report.story.trials import Advice, Symptom, Trial, Verdict, is_lost

BY_NAME = {each.name: each for each in ADVICE}
MEASURED = {"reproduction": {}, "friction": {}}


def verdicts(*changes) -> dict[str, str]:
    """Return the outcome of each claim, and below `table` the verdicts as printed."""
    section = advice.derive(chapters_with(MEASURED, *changes))
    found = found_in(section)
    for table in section.tables.values():
        names = table.frame.index
        for name, verdict in zip(names, table.frame["verdict"], strict=True):
            found[f"table/{name.partition('<')[0]}"] = verdict.striptags()
    return found


@pytest.mark.parametrize(
    ("before", "after", "answer", "printed"),
    [
        # With a bound of 10 %, 6 mm have to fall to 5.4 mm or rise to 6.6 mm.
        ({}, {"slip_mm": 5.3}, "holds", "helps"),
        ({}, {"slip_mm": 5.5}, "fails", "does nothing"),
        ({}, {"slip_mm": 6.5}, "fails", "does nothing"),
        ({}, {"slip_mm": 6.7}, "the opposite", "makes it worse"),
        # The noise of a slip is 0.001 mm here, so the interval contains the bound.
        ({}, {"slip_mm": 5.4}, "cannot tell", "cannot tell"),
        ({}, {"slip_mm": 6.6}, "cannot tell", "cannot tell"),
        ({}, {"slip_mm": None, "dropped": True}, "the opposite", "makes it worse"),
        ({"slip_mm": None, "dropped": True}, {"slip_mm": 9.0}, "holds", "helps"),
        ({"failure": "not finite"}, {"failure": "not finite"}, "fails", "does nothing"),
        ({}, {"slip_mm": None}, "cannot tell", "not measured here"),
    ],
)
def test_a_verdict_follows_from_two_cells(before, after, answer, printed):
    cells = {"pad-mu-1": {"slip_mm": 6.0} | before, "pad-mu-10": after}
    found = verdicts({"friction": cells})
    words = BY_NAME["raise_mu"].words
    assert found["raise_mu"] == answer
    assert found[f"table/{words}"] == printed


def decided(*answers: Outcome) -> Verdict:
    trials = [Trial("s", "a", "b", where) for where in "xyz"[: len(answers)]]
    row = Advice("row", Symptom.SLIPS, "Do it", "slip", tuple(trials))
    return Verdict(row, dict(zip(trials, answers, strict=True)))


HELPS = Outcome("holds")
NOTHING = Outcome("fails")
WORSE = Outcome("fails", is_opposite=True)
UNSURE = Outcome("unknown", "noise", is_inconclusive=True)
UNMEASURED = Outcome("unknown", "not measured")


@pytest.mark.parametrize(
    ("answers", "answer", "printed"),
    [
        ((HELPS, HELPS), "holds", "helps"),
        ((WORSE, WORSE), "the opposite", "makes it worse"),
        ((HELPS, UNMEASURED), "holds", "helps"),
        ((HELPS, UNSURE), "cannot tell", "cannot tell"),
        ((HELPS, NOTHING), "fails", "depends: helps (x); does nothing (y)"),
        ((WORSE, NOTHING), "fails", "depends: makes it worse (x); does nothing (y)"),
        (
            (HELPS, WORSE, UNSURE),
            "fails",
            "depends: helps (x); makes it worse (y); cannot tell (z)",
        ),
        ((UNMEASURED, UNMEASURED), "cannot tell", "not measured here"),
        ((), "cannot tell", "not measured here"),
    ],
)
def test_a_verdict_on_several_trials_names_the_conditions(answers, answer, printed):
    verdict = decided(*answers)
    assert verdict.outcome.answer == answer
    assert verdict.html().striptags() == printed


def test_each_row_has_a_source_and_a_claim():
    assert len(ADVICE) == len(BY_NAME) >= 25
    assert {each.symptom for each in ADVICE} == {*Symptom}
    assert {each.source for each in ADVICE} == {*SOURCES}
    assert all(source.url.startswith("https://") for source in SOURCES.values())
    assert all(source.version for source in SOURCES.values())
    section = advice.derive(chapters_with(MEASURED))
    assert [claim.name for claim in section.claims] == [*BY_NAME]
    assert sum(len(table.frame) for table in section.tables.values()) == len(ADVICE)


@pytest.fixture(scope="module")
def newest() -> Sections:
    names = {trial.section for each in ADVICE for trial in each.trials}
    costs = {each.cost.partition("/")[0] for each in ADVICE if each.cost}
    names |= costs
    return Sections({name: read(name, "1.8.0") for name in names})


def test_each_run_and_each_run_time_was_measured(newest):
    lacking = [
        (each.name, trial.before, trial.after)
        for each in ADVICE
        for trial in each.trials
        if not trial.rows(newest)
    ]
    assert lacking == []
    untimed = [each.name for each in ADVICE if each.cost and not each.run_times(newest)]
    assert untimed == []


def test_each_verdict_flips_with_its_cells(newest):
    """Halve and double the number of the second run of each trial."""
    bound = newest.value("friction", "cause_bound")
    for each in ADVICE:
        for trial in each.trials:
            before, _ = trial.rows(newest)
            number = 1.0 if is_lost(before) else before[trial.column].number
            answers = []
            for factor in (0.5, 1.0, 2.0):
                held = {"dropped": False, "class": "creeping", "failure": None}
                cells = {trial.column: factor * number, **held}
                results = changed(newest.results[trial.section], {trial.after: cells})
                found = Sections({**newest.results, trial.section: results})
                answers.append(trial.outcome(found, bound).answer)
            expected = ["holds", "fails", "the opposite"]
            if is_lost(before):
                expected = ["holds"] * 3
            assert answers == expected, (each.name, trial)


RECORDED = {
    "1.4.0": {
        "raise_mu": "fails",
        "impratio": "fails",
        "tolerance": "fails",
        "penetration": "holds",
        "mujoco_contacts": "fails",
        "more_substeps": "the opposite",
        "friction_gain": "cannot tell",  # this release does not read kf
        "hydroelastic": "fails",
    },
    "1.8.0": {
        "raise_mu": "fails",
        "elliptic": "holds",
        "impedance": "the opposite",
        "mujoco_contacts": "the opposite",
        "more_substeps": "holds",
        "smaller_step": "holds",
        "runge_kutta": "the opposite",
    },
    "1.6.1": {"raise_mu": "cannot tell", "mujoco_contacts": "the opposite"},
}


def test_verdicts_of_the_tracked_records(editions):
    for release, expected in RECORDED.items():
        found = found_in(advice.derive(editions[release].chapters))
        assert only(found, expected) == expected, release
