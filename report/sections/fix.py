"""The fix as a download: do the very files that are offered do what they promise?"""

import pandas as pd

from experiments.facts.case import STIFF_PADS
from experiments.facts.fix_files import fix_files
from measured_report.claims.claims import Claim, all_of, at_least, at_most, decided
from measured_report.parts.parts import Download, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import SETTLES, departure, other_cell, other_value, ratio

order = 140
page = "fix"
label = "the fix as files"

ENGINES = {"warp": "MuJoCo Warp", "mujoco": "MuJoCo C"}
PASSED = {True: "passes", False: "fails"}
SAME_IN_REPORT = {"as-shipped": "as-shipped", "fixed": "stiff-pads"}
"""Case of the first section that each script must repeat."""


def derive(results: Results) -> Section:
    shipped, fixed = results.row["as-shipped"], results.row["fixed"]
    gain = _gain(results, "gain", shipped, fixed)
    bound = results.chosen("gain_bound", *SETTLES)
    return Section(
        tables={"runs": _table(results)},
        claims=[
            _recommended(shipped, fixed, gain, bound),
            _patch_rounds_up(results),
            _test_tells(shipped, fixed),
            _same_on_mujoco_c(results, bound),
            _same_as_report(results),
        ],
        downloads=[Download(name, text) for name, text in fix_files().items()],
    )


def test_passed(row: Row) -> bool:
    return row.exit_status.value == 0


def _recommended(shipped: Row, fixed: Row, gain: Value, bound: Value) -> Claim:
    passes = decided(test_passed(fixed), fixed.slip_mm)
    return Claim(
        "recommended",
        all_of(at_least(gain, bound), passes),
        numbers={"before": shipped.slip_mm, "after": fixed.slip_mm, "gain": gain},
    )


def _patch_rounds_up(results: Results) -> Claim:
    """The patch's ke and kd against those beyond which the engine, whose shortest timeconst is two steps, makes no
    contact harder."""
    step = other_value(results, "stiffness", "substep", unit="s")
    results.value("step_ms", "the same in ms", lambda step: 1e3 * step, step, unit="ms")
    least_kd = results.value("step_kd", "kd of which two steps are the timeconst, 2 / kd", lambda step: 1 / step, step)
    least_ke = results.value("step_ke", "ke with which the damping ratio, kd / (2 √ke), is 1", _critical_ke, least_kd)
    kd = results.value("patch_kd", "given: kd of the stiff pads, which the patch sets", lambda: STIFF_PADS.pad_kd)
    ke = results.value("patch_ke", "given: ke of the stiff pads, which the patch sets", lambda: STIFF_PADS.pad_ke)
    bound = results.chosen("rounding_bound", "rounded", 10.0, unit="%")
    off = [
        departure(results, "patch_kd_off", "how far the patch's kd is from that", kd, least_kd),
        departure(results, "patch_ke_off", "how far the patch's ke is from that", ke, least_ke),
    ]
    outcome = all_of(at_least(kd, least_kd), at_least(ke, least_ke), *(at_most(each, bound) for each in off))
    return Claim("patch_rounds_up", outcome, numbers={"kd": kd, "ke": ke, "bound": bound})


def _critical_ke(kd: float) -> float:
    return kd**2 / 4


def _test_tells(shipped: Row, fixed: Row) -> Claim:
    """A script that breaks down has no slip and fails its test for another reason."""
    is_told = test_passed(fixed) and not test_passed(shipped)
    return Claim(
        "test_tells",
        decided(is_told, shipped.slip_mm, fixed.slip_mm),
        numbers={"before": PASSED[test_passed(shipped)], "after": PASSED[test_passed(fixed)]},
    )


def _same_on_mujoco_c(results: Results, bound: Value) -> Claim:
    shipped, fixed = results.row["as-shipped-mujoco-c"], results.row["fixed-mujoco-c"]
    gain = _gain(results, "gain_mujoco_c", shipped, fixed)
    return Claim(
        "same_on_mujoco_c",
        at_least(gain, bound),
        numbers={"before": shipped.slip_mm, "after": fixed.slip_mm, "gain": gain, "bound": bound},
    )


def _same_as_report(results: Results) -> Claim:
    """The scripts are a second writing of the scene, so they have to prove that they are the same one."""
    slips = [
        slip
        for case, same in SAME_IN_REPORT.items()
        for slip in (results.row[case].slip_mm, other_cell(results, "reproduction", same, "slip_mm", unit="mm"))
    ]
    difference = results.value(
        "difference",
        "largest difference in slip between a script and the same case of the section reproduction",
        lambda *found: max(abs(a - b) for a, b in zip(found[::2], found[1::2], strict=True)),
        *slips,
        unit="mm",
    )
    bound = results.chosen("difference_bound", "the calibration's tolerance", 0.03, unit="mm")
    return Claim("same_as_report", at_most(difference, bound), numbers={"difference": difference, "bound": bound})


def _gain(results: Results, name: str, shipped: Row, fixed: Row) -> Value:
    formula = f"slip of {shipped.case} over slip of {fixed.case}"
    return ratio(results, name, formula, shipped.slip_mm, fixed.slip_mm)


def _table(results: Results) -> Table:
    rows = results.rows
    columns = {
        "engine": [ENGINES.get(row.backend, row.backend) for row in rows],
        "its test": [PASSED[test_passed(row)] for row in rows],
        "slip": [row.slip_mm for row in rows],
        "drift": [row.drift_mm_s for row in rows],
        "dropped": [row.dropped for row in rows],
    }
    index = pd.Index([row.script for row in rows], name="file")
    return Table(pd.DataFrame(columns, index=index))
