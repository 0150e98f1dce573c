"""The front page: the verdict, what to change, and short answers to what one asks first."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from report.chapters import Chapters
from report.claims import HOLDS, Claim, Outcome, all_of, at_least, decided, greater
from report.overview import overview
from report.parts import Figure, Section
from report.quantities import Quantity
from report.story.figures import draw_still
from report.story.found import Found


def front_of(chapters: Chapters) -> Section:
    """Figures, cards and claims of the front page of one release."""
    found = Found(chapters)
    if "reproduction" not in chapters:
        return Section(figures=_overview(chapters))
    asked = {name: ask for name, (sections, ask) in QUESTIONS.items() if sections <= set(chapters)}
    if found.does_slip:
        asked.pop("clamp", None)
    questions = {name: ask(found) for name, ask in asked.items()}
    return Section(
        figures={"still": _still(found)} | _overview(chapters),
        claims=[*_verdict(found), *questions.values(), *_ways(found)],
        unmeasured=set(QUESTIONS) - set(questions),
    )


def _overview(chapters: Chapters) -> dict[str, Figure]:
    figure = overview({name: chapter.results for name, chapter in chapters.items()})
    return {"overview": figure} if figure else {}


def _verdict(found: Found) -> list[Claim]:
    """What the cube does, in the title and below it, and whether the fix is one."""
    settings = {
        "ke": found.cell("reproduction", "stiff-pads", "pad_ke"),
        "kd": found.cell("reproduction", "stiff-pads", "pad_kd"),
    }
    return [
        found.titled("title"),
        found.retold("walks", "reproduction", "slips"),
        found.retold("remedy", "reproduction", "stiff_pads_hold", settings | {"slips": found.does_slip}),
    ]


def _still(found: Found) -> Figure:
    cases = ("as-shipped", "stiff-pads")
    traces = {case: found.trace("reproduction", case) for case in cases}
    slips = {case: found.cell("reproduction", case, "slip_mm", "mm") for case in cases}
    return Figure(
        draw=lambda: draw_still(traces, slips),
        sources=[*traces.values(), *slips.values()],
        numbers={
            "shipped": slips["as-shipped"],
            "stiff": slips["stiff-pads"],
            "slips": found.does_slip,
            "less": found.does_hold,
        },
    )


def _should_work(found: Found) -> Claim:
    used = {"used": found.value("contacts", "grip_used_shipped")}
    return found.retold("should_work", "contacts", "far_inside_cone", used)


def _is_mistuned(found: Found) -> Claim:
    """Stiff pads would help, and the cube's own material has no effect."""
    cases = {"slip": "as-shipped", "stiff": "stiff-pads"}
    slips = {name: found.cell("reproduction", case, "slip_mm", "mm") for name, case in cases.items()}
    material = found.retold("is_mistuned", "lint", "names_the_material", slips)
    held = found.retold("held", "reproduction", "stiff_pads_hold")
    return replace(material, outcome=all_of(held.outcome, material.outcome))


def _costs_no_speed(found: Found) -> Claim:
    return found.retold("costs_no_speed", "speed", "stiff_pads_only_same_time")


def _luck(found: Found) -> Claim:
    return found.retold("luck", "contacts", "slide_falls_less_than_displacement", {"slips": found.does_slip})


def _impratio(found: Found) -> Claim:
    kept = found.value("reproduction", "impratio").code
    return found.retold("impratio", "error_runtime", "impratio", {"kept": kept})


def _clamp(found: Found) -> Claim:
    return found.retold("clamp", "stability", "leans_on_clamp")


def _newest(found: Found) -> Claim:
    """From the release of the page, where that is neither the oldest nor the newest."""
    between = found.claim("upgrade", "same_as_newest")
    return found.retold("newest", "upgrade", "same_as_newest" if between else "slip_is_the_same")


QUESTIONS: dict[str, tuple[set[str], Callable[[Found], Claim]]] = {
    "should_work": ({"contacts"}, _should_work),
    "is_mistuned": ({"lint"}, _is_mistuned),
    "costs_no_speed": ({"speed"}, _costs_no_speed),
    "luck": ({"contacts"}, _luck),
    "impratio": ({"error_runtime"}, _impratio),
    "clamp": ({"stability"}, _clamp),
    "newest": ({"upgrade"}, _newest),
}
"""Claims that are made where the sections that they need have results."""


def _ways(found: Found) -> list[Claim]:
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
        less = _is_less(cells, noise) if len(cells) > 1 else _is_less([numbers["shipped"], numbers["stiff"]], None)
        outcome = all_of(slips, less) if slips == HOLDS else slips
        claims.append(Claim(f"way_{way}", outcome, numbers | {"slips": slips == HOLDS}))
    return claims


def _is_less(cells: Sequence[Quantity], noise: Quantity | None) -> Outcome:
    """Whether stiff pads leave less, by more than the noise where there is one; holds where they were not measured."""
    before, after = cells
    if after.value is None:
        return HOLDS
    if noise is not None:
        return greater(before, after, noise=noise)
    return decided(None not in (before.value, after.value) and after.value < before.value, before, after)
