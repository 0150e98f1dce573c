"""The story of one release: from the scene to the cause, the fix and what stays open."""

from dataclasses import replace

import pandas as pd
from markupsafe import Markup

from measured_report.claims.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.deriving.chapters import Chapters
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity
from report.story.figures import draw_mechanism, draw_suspects, draw_walk
from report.story.found import Found
from report.story.shared import gain, remedy_elsewhere, substeps

SUSPECTS = (
    ("friction", "largest_share", "pads and cube, lower and higher"),
    ("contact_source", "largest_share", "more often, by another code, on other shapes"),
    ("solver", "largest_share", "iterations, tolerance, impratio, cone, smaller steps"),
    ("gap", "slip_difference_share", "as the robot's, and none"),
    ("priority", "cube_slip_share", "ke lower and higher"),
)
"""What was suspected: section, value, and what was tried."""
REMEDY = "stiff pads"
TOLD = {
    "walks": ("reproduction", "slips"),
    "steady": ("reproduction", "drift_is_steady"),
    "needs_shake": ("reproduction", "needs_shaking"),
    "held": ("reproduction", "moves_little_when_held"),
    "friction": ("friction", "less_friction_slips_no_more"),
    "contact_points": ("contact_source", "not_the_cause"),
    "solver": ("solver", "not_the_cause"),
    "gap": ("gap", "not_the_cause"),
    "material": ("priority", "cube_does_not_count"),
    "noslip": ("noslip", "noslip_does_not_help_in_mujoco_c"),
    "grip": ("contacts", "far_inside_cone"),
    "no_memory": ("contacts", "no_friction_residual"),
    "slide": ("contacts", "slide_accounts"),
    "slide_stiff": ("contacts", "slide_accounts_when_stiff"),
    "rest": ("contacts", "rest_is_creep"),
    "left_out": ("contacts", "term_restored"),
    "missing": ("contacts", "missing_term"),
    "restored": ("contacts", "term_restored"),
    "law": ("stiffness", "drift_follows_timeconst"),
    "remedy": ("stiffness", "together_they_hold"),
    "ke_alone": ("stiffness", "ke_alone_does_not_help"),
    "clamp": ("stiffness", "flat_below_clamp"),
    "harder": ("envelope", "stiff_pads_never_drop"),
    "gravity": ("stability", "gravities"),
    "files": ("fix", "recommended"),
    "release": ("upgrade", "slip_is_the_same"),
    "own_timeconst": ("upgrade", "friction_timeconst_is_new"),
    "leans": ("stability", "leans_on_clamp"),
    "taken_away": ("upgrade", "taking_it_away_brings_it_back"),
    "creeps": ("hold", "creep_goes_on"),
    "rounding": ("hold", "creep_is_rounding"),
    "not_rigid": ("error_runtime", "pads_decide"),
    "small_cubes": ("stability", "sizes"),
}
"""Claims of the story that retell a section's claim: section and name."""
ASKED = (
    ("contacts", "slide_falls_less_than_displacement"),
    ("error_runtime", "impratio"),
    ("stability", "safe_settings"),
    ("upgrade", "mujoco_contacts_as_before"),
    ("upgrade", "pyramid_as_before"),
)
"""Others that have to be there."""
OF_A_SLIP, OF_A_HOLD = {"law", "ke_alone", "clamp"}, {"leans", "substeps", "remedy_elsewhere"}
"""Those that say something only where the cube slips with shipped pads, and only where it does not."""


def derive(chapters: Chapters) -> Section:
    """Derive figures, table of suspects and claims of the story; nothing where a part of it was not measured."""
    found = Found(chapters)
    if any(found.claim(*place) is None for place in (*TOLD.values(), *ASKED)):
        return Section()
    unsaid = OF_A_HOLD if found.does_slip else OF_A_SLIP
    told = {name: place for name, place in TOLD.items() if name not in unsaid}
    claims = [found.retold(name, *place) for name, place in told.items()]
    impratio = found.retold("impratio", "error_runtime", "impratio", {"kept": found.value("reproduction", "impratio")})
    own = [_cube_moves(found), _safe(found), gain(found), impratio, _elsewhere(found)]
    own += [] if found.does_slip else [substeps(found), remedy_elsewhere(found)]
    return Section(
        tables={"suspects": _suspect_table(found)},
        figures={"walk": _walk(found), "suspects": _suspect_figure(found), "mechanism": _mechanism(found)},
        claims=[found.titled("title"), *claims, *own],
        unmeasured=unsaid,
    )


def _safe(found: Found) -> Claim:
    """The ke of stiff pads lies between the least and the largest at which every step keeps the cube."""
    told = found.retold("safe", "stability", "safe_settings")
    most = found.value("stability", "safe_ke_most")
    outcome = all_of(told.outcome, at_least(most, told.numbers["stiff"]))
    return replace(told, outcome=outcome, numbers={**told.numbers, "most": most})


def _elsewhere(found: Found) -> Claim:
    """With other contacts and another cone the slip is as before, and one that can be seen."""
    mujoco = found.retold("elsewhere", "upgrade", "mujoco_contacts_as_before")
    pyramid = found.retold("pyramid", "upgrade", "pyramid_as_before")
    slips = {"found": mujoco.numbers["found"], "pyramid": pyramid.numbers["after"]}
    bound = found.value("reproduction", "slip_bound", "mm")
    seen = (at_least(slip, bound) for slip in slips.values())
    return replace(mujoco, outcome=all_of(mujoco.outcome, pyramid.outcome, *seen), numbers=slips)


def _cube_moves(found: Found) -> Claim:
    """The cube moves, and the robot's own bodies don't."""
    moves = found.retold("cube_moves", "frames", "cube_moves_in_fingers")
    still = found.retold("robot", "frames", "robot_is_still")
    numbers = {**moves.numbers, "robot": still.numbers["largest"]}
    return replace(moves, outcome=all_of(moves.outcome, still.outcome), numbers=numbers)


def _walk(found: Found) -> Figure:
    cases = ("as-shipped", "stiff-pads", "hold")
    traces = {case: found.trace("reproduction", case) for case in cases}
    slips = {case: found.cell("reproduction", case, "slip_mm", "mm") for case in cases}
    bound = found.value("reproduction", "slip_bound", "mm")
    numbers = dict(zip(("shipped", "stiff", "hold"), slips.values(), strict=True)) | {
        "walks": found.does_slip and found.does_hold,
        "stays": all(at_most(slips[case], bound) == HOLDS for case in cases[:2]),
    }
    return Figure(draw=lambda: draw_walk(traces, slips), sources=list(traces.values()), numbers=numbers)


def _shares(found: Found) -> dict[str, Quantity]:
    labels = {section: found.chapters[section].results.label for section, _, _ in SUSPECTS}
    labels |= {"priority": "cube's material"}
    shares = {labels[section]: found.value(section, value, "%") for section, value, _ in SUSPECTS}
    return shares | {REMEDY: found.value("reproduction", "stiff_share", "%")}


def _suspect_figure(found: Found) -> Figure:
    shares = _shares(found)
    bound, noise = found.value("friction", "cause_bound", "%"), found.value("noise", "slip_floor_share", "%")
    numbers = {
        "remedy": shares[REMEDY],
        "shares": Markup(", ").join(Markup("{} {}").format(name, share) for name, share in shares.items()),
        "ruled_out": all_of(*(at_most(share, bound) for name, share in shares.items() if name != REMEDY)).said,
    }
    return Figure(lambda: draw_suspects(shares, REMEDY, bound, noise), list(shares.values()), numbers)


def _suspect_table(found: Found) -> Table:
    shares = _shares(found)
    tried = [what for _, _, what in SUSPECTS]
    columns = {"what was tried": [*tried, "ke and kd raised together"], "largest change in slip": list(shares.values())}
    return Table(pd.DataFrame(columns, index=pd.Index(list(shares), name="suspect")))


def _mechanism(found: Found) -> Figure:
    """A drawing, of which the measured part is what the left-out acceleration makes of slide."""
    slide = found.cell("contacts", "as-shipped-missing-term", "slide_mm", "mm")
    return Figure(draw=draw_mechanism, sources=[slide], numbers={"slips": found.does_slip})
