"""Derive the story of a release: mechanism, recommended setup, and releases that need the fix."""

from markupsafe import Markup

from measured_report.findings.chapters import Releases
from report.sections.upgrade.ends import released
from report.shared import (
    CASES,
    HOLDS,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Section,
    Sections,
    all_of,
    at_least,
    at_most,
    decided,
    departure,
    sections_of,
    settings_of,
    table_of,
)
from report.story import frontier, frontier_figure, questions, steps
from report.story.figures import draw_mechanism

NEWTON = "Newton's contacts"
PYRAMID = "pyramidal cone"
MUJOCO = "MuJoCo's contacts"
# Cells with the slip of shipped and of stiff pads, or with their motion per cycle, by
# contacts and cone.
CONTACTS = {
    NEWTON: [("reproduction", case, "slip_mm") for case in CASES],
    PYRAMID: [
        ("solver", "cone-pyramidal", "slip_mm"),
        ("cure", "pyramidal-implicitfast-50-stiff-3cm-plain-rounded", "slip_mm"),
    ],
    MUJOCO: [("upgrade", f"{case}-mujoco-contacts", "slip_mm") for case in CASES],
    "both, in MuJoCo C": [
        ("lab", "cone-pyramidal", "slip_mm"),
        (
            "error_runtime",
            "stiff/c/cone-pyramidal",
            "grasp_error_mm_per_cycle",
        ),  # a motion per cycle, which is not compared with the bound in mm
    ],
}


def derive(releases: Releases, release: str) -> Section:
    """Derive the figures, the table and the claims in the story of one release."""
    releases = released(releases, release)
    by_release = {name: sections_of(chapters) for name, chapters in releases.items()}
    sections = by_release[release]
    if not {"reproduction", "contact_source", "cure_cost"} & sections.results.keys():
        return Section()
    bound = sections.value("reproduction", "slip_bound")
    slips = {  # of shipped and of stiff pads, in each release
        contacts: [
            [findings.cell(*place) for place in places]
            for findings in by_release.values()
        ]
        for contacts, places in CONTACTS.items()
    }
    needed = {
        contacts: [_advice(before, after, bound) for before, after in cells]
        for contacts, cells in slips.items()
    }
    shipped = {
        contacts: {
            name: before for name, (before, _) in zip(by_release, cells, strict=True)
        }
        for contacts, cells in slips.items()
    }
    measured = {
        contacts: {name: slip for name, slip in cells.items() if slip.source}
        for contacts, cells in shipped.items()
    }

    # Each release has its own test, because releases may be measured on different
    # machines.
    newton = measured[NEWTON]
    slipping = [name for name, slip in newton.items() if at_least(slip, bound) == HOLDS]
    fine = [name for name in newton if name not in slipping]
    is_ordered = bool(slipping and fine) and list(newton) == [*slipping, *fine]
    tests = [decided(is_ordered, slip, bound) for slip in shipped[NEWTON].values()]
    unmeasured = (test for test in tests if test.name == "unknown")
    fine_since = next(unmeasured, all_of(*tests))

    others = (measured[MUJOCO], measured[PYRAMID])
    is_needed = Outcome("unknown", "one of the two was not measured")
    if all(others):
        is_needed = all_of(
            *(at_least(slip, bound) for cells in others for slip in cells.values())
        )
    settings = settings_of(releases)
    *names, last = map(settings.name_of, measured[PYRAMID] or [""])
    pyramids = " and ".join(filter(None, (", ".join(names), last)))

    claims = [
        *frontier.advice(sections, by_release),
        Claim(
            "fine_since",
            fine_since,
            {
                "until": slipping[-1] if slipping else "",
                "since": fine[0] if fine else "",
                "bound": bound,
            },
        ),
        Claim("still_needed", is_needed, {"pyramids": pyramids}),
    ]
    for name, contacts in (("with_mujoco", MUJOCO), ("with_pyramid", PYRAMID)):
        before, after = slips[contacts][list(by_release).index(release)]
        is_halved = None not in (before.value, after.value)
        is_halved = is_halved and 2.0 * after.number <= before.number
        outcome = all_of(
            at_least(before, bound),
            at_most(after, bound),
            decided(is_halved, before, after),
        )
        claims.append(Claim(name, outcome, {"before": before, "after": after}))
    slide = sections.cell("contacts", "as-shipped-missing-term", "slide_mm")
    tables = {
        "needed": table_of("release", map(settings.short_name, by_release), needed)
    }
    if by_step := steps.table(sections):
        tables["steps"] = by_step
    return Section(
        tables=tables,
        figures={
            "mechanism": Figure(draw_mechanism, [slide]),
            "frontier": frontier_figure.figure(sections),
            "questions": questions.figure(sections),
        },
        claims=[*claims, _coarser_moves(sections)],
        unmeasured=() if by_step else ("steps",),
    )


def _advice(before: Quantity, after: Quantity, bound: Quantity) -> Markup:
    """Mark whether shipped pads keep the cube, and if not, whether stiff pads do."""
    if None in (before.value, bound.value):
        return Markup("lost or failed" if before.source else "not measured")
    if before.value < bound.value:
        return Markup("✓ {}").format(before)
    if after.value is None or after.unit != bound.unit:
        return Markup("✗ {}").format(before)
    mark = "✗" if after.value >= bound.value else "✓"
    return Markup("✗ {}, stiff {}").format(before, mark)


def _coarser_moves(sections: Sections) -> Claim:
    """Test whether a coarser solver changes the slip by more than a cause would."""
    cases = {"shipped": "as-shipped", "impratio": "impratio-1", "steps": "substeps-4"}
    slips = {
        name: sections.cell("lab", case, "slip_mm") for name, case in cases.items()
    }
    bound = sections.value("friction", "cause_bound")
    shipped, *coarse = slips.values()
    tests = [at_least(departure(slip, shipped), bound) for slip in coarse]
    return Claim("coarser_moves", all_of(*tests).having_read(*slips.values()), slips)
