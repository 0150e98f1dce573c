"""The turntable, the pinched capsule and the shake in other engines: does each do what its contact model says?"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from measured_report.parts.claim import Claim, all_of, at_least, at_most, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results
from report.sections.engines import published, robot
from report.shared.arithmetic import Column, Found, ratio, share, table_of

order = 187
page = "scenes"
reads = ("cure", "scenes")
label = "other engines"

LONG, SHORT = "2ms", "1ms"
LAWS = {
    "mujoco": "ω²((1 + Rm/n)/b − h/2)",
    "discrete": "ω²((1 + Rm/n)/b + h/2)",
    "step": "ω²h/2",
    "sap": "ω²h/2 + σwhω²m/n",
    "mixed": "ω²h/2 + εwhω²m/n",
    "tamsi": "ω²h/2 + v/r, s(2 − s) = x",
    "lagged": "ω²h/2 + v/r, s/√(1 + s²) = x",
    "stribeck": "v/r, s³(10 − 15s + 6s²) = x",
    "anchored": "none",
}
"""Laws of the walk. Each gives the sinking as well, by the same v."""
MUJOCO = ("mujoco", "discrete")
HELPS = {"mujoco": "the term", **dict.fromkeys(("tamsi", "lagged", "stribeck"), "smaller vₛ")}
"""Remedies that a law of the walk names, beside a shorter step."""
GOES_WITH_STEP = 0.75
"""Half the step leaves at most so much of a walk that goes with the step."""
MODELS = {
    "mjx": ("MJX", "mujoco"),
    "drake-sap-point": ("Drake, SAP, points", "sap"),
    "drake-sap-hydroelastic": ("Drake, SAP, hydroelastic", "sap"),
    "drake-tamsi-point": ("Drake, TAMSI, points", "tamsi"),
    "drake-tamsi-hydroelastic": ("Drake, TAMSI, hydroelastic", "tamsi"),
    "drake-tamsi-strict": ("Drake, TAMSI, vₛ a tenth", "tamsi"),
    "drake-lagged-point": ("Drake, lagged, points", "lagged"),
    "drake-continuous-point": ("Drake, continuous, points", "stribeck"),
    "dart": ("DART", "mixed"),
    "pybullet": ("PyBullet", "step"),
    "physx": ("PhysX, TGS", "anchored"),
    "discrete-20ms": ("MuJoCo C, integrator discrete", "discrete"),
}
WALK_LAW, SINK_LAW = "predicted_growth_per_s", "predicted_creep_mm_s"


@dataclass(frozen=True)
class Line:
    """A contact model with its numbers: walk [%/s] and sinking [µm/s], measured and by its law, at a step of 2 ms."""

    name: str
    """Begins with that of the engine."""
    release: str
    law: str
    walk: Value
    walk_law: Value
    short_walk: Value
    """Walk with half the step."""
    sink: Value
    sink_law: Value


def derive(results: Results) -> Section:
    why = "a place 200 mm from the axis is rounded to 15 nm in single precision, half of it in each step of 2 ms"
    walk_bound = results.chosen("walk_bound", why, 2e-3, unit="%/s")
    sink_bound = results.chosen("sink_bound", "10 nm in a second", 0.01, unit="µm/s")
    lines = list(_lines(results))
    columns: dict[str, Column] = {
        "release": [line.release for line in lines],
        "walk by law": _shown([line.walk_law for line in lines], walk_bound),
        "walk": _shown([line.walk for line in lines], walk_bound),
        "half the step": _shown([line.short_walk for line in lines], walk_bound),
        "sinks by law": _shown([line.sink_law for line in lines], sink_bound),
        "sinks": _shown([line.sink for line in lines], sink_bound),
        "what should help": [_helps(line, walk_bound) for line in lines],
        "law of the walk": [LAWS[line.law] for line in lines],
    }
    long = results.chosen("step", "given: the time step", 2.0, unit="ms")
    said: dict[str, Any] = {"walk_bound": walk_bound, "sink_bound": sink_bound, "long": long}
    claims = [_as_their_laws_say(results, lines, walk_bound, sink_bound), _walks_most_in_mujoco(results, lines)]
    engines = table_of("engine", [line.name for line in lines], columns, **said)
    robots = robot.derive(results, {model: name for model, (name, _) in MODELS.items()})
    others = published.derive(results)
    return Section(
        tables={"engines": engines, **robots.tables, **others.tables},
        claims=[*claims, *robots.claims, _test_lets_through(results), *others.claims],
        unmeasured=[*robots.unmeasured, *others.unmeasured],
    )


def _lines(results: Results) -> Iterator[Line]:
    found, units = Found(results.others), {"cure": "1/s", "scenes": "mm/s"}
    turntable, capsule = (partial(found.cell, section, unit=unit) for section, unit in units.items())
    newton = f"Newton {results.record.identity.packages['newton']}"
    for engine, name in (("c", "MuJoCo C"), ("warp", "MuJoCo Warp")):
        walks = [turntable(f"plain-{engine}", column) for column in ("growth_per_s", WALK_LAW)]
        walks.append(turntable(f"half-step-{engine}", "growth_per_s"))
        sinks = [capsule(f"within-pads-{engine}", column) for column in ("steady_creep_mm_s", SINK_LAW)]
        yield _line(results, engine, (name, newton), "mujoco", walks, sinks)
    for model, (name, law) in MODELS.items():
        step = "0ms" if law == "stribeck" else LONG
        long, short, pinch = (
            results.row[f"{model}-{run}"] for run in (f"turntable-{step}", f"turntable-{SHORT}", f"pinch-{step}")
        )
        laws = long[WALK_LAW], pinch[SINK_LAW]
        if law == "mujoco":  # the equations are MuJoCo's
            laws = turntable("plain-c", WALK_LAW), capsule("within-pads-c", SINK_LAW)
        halved = absent("1/s", "continuous time has no step") if law == "stribeck" else short.growth_per_s
        walks, sinks = [long.growth_per_s, laws[0], halved], [pinch.creep_mm_s, laws[1]]
        yield _line(results, model.replace("-", "_"), (name, long.release), law, walks, sinks)


def _line(
    results: Results, key: str, named: tuple[str, str], law: str, walks: Sequence[Quantity], sinks: Sequence[Quantity]
) -> Line:
    """Derive a line from walks [1/s], measured, by law and with half the step, and sinkings [mm/s]."""
    shown = []
    for name, cell in zip(("walk", "walk_law", "short_walk"), walks, strict=True):
        formula = "in percent of the distance from the axis"
        shown.append(results.value(f"{key}_{name}", formula, lambda rate: 100 * rate, cell, unit="%/s"))
    for name, cell in zip(("sink", "sink_law"), sinks, strict=True):
        formula = "how fast the capsule sinks"
        shown.append(results.value(f"{key}_{name}", formula, lambda rate: 1e3 * rate, cell, unit="µm/s"))
    return Line(*named, law, *shown)


def _shown(cells: Sequence[Value], bound: Value) -> list[Quantity | str]:
    return ["not seen" if cell.value is not None and abs(cell.value) <= bound.value else cell for cell in cells]


def _helps(line: Line, bound: Value) -> str:
    """Say what takes away from the walk: a shorter step where that was seen, and what its law names."""
    walk, short = line.walk.value, line.short_walk.value
    if walk is not None and abs(walk) <= bound.value:
        return "nothing to help"
    is_shorter = None not in (walk, short) and abs(short) <= GOES_WITH_STEP * abs(walk)
    return ", ".join(filter(None, ["shorter step" if is_shorter else "", HELPS.get(line.law, "")])) or "not known"


def _as_their_laws_say(results: Results, lines: Sequence[Line], walk_bound: Value, sink_bound: Value) -> Claim:
    pairs = [(line.name, line.walk, line.walk_law, walk_bound) for line in lines]
    pairs += [(line.name, line.sink, line.sink_law, sink_bound) for line in lines]
    told = [(name, a, b) for name, a, b, seen in pairs if a.value is not None and abs(b.value or 0.0) > seen.number]
    seen, engines = [cell for _, *both in told for cell in both], len({name.partition(",")[0] for name, *_ in told})

    def largest_departure(*cells: float) -> float:
        return max(100 * abs(a / b - 1) for a, b in zip(cells[::2], cells[1::2], strict=True))

    formula = "largest departure from the law, of it, where the law gives what can be seen"
    largest = results.value("law_off", formula, largest_departure, *seen, unit="%", across=True)
    counted = results.value("engine_count", "engines", lambda *found: engines, *seen, across=True)
    count = results.value("law_count", "numbers that a law gives", lambda *found: len(found) // 2, *seen, across=True)
    outcome = at_most(largest, 5.0, why="as the law says")
    return Claim("as_their_laws_say", outcome, {"largest": largest, "engines": counted, "count": count})


def _walks_most_in_mujoco(results: Results, lines: Sequence[Line]) -> Claim:
    """Tell whether it walks nowhere else as fast, and half the step does not help; MJX ran where the others did."""
    mine = next(line for line in lines if line.name == "MJX")
    others = [line.walk for line in lines if line.law not in MUJOCO and line.walk.value is not None]
    worst = results.value("worst_other", "fastest walk in another engine", max, *others, unit="%/s")
    times = ratio(results, "times", "walk in MuJoCo's MJX, of the fastest elsewhere", mine.walk, worst)
    formula = "walk in MuJoCo's MJX with half the step, of that with the whole"
    kept = share(results, "kept", formula, mine.short_walk, mine.walk)
    outcome = all_of(at_least(times, 1.5, why="much faster"), at_least(kept, 90.0, why="about as much"))
    return Claim("walks_most_in_mujoco", outcome, {"mine": mine.walk, "worst": worst, "short": mine.short_walk})


def _test_lets_through(results: Results) -> Claim:
    bound = results.chosen("test_bound", "the test passes below 3 cm", 30.0, unit="mm")
    shipped, soft = (results.row[f"fet028-pad-kd-{kd}"] for kd in (100, 5))
    formula = "slip with less damped pads, of that as shipped"
    times = ratio(results, "soft_times", formula, soft.slip_mm, shipped.slip_mm)
    passes = (at_most(row.slip_mm, bound) for row in (soft, shipped))
    outcome = all_of(*passes, at_least(times, 10.0, why="far more"))
    is_more = greater(soft.slip_mm, shipped.slip_mm).said
    numbers = {"slip": shipped.slip_mm, "kd": soft.pad_kd, "soft": soft.slip_mm, "is_more": is_more, "bound": bound}
    numbers |= {"amplitude": shipped.shake_amplitude_m, "frequency": shipped.shake_frequency_hz}
    return Claim("test_lets_through", outcome, numbers | {"seconds": shipped.shake_duration_s})
