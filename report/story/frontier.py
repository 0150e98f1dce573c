"""Error against run time: engines and cures in one figure, and which is advised."""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

from markupsafe import Markup

from report.sections.reproduction import FRAME_RATE
from report.shared import (
    FAILS,
    HOLDS,
    MS_PER_S,
    SLOWER,
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
    greater,
    worlds_name,
)
from report.shared.drawing import (
    CURE,
    INK,
    SERIES,
    SHIPPED,
    STIFF,
    TERM,
    Drawing,
    new_figure,
    tick_at,
    write,
)

ALONE = TIMED_WORLDS[0]
MANY = TIMED_WORLDS[-1]
SHAKE = ("shake_duration_s", "shake_frequency_hz")
NOTHING, ARGUMENT, SOLVER, PATCH = range(4)  # effort of a way, in the order of advice


@dataclass(frozen=True)
class Way:
    """A way to shake the cube."""

    name: str
    effort: int
    run: str  # section and case of its slip
    timed: str  # the same of its frames, over those of MuJoCo Warp as shipped
    colour: str
    marker: str = "o"

    def slip(self, sections: Sections, column: str = "slip_mm") -> Quantity:
        section, _, case = self.run.partition("/")
        return sections.cell(section, case, column)

    def is_offered(self, sections: Sections) -> bool:
        """Tell whether a release has it: one without a solver has no row of that."""
        section, _, variant = self.timed.partition("/")
        cases = [row.case for row in sections.rows(section)]
        is_there = any(case.startswith(f"{variant}-") for case in cases)
        return is_there or not (self.is_other and cases)

    def keeps(self, sections: Sections, bound: Quantity) -> Outcome:
        """Tell whether the slip stays below a bound.

        In another solver it has to without weight too, and in the same shake.
        """
        section, _, case = self.run.partition("/")
        variant = self.timed.partition("/")[2]
        cases = [case, f"{variant}-3cm"] if self.is_other else [case]
        runs = [row.plain for row in sections.rows(section) if row.case in cases]
        # A run that fails in another solver says so of that solver.
        ends = ("dropped", "failure") if self.is_other else ("dropped",)
        slip = self.slip(sections)
        if any(run.get(end) for run in runs for end in ends):
            return FAILS.having_read(slip)
        tests = [at_most(slip, bound)]
        if self.is_other:
            slip = sections.cell(section, f"{variant}-3cm", "slip_mm")
            hand = sections.value(section, f"{variant}_hand")
            as_far = sections.value(section, "as_far")
            tests += [at_most(slip, bound), at_most(hand, as_far)]
        return all_of(*tests)

    @property
    def is_other(self) -> bool:
        """Tell whether it is another solver than MuJoCo's."""
        return self.effort == SOLVER

    def creep_mm(self, sections: Sections) -> float | None:
        """Return the slip of a cycle, or the least slip that would be seen."""
        slip = self.slip(sections)
        seconds, per_second = (self.slip(sections, column).value for column in SHAKE)
        if None in (slip.value, seconds, per_second):
            return None
        return max(slip.number, slip.noise or 0.0) / (seconds * per_second)

    def ratios(self, sections: Sections) -> dict[int, Quantity]:
        """Return the times that were measured, by number of worlds."""
        section, _, name = self.timed.partition("/")
        names = {name, f"{name}-only", f"{name}-{MANY}"}
        times = {}
        for row in sections.rows(section):
            if names & {row.case, row.plain.get("variant")}:
                for column in ("frame_ratio", "time_ratio"):
                    if column in row and row[column].value is not None:
                        times[row.plain.get("worlds", ALONE)] = row[column]
        return {count: times[count] for count in (ALONE, MANY) if count in times}


def _solver(name: str, marker: str, variant: str = "") -> Way:
    run = f"newton_solvers/{variant or name.lower()}"
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
        "cure/newton-rk4-50-shipped-3cm-plain-rounded",
        "error_runtime/as-shipped/newton-rk4/substeps-16",
        SHIPPED,
        "s",
    ),
    Way(
        "RK4, stiff pads",
        ARGUMENT,
        "cure/newton-rk4-50-stiff-3cm-plain-rounded",
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
        "cure/newton-implicitfast-50-shipped-3cm-term-rounded",
        "cure_cost/term",
        TERM,
    ),
    Way(
        "the term, RK4",
        PATCH,
        "cure/newton-rk4-50-shipped-3cm-term-rounded",
        "cure_cost/term-rk4",
        TERM,
        "s",
    ),
    Way(
        "the root cure",
        PATCH,
        "cure/newton-euler-400-shipped-3cm-full-kept",
        "cure_cost/best",
        CURE,
    ),
    Way(
        "the root cure, stiff pads",
        PATCH,
        "cure/newton-implicitfast-400-stiff-3cm-centred-kept",
        "cure_cost/firm",
        CURE,
        "D",
    ),
)
C_WAYS = (  # on a core of the processor, in as many worlds as it has cores: not advised
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
BOUNDS = {
    "advice": ("reproduction", "slip_bound"),
    "ends_creep": ("newton_solvers", "ended_bound"),
}
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


class Mark(NamedTuple):
    """A way in the figure; creep that is not seen stands at its bound."""

    way: Way
    creep: float  # slip of a cycle [mm]
    times: list[float]  # of a world's frame [ms]
    is_seen: bool


def figure(sections: Sections) -> Figure:
    """Draw the creep of ways against the time of a frame, alone and among many."""
    worlds = {
        count: sections.cell("error_runtime", f"worlds-{count}", "ms_per_s")
        for count in (ALONE, MANY)
    }
    frames_ms = {
        count: cell.number / FRAME_RATE / count
        for count, cell in worlds.items()
        if cell.value is not None
    }
    # As the error page compares them: by the times that C took in turn with each
    # number of worlds.
    core = sections.value("error_runtime", "one_core_rate")
    alone_in_c = C_WAYS[0].ratios(sections).get(ALONE)
    core_ms = frames_ms
    if core.value and alone_in_c:
        core_s = 1 / FRAME_RATE / core.value
        core_ms = {ALONE: MS_PER_S.number * core_s / alone_in_c.number}
    cells = []
    marks = []
    ways = []
    other = next(
        (way for way in WAYS if way.name in OTHERS and way.ratios(sections)), None
    )
    for way in (*WAYS, *C_WAYS):
        creep = way.creep_mm(sections)
        if creep is None or not (way.name in MARKED or way is other):
            continue
        ways.append(way)
        slip = way.slip(sections)
        ratios = way.ratios(sections)
        cells += [slip, *ratios.values()]
        paces = core_ms if way in C_WAYS else frames_ms
        times = [
            ratio.number * paces[count]
            for count, ratio in ratios.items()
            if count in paces
        ]
        if times:
            marks.append(Mark(way, creep, times, slip.is_distinct))
    bounds = [sections.value(*place) for place in BOUNDS.values()]
    shake = [sections.cell("reproduction", "as-shipped", name).value for name in SHAKE]
    lines = [
        (bound, bound.number / math.prod(shake))
        for bound in bounds
        if None not in (bound.value, *shake)
    ]
    gain = sections.value("reproduction", "stiff_gain")
    stiff = WAYS[1].slip(sections)
    is_cut = all_of(
        at_least(gain, 10.0, "an order of magnitude"), at_most(stiff, bounds[0])
    )
    patches = [way for way in ways if way.effort == PATCH]
    numbers = {
        "gain": gain,
        "is_cut": is_cut == HOLDS,
        "is_ended": any(way.keeps(sections, bounds[1]) == HOLDS for way in patches),
    }
    cells += [*worlds.values(), core, *bounds]
    return Figure(lambda: _draw(marks, lines), cells, numbers)


def _draw(marks: list[Mark], lines: list[tuple[Quantity, float]]) -> Drawing:
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


NUMBERS = (
    *("way", "slip", "ratio", "bound", "many", "off", "elsewhere"),
    *("patch", "patch_slip", "patch_ratio", "patch_many", "has_patch"),
    *("is_argument", "is_other", "faster"),
)
"""What the words of advice can name; all of it is empty where nothing is advised."""


def advice(sections: Sections, every: dict[str, Sections]) -> list[Claim]:
    """Advise what keeps the slip below one that can be seen, and below a tenth of it."""
    return [
        _advised(sections, name, sections.value(*bound), every)
        for name, bound in BOUNDS.items()
    ]


NOTHING_HOLDS = "none of the ways that were tried does"


def _without(numbers: dict[str, Any], reason: str, bound: Quantity) -> dict[str, Any]:
    none = absent("1", bound.reason or reason)
    return numbers | {"slip": none, "ratio": none}


def _unmeasured(
    sections: Sections,
    tests: dict[Way, Outcome],
    times: dict[Way, Quantity],
    effort: int,
) -> Outcome | None:
    """Return unknown if a way lacks a measurement that could make it the advice.

    Without this, advice would become costlier because data are missing.
    """
    fastest = min(
        (time.number for way, time in times.items() if way.effort == effort),
        default=math.inf,
    )
    for way, test in tests.items():
        is_untimed = test == HOLDS and way not in times
        is_unknown = test.name == "unknown" and not test.is_inconclusive
        if not (is_untimed or is_unknown) or way.effort > effort:
            continue
        time = way.ratios(sections).get(ALONE)
        is_slower = time is not None and time.number >= fastest
        is_slower = is_slower or fastest <= 1 + 0.01 * SLOWER[1]
        if (way.effort == effort and is_slower) or not way.is_offered(sections):
            continue
        what = "timed" if is_untimed else "measured"
        reason = f"{way.name}, which may be cheaper, was not {what}"
        if is_unknown:
            reason += f" ({test.reason})"
        section = (way.timed if is_untimed else way.run).partition("/")[0]
        if "make rerun" not in reason:
            reason += f"; make rerun SECTION={section} measures it"
        return Outcome("unknown", reason, reads=test.reads)
    return None


def _fastest(ways: list[Way], times: dict[Way, Quantity]) -> Way:
    """Return the first of the timed ways that is not surely slower than the fastest."""
    timed = [way for way in ways if way in times]
    fastest = min((times[way] for way in timed), key=lambda time: time.number)
    return next(
        way
        for way in timed
        if times[way] is fastest or not (times[way] - fastest).is_distinct
    )


def _faster(sections: Sections, way: Way, time: Quantity) -> Quantity | str:
    """Return how many times as fast a way is; empty if it is not surely faster."""
    section, _, variant = way.timed.partition("/")
    speedup = sections.value(section, f"{variant}_speedup")
    return speedup if greater(1.0, time, "as fast") == HOLDS and speedup.value else ""


def _advised(
    sections: Sections, name: str, bound: Quantity, every: dict[str, Sections]
) -> Claim:
    """Choose the fastest way with the least effort that keeps the slip below a bound."""
    numbers: dict[str, Any] = dict.fromkeys(NUMBERS, "") | {"bound": bound}
    tests = {way: way.keeps(sections, bound) for way in WAYS}
    holding = [way for way, test in tests.items() if test == HOLDS]
    ratios = {way: way.ratios(sections) for way in holding}
    times = {way: ratio[ALONE] for way, ratio in ratios.items() if ALONE in ratio}
    effort = min((way.effort for way in holding), default=PATCH)
    least = [way for way in holding if way.effort == effort]
    if lack := _unmeasured(sections, tests, times, effort):
        return Claim(name, lack, _without(numbers, lack.reason, bound))
    near = [
        test
        for way, test in tests.items()
        if test.is_inconclusive and ARGUMENT <= way.effort < effort
    ]
    least = [way for way in least if way in times]
    if near or not least:
        outcome = near[0] if near else Outcome("unknown", bound.reason or NOTHING_HOLDS)
        return Claim(name, outcome, _without(numbers, outcome.reason, bound))

    way = _fastest(least, times)
    variant = way.timed.rpartition("/")[2]
    off = sections.cell("newton_solvers", f"{variant}-3cm", "wander_mm")  # on the way
    more = []
    for release, other in every.items() if way.is_other else ():
        slip = way.slip(other)
        if slip.value is not None and slip.value > bound.number:
            more.append((slip, release))
    numbers |= {
        "way": way.name,
        "slip": way.slip(sections),
        "ratio": times[way],
        "many": ratios[way].get(MANY, ""),
        "off": off if at_least(off, bound) == HOLDS else "",
        "elsewhere": Markup(", ").join(
            Markup("{} in {}").format(*pair) for pair in more
        ),
        "is_argument": way.effort != NOTHING,
        "is_other": way.is_other,
        "faster": _faster(sections, way, times[way]),
    }
    patches = [way for way in times if way.effort == PATCH]
    if patches:
        patch = _fastest(patches, times)
        numbers |= {
            "patch": patch.name,
            "patch_slip": patch.slip(sections),
            "patch_ratio": times[patch],
            "patch_many": ratios[patch].get(MANY, ""),
            "has_patch": True,
        }
    # Each is looked at by itself: times are ratios of what one machine measured.
    read = [
        off,
        *(slip for slip, _ in more),
        *(way.slip(sections) for way in WAYS),
    ]
    read = [cell for cell in read if cell.value is not None]
    read += [
        *ratios[way].values(),
        *(times[each] for each in (*least, *patches) if each in times),
        bound,
    ]
    outcome = all_of(*(decided(way.effort != PATCH, cell) for cell in read))
    return Claim(name, outcome, numbers)
