"""What sections derive, worked out by hand from a few cells."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from by_hand import lines_of, mismatches, read, releases_of, results_of, unbacked, unlike

from measured_report.findings.sections import derive_section
from measured_report.values.quantities import Quantity
from report.sections import envelope, reproduction, upgrade
from report.shared.arithmetic import Sections
from report.story import frontier, story

pytestmark = pytest.mark.usefixtures("unchanged")

BLOCKS = dict(block.split("]\n", 1) for block in Path(__file__).with_name("by_hand.txt").read_text()[1:].split("\n\n["))
"""Lines by section and release; those of ``upgrade`` and ``story`` are about several releases."""
OLD = """
    noise: speed:*.frame_ms=10 speed:*.frame_ms_p5=9.9 speed:*.frame_ms_p95=10.1 speed:*.repeat_count=1
    upgrade:as-shipped.slip_mm=6 upgrade:as-shipped.friction_timeconst_s=0 solver:cone-pyramidal.slip_mm=6
    upgrade:as-shipped-mujoco-contacts.slip_mm=6 reproduction:as-shipped-mujoco-c.slip_mm=6
    upgrade:as-shipped-friction-timeconst-on.slip_mm=0.35
"""
NEW = f"""{OLD}
    upgrade:as-shipped.slip_mm=0.3 upgrade:as-shipped.friction_timeconst_s=0.002 solver:cone-pyramidal.slip_mm=5.75
    upgrade:as-shipped-mujoco-contacts.slip_mm=6.2 reproduction:as-shipped-mujoco-c.slip_mm=6.28
    upgrade:as-shipped-friction-timeconst-off.slip_mm=5.9 upgrade:as-shipped-kf-off.slip_mm=5.8
"""
TOLD = """
    noise: stiffness: contacts: gap: priority: reproduction:as-shipped.slip_mm=6 reproduction:stiff-pads.slip_mm=0.3
    friction:largest_share=4 contact_source:largest_share=4 solver:largest_share=4 gap:slip_difference_share=4
    priority:cube_slip_share=4 lab:as-shipped.slip_mm=6 lab:impratio-1.slip_mm=6.61
    lab:substeps-4.slip_mm=5.39 upgrade:as-shipped-mujoco-contacts.slip_mm=6 solver:cone-pyramidal.slip_mm=6
    upgrade:stiff-pads-mujoco-contacts.slip_mm=0.9 cure:pyramidal-implicitfast-50-stiff-3cm-plain-rounded.slip_mm=0.5
    error_runtime:stiff/c/cone-pyramidal.grasp_error_mm_per_cycle=0.03 lab:cone-pyramidal.slip_mm=6
"""


@pytest.mark.parametrize("head", [head for head in BLOCKS if " " in head])
def test_what_sections_derive(head):
    wrong = [*mismatches(*head.split(), BLOCKS[head])]
    assert not wrong, "\n".join(wrong)


def test_what_releases_change():
    results = results_of("upgrade", "1.8.0", "")
    for _, given, expected in lines_of(BLOCKS["upgrade"]):
        derived = replace(results, derived={})
        found = upgrade.derive(derived, releases_of({"1.4.0": OLD, "1.5.0": OLD, "1.8.0": NEW + given}))
        assert list(unlike(expected, found, derived.derived)) == [], given
    found = upgrade.derive(
        results, releases_of({"1.4.0": OLD, "1.5.0": f"{OLD} upgrade:as-shipped.slip_mm=3", "1.8.0": NEW})
    )
    assert list(unlike("in_one_step=fails", found)) == [], "a slip that falls in two steps falls in no one"
    found = upgrade.derive(replace(results, derived={}), releases_of({"1.4.0": OLD, "1.8.0": NEW}))
    assert list(unlike("in_one_step=cannot_tell", found)) == [], "with no release between nobody knows"


def test_what_the_story_tells():
    fine = f"{TOLD} reproduction:as-shipped.slip_mm=0.3"
    for _, given, expected in lines_of(BLOCKS["story"]):
        found = story.derive(releases_of({"1.4.0": TOLD + given, "1.8.0": fine}), "1.4.0")
        assert list(unlike(expected, found)) == [], given


@pytest.mark.parametrize("head", [head for head in BLOCKS if " " in head])
def test_no_case_is_named_that_has_no_row(head):
    results = results_of(*head.split(), "")
    section = derive_section(results, {})
    cells = [cell for table in section.tables.values() for cell in table.frame.to_numpy().ravel()]
    numbers = [
        *results.derived.values(),
        *cells,
        *(each for claim in section.claims for each in claim.numbers.values()),
    ]
    lost = {each.reason for each in numbers if isinstance(each, Quantity) and "no single row" in each.reason}
    assert lost <= {"there is no single row of case discrete-20ms-pinch-2ms"}


def test_every_way_was_run_and_timed():
    found = Sections(
        {name: read(name, "1.8.0") for name in ("cure", "cure_cost", "error_runtime", "newton_solvers", "solver")}
    )
    found = Sections({**found.results, "reproduction": read("reproduction", "1.8.0"), "speed": read("speed", "1.8.0")})
    assert [way.name for way in frontier.WAYS if not way.slip(found).source] == []
    assert [way.name for way in frontier.WAYS if not way.ratios(found)] == ["VBD"], "which loses the cube"
    kept = {way.name: way.keeps(found, Quantity(1.0, "mm", "")).name for way in frontier.WAYS}
    assert (kept["as shipped"], kept["stiff pads"], kept["Steel"], kept["XPBD"]) == ("holds", "holds", "holds", "fails")


SIDES = ["as-shipped"] * 4 + ["stiff"] * 4
MAP = {"side": SIDES, "shake_amplitude_m": 2 * [0.01, 0.02, 0.01, 0.02], "shake_frequency_hz": 2 * [1.0, 1.0, 3.0, 3.0]}
MAP |= {"slip_mm": [2.0, 6.0, 4.0, 500.0, 1.0, 1.5, 1.0, 5.0], "dropped": [False] * 3 + [True] + [False] * 4}
MAP |= {"cube_height_m": [0.2, 0.16, 0.2, 0.01] + 4 * [0.2]}


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {},
            "map_gain_median=4 map_gain_least=2 map_gap_least=1 lost_as_shipped=1 lost_stiff=0 cells=4 map_gain=holds",
        ),
        ({}, "as_shipped_drops=holds stiff_pads_never_drop=holds maps/keeps=true"),
        ({}, "maps/shipped=1 maps/stiff=0"),
        ({("cube_height_m", 1): 0.14}, "lost_as_shipped=2 lost_stiff=0"),
        ({("cube_height_m", 6): 0.14}, "lost_stiff=1 stiff_pads_never_drop=fails maps/keeps=false maps/drops=true"),
        ({("cube_height_m", 3): 0.2}, "as_shipped_drops=fails maps/drops=false maps/keeps=true"),
        ({("slip_mm", 4): 2.1}, "map_gain_least=0.952381 map_gap_least=0.1 map_gain=fails"),
        ({("slip_mm", 4): 1.995}, "map_gain_least=1.002506 map_gain=cannot_tell"),
        ({("dropped", 1): True}, "map_gain_median=3"),
    ],
)
def test_what_a_map_tells(changes, expected):
    frame = pd.DataFrame(MAP)
    for (column, index), value in changes.items():
        frame.loc[index, column] = value
    results = replace(results_of("envelope", "1.4.0", "as-shipped-3cm-1hz.shake_frequency_hz=1"), frame=frame)
    section = envelope.derive(results)
    assert [*unlike(expected, section, results.derived), *unbacked("envelope", section)] == []


@pytest.mark.parametrize(("late", "change", "outcome"), [(1.09, 9, "holds"), (0.91, 9, "holds"), (1.12, 12, "fails")])
def test_a_steady_drift_moves_as_far_early_as_late(late, change, outcome):
    along = np.cumsum([0.0, 9.0, *4 * [1.0], 5.0, 5.0, *4 * [late]])
    frame = pd.DataFrame({"time_s": np.arange(len(along), dtype=float), "along_mm": along})
    results = replace(results_of("reproduction", "1.4.0", "as-shipped.shake_frequency_hz=1"), frame=frame)
    expected = f"increment_earlier=1 increment_later={late} steady_cycle_count=4 increment_change={change}"
    expected += f" increment_even={(7 + 2 * late) / 5} increment_odd={(7 + 2 * late) / 5} every_second_adds_more=fails"
    assert list(unlike(f"{expected} drift_is_steady={outcome}", reproduction.derive(results), results.derived)) == []
