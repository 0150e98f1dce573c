"""Test the statements of the investigation that this report follows."""

from measured_report.findings.chapters import Chapters
from report.shared import Claim, Outcome, Section, all_of, sections_of

SHIPPED = "reproduction/as-shipped/"
STIFF = "reproduction/stiff-pads/"
HELD = "hold/hold-60s/"
SOURCE = "contact_source/"
DRIFT = "cure/{}_drift"
# By name: the claims that decide a statement, and the cells and values that its wording
# prints.
STATEMENTS = {
    "drifts": (
        "reproduction.slips reproduction.drift_is_steady",
        f"{SHIPPED}slip_mm",
        f"{SHIPPED}drift_mm_s",
    ),
    "not_friction": ("friction.not_the_cause", "friction/largest_share"),
    "not_solver": (
        "solver.not_the_cause solver.solver_has_converged",
        "solver/largest_share",
    ),
    "not_contacts": ("contact_source.not_the_cause", f"{SOURCE}largest_share"),
    "pads_and_engine": (
        "contact_source.not_the_cause",
        *(
            f"{SOURCE}{case}/slip_mm"
            for case in ("pads-convex-mesh", "engine-mujoco-c")
        ),
    ),
    "stiff_pads": (
        "reproduction.stiff_pads_hold",
        f"{STIFF}slip_mm",
        f"{SHIPPED}slip_mm",
    ),
    "not_rectified": (
        "cure.only_turning_creeps cure.joints_turn stiffness.not_creep_under_load",
        *map(DRIFT.format, ("straight", "turning")),
    ),
    "static_creep": ("hold.creep_goes_on", f"{HELD}slip_mm", f"{HELD}shake_duration_s"),
}


def derive(chapters: Chapters) -> Section:
    sections = sections_of(chapters)
    tests = {
        f"{name}.{claim.name}": claim
        for name, chapter in chapters.items()
        for claim in chapter.section.claims
    }
    unmeasured = Claim("unmeasured", Outcome("unknown", "it was not measured"))
    claims = []
    for name, (needs, *places) in STATEMENTS.items():
        deciding = [tests.get(need, unmeasured) for need in needs.split()]
        cells = []
        for place in places:
            parts = place.split("/")
            get = sections.cell if len(parts) > 2 else sections.value
            cells.append(get(*parts))
        outcome = all_of(*(claim.outcome for claim in deciding)).having_read(*cells)
        numbers = dict(zip(("first", "second"), cells, strict=False))
        claims.append(Claim(name, outcome, numbers))
    return Section(claims=claims)
