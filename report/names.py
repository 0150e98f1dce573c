"""Names of cases for people: the one place that says what a case is called in figures, tables and sentences.

A case keeps its code name in the data, and in the title of what stands for it on the page.
"""

import re
from collections.abc import Iterable, Sequence

from markupsafe import Markup

from measured_report.values.format import format_number, format_power

WHOLE = {
    "untrimmed": "exactly as shipped",
    "as-shipped-untrimmed": "exactly as shipped",
    "engine-mujoco-c": "MuJoCo's C engine",
    "contacts-mujoco": "contacts found by MuJoCo",
    "pads-convex-mesh": "pads as convex meshes",
    "all-gaps-zero": "no contact gap",
    "cube-gap-default": "default gap",
    "priority-0": "equal priorities",
    "priority-0-cube-ke-8e5": "equal priorities, stiffer cube",
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "iterations-15": "shipped settings",
    "stiff-pads-only": "stiff pads",
    "fixed": "fixed scene",
    "batch-1": "one world",
    "batch-64": "64 worlds in a batch",
    "one-core": "one core of C",
    "long-stiff": "stiff pads, long shake",
    "precision-warp": "MuJoCo Warp, single precision",
    "precision-c-double": "MuJoCo C, double precision",
    "precision-c-single": "MuJoCo C, positions rounded to single",
    "double-step-term-restored": "shipped pads, steps twice as long, missing term put back",
    "without-all": "without all of it",
    "without-buffers": "without room in the buffers",
    "without-ik-iterations": "without most IK iterations",
    "without-ik-in-turn": "without waiting for IK",
    "without-state-sync": "without writing the state",
    "without-cube-gap": "without the cube's wide gap",
    "without-hand-box": "without the hand's box",
    "without-visuals": "without visual shapes",
    "without-fixed-joints": "without fixed joints",
    "without-broad-phase": "without the broad phase",
    "gravity--9.81": "gravity upward",
    "gravity-98.1": "gravity tenfold",
    "gravity-9.81": "gravity as on Earth",
    "gravity-0": "no gravity",
    "gravity-0-freed-as-shipped": "no gravity, cube let go, shipped pads",
    "gravity-0-freed-stiff": "no gravity, cube let go, stiff pads",
    "buffers-ample": "ample buffers",
}
"""Cases that are called by a name of their own."""

N = r"(\d[\d.]*(?:e[+-]?\d+)?)"
PARTS = (
    (rf"(?:pad|sweep)-ke-{N}-kd-{N}", "pads' ke {}, kd {}"),
    (rf"(?:pad|sweep)-ke-{N}", "pads' ke {}, kd with it"),
    (rf"largest-step-ke-critical-{N}", "largest step, ke {}, kd = 2√ke"),
    (rf"largest-step-ke-kd-{N}-{N}", "largest step, ke {1}, kd {0}"),
    (rf"ke-critical-{N}-{N}", "pads' ke {}, kd = 2√ke, {} substeps"),
    (rf"ke-kd-{N}-{N}-{N}", "pads' ke {1}, kd {0}, {2} substeps"),
    (rf"pad-mu-{N}", "pads' friction {}"),
    (rf"cube-mu-{N}", "cube's friction {}"),
    (rf"friction-{N}", "friction {}"),
    (rf"cube-ke-{N}", "cube's ke {}"),
    (rf"cube-gap-{N}", "cube's gap {} m"),
    (rf"solimp-dmax-{N}", "dmax {}"),
    (r"kf-off", "kf below zero"),
    (rf"kf-{N}", "kf {}"),
    (r"friction-timeconst-off", "friction rows' time constant taken out"),
    (r"friction-timeconst-on", "two substeps as friction rows' time constant"),
    (rf"contacts-{N}hz", "contacts at {} Hz"),
    (rf"iterations-{N}", "{} iterations"),
    (rf"ls_iterations-{N}", "{} line search iterations"),
    (rf"tolerance-{N}", "tolerance {}"),
    (rf"elliptic-impratio-{N}", "impratio {}"),
    (rf"pyramidal-impratio-{N}", "pyramidal cone, impratio {}"),
    (rf"impratio-{N}", "impratio {}"),
    (r"cone-pyramidal", "pyramidal cone"),
    (r"solver-cg", "conjugate gradients"),
    (r"integrator-euler", "Euler integrator"),
    (rf"substeps-{N}", "substeps {}"),
    (rf"steps-as-shipped-{N}", "shipped pads, {} substeps"),
    (rf"steps-stiff-{N}", "stiff pads, {} substeps"),
    (rf"clamp-off-{N}", "clamp off, timeconst of {} steps"),
    (rf"clamp-direct-{N}", "negative solref, timeconst of {} steps"),
    (rf"shake-{N}mm-{N}hz", "shake {} mm, {} Hz"),
    (rf"{N}cm-{N}hz", "{} cm, {} Hz"),
    (rf"{N}s(?=-|$)", "{} s"),
    (rf"grip-{N}", "grip × {}"),
    (rf"mass-{N}kg", "mass {} kg"),
    (rf"size-{N}mm-as-shipped", "edge {} mm, shipped grip"),
    (rf"size-{N}mm-scaled", "edge {} mm, grip by mass"),
    (rf"overlap-pads-as-shipped-{N}mm", "start {} mm deep in shipped pads"),
    (rf"overlap-pads-stiff-{N}mm", "start {} mm deep in stiff pads"),
    (rf"overlap-ground-springy-{N}mm", "start {} mm deep in springy ground"),
    (rf"overlap-ground-{N}mm", "start {} mm deep in the ground"),
    (rf"buffers-contact-{N}", "room for {} contacts"),
    (rf"buffers-constraint-{N}", "room for {} constraint rows"),
    (rf"worlds-{N}", "{} worlds"),
    (rf"batch-{N}", "run {} of a batch"),
    (rf"alone-{N}", "run {} by itself"),
    (r"alone(?=-)", "alone"),
    (rf"map-{N}", "cell {} of the map"),
    (r"double", "double precision"),
    (r"without-[a-z-]+", "{whole}"),
    (r"untrimmed", "exactly as shipped"),
    (r"as-shipped", "shipped pads"),
    (r"stiff-pads|stiff", "stiff pads"),
    (r"fixed", "fixed scene"),
    (r"hold", "arm held still"),
    (r"mujoco-contacts", "contacts found by MuJoCo"),
    (r"mujoco-c(?=-|$)", "MuJoCo C"),
    (r"warp-cpu", "Warp on the CPU"),
    (r"warp", "MuJoCo Warp"),
    (r"through-newton", "through Newton"),
    (r"newton-each-substep", "Newton's contacts in each substep"),
    (r"(newton|mujoco|c)-rk4(?=/)", "{engine}, RK4"),
    (r"(newton|mujoco|c|cpu|reference)(?=/)", "{engine}"),
    (r"noslip", "noslip"),
    (r"missing-term", "missing term computed"),
    (r"term-restored", "missing term put back"),
    (r"mujoco", "MuJoCo's contacts"),
    (r"newton", "Newton's contacts"),
    (rf"implicitfast-{N}", "implicitfast, impratio {}"),
    (rf"euler-{N}", "Euler, impratio {}"),
    (rf"rk4-{N}", "RK4, impratio {}"),
    (r"rk4", "RK4"),
    (r"(?:cube|ball)(?=-)", "{whole}"),
    (rf"{N}ms(?=-|$)", "{} ms"),
    (r"published", "as published"),
    (r"elliptic(?=-|$)", "elliptic cone"),
    (r"slope(?=-)", "slope"),
    (r"implicitfast", "implicitfast"),
    (r"recipe", "elliptic cone, impratio 10"),
    (rf"condim-{N}", "condim {}"),
    (r"within-pads", "shorter than the pads"),
    (r"short", "timeconst 4 ms"),
    (r"own-timeconst", "MuJoCo's own timeconst"),
    (r"euler", "Euler"),
    (r"impratio", "impratio raised"),
    (r"pyramidal", "pyramidal cone"),
    (r"half-timeconst", "half the time constant"),
    (r"half-step", "half the step"),
    (r"plain", "nothing done"),
    (r"term-centred|centred", "term centred"),
    (r"term", "term put back"),
    (r"full", "term centred, in normal rows too"),
    (r"kept", "positions compensated"),
    (r"rounded", "positions rounded"),
    (r"best", "all remedies"),
    (r"motion", "motion in MuJoCo C"),
    (r"shipped", "shipped pads"),
    (r"held", "held still"),
    (rf"{N}cm", "{} cm"),
    (r"c(?=$)", "MuJoCo C"),
)
"""Parts that the name of a case is made of, the first that fits counts; what is in brackets are its numbers."""
ONE = re.compile(r"(\b1 (?:\w+ )*\w+)s$")
"""One of something, whose plural loses its s."""
ENGINES = {
    "newton": "Newton's contacts",
    "mujoco": "MuJoCo's contacts",
    "c": "MuJoCo C",
    "cpu": "Warp on the CPU",
    "reference": "converged",
}
COMPILED = tuple((re.compile(f"[-/]?(?:{pattern})"), words) for pattern, words in PARTS)


NAMED_COUNT = 6
"""Cases that a sentence names at most."""


def name_of(case: str) -> str:
    """What a case is called; a case that no rule knows keeps its own name, with spaces."""
    if case in WHOLE:
        return WHOLE[case]
    rest, names = case, []
    while rest:
        found = next((pair for pair in ((rule.match(rest), words) for rule, words in COMPILED) if pair[0]), None)
        if found is None:
            return case.replace("-", " ").replace("_", " ")
        match, words = found
        names.append(_filled(match, words))
        rest = rest[match.end() :]
    return ", ".join(names)


def _filled(match: re.Match, words: str) -> str:
    whole = match[0].lstrip("-/")
    engine = ENGINES.get(next(iter(match.groups()), ""), "")
    numbers = [] if engine else [number_of(text) for text in match.groups()]
    text = words.format(*numbers, engine=engine, whole=WHOLE.get(whole, whole.replace("-", " ")))
    return ONE.sub(r"\1", text)


def number_of(text: str) -> str:
    """A number of a case's name as one reads it: ``2.5e6`` as 2.5×10⁶ and ``0.2`` as it is."""
    mantissa, _, power = text.partition("e")
    if not power:
        return text
    value = float(text)
    if 1e-3 <= value < 1e5:
        return f"{value:g}"
    scale = format_power(int(power))
    return scale if float(mantissa) == 1 else f"{mantissa}×{scale}"


def worlds_name(count: int) -> str:
    """What a batch of so many worlds is called."""
    return f"{format_number(count)} world{'s' * (count > 1)}"


def case_html(case: str) -> Markup:
    """The name of a case, its code name in the title."""
    return Markup('<span class="case" title="{}">{}</span>').format(case, name_of(case))


def some_html(names: Sequence[Markup]) -> Markup:
    """As many of these as a sentence can hold, and that there are others."""
    text = Markup("; ").join(names[:NAMED_COUNT])
    return text + " and others" if len(names) > NAMED_COUNT else text


def cases_html(cases: Iterable[str]) -> Markup:
    """Names of cases in a sentence; ``none`` where there are none."""
    return Markup("; ").join(map(case_html, cases)) or Markup("none")
