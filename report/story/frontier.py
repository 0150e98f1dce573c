"""Error against run time: engines and cures in one figure, and the rule by which one of them is advised."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, tick_at, write
from report.sections.reproduction import FRAME_RATE
from report.shared import (
    HOLDS,
    MS_PER_S,
    TIMED_WORLDS,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Sections,
    absent,
    all_of,
    at_least,
    at_most,
    decided,
    worlds_name,
)
from report.shared.drawing import CURE, SHIPPED, STIFF, TERM

ALONE, MANY = TIMED_WORLDS[0], TIMED_WORLDS[-1]
SOLVERS = "newton_solvers"  # where Newton's other solvers are measured
RATIOS = ("frame_ratio", "time_ratio")
SHAKE = ("shake_duration_s", "shake_frequency_hz")
FLAGS = ("is_argument", "is_other", "has_many", "is_longer", "has_patch")
UNSEEN = {  # section and value of how much longer the frames of a way may take and are not seen to
    "stiff pads": ("speed", "stiff_pads_only_change"),
    "the root cure": ("cure_cost", "best_unseen"),
    "the root cure, stiff pads": ("cure_cost", "firm_unseen"),
}
NOTHING, ARGUMENT, SOLVER, PATCH = range(
    4
)  # what a way takes, in the order of advice; an argument of the solver


@dataclass(frozen=True)
class Way:
    """A way to shake the cube."""

    name: str
    effort: int
    run: str  # section and case of its slip
    timed: str  # the same of the times of its frames, each over that of MuJoCo Warp as shipped with as many worlds
    colour: str
    marker: str = "o"

    def slip(self, sections: Sections, column: str = "slip_mm") -> Quantity:
        section, _, case = self.run.partition("/")
        return sections.cell(section, case, column)

    def keeps(self, sections: Sections, bound: Quantity) -> Outcome:
        """Tell whether the slip stays below a bound; in another solver without weight too, and in the same shake."""
        slips, tests = [self.slip(sections)], []
        if self.is_other:
            section, _, variant = self.timed.partition("/")
            slips.append(sections.cell(section, f"{variant}-3cm", "slip_mm"))
            tests.append(
                at_most(
                    sections.value(section, f"{variant}_hand"),
                    sections.value(section, "as_far"),
                )
            )
        return all_of(*(at_most(slip, bound) for slip in slips), *tests)

    @property
    def is_other(self) -> bool:
        """Whether it is another solver than MuJoCo's."""
        return self.effort == SOLVER

    def creep_mm(self, sections: Sections) -> float | None:
        """Return the slip of a cycle of the shake, or what would be seen where it is less."""
        slip, (seconds, per_second) = (
            self.slip(sections),
            (self.slip(sections, column).value for column in SHAKE),
        )
        is_measured = None not in (slip.value, seconds, per_second)
        return (
            max(slip.number, slip.noise or 0.0) / (seconds * per_second)
            if is_measured
            else None
        )

    def ratios(self, sections: Sections) -> dict[int, Quantity]:
        """Return the times that were measured, by number of worlds."""
        section, _, name = self.timed.partition("/")
        rows = sections.results[section].rows if section in sections.results else []
        names = {name, f"{name}-only", f"{name}-{MANY}"}
        mine = [row for row in rows if names & {row.case, row.plain.get("variant")}]
        times = {
            row.plain.get("worlds", ALONE): row[column]
            for row in mine
            for column in RATIOS
            if column in row
        }
        return {
            count: times[count]
            for count in (ALONE, MANY)
            if count in times and times[count].value is not None
        }


def _cure(model: str, parts: str = "plain-rounded") -> str:
    return f"cure/newton-{model}-3cm-{parts}"


def _solver(name: str, marker: str, variant: str = "") -> Way:
    run = f"{SOLVERS}/{variant or name.lower()}"
    return Way(name, SOLVER, f"{run}-weight", run, SERIES[4], marker)


WAYS = (
    Way(
        "as shipped",
        NOTHING,
        "reproduction/as-shipped",
        "cure_cost/as-shipped",
        SHIPPED,
    ),
    Way("stiff pads", ARGUMENT, "reproduction/stiff-pads", "speed/stiff-pads", STIFF),
    Way(
        "RK4",
        ARGUMENT,
        _cure("rk4-50-shipped"),
        "error_runtime/as-shipped/newton-rk4/substeps-16",
        SHIPPED,
        "s",
    ),
    Way(
        "RK4, stiff pads",
        ARGUMENT,
        _cure("rk4-50-stiff"),
        "error_runtime/stiff/newton-rk4/substeps-16",
        STIFF,
        "s",
    ),
    _solver("Steel", "P"),
    _solver("Steel, no anchors", "X", "steel-points"),
    _solver("Kamino", "*"),
    _solver("XPBD", "^"),
    _solver("VBD", "<"),
    Way(
        "the term",
        PATCH,
        _cure("implicitfast-50-shipped", "term-rounded"),
        "cure_cost/term",
        TERM,
    ),
    Way(
        "the term, RK4",
        PATCH,
        _cure("rk4-50-shipped", "term-rounded"),
        "cure_cost/term-rk4",
        TERM,
        "s",
    ),
    Way(
        "the root cure",
        PATCH,
        _cure("euler-400-shipped", "full-kept"),
        "cure_cost/best",
        CURE,
    ),
    Way(
        "the root cure, stiff pads",
        PATCH,
        _cure("implicitfast-400-stiff", "centred-kept"),
        "cure_cost/firm",
        CURE,
        "D",
    ),
)
BOUNDS = {
    "advice": ("reproduction", "slip_bound"),
    "ends_creep": ("newton_solvers", "ended_bound"),
}
C_WAYS = (  # on a core of the processor, and in as many worlds as it has cores: not advised
    Way(
        "MuJoCo C",
        NOTHING,
        "solver/as-shipped-mujoco-c",
        "error_runtime/as-shipped/c/substeps-16",
        SHIPPED,
        "v",
    ),
    Way(
        "C, stiff pads",
        ARGUMENT,
        "solver/stiff-pads-mujoco-c",
        "error_runtime/stiff/c/substeps-16",
        STIFF,
        "v",
    ),
)
MARKED = (
    "as shipped",
    "stiff pads",
    "RK4, stiff pads",
    "the root cure",
    "MuJoCo C",
    "C, stiff pads",
)
OTHERS = ("Steel", "Kamino")  # the first of these that was timed is marked too
GAP = 0.17  # decades between two names that stand one above the other


def figure(sections: Sections) -> Figure:
    """Draw the creep of some ways against the time of a world's frame, alone and among many."""
    seconds = {
        count: sections.cell("error_runtime", f"worlds-{count}", "ms_per_s")
        for count in (ALONE, MANY)
    }
    frames_ms = {
        count: cell.number / FRAME_RATE / count
        for count, cell in seconds.items()
        if cell.value is not None
    }
    other = next(
        (way for way in WAYS if way.name in OTHERS and way.ratios(sections)), None
    )
    marked = [way for way in (*WAYS, *C_WAYS) if way.name in MARKED or way is other]
    ways = {
        way: way.ratios(sections)
        for way in marked
        if way.creep_mm(sections) is not None
    }
    core, ratio = (
        sections.value("error_runtime", "one_core_rate"),
        C_WAYS[0].ratios(sections).get(ALONE),
    )
    # As the error page compares them: by the times that C took in turn with each number of worlds.
    core_ms = (
        {ALONE: MS_PER_S.number / FRAME_RATE / core.value / ratio.number}
        if core.value and ratio
        else frames_ms
    )
    marks = [
        Mark(
            way,
            way.creep_mm(sections),
            times,
            way.slip(sections).number > (way.slip(sections).noise or 0.0),
        )
        for way, ratios in ways.items()
        if (paces := core_ms if way in C_WAYS else frames_ms)
        and (
            times := [
                ratio.number * paces[count]
                for count, ratio in ratios.items()
                if count in paces
            ]
        )
    ]
    shake = [
        sections.cell("reproduction", "as-shipped", column).value for column in SHAKE
    ]
    bounds = [sections.value(*place) for place in BOUNDS.values()]
    lines = [
        (bound, bound.number / math.prod(shake))
        for bound in bounds
        if None not in (bound.value, *shake)
    ]
    gain, stiff = sections.value("reproduction", "stiff_gain"), WAYS[1].slip(sections)
    numbers: dict[str, Any] = {"gain": gain}
    numbers["is_cut"] = (
        all_of(
            at_least(gain, 10.0, why="an order of magnitude"), at_most(stiff, bounds[0])
        )
        == HOLDS
    )
    numbers["is_ended"] = any(
        way.effort == PATCH and way.keeps(sections, bounds[1]) == HOLDS for way in ways
    )
    cells = [
        cell
        for way, ratios in ways.items()
        for cell in (way.slip(sections), *ratios.values())
    ]
    return Figure(
        lambda: _draw(marks, lines), [*cells, *seconds.values(), core, *bounds], numbers
    )


class Mark(NamedTuple):
    """Place a way: slip of a cycle [mm] and times of a world's frame [ms]; what is not seen stands at its bound."""

    way: Way
    creep: float
    times: list[float]
    is_seen: bool


def _draw(marks: Sequence[Mark], lines: Sequence[tuple[Quantity, float]]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.6)
    for bound, creep in lines:
        axes.axhline(
            creep, color=INK, linewidth=0.8, linestyle=(0, (4, 4)), marker="", alpha=0.5
        )
        at = {"xycoords": ("axes fraction", "data"), "va": "bottom", "fontsize": 8.5}
        axes.annotate(f"{write(bound)} mm in the whole shake", (0.01, creep), **at)
    last = math.inf
    for way, creep, times, is_seen in sorted(marks, key=lambda mark: -mark.creep):
        style = {
            "marker": way.marker,
            "markerfacecolor": way.colour if is_seen else "none",
            "markersize": 8,
        }
        axes.plot(
            times,
            [creep] * len(times),
            color=way.colour,
            linestyle=":",
            linewidth=0.9,
            markevery=1,
            **style,
        )
        beside: dict[str, Any] = {
            "color": way.colour,
            "fontsize": 9.5,
            "textcoords": "offset points",
        }
        if way in C_WAYS:  # below their marks
            axes.annotate(
                way.name,
                (max(times), creep),
                xytext=(0, -8),
                ha="center",
                va="top",
                **beside,
            )
        else:  # as far down as keeps a name clear of the one above
            last = min(math.log10(creep), last - GAP)
            axes.annotate(
                way.name, (max(times), 10**last), xytext=(8, 0), va="center", **beside
            )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="time of a world's frame [ms]",
        ylabel="slip [mm/cycle]",
    )
    axes.set_xlim(right=60 * max((max(mark.times) for mark in marks), default=1.0))
    axes.set_ylim(top=3 * max((mark.creep for mark in marks), default=1.0))
    tick_at(axes.xaxis, [10.0**power for power in range(-3, 4)])
    tick_at(axes.yaxis, [10.0**power for power in range(-4, 2)])
    pair = next(
        (
            mark
            for mark in sorted(marks, key=lambda mark: -mark.creep)
            if len(mark.times) > 1
        ),
        None,
    )
    names = {
        worlds_name(ALONE): (4, "right"),
        worlds_name(MANY): (-4, "left"),
    }  # above, towards each other
    for (name, (shift, side)), time in zip(
        names.items(), pair.times if pair else (), strict=False
    ):
        axes.annotate(
            name,
            (time, pair.creep),
            (shift, 8),
            textcoords="offset points",
            fontsize=8.5,
            ha=side,
        )
    axes.text(
        0.98,
        0.97,
        "↙ better",
        transform=axes.transAxes,
        fontsize=8.5,
        ha="right",
        va="top",
    )
    return drawing


def advice(sections: Sections, every: Mapping[str, Sections]) -> list[Claim]:
    """Advise what keeps the slip below one that can be seen, and below a tenth of that; ``every`` release is asked."""
    return [
        _chosen(sections, name, sections.value(*bound), every)
        for name, bound in BOUNDS.items()
    ]


def _chosen(
    sections: Sections, name: str, bound: Quantity, every: Mapping[str, Sections]
) -> Claim:
    """Choose the fastest of those ways in Newton that keep the slip below the bound and take the least effort."""
    tests = {way: way.keeps(sections, bound) for way in WAYS}
    holding = [way for way, test in tests.items() if test == HOLDS]
    effort = min((way.effort for way in holding), default=PATCH)
    times = {
        way: ratios[ALONE]
        for way in holding
        if ALONE in (ratios := way.ratios(sections))
    }
    least = [way for way in holding if way.effort == effort]
    near = [
        test
        for way, test in tests.items()
        if test.is_inconclusive and ARGUMENT <= way.effort < effort
    ]
    untimed = (
        "what holds the cube was not timed"
        if holding
        else "nothing that was tried is seen to"
    )
    none = absent("1", bound.reason or untimed)
    numbers = {"way": "", "slip": none, "ratio": none, "bound": bound}
    numbers |= dict.fromkeys(
        (
            "many",
            "off",
            "patch",
            "patch_slip",
            "patch_ratio",
            "patch_many",
            "elsewhere",
        ),
        "",
    )
    if near or not least or not times.keys() >= {*least}:
        return Claim(
            name,
            next(iter(near), Outcome("unknown", none.reason)),
            numbers | dict.fromkeys(FLAGS, False),
        )
    way = min(least, key=lambda way: times[way].number)
    ratios = way.ratios(sections)
    seen = sections.value(*UNSEEN.get(way.name, ("", "")))
    off = sections.cell(
        SOLVERS, f"{way.timed.rpartition('/')[2]}-3cm", "wander_mm"
    )  # from its place, on the way
    numbers |= {
        "way": way.name,
        "slip": way.slip(sections),
        "ratio": ratios[ALONE],
        "many": ratios.get(MANY, ""),
    }
    numbers["off"] = off if at_least(off, bound) == HOLDS else ""
    share = 0.01 * (seen.value or 0.0)
    is_longer = any(
        ratio.number - 1.0 > max(ratio.noise or 0.0, share) for ratio in ratios.values()
    )
    patches = [way for way in times if way.effort == PATCH]
    flags = (
        way.effort != NOTHING,
        way.is_other,
        MANY in ratios,
        is_longer,
        bool(patches),
    )
    if patches:
        patch = min(patches, key=lambda way: times[way].number)
        numbers |= {
            "patch": patch.name,
            "patch_slip": patch.slip(sections),
            "patch_ratio": times[patch],
        }
        numbers["patch_many"] = patch.ratios(sections).get(MANY, "")
    slips = {
        release: way.slip(other) for release, other in every.items() if way.is_other
    }
    more = [
        (slip, release)
        for release, slip in slips.items()
        if slip.value is not None and slip.value > bound.number
    ]
    numbers["elsewhere"] = Markup(", ").join(
        Markup("{} in {}").format(*pair) for pair in more
    )
    read = [
        seen,
        off,
        *(slip for slip, _ in more),
        *(way.slip(sections) for way in tests),
    ]
    read = [cell for cell in read if cell.value is not None]
    read += [*ratios.values(), *(times[way] for way in (*least, *patches))]
    # Each way is looked at by itself: times are ratios of what one machine measured in turn.
    outcomes = [decided(way.effort != PATCH, cell) for cell in (*read, bound)]
    return Claim(
        name, all_of(*outcomes), numbers | dict(zip(FLAGS, flags, strict=True))
    )
