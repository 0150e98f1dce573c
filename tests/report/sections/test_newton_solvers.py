"""Test the claims about Newton's own solvers after a second measurement."""

from collections.abc import Mapping
from dataclasses import replace

import pytest
from deriving import assert_found, with_cells

from measured_report.records.record import Record
from measured_report.values.body import body_of
from measured_report.values.results import Results
from report.sections.newton_solvers import derive


def test_whose_slip_does_not_repeat_is_named_with_each_that_keeps_the_cube(editions):
    tracked = editions["1.8.0"].chapters["newton_solvers"].results

    def set_slips(record: Record, slips: Mapping[str, float]) -> Record:
        for case, slip in slips.items():
            record = with_cells(record, case, {"slip_mm": slip})
        return record

    slips = {"kamino-3cm": 0.2, "steel-points-held": 1, "xpbd-10cm": 4}
    first = set_slips(tracked.record, slips)

    def repeat(**slips: float) -> tuple[str, str]:
        again = set_slips(
            first, {case.replace("_", "-"): slip for case, slip in slips.items()}
        )
        again = replace(again, machine=first.machine | {"gpu_uuid": "another"})
        records = [first, again] if slips else [first]
        place = ("1.8.0", "newton_solvers")
        evidence = body_of({place: records}, tracked.columns).sections[place]
        section = derive(
            Results(first, tracked.path, tracked.others, evidence=evidence)
        )
        [claim] = [claim for claim in section.claims if claim.name == "slips_repeat"]
        return claim.outcome.answer, claim.numbers["solvers"]

    assert repeat() == ("cannot tell", "")
    assert repeat(xpbd_10cm=4.09) == ("holds", "")
    named = ("the opposite", "Kamino and in Steel without anchors")
    assert repeat(kamino_3cm=0.31, steel_points_held=0.8) == named
    assert repeat(vbd_3cm=100) == ("holds", ""), "it loses the cube"


GIVEN = {
    "warp-3cm": {"slip_mm": 0.33, "hand_amplitude_mm": 28},
    "*-3cm": {"hand_amplitude_mm": 28},
    "steel-*": {"slip_mm": 0.5},
    "steel-weight": {"slip_mm": 0.05},
    "kamino-*": {"slip_mm": 0.05},
    "steel-worlds-1": {"frame_ratio": 1.2},
    "steel-2ms": {"growth_per_s": -1e-05},
    "steel-points-2ms": {"growth_per_s": 0.004},
    "mujoco-2ms": {"growth_per_s": 0.035},
    "steel-held": {"slip_mm": 0.05, "friction_share": 0.2},
    "steel-3cm": {
        "hand_amplitude_mm": 29.4,
        "slip_mm": 0.05,
        "friction_share": 0.25,
        "peak_constraint_count": 33,
    },
    "*": {"ratio_resolution": 0.01},
    "kamino-2ms": {"growth_per_s": 1e-05},
    "kamino-worlds-1": {"frame_ratio": 20},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "offered": "holds",
                "steel_hand": 5,
                "others_hold": "holds",
                "others_hold/solvers": "Kamino and Steel",
                "others_hold/fastest": "Steel",
                "others_hold/faster": "",
                "steel_speedup": 0.833333,
                "kamino_speedup": 0.05,
                "hands_go_as_far": "holds",
                "steel_2ms": -0.001,
                "steel_stays": "holds",
                "slips_less": "holds",
                "strain": 80,
                "contacts_strain": "holds",
                "rows_overflow": "holds",
                "costs_more": "holds",
                "boxes/step of 2 ms/1": "not measurable",
                "boxes/step of 2 ms/2": 3.5,
                "boxes/step of 2 ms/0": "sinks in or lost",
            },
        ),
        (
            {"steel-3cm": {"hand_amplitude_mm": 31}, "warp-3cm": {"slip_mm": 0.02}},
            {
                "others_hold/solvers": "Kamino",
                "others_hold/fastest": "Kamino",
                "hands_go_as_far": "fails",
                "others_hold": "cannot tell",
                "slips_less": "the opposite",
            },
        ),
        (
            {"steel-weight": {"slip_mm": 0.11}, "xpbd-3cm": {"hand_amplitude_mm": 45}},
            {
                "others_hold/solvers": "Kamino",
                "hands_go_as_far": "fails",
                "hands_go_as_far/worst": "XPBD",
                "hands_go_as_far/is_farther": True,
            },
        ),
        (
            {
                "steel-weight": {"slip_mm": 0.14},
                "kamino-3cm": {"slip_mm": 0.14},
                "steel-worlds-1": {"frame_ratio": 1.005},
                "steel-2ms": {"growth_per_s": -3e-05},
            },
            {
                "others_hold": "fails",
                "others_hold/faster": "",
                "steel_stays": "fails",
            },
        ),
        (
            {
                "steel-worlds-1": {"frame_ratio": 0.8},
                "xpbd-3cm": {"hand_amplitude_mm": 20},
            },
            {
                "costs_more": "the opposite",
                "others_hold/faster": 1.25,
                "hands_go_as_far": "fails",
                "hands_go_as_far/is_farther": False,
            },
        ),
        (
            {
                "steel-points-2ms": {"growth_per_s": 1e-05},
                "steel-points-3cm": {"slip_mm": 1},
                "steel-points-10cm": {"slip_mm": 1},
                "steel-held": {"friction_share": 0.12},
            },
            {
                "steel_stays": "fails",
                "anchors_help": "holds",
                "contacts_strain": "fails",
            },
        ),
        (
            {
                "mujoco-2ms": {"growth_per_s": 1e-05},
                "steel-points-3cm": {"slip_mm": 1},
                "steel-points-10cm": {"slip_mm": 0.1},
                "steel-3cm": {"peak_constraint_count": 31},
            },
            {
                "steel_stays": "fails",
                "anchors_help": "the opposite",
                "rows_overflow": "fails",
            },
        ),
        (
            {"steel-32-rows-3cm": {"failure": None}, "steel-10cm": {"dropped": True}},
            {"rows_overflow": "fails", "fails_sooner": "holds"},
        ),
        (
            {"steel-10cm": {"dropped": False}, "warp-10cm": {"dropped": False}},
            {"fails_sooner": "fails", "fails_sooner/are_lost": False},
        ),
        (
            {"steel-10cm": {"dropped": False}, "warp-10cm": {"dropped": True}},
            {"fails_sooner": "the opposite"},
        ),
    ],
)
def test_newton_solvers_follows_from_its_cells(cells, expected):
    assert_found("newton_solvers", GIVEN, cells, expected=expected, release="1.8.0")


def test_a_run_that_lost_the_cube_or_failed_has_no_numbers_of_the_cube(editions):
    tracked = editions["1.8.0"].chapters["newton_solvers"].results
    tables = derive(Results(tracked.record, tracked.path, tracked.others)).tables
    frame = tables["shakes"].frame.drop(columns=["hand amplitude", "creep"])
    assert set(frame.loc["VBD"]) == {"lost"}
    assert set(frame.loc["Featherstone"]) == {"fails"}
