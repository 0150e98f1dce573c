"""Offer the fix as downloads, with the slip that was measured with these files."""

from experiments.facts.case import STIFF_PADS
from experiments.facts.fix_files import fix_files
from report.shared import (
    MS_PER_S,
    SETTLES,
    SUBSTEP_S,
    Claim,
    Results,
    Section,
    Sections,
    all_of,
    at_least,
    at_most,
    constant,
    decided,
    departure,
)

order = 140
page = "fix"
reads = ("stiffness",)
first = True
label = "the fix as files"


def derive(results: Results) -> Section:
    shipped = results.row["as-shipped"]
    fixed = results.row["fixed"]
    gain = results.value(
        "gain",
        "slip as shipped over slip with the fix",
        shipped.slip_mm / fixed.slip_mm,
    )
    passes = [row.exit_status.value == 0 for row in (shipped, fixed)]
    holds = all_of(at_least(gain, *SETTLES), decided(passes[1], fixed.slip_mm))
    # A script that crashes also fails, but it has no slip, so that the claim cannot
    # tell.
    tells = decided(passes == [False, True], shipped.slip_mm, fixed.slip_mm)
    before, after = ("passes" if is_passed else "fails" for is_passed in passes)

    # The engine does not use a timeconst of less than two steps, which limits the
    # hardness.
    step = Sections(results.others).value("stiffness", "substep")
    if step.value is None:
        step = results.value(
            "substep",
            "given by the scene: frame time over substeps",
            SUBSTEP_S,
        )
    dt = results.value("step_ms", "the substep", MS_PER_S * step)
    least_kd = results.value(
        "step_kd",
        "kd with a timeconst, 2 / kd, of two steps",
        constant(1, "s") / step,
    )
    least_ke = results.value(
        "step_ke",
        "ke with a damping ratio, kd / (2 √ke), of 1",
        least_kd * least_kd / 4,
    )
    numbers = {"dt": dt, "least_kd": least_kd, "least_ke": least_ke}
    tests = []
    for name, patched, least in (
        ("kd", STIFF_PADS.pad_kd, least_kd),
        ("ke", STIFF_PADS.pad_ke, least_ke),
    ):
        numbers[name] = results.value(
            f"patch_{name}",
            f"given: {name} of the stiff pads, which the patch sets",
            constant(patched),
        )
        off = results.value(
            f"patch_{name}_off",
            f"absolute difference between the {name} of the patch and the least one,"
            " relative to the latter",
            departure(numbers[name], least),
        )
        tests += [
            at_least(numbers[name], least),
            at_most(off, 10.0, "a rounded number"),
        ]
    return Section(
        claims=[
            Claim(
                "recommended",
                holds,
                {"before": shipped.slip_mm, "after": fixed.slip_mm},
            ),
            Claim("patch_rounds_up", all_of(*tests), numbers),
            Claim("test_tells", tells, {"before": before, "after": after}),
        ],
        downloads=fix_files(),
    )
