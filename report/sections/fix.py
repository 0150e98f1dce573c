"""The fix as a download: do the very files that are offered do what they promise?"""

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.facts.fix_files import fix_files
from report.shared import (
    MS_PER_S,
    SETTLES,
    Claim,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    constant,
    decided,
    departure,
    other_value,
)

order = 140
page = "fix"
reads = ("stiffness",)
first = True
label = "the fix as files"


def derive(results: Results) -> Section:
    shipped = results.row["as-shipped"]
    fixed = results.row["fixed"]
    bound = results.chosen("gain_bound", *SETTLES)
    gain = results.value(
        "gain", "slip of as-shipped over slip of fixed", shipped.slip_mm / fixed.slip_mm
    )
    passes = [row.exit_status.value == 0 for row in (shipped, fixed)]
    holds = all_of(at_least(gain, bound), decided(passes[1], fixed.slip_mm))
    # A script that breaks down has no slip, and fails the test for another reason.
    tells = decided(passes == [False, True], shipped.slip_mm, fixed.slip_mm)
    before, after = ("passes" if is_passed else "fails" for is_passed in passes)

    # Two steps are the shortest timeconst: no contact is harder.
    step = other_value(results, "stiffness", "substep")
    if step.value is None:
        step = results.value(
            "substep",
            "given by the scene: frame time over substeps",
            constant(1 / 60 / AS_SHIPPED.substeps, "s"),
        )
    dt = results.value("step_ms", "the same in ms", MS_PER_S * step)
    least_kd = results.value(
        "step_kd",
        "kd of which two steps are the timeconst, 2 / kd",
        constant(1, "s") / step,
    )
    least_ke = results.value(
        "step_ke",
        "ke with which the damping ratio, kd / (2 √ke), is 1",
        least_kd * least_kd / 4,
    )
    rounded = results.chosen("rounding_bound", "rounded", 10.0, "%")
    numbers = {"dt": dt, "least_kd": least_kd, "least_ke": least_ke}
    tests = []
    for name, given, least in (
        ("kd", STIFF_PADS.pad_kd, least_kd),
        ("ke", STIFF_PADS.pad_ke, least_ke),
    ):
        numbers[name] = results.value(
            f"patch_{name}",
            f"given: {name} of the stiff pads, which the patch sets",
            constant(given),
        )
        off = results.value(
            f"patch_{name}_off",
            f"how far the patch's {name} is from that",
            departure(numbers[name], least),
        )
        tests += [at_least(numbers[name], least), at_most(off, rounded)]
    slips = {"before": shipped.slip_mm, "after": fixed.slip_mm}
    return Section(
        claims=[
            Claim("recommended", holds, slips),
            Claim("patch_rounds_up", all_of(*tests), numbers),
            Claim("test_tells", tells, {"before": before, "after": after}),
        ],
        downloads=fix_files(),
    )
