"""Other engines: the box on the turning table, the pinched capsule, the shake, and numbers that others published."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from report.sections.engines import published, robot
from report.shared import (
    PERCENT,
    Claim,
    Column,
    Quantity,
    Results,
    Section,
    Sections,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    combined,
    constant,
    greater,
    joined,
    table_of,
)

order = 187
page = "scenes"
reads = ("cure", "scenes", "solver")
label = "other engines"

MODELS = {
    "mjx": "MJX",
    "drake-sap-point": "Drake, SAP, points",
    "drake-sap-hydroelastic": "Drake, SAP, hydroelastic",
    "drake-tamsi-point": "Drake, TAMSI, points",
    "drake-tamsi-hydroelastic": "Drake, TAMSI, hydroelastic",
    "drake-tamsi-strict": "Drake, TAMSI, vₛ a tenth",
    "drake-lagged-point": "Drake, lagged, points",
    "drake-continuous-point": "Drake, continuous, points",
    "dart": "DART",
    "pybullet": "PyBullet",
    "physx": "PhysX, TGS",
    "discrete-20ms": "MuJoCo C, integrator discrete",
}
OURS = {
    "c": "MuJoCo C",
    "warp": "MuJoCo Warp",
}  # engines of which other sections have the numbers
CONTINUOUS = "drake-continuous-point"


class Line(NamedTuple):
    """A contact model with its numbers: walk [%/s] and sinking [µm/s], at a step of 2 ms."""

    name: str
    release: str
    walk: Value
    short_walk: Value  # walk with half the step
    sink: Value


def derive(results: Results) -> Section:
    why = "a place 200 mm from the axis is rounded to 15 nm in single precision, half of it in each step of 2 ms"
    walk_bound = results.chosen("walk_bound", why, 0.002, "%/s")
    sink_bound = results.chosen("sink_bound", "10 nm in a second", 0.01, "µm/s")
    lines = list(_lines(results))
    columns: dict[str, Column] = {"release": [line.release for line in lines]}
    columns |= {"walk": _shown([line.walk for line in lines], walk_bound)}
    columns |= {
        "half the step": _shown([line.short_walk for line in lines], walk_bound)
    }
    columns |= {"sinks": _shown([line.sink for line in lines], sink_bound)}
    long = results.chosen("step", "given: the time step", 2.0, "ms")
    numbers: dict[str, Any] = {
        "walk_bound": walk_bound,
        "sink_bound": sink_bound,
        "long": long,
    }
    engines = table_of("engine", [line.name for line in lines], columns, **numbers)
    robots, others = robot.derive(results, MODELS), published.derive(results)
    claims = [_walks_most_in_mujoco(results, lines), _test_lets_through(results)]
    return joined([Section(tables={"engines": engines}, claims=claims), robots, others])


def _lines(results: Results) -> Iterator[Line]:
    """Derive each line from its walks [1/s], with the whole step and with half of it, and the sinking [mm/s]."""
    runs: list[tuple[Any, ...]] = []
    sections, newton = (
        Sections(results.others),
        f"Newton {results.record.identity.packages['newton']}",
    )
    for engine, name in OURS.items():
        walks = [
            sections.cell("cure", f"{run}-{engine}", "growth_per_s")
            for run in ("plain", "half-step")
        ]
        sink = sections.cell("scenes", f"within-pads-{engine}", "steady_creep_mm_s")
        runs.append((engine, name, newton, *walks, sink))
    for model, name in MODELS.items():
        step = "0ms" if model == CONTINUOUS else "2ms"
        tests = f"turntable-{step}", "turntable-1ms", f"pinch-{step}"
        long, short, pinch = (results.row[f"{model}-{test}"] for test in tests)
        halved = (
            absent("1/s", "continuous time has no step")
            if model == CONTINUOUS
            else short.growth_per_s
        )
        runs.append(
            (
                model.replace("-", "_"),
                name,
                long.release,
                long.growth_per_s,
                halved,
                pinch.creep_mm_s,
            )
        )
    for key, name, release, whole, half, sink in runs:
        formula = "in percent of the distance from the axis"
        walk = results.value(f"{key}_walk", formula, PERCENT * whole)
        halved = results.value(f"{key}_short_walk", formula, PERCENT * half)
        sinking = results.value(
            f"{key}_sink", "how fast the capsule sinks", constant(1e3, "µm/mm") * sink
        )
        yield Line(name, release, walk, halved, sinking)


def _shown(cells: Sequence[Value], bound: Value) -> list[Quantity | str]:
    return [
        "not seen"
        if cell.value is not None and abs(cell.value) <= bound.value
        else cell
        for cell in cells
    ]


def _walks_most_in_mujoco(results: Results, lines: Sequence[Line]) -> Claim:
    """Tell whether it walks nowhere else as fast, and half the step does not help; MJX ran where the others did."""
    mujoco = {*OURS.values(), MODELS["mjx"], MODELS["discrete-20ms"]}
    mine = next(line for line in lines if line.name == MODELS["mjx"])
    others = [
        line.walk
        for line in lines
        if line.name not in mujoco and line.walk.value is not None
    ]
    worst = results.value(
        "worst_other", "fastest walk in another engine", combined(max, *others)
    )
    times = results.value(
        "times", "walk in MuJoCo's MJX, of the fastest elsewhere", mine.walk / worst
    )
    halved = results.value(
        "kept",
        "walk in MuJoCo's MJX with half the step, of that with the whole",
        PERCENT * mine.short_walk / mine.walk,
    )
    tests = [
        at_least(times, 1.5, why="much faster"),
        at_least(halved, 90.0, why="about as much"),
    ]
    discrete = next(line.walk for line in lines if line.name == MODELS["discrete-20ms"])
    if discrete.value is not None:
        tests.append(
            at_least(
                results.value(
                    "discrete_times",
                    "walk in MuJoCo C with the integrator discrete, of the fastest elsewhere",
                    discrete / worst,
                ),
                1.5,
                why="much faster",
            )
        )
    numbers: dict[str, Any] = {
        "mine": mine.walk,
        "worst": worst,
        "short": mine.short_walk,
    }
    numbers["discrete"] = "" if discrete.value is None else discrete
    return Claim("walks_most_in_mujoco", all_of(*tests).having_read(discrete), numbers)


def _test_lets_through(results: Results) -> Claim:
    bound = results.chosen("test_bound", "the test passes below 3 cm", 30.0, "mm")
    shipped, soft = (results.row[f"fet028-pad-kd-{kd}"] for kd in (100, 5))
    more = results.value(
        "soft_times",
        "slip with less damped pads, of that as shipped",
        soft.slip_mm / shipped.slip_mm,
    )
    passes = (at_most(row.slip_mm, bound) for row in (soft, shipped))
    outcome = all_of(*passes, at_least(more, 10.0, why="far more"))
    is_more = greater(soft.slip_mm, shipped.slip_mm).answer
    numbers = {
        "slip": shipped.slip_mm,
        "kd": soft.pad_kd,
        "soft": soft.slip_mm,
        "is_more": is_more,
        "bound": bound,
    }
    numbers |= {
        "amplitude": shipped.shake_amplitude_m,
        "frequency": shipped.shake_frequency_hz,
    }
    return Claim(
        "test_lets_through", outcome, numbers | {"seconds": shipped.shake_duration_s}
    )
