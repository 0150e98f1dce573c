"""Measure the defaults of a release: solver options, joints and contact materials.

All other sections set the values of 1.4.0 explicitly in the scene, so that they do not
depend on these defaults.
"""

from dataclasses import replace

import newton
from newton.solvers import SolverMuJoCo

from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    numbers_of,
    summarize,
)

NEEDS_GPU = False
"""Tells ``measured_report.measuring.machine`` that a GPU is not needed.

The options are the same on every machine, and the case runs on the CPU.
"""


def measure(conditions: Conditions) -> Measurement:
    """Return a row for the run and one for each default."""
    case = own_case()
    [trace] = conditions.simulate([case], title="defaults")
    run = {"kind": "run", "name": case.name, **summarize(case, trace)}
    return Measurement([run, *default_rows()])


def own_case() -> Case:
    """Return the scene as shipped with this release's contact defaults and gap."""
    builder = newton.ModelBuilder()
    config = builder.ShapeConfig()
    pads = {
        "pad_ke": config.ke,
        "pad_kd": config.kd,
        "pad_kf": config.kf,
        "pad_mu": config.mu,
    }
    return replace(
        AS_SHIPPED,
        name="own-defaults",
        device="cpu",
        cube_gap_m=builder.rigid_gap,
        **pads,
    )


def default_rows() -> list[dict[str, object]]:
    """Return a row for each default option of a solver and each default of a joint."""
    builder = newton.ModelBuilder()
    builder.add_shape_box(builder.add_body(), hx=0.1, hy=0.1, hz=0.1)
    engine = SolverMuJoCo(builder.finalize(device="cpu")).mjw_model
    joint = vars(builder.JointDofConfig())
    numbers = {
        name: float(value)
        for name, value in sorted(joint.items())
        if isinstance(value, (bool, int, float))
    }
    settings = {"solver": dict(numbers_of(engine.opt)), "joint": numbers}
    return [
        {"kind": kind, "case": f"{kind}-{name}", "name": name, "value": value}
        for kind, values in settings.items()
        for name, value in values.items()
    ]
