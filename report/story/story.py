"""The story of one release: the mechanism, what was suspected, and which releases need the fix."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup

from measured_report.files.config import config
from measured_report.findings.chapters import Releases
from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_least, at_most, decided, greater
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity
from report.sections.gap import CASES as CASES_OF_GAP
from report.sections.priority import CUBE
from report.sections.upgrade.ends import released
from report.shared.arithmetic import CASES, Sections
from report.shared.tables import table_of
from report.story import frontier
from report.story.figures import FIX, draw_mechanism, draw_setup, draw_suspects

SUSPECTS = {  # what was suspected, in the reader's words: section and value
    "friction": ("friction", "largest_share"),
    "who finds the contacts": ("contact_source", "largest_share"),
    "solver, its step and cone": ("solver", "largest_share"),
    "contact gap": ("gap", "slip_difference_share"),
    "the cube's ke and kd": ("priority", "cube_slip_share"),
}
COARSE = "a coarser solver, in MuJoCo C"
COARSER = [("lab", case, "slip_mm") for case in ("impratio-1", "substeps-4")]
ONE_THING = {"gap": CASES_OF_GAP, "priority": CUBE}  # cases of sections that derive no differences

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
        ("error_runtime", "stiff/c/cone-pyramidal", "grasp_error_mm_per_cycle"),  # by cycle, and not told apart by mm
    ],
}
UNSEEN, FAILED = Markup("not measured"), Markup("run failed")


def derive(releases: Releases, shown: str) -> Section:
    """Derive figures, table and claims of the story of the release ``shown``."""
    every = {
        release: Sections({section: chapter.results for section, chapter in chapters.items()})
        for release, chapters in released(releases, shown).items()
    }
    sections = every[shown]
    if "reproduction" not in sections.results:
        return Section()
    bound, dimensions = sections.value("reproduction", "slip_bound"), _dimensions(sections)
    needed = {way: [_advice(_slips(sections, way), bound) for sections in every.values()] for way in WAYS}
    named = map(config().short_name, every)
    tables = {"needed": table_of("release", named, needed), "setup": _setup(sections, dimensions)}
    slide = sections.cell("contacts", "as-shipped-missing-term", "slide_mm")
    figures = {"suspects": _suspects(sections), "mechanism": Figure(draw_mechanism, [slide])}
    figures["experiment"] = Figure(lambda: draw_setup(dimensions), list(dimensions.values()), dimensions)
    figures["frontier"] = frontier.figure(sections)
    claims = [*frontier.advice(sections, every), _fine_since(every, bound), _still_needed(every, bound)]
    claims += [_with_mujoco(sections, bound), _coarser_moves(sections)]
    return Section(tables=tables, figures=figures, claims=claims)


def _suspects(sections: Sections) -> Figure:
    shares = {label: sections.value(*place) for label, place in SUSPECTS.items()}
    fix = sections.value("reproduction", "stiff_share")
    shipped, stiff = (sections.cell("reproduction", case, "slip_mm") for case in CASES)
    bound = sections.value("friction", "cause_bound")
    slips = {label: _changed(sections, section) for label, (section, _) in SUSPECTS.items()}
    others = {COARSE: [sections.cell(*place) for place in COARSER], FIX: [stiff]}
    slips |= {label: cells for label, cells in others.items() if any(cell.source for cell in cells)}
    every = {**shares, FIX: fix}
    less = greater(shipped, stiff, noise=sections.value("noise", "slip_floor"))
    numbers = {
        "shares": Markup(", ").join(Markup("{} {}").format(*pair) for pair in every.items()),
        "ruled_out": all_of(*(at_most(share, bound) for share in shares.values()), at_least(fix, bound), less).answer,
        "moving": ", ".join(name for name, share in every.items() if share.value and at_least(share, bound) == HOLDS),
    }
    cells = [shipped, *(cell for some in slips.values() for cell in some)]
    return Figure(lambda: draw_suspects(slips, others, shipped, bound), cells, numbers)


def _changed(sections: Sections, section: str) -> list[Quantity]:
    """Look up the slips of a section's variants; what it has besides them is of another question."""
    if section not in sections.results:
        return []
    results = sections.results[section]
    variants = [row for row in results.rows if f"{row.case}_difference" in results.derived]
    return [row.slip_mm for row in variants or map(results.row.__getitem__, ONE_THING.get(section, ()))]


def _dimensions(sections: Sections) -> dict[str, Quantity]:
    names = {"edge": "cube_edge", "mass": "cube_mass", "amplitude": "amplitude", "frequency": "frequency"}
    numbers = {key: sections.value("reproduction", name) for key, name in names.items()}
    numbers["grip"] = sections.cell("stiffness", "pad-ke-2.5e3", "normal_force_n")
    return numbers | {"duration": sections.cell("reproduction", "as-shipped", "shake_duration_s")}


def _setup(sections: Sections, numbers: Mapping[str, Quantity]) -> Table:
    """Tell what stays as it is in every run that does not say otherwise."""

    def told(text: str, *names: str) -> Markup:
        return Markup(text).format(*(sections.value("reproduction", name) for name in names))

    stiff = sections.cell("stiffness", "pad-ke-2.5e5", "normal_force_n")
    lines = {
        "robot": Markup("Franka FR3 with its hand, gravity compensated"),
        "cube": told("edge {}, mass {}, friction {}", "cube_edge", "cube_mass", "cube_friction"),
        "finger pads": told("friction {}, ke {}, kd {}", "pad_friction", "pad_ke", "pad_kd"),
        "grip": Markup("{} from each pad, {} in stiff pads").format(numbers["grip"], stiff),
        "task": Markup("approach, descend, grasp, lift, then shake for {}").format(numbers["duration"]),
        "shake": told("{} to either side at {}, less along the other two axes", "amplitude", "frequency"),
        "time": told("frame rate {}, {} substeps a frame", "frame_rate", "substeps"),
        "solver": told("Newton, {} iterations; implicitfast; elliptic cone, impratio {}", "iterations", "impratio"),
        "contacts": Markup("found by Newton, once a frame"),
    }
    return table_of("part", lines, {"in every run": list(lines.values())})


def _slips(sections: Sections, way: str) -> list[Quantity]:
    return [sections.cell(*place) for place in WAYS[way]]


def _advice(slips: Sequence[Quantity], bound: Quantity) -> Markup:
    """Mark whether shipped pads keep the cube, and where they don't, whether stiff ones do."""
    before, after = slips
    if None in (before.value, bound.value):
        return FAILED if before.source else UNSEEN
    if before.value < bound.value:
        return Markup("✓ {}").format(before)
    if after.value is None or after.unit != bound.unit:
        return Markup("✗ {}").format(before)
    return Markup("✗ {}, stiff {}").format(before, "✗" if after.value >= bound.value else "✓")


def _fine_since(every: Mapping[str, Sections], bound: Quantity) -> Claim:
    slips = {release: _slips(sections, NEWTON)[0] for release, sections in every.items()}
    measured = {release: slip for release, slip in slips.items() if slip.source}
    slipping = [release for release, slip in measured.items() if at_least(slip, bound) == HOLDS]
    fine = [release for release in measured if release not in slipping]
    is_so = bool(slipping and fine) and list(measured) == [*slipping, *fine]
    numbers = {"until": slipping[-1] if slipping else "", "since": fine[0] if fine else ""}
    # Each release is looked at by itself: none is compared with another.
    return Claim("fine_since", all_of(*(decided(is_so, slip, bound) for slip in measured.values())), numbers)


def _still_needed(every: Mapping[str, Sections], bound: Quantity) -> Claim:
    slips = {way: [_slips(sections, way)[0] for sections in every.values()] for way in (MUJOCO, PYRAMID)}
    measured = {way: [slip for slip in cells if slip.source] for way, cells in slips.items()}
    seen = [at_least(slip, bound) for cells in measured.values() for slip in cells]
    outcome = all_of(*seen) if all(measured.values()) else Outcome("unknown", "not both were measured")
    pyramids = [release for release, slip in zip(every, slips[PYRAMID], strict=True) if slip.source]
    return Claim("still_needed", outcome, {"pyramids": " and ".join(map(config().short_name, pyramids))})


def _with_mujoco(sections: Sections, bound: Quantity) -> Claim:
    before, after = _slips(sections, MUJOCO)
    is_halved = None not in (before.value, after.value) and 2.0 * after.number <= before.number
    outcome = all_of(at_least(before, bound), decided(is_halved, before, after))
    return Claim("with_mujoco", outcome, {"before": before, "after": after})


def _coarser_moves(sections: Sections) -> Claim:
    shipped, *coarse = (sections.cell(*place) for place in (("lab", "as-shipped", "slip_mm"), *COARSER))
    bound = sections.value("friction", "cause_bound")
    is_measured = None not in (shipped.value, bound.value, *(slip.value for slip in coarse))
    least = max(0.01 * bound.value * shipped.value, shipped.noise or 0.0) if is_measured else 0.0
    moved = is_measured and all(abs(slip.value - shipped.value) >= least for slip in coarse)
    numbers = dict(zip(("shipped", "impratio", "steps"), (shipped, *coarse), strict=True))
    return Claim("coarser_moves", decided(moved, shipped, *coarse, bound), numbers)
