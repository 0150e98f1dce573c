"""Claims that the front page and the story both make, each in words of its own."""

from measured_report.claims.claim import HOLDS, Claim, Outcome, all_of, at_least, decided, greater
from measured_report.values.quantities import Quantity
from report.story.found import Found


def gain(found: Found) -> Claim:
    """Whether stiff pads gain more at the shipped step than with its error removed, both in MuJoCo C."""
    coarse, converged = (found.value("error_runtime", name) for name in ("pads_gain_shipped_step", "pads_gain"))
    same = found.value("error_runtime", "pads_gain_same")
    hides = found.claim("contacts", "slide_falls_less_than_displacement")
    numbers: dict[str, Quantity | bool]
    numbers = {"coarse": coarse, "converged": converged, "substeps": found.value("reproduction", "substeps")}
    numbers["hides"] = bool(hides and hides.numbers["hides"])
    return Claim("gain", greater(coarse, converged, noise=same), numbers)


def substeps(found: Found) -> Claim:
    """Whether the slip falls with the step, where friction rows ask for less than the two substeps that they get."""
    before, after = (found.cell("solver", case, "slip_mm", "mm") for case in ("iterations-15", "substeps-64"))
    own = found.cell("stiffness", "pad-ke-2.5e3", "friction_timeconst_s", "s")
    shortest = found.value("stiffness", "least_timeconst", "s")
    is_shorter = None not in (own.value, shortest.value) and 0.0 < own.value < shortest.value
    outcome = all_of(
        greater(before, after, noise=found.value("noise", "slip_floor", "mm")), decided(is_shorter, own, shortest)
    )
    return Claim("substeps", outcome, {"substeps": found.cell("solver", "substeps-64", "substeps"), "slip": after})


def ways(found: Found) -> list[Claim]:
    """Each way of finding contacts: whether the cube slips there with the shipped pads, and less with stiff ones.

    Where no stiff ones were measured the slip alone decides.
    """
    bound, noise = found.value("reproduction", "slip_bound", "mm"), found.value("noise", "slip_floor", "mm")
    ways = {
        "newton": [("reproduction", "as-shipped"), ("reproduction", "stiff-pads")],
        "mujoco": [("upgrade", "as-shipped-mujoco-contacts"), ("upgrade", "stiff-pads-mujoco-contacts")],
        "c": [("reproduction", "as-shipped-mujoco-c"), ("reproduction", "stiff-pads-mujoco-c")],
        "pyramid": [("solver", "cone-pyramidal")],
    }
    claims = []
    for way, places in ways.items():
        cells = [found.cell(*place, "slip_mm", "mm") for place in places]
        numbers = dict(zip(("before", "after"), cells, strict=False))
        if way == "pyramid":
            for name, pads in (("shipped", "as-shipped"), ("stiff", "stiff")):
                case = f"{pads}/newton/cone-pyramidal"
                numbers[name] = found.cell("error_runtime", case, "grasp_error_mm_per_cycle", "mm/cycle")
        slips = at_least(cells[0], bound)
        less = _is_less(cells[0], cells[1], noise) if len(cells) > 1 else _is_less(numbers["shipped"], numbers["stiff"])
        outcome = all_of(slips, less) if slips == HOLDS else slips
        claims.append(Claim(f"way_{way}", outcome, numbers | {"slips": slips == HOLDS}))
    return claims


def remedy_elsewhere(found: Found) -> Claim:
    """Whether stiff pads help with all the ways but contacts that Newton finds."""
    others = {claim.name: claim for claim in ways(found) if claim.name != "way_newton"}
    numbers = {name: others[f"way_{name}"].numbers["after"] for name in ("mujoco", "c")}
    numbers["pyramid"] = others["way_pyramid"].numbers["stiff"]
    return Claim("remedy_elsewhere", all_of(*(claim.outcome for claim in others.values())), numbers)


def _is_less(before: Quantity, after: Quantity, noise: Quantity | None = None) -> Outcome:
    """Whether stiff pads leave less, by more than the noise where there is one; holds where they were not measured."""
    if after.value is None:
        return HOLDS
    if noise is not None:
        return greater(before, after, noise=noise)
    return decided(None not in (before.value, after.value) and after.value < before.value, before, after)
