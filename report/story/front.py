"""The front page: the verdict, what to change, and short answers to what one asks first."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from measured_report.claims.claim import HOLDS, Claim, all_of, greater
from measured_report.deriving.chapters import Chapters
from measured_report.parts.section import Figure, Section
from report.shared.overview import overview
from report.story.figures import draw_still
from report.story.found import Found
from report.story.shared import gain, substeps, ways


def derive(chapters: Chapters) -> Section:
    """Derive figures and claims of the front page of one release."""
    found = Found(chapters)
    if "reproduction" not in chapters:
        return Section(figures=_overview(chapters))
    asked = [name for name, (sections, _) in QUESTIONS.items() if chapters.keys() >= set(sections)]
    if found.does_slip:
        asked = [name for name in asked if name not in OF_A_HOLD]
    questions = [_answer(found, name, *QUESTIONS[name]) for name in asked]
    return Section(
        figures={"still": _still(found)} | _overview(chapters),
        claims=[*_verdict(found), *questions, *ways(found)],
        unmeasured=set(QUESTIONS) - set(asked),
    )


def _overview(chapters: Chapters) -> dict[str, Figure]:
    figure = overview({name: chapter.results for name, chapter in chapters.items()})
    return {"overview": figure} if figure else {}


def _verdict(found: Found) -> list[Claim]:
    """What the cube does, in the title and below it, and whether the fix is one."""
    settings = {name: found.cell("reproduction", "stiff-pads", f"pad_{name}") for name in ("ke", "kd")}
    return [
        found.titled("title"),
        found.retold("walks", "reproduction", "slips"),
        found.retold("remedy", "reproduction", "stiff_pads_hold", settings | {"slips": found.does_slip}),
    ]


def _still(found: Found) -> Figure:
    cases = ("as-shipped", "stiff-pads")
    traces = {case: found.trace("reproduction", case) for case in cases}
    slips = {case: found.cell("reproduction", case, "slip_mm", "mm") for case in cases}
    shipped, stiff = slips.values()
    numbers = {"shipped": shipped, "stiff": stiff, "slips": found.does_slip, "less": found.does_hold}
    return Figure(lambda: draw_still(traces, slips), [*traces.values(), *slips.values()], numbers)


def _answer(found: Found, name: str, sections: Sequence[str], asked: str | Callable[[Found], Claim]) -> Claim:
    return found.retold(name, sections[0], asked) if isinstance(asked, str) else asked(found)


def _is_mistuned(found: Found) -> Claim:
    """The cube's own material has no effect, which the lint has to say first, and stiff pads would help."""
    slip, stiff = (found.cell("reproduction", case, "slip_mm", "mm") for case in ("as-shipped", "stiff-pads"))
    material = found.retold("is_mistuned", "lint", "names_the_material")
    held = found.retold("held", "reproduction", "stiff_pads_hold")
    better = greater(slip, stiff, noise=found.value("noise", "slip_floor", "mm"))
    is_named = material.outcome == HOLDS
    outcome = all_of(material.outcome, held.outcome) if is_named else material.outcome
    own = {"slip": slip, "stiff": stiff, "bound": found.value("reproduction", "stiff_gain_bound")}
    numbers = {**material.numbers, **own, "is_named": is_named, "is_better": better == HOLDS}
    return replace(material, outcome=replace(outcome, reads=outcome.reads | better.reads), numbers=numbers)


def _impratio(found: Found) -> Claim:
    kept = found.value("reproduction", "impratio").code
    return found.retold("impratio", "error_runtime", "impratio", {"kept": kept})


def _newest(found: Found) -> Claim:
    """From the release of the page, where that is neither the oldest nor the newest."""
    if found.claim("upgrade", "same_as_newest"):
        return found.retold("newest", "upgrade", "same_as_newest", {"until": "", "since": ""})
    step = found.claim("upgrade", "in_one_step")
    [(until, since)] = step.numbers["steps"] if step and step.outcome == HOLDS else [("", "")]
    return found.retold("newest", "upgrade", "slip_is_the_same", {"until": until, "since": since})


QUESTIONS: dict[str, tuple[Sequence[str], str | Callable[[Found], Claim]]] = {
    "should_work": (["contacts"], "far_inside_cone"),
    "is_mistuned": (["lint"], _is_mistuned),
    "costs_no_speed": (["speed"], "stiff_pads_only_same_time"),
    "gain": (["error_runtime"], gain),
    "impratio": (["error_runtime"], _impratio),
    "clamp": (["stability"], "leans_on_clamp"),
    "substeps": (["solver", "stiffness"], substeps),
    "use": (["cure", "cure_cost"], "what_to_use"),
    "newest": (["upgrade"], _newest),
}
"""Claims that are made where the sections that they need have results; many retell one of the first of these."""
OF_A_HOLD = {"clamp", "substeps"}
"""Those that say something only where the cube does not slip."""
