"""The story of one release: the mechanism, what was suspected, and which releases need the fix."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup

from measured_report.files.config import config
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
    table_of,
)
from report.story import frontier
from report.story.figures import draw_mechanism

NEWTON, PYRAMID, MUJOCO = "Newton's contacts", "pyramidal cone", "MuJoCo's contacts"
WAYS = {  # slips with shipped pads and with stiff ones, or how far these move in a cycle, by who finds the contacts
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
        ),  # by cycle, and not told apart by mm
    ],
}


def derive(releases: Releases, shown: str) -> Section:
    """Derive figures, table and claims of the story of the release ``shown``."""
    every = {
        release: Sections(
            {section: chapter.results for section, chapter in chapters.items()}
        )
        for release, chapters in released(releases, shown).items()
    }
    sections = every[shown]
    if "reproduction" not in sections.results:
        return Section()
    bound = sections.value("reproduction", "slip_bound")
    needed = {
        way: [_advice(_slips(sections, way), bound) for sections in every.values()]
        for way in WAYS
    }
    tables = {"needed": table_of("release", map(config().short_name, every), needed)}
    slide = sections.cell("contacts", "as-shipped-missing-term", "slide_mm")
    figures = {
        "mechanism": Figure(draw_mechanism, [slide]),
        "frontier": frontier.figure(sections),
    }
    claims = [
        *frontier.advice(sections, every),
        _fine_since(every, bound),
        _still_needed(every, bound),
    ]
    for name, way in (("with_mujoco", MUJOCO), ("with_pyramid", PYRAMID)):
        before, after = _slips(sections, way)
        is_halved = (
            None not in (before.value, after.value)
            and 2.0 * after.number <= before.number
        )
        outcome = all_of(
            at_least(before, bound),
            at_most(after, bound),
            decided(is_halved, before, after),
        )
        claims.append(Claim(name, outcome, {"before": before, "after": after}))
    return Section(
        tables=tables, figures=figures, claims=[*claims, _coarser_moves(sections)]
    )


def _slips(sections: Sections, way: str) -> list[Quantity]:
    return [sections.cell(*place) for place in WAYS[way]]


def _advice(slips: Sequence[Quantity], bound: Quantity) -> Markup:
    """Mark whether shipped pads keep the cube, and where they don't, whether stiff ones do."""
    before, after = slips
    if None in (before.value, bound.value):
        return Markup("lost or failed" if before.source else "not measured")
    if before.value < bound.value:
        return Markup("✓ {}").format(before)
    if after.value is None or after.unit != bound.unit:
        return Markup("✗ {}").format(before)
    return Markup("✗ {}, stiff {}").format(
        before, "✗" if after.value >= bound.value else "✓"
    )


def _fine_since(every: Mapping[str, Sections], bound: Quantity) -> Claim:
    slips = {
        release: _slips(sections, NEWTON)[0] for release, sections in every.items()
    }
    measured = {release: slip for release, slip in slips.items() if slip.source}
    slipping = [
        release for release, slip in measured.items() if at_least(slip, bound) == HOLDS
    ]
    fine = [release for release in measured if release not in slipping]
    is_so = bool(slipping and fine) and list(measured) == [*slipping, *fine]
    numbers = {
        "until": slipping[-1] if slipping else "",
        "since": fine[0] if fine else "",
    }
    # Each release is looked at by itself: none is compared with another.
    return Claim(
        "fine_since",
        all_of(*(decided(is_so, slip, bound) for slip in measured.values())),
        numbers,
    )


def _still_needed(every: Mapping[str, Sections], bound: Quantity) -> Claim:
    slips = {
        way: [_slips(sections, way)[0] for sections in every.values()]
        for way in (MUJOCO, PYRAMID)
    }
    measured = {
        way: [slip for slip in cells if slip.source] for way, cells in slips.items()
    }
    seen = [at_least(slip, bound) for cells in measured.values() for slip in cells]
    outcome = (
        all_of(*seen)
        if all(measured.values())
        else Outcome("unknown", "not both were measured")
    )
    pyramids = [
        release
        for release, slip in zip(every, slips[PYRAMID], strict=True)
        if slip.source
    ]
    *names, last = map(config().name_of, pyramids or [""])
    return Claim(
        "still_needed",
        outcome,
        {"pyramids": " and ".join(filter(None, (", ".join(names), last)))},
    )


def _coarser_moves(sections: Sections) -> Claim:
    shipped, *coarse = (
        sections.cell("lab", case, "slip_mm")
        for case in ("as-shipped", "impratio-1", "substeps-4")
    )
    bound = sections.value("friction", "cause_bound")
    is_measured = None not in (
        shipped.value,
        bound.value,
        *(slip.value for slip in coarse),
    )
    least = (
        max(0.01 * bound.value * shipped.value, shipped.noise or 0.0)
        if is_measured
        else 0.0
    )
    moved = is_measured and all(
        abs(slip.value - shipped.value) >= least for slip in coarse
    )
    numbers = dict(
        zip(("shipped", "impratio", "steps"), (shipped, *coarse), strict=True)
    )
    return Claim("coarser_moves", decided(moved, shipped, *coarse, bound), numbers)
