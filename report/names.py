"""What cases are called in figures, tables and sentences; the data, and a title on the page, have their code names."""

import re
from collections.abc import Iterable, Sequence
from functools import cache

from markupsafe import Markup

from measured_report.values.format import format_number, format_power

WHOLE = {"batch-1": "one world", "batch-64": "64 worlds in a batch", "iterations-15": "shipped settings"}
"""Cases whose names say another thing within that of another case."""
PARTS = """
as-shipped, shipped, pad-ke-2.5e3: shipped pads; stiff-pads, stiff, stiff-pads-only, pad-ke-2.5e5: stiff pads
untrimmed, as-shipped-untrimmed: exactly as shipped; fixed: fixed scene; hold: arm held still; held: held still
pad-ke-#-kd-#, sweep-ke-#-kd-#: pads' ke {}, kd {}; pad-ke-#, sweep-ke-#: pads' ke {}, kd with it
ke-critical-#-#: pads' ke {}, kd = 2√ke, {} substeps; ke-kd-#-#-#: pads' ke {1}, kd {0}, {2} substeps
largest-step-ke-critical-#: largest step, ke {}, kd = 2√ke; largest-step-ke-kd-#-#: largest step, ke {1}, kd {0}
kf-off: kf below zero; kf-#: kf {}; pad-mu-#: pads' friction {}; cube-mu-#: cube's friction {}; cube-ke-#: cube's ke {}
priority-0: equal priorities; priority-0-cube-ke-8e5: equal priorities, stiffer cube; solimp-dmax-#: dmax {}
all-gaps-zero: no contact gap; cube-gap-default: default gap; cube-gap-#: cube's gap {} m; condim-#: condim {}
pads-convex-mesh: pads as convex meshes; within-pads: shorter than the pads; contacts-#hz: contacts at {} Hz
own-timeconst: MuJoCo's own timeconst; half-timeconst: half the time constant; short: timeconst 4 ms
friction-timeconst-off: friction rows' time constant taken out; published: as published; substeps-#: substeps {}
friction-timeconst-on: two substeps as friction rows' time constant; integrator-euler: Euler integrator
iterations-#: {} iterations; ls_iterations-#: {} line search iterations; tolerance-#: tolerance {}
impratio: impratio raised; impratio-#, elliptic-impratio-#: impratio {}; recipe: elliptic cone, impratio 10
elliptic: elliptic cone; pyramidal, cone-pyramidal: pyramidal cone; solver-cg: conjugate gradients
implicitfast-#: implicitfast, impratio {}; euler-#: Euler, impratio {}; rk4-#: RK4, impratio {}; rk4: RK4; euler: Euler
steps-as-shipped-#: shipped pads, {} substeps; steps-stiff-#: stiff pads, {} substeps; half-step: half the step
clamp-off-#: clamp off, timeconst of {} steps; clamp-direct-#: negative solref, timeconst of {} steps
shake-#mm-#hz: shake {} mm, {} Hz; #cm-#hz: {} cm, {} Hz; #cm: {} cm; #ms: {} ms; #s: {} s; grip-#: grip × {}
mass-#kg: mass {} kg; size-#mm-as-shipped: edge {} mm, shipped grip; size-#mm-scaled: edge {} mm, grip by mass
overlap-pads-as-shipped-#mm: start {} mm deep in shipped pads; overlap-pads-stiff-#mm: start {} mm deep in stiff pads
overlap-ground-#mm: start {} mm deep in the ground; overlap-ground-springy-#mm: start {} mm deep in springy ground
gravity--9.81: gravity upward; gravity-98.1: gravity tenfold; gravity-9.81: gravity as on Earth; gravity-0: no gravity
freed: cube let go; buffers-contact-#: room for {} contacts; buffers-constraint-#: room for {} constraint rows
buffers-ample: ample buffers; long-stiff: stiff pads, long shake; best: the whole cure; motion: motion in MuJoCo C
worlds-#: {} worlds; batch-#: run {} of a batch; alone-#: run {} by itself; map-#: cell {} of the map
mujoco-c, c: MuJoCo C; warp: MuJoCo Warp; warp-cpu, cpu: Warp on the CPU; one-core: one core of C; reference: converged
mujoco: MuJoCo's contacts; contacts-mujoco, mujoco-contacts: contacts found by MuJoCo; newton: Newton's contacts
newton-each-substep: Newton's contacts in each substep; through-newton: through Newton; double: double precision
precision-warp: MuJoCo Warp, single precision; precision-c-double: MuJoCo C, double precision
precision-c-single: MuJoCo C, positions rounded to single; engine-mujoco-c: MuJoCo's C engine
missing-term: missing term computed; term-restored: missing term put back; term: term put back; plain: nothing done
double-step-term-restored: shipped pads, steps twice as long, missing term put back; kept: positions compensated
term-centred, centred: term centred; full: term centred, in normal rows too; rounded: positions rounded
without-all: without all of it; without-buffers: without room in the buffers; without-ik-in-turn: without waiting for IK
without-ik-iterations: without most IK iterations; without-state-sync: without writing the state
without-cube-gap: without the cube's wide gap; without-hand-box: without the hand's box
firm: the cure on stiff pads; firm-euler: the cure on stiff pads, Euler
whole-cure: the whole cure; without-visuals: without visual shapes; without-broad-phase: without the broad phase
"""
"""Parts that the name of a case is made of, the longest that fits counts; a # is a number."""
AS_IT_IS = r"without-[a-z-]+|noslip|slope|implicitfast|cube|ball|alone"
"""Parts that are called so."""
NUMBER, ONE = r"(\d[\d.]*(?:e[+-]?\d+)?)", re.compile(r"(\b1 (?:\w+ )*\w+)s$")
"""A number in a name, and one of something, whose plural loses its s."""
NAMED_COUNT = 6
"""Cases that a sentence names at most."""


def _rules() -> list[tuple[re.Pattern, str]]:
    entries = (entry.split(": ", 1) for entry in re.split("; |\n", PARTS.strip()))
    pairs = [(code, words) for codes, words in entries for code in codes.split(", ")]
    named = {re.escape(code).replace(r"\#", NUMBER): words for code, words in sorted(pairs, key=lambda it: -len(it[0]))}
    named[AS_IT_IS] = ""
    return [(re.compile(f"[-/]?(?:{code})(?=[-/]|$)"), words) for code, words in named.items()]


RULES = _rules()


@cache
def name_of(case: str) -> str:
    """Return what a case is called; a case that no rule knows keeps its own name, with spaces."""
    if case in WHOLE:
        return WHOLE[case]
    rest, names = case, []
    while rest:
        found = next(((match, words) for rule, words in RULES if (match := rule.match(rest))), None)
        if found is None:
            return case.replace("-", " ").replace("_", " ")
        match, words = found
        text = words.format(*map(number_of, match.groups())) or match[0].lstrip("-/").replace("-", " ")
        names.append(ONE.sub(r"\1", text))
        rest = rest[match.end() :]
    return ", ".join(names)


def number_of(text: str) -> str:
    """Return a number of a case's name as one reads it: ``2.5e6`` as 2.5×10⁶ and ``0.2`` as it is."""
    mantissa, _, power = text.partition("e")
    if not power:
        return text
    if 1e-3 <= float(text) < 1e5:
        return f"{float(text):g}"
    scale = format_power(int(power))
    return scale if float(mantissa) == 1 else f"{mantissa}×{scale}"


def worlds_name(count: int) -> str:
    """Return what a batch of so many worlds is called."""
    return f"{format_number(count)} world{'s' * (count > 1)}"


def listed(names: Sequence[str]) -> str:
    """Return these as a sentence lists them."""
    return " and ".join(filter(None, [", ".join(names[:-1]), *names[-1:]]))


def case_html(case: str) -> Markup:
    """Return the name of a case, its code name in the title."""
    return Markup('<span class="case" title="{}">{}</span>').format(case, name_of(case))


def some_html(names: Sequence[Markup]) -> Markup:
    """Return as many of these as a sentence can hold, and that there are others."""
    return Markup("; ").join(names[:NAMED_COUNT]) + (" and others" if len(names) > NAMED_COUNT else "")


def cases_html(cases: Iterable[str]) -> Markup:
    """Return the names of cases in a sentence; ``none`` where there are none."""
    return Markup("; ").join(map(case_html, cases)) or Markup("none")
