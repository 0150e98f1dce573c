"""Compare results of other engines for four scenes: a box on a table, a pinched
capsule, the shake, and scenes with published numbers.
"""

from collections.abc import Iterator
from typing import NamedTuple

from report.sections.engines import published, robot
from report.shared import (
    PERCENT,
    Claim,
    Quantity,
    Results,
    Section,
    Sections,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    constant,
    extreme,
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
# Engines that were measured in other sections.
OURS = {"c": "MuJoCo C", "warp": "MuJoCo Warp"}
CONTINUOUS = "drake-continuous-point"


class Line(NamedTuple):
    """The results of a contact model: the walk [%/s] and the sinking [µm/s]."""

    name: str
    release: str
    walk: Value  # with a step of 2 ms
    short_walk: Value  # with half the step
    sink: Value


def derive(results: Results) -> Section:
    lines = list(_lines(results))
    by_name = {line.name: line for line in lines}
    walk_bound = results.chosen(
        "walk_bound",
        "rounding to single precision, which is 7.5 nm in each step of 2 ms at 200 mm"
        " from the axis, gives this rate",
        0.002,
        "%/s",
    )
    sink_bound = results.chosen("sink_bound", "10 nm in a second", 0.01, "µm/s")
    columns = {
        "release": [line.release for line in lines],
        "walk": _measurable([line.walk for line in lines], walk_bound),
        "walk with half the step": _measurable(
            [line.short_walk for line in lines], walk_bound
        ),
        "sinks": _measurable([line.sink for line in lines], sink_bound),
    }
    step = results.chosen("step", "given: the time step", 2.0, "ms")
    engines = table_of(
        "engine",
        by_name,
        columns,
        walk_bound=walk_bound,
        sink_bound=sink_bound,
        long=step,
    )

    # MJX was run on the same machine as the other engines.
    mjx = by_name[MODELS["mjx"]]
    discrete = by_name[MODELS["discrete-20ms"]].walk
    mujoco = {*OURS.values(), MODELS["mjx"], MODELS["discrete-20ms"]}
    others = [line.walk for line in lines if line.name not in mujoco]
    worst = results.value(
        "worst_other", "fastest walk in another engine", extreme(max, others)
    )
    times = results.value(
        "times",
        "walk in MJX over the fastest walk in another engine",
        mjx.walk / worst,
    )
    halved = results.value(
        "kept",
        "walk in MJX with half the step, relative to the walk with the whole step",
        PERCENT * mjx.short_walk / mjx.walk,
    )
    tests = [
        at_least(times, 1.5, "much faster"),
        at_least(halved, 90.0, "about as much"),
    ]
    if discrete.value is not None:
        discrete_times = results.value(
            "discrete_times",
            "walk in MuJoCo C with the integrator discrete over the fastest walk in"
            " another engine",
            discrete / worst,
        )
        tests.append(at_least(discrete_times, 1.5, "much faster"))
    walks = Claim(
        "walks_most_in_mujoco",
        all_of(*tests).having_read(discrete),
        {
            "mine": mjx.walk,
            "worst": worst,
            "short": mjx.short_walk,
            "discrete": "" if discrete.value is None else discrete,
        },
    )

    bound = results.chosen("test_bound", "the test passes below 3 cm", 30.0, "mm")
    shipped, soft = (results.row[f"fet028-pad-kd-{kd}"] for kd in (100, 5))
    more = results.value(
        "soft_times",
        "slip with less damped pads divided by the slip as shipped",
        soft.slip_mm / shipped.slip_mm,
    )
    passes = all_of(
        at_most(soft.slip_mm, bound),
        at_most(shipped.slip_mm, bound),
        at_least(more, 10.0, "far more"),
    )
    lets_through = Claim(
        "test_lets_through",
        passes,
        {
            "slip": shipped.slip_mm,
            "kd": soft.pad_kd,
            "soft": soft.slip_mm,
            "is_more": greater(soft.slip_mm, shipped.slip_mm).answer,
            "bound": bound,
            "amplitude": shipped.shake_amplitude_m,
            "frequency": shipped.shake_frequency_hz,
            "seconds": shipped.shake_duration_s,
        },
    )
    section = Section(tables={"engines": engines}, claims=[walks, lets_through])
    return joined([section, robot.derive(results, MODELS), published.derive(results)])


def _lines(results: Results) -> Iterator[Line]:
    def line(key: str, name: str, release: str, whole, half, sink) -> Line:
        formula = "growth of the distance from the axis, relative to the distance"
        walk = results.value(f"{key}_walk", formula, PERCENT * whole)
        halved = results.value(f"{key}_short_walk", formula, PERCENT * half)
        sinking = results.value(
            f"{key}_sink",
            "speed at which the capsule sinks",
            constant(1e3, "µm/mm") * sink,
        )
        return Line(name, release, walk, halved, sinking)

    cell = Sections(results.others).cell
    newton = f"Newton {results.record.identity.packages['newton']}"
    for engine, name in OURS.items():
        yield line(
            engine,
            name,
            newton,
            cell("cure", f"plain-{engine}", "growth_per_s"),
            cell("cure", f"half-step-{engine}", "growth_per_s"),
            cell("scenes", f"within-pads-{engine}", "steady_creep_mm_s"),
        )
    for model, name in MODELS.items():
        step = "0ms" if model == CONTINUOUS else "2ms"
        row = results.row[f"{model}-turntable-{step}"]
        half = results.row[f"{model}-turntable-1ms"].growth_per_s
        if model == CONTINUOUS:
            half = absent("1/s", "continuous time does not have a step")
        sink = results.row[f"{model}-pinch-{step}"].creep_mm_s
        key = model.replace("-", "_")
        yield line(key, name, row.release, row.growth_per_s, half, sink)


def _measurable(cells: list[Value], bound: Value) -> list[Quantity | str]:
    """Return the cells, with "not measurable" for cells up to the bound."""
    return [
        "not measurable"
        if cell.value is not None and abs(cell.value) <= bound.value
        else cell
        for cell in cells
    ]
