"""Error against run time: engines and cures in one figure, and the rule by which one of them is advised."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import Claim, Outcome, all_of, decided
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.section import Figure
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Row
from report.shared.drawing import CURE, SHIPPED, STIFF, TERM
from report.shared.timing import TIMED_WORLDS
from report.story.found import Found

ALONE, MANY = TIMED_WORLDS[0], TIMED_WORLDS[-1]
IN_C = "v"
"""Marker of what runs on a core of the processor, and in as many worlds as it has cores."""
BASELINE = "cure_cost/as-shipped"
NOTHING, ARGUMENT, PATCH = range(3)
"""What it takes to have a way, in the order in which they are advised; an argument is one of a constructor."""


@dataclass(frozen=True)
class Way:
    """A way to shake the cube."""

    name: str
    effort: int
    slip: str
    """Section and case of its slip."""
    timed: str
    """The same of the times of its frames, each over that of MuJoCo Warp as shipped with as many worlds."""
    colour: str
    marker: str = "o"


def _cure(model: str, parts: str = "plain-rounded") -> str:
    return f"cure/newton-{model}-3cm-{parts}"


WAYS = (
    Way("as shipped", NOTHING, _cure("implicitfast-50-shipped"), BASELINE, SHIPPED),
    Way("stiff pads", ARGUMENT, _cure("implicitfast-50-stiff"), "speed/stiff-pads-only", STIFF),
    Way("RK4", ARGUMENT, _cure("rk4-50-shipped"), "error_runtime/as-shipped/newton-rk4/substeps-16", SHIPPED, "s"),
    Way("RK4, stiff pads", ARGUMENT, _cure("rk4-50-stiff"), "error_runtime/stiff/newton-rk4/substeps-16", STIFF, "s"),
    Way("Steel", ARGUMENT, "newton_solvers/steel-3cm", "newton_solvers/steel", SERIES[4], "P"),
    Way(
        "Steel, no anchors", ARGUMENT, "newton_solvers/steel-points-3cm", "newton_solvers/steel-points", SERIES[4], "X"
    ),
    Way("the term", PATCH, _cure("implicitfast-50-shipped", "term-rounded"), "cure_cost/term", TERM),
    Way("the term, RK4", PATCH, _cure("rk4-50-shipped", "term-rounded"), "cure_cost/term-rk4", TERM, "s"),
    Way("the root cure", PATCH, _cure("euler-400-shipped", "full-kept"), "cure_cost/best", CURE),
    Way("the same, stiff pads", PATCH, _cure("implicitfast-400-stiff", "centred-kept"), "cure_cost/firm", CURE, "D"),
    Way("MuJoCo C", NOTHING, "solver/as-shipped-mujoco-c", "error_runtime/as-shipped/c/substeps-16", SHIPPED, IN_C),
    Way(
        "MuJoCo C, stiff pads", ARGUMENT, "solver/stiff-pads-mujoco-c", "error_runtime/stiff/c/substeps-16", STIFF, "v"
    ),
)


@dataclass(frozen=True)
class Place:
    """A way where it was measured: its slip, and times over that of MuJoCo Warp as shipped, by number of worlds."""

    way: Way
    row: Row | None
    ratios: dict[int, Quantity]

    @property
    def slip(self) -> Quantity:
        return self.row.slip_mm if self.row else absent("mm", f"{self.way.name} was not measured")

    @property
    def creep_mm(self) -> float | None:
        """Return the slip of a cycle of the shake."""
        if not self.row or self.slip.value is None or self.row.dropped:
            return None
        return self.slip.value / (self.row.shake_duration_s.value * self.row.shake_frequency_hz.value)


def places_of(found: Found) -> list[Place]:
    """Look up each way; one that no section has here has no row."""
    places = []
    for way in WAYS:
        section, _, case = way.slip.partition("/")
        row = found.chapters[section].results.row[case] if section in found.chapters else None
        ratios = {count: ratio for count in (ALONE, MANY) if (ratio := _timed(found, way.timed, count))}
        places.append(Place(way, row or None, ratios))
    return places


def _timed(found: Found, place: str, count: int) -> Quantity | None:
    """Look up how long a frame takes with so many worlds, over that as shipped."""
    section, _, name = place.partition("/")
    rows = found.chapters[section].results.rows if section in found.chapters else []
    for row in rows:
        if name in (row.case, row.plain.get("variant")) and row.plain.get("worlds", ALONE) == count:
            ratio = next((row[column] for column in ("frame_ratio", "time_ratio") if column in row), None)
            if ratio is not None and ratio.value is not None:
                return ratio
    return None


def figure(found: Found) -> Figure:
    """Draw the creep of each way against the time of a world's frame, alone and among many."""
    rows = found.chapters["cure_cost"].results.rows if "cure_cost" in found.chapters else []
    shipped = {row.worlds.value: row for row in rows if row.case == "as-shipped" and row.worlds.value in (ALONE, MANY)}
    there = [place for place in places_of(found) if place.creep_mm is not None and place.ratios]
    cells = [cell for place in there for cell in (place.slip, *place.ratios.values())]
    cells += [row.frame_ms for row in shipped.values()]
    many = shipped[MANY].worlds if MANY in shipped else absent("1", "no frames were timed")
    return Figure(lambda: draw(there, shipped), cells, {"many": many})


def draw(places: Sequence[Place], shipped: Mapping[int, Row]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.0)
    for place in places:
        counts = [count for count in (MANY, ALONE) if count in place.ratios and count in shipped]
        x = [place.ratios[count].number * shipped[count].frame_ms.number / count for count in counts]
        style = {
            "color": place.way.colour,
            "marker": place.way.marker,
            "markevery": 1,
            "linestyle": ":",
            "linewidth": 0.8,
        }
        axes.plot(x, [place.creep_mm] * len(x), label=place.way.name, **style)
    axes.set(xscale="log", yscale="log", xlabel="time of a world's frame [ms]", ylabel="creep [mm/cycle]")
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8)
    return drawing


def advice(found: Found) -> list[Claim]:
    """Advise what keeps the slip below one that can be seen, and below a tenth of that."""
    bounds = {"advice": ("reproduction", "slip_bound"), "ends_creep": ("newton_solvers", "ended_bound")}
    timed = [place for place in places_of(found) if place.slip.value is not None and ALONE in place.ratios]
    return [_chosen(name, timed, found.value(*bound, "mm")) for name, bound in bounds.items()]


def _chosen(name: str, timed: Sequence[Place], bound: Quantity) -> Claim:
    """Choose among the ways in Newton that keep the slip below the bound: an argument before a patch, and of those that
    take as much the fastest."""
    none = absent("1", bound.reason or "what holds the cube was not timed")
    numbers = {"way": "", "slip": replace(none, unit="mm"), "ratio": none, "many": none, "bound": bound}
    numbers |= {"is_argument": False, "is_steel": False}
    kept = [each for each in timed if bound.value and each.slip.number < bound.value and not each.row.dropped]
    in_newton = [place for place in kept if place.way.marker != IN_C]
    if not in_newton:
        return Claim(name, Outcome("unknown", none.reason), numbers)
    place = min(in_newton, key=lambda place: (place.way.effort, place.ratios[ALONE].number))
    numbers |= {"way": place.way.name, "slip": place.slip, "ratio": place.ratios[ALONE]}
    numbers |= {"many": place.ratios.get(MANY, none), "is_argument": place.way.effort == ARGUMENT}
    numbers["is_steel"] = place.way.slip.startswith("newton_solvers")
    read = [cell for each in timed for cell in (each.slip, each.ratios[ALONE])]
    # Each way is looked at by itself: times are ratios of what one machine measured in turn.
    outcomes = [decided(place.way.effort != PATCH, cell) for cell in (*read, bound)]
    return Claim(name, all_of(*outcomes), numbers)
