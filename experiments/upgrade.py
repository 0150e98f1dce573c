"""Measure the values to compare between releases.

These are the headline runs, their live contact rows, and the only known cause of
changes.
"""

from dataclasses import replace

import newton
import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, HOLD, STIFF_PADS, Case
from experiments.facts.trace import ContactRows
from experiments.simulation.measurement import (
    SHAKE_COLUMNS,
    Conditions,
    grasp_columns,
    numbers_of,
    summarize,
)
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE
from measured_report.measuring.measurement import Measurement, absent
from newton_lint.newton_models import compat

REFSAFE_TIMECONST_S = 2.0 / (FRAME_RATE * AS_SHIPPED.substeps)
"""The timeconst to which the engine raises any smaller one: two time steps."""
# Runs of every release. The last two remove or add a timeconst of the friction rows.
RUNS = (
    AS_SHIPPED,
    STIFF_PADS,
    HOLD,
    replace(AS_SHIPPED, name="as-shipped-mujoco-contacts", contacts="mujoco"),
    replace(STIFF_PADS, name="stiff-pads-mujoco-contacts", contacts="mujoco"),
    replace(
        AS_SHIPPED,
        name="as-shipped-friction-timeconst-off",
        friction_timeconst_override_s=0.0,
    ),
    replace(
        AS_SHIPPED,
        name="as-shipped-friction-timeconst-on",
        friction_timeconst_override_s=REFSAFE_TIMECONST_S,
    ),
)
KF_RUNS = (  # the same with a parameter that users can set, if the release uses it
    *(
        replace(case, name=f"{case.name}-kf-off", pad_kf=-1.0)
        for case in (AS_SHIPPED, STIFF_PADS, HOLD)
    ),
    *(
        replace(AS_SHIPPED, name=f"as-shipped-kf-{kf:g}", pad_kf=kf)
        for kf in (3.0, 10.0, 30.0, 100.0)
    ),
)
ENGINE_ARRAYS = (
    "actuator_biasprm actuator_gainprm body_gravcomp body_mass dof_armature dof_damping dof_frictionloss"
    " geom_condim geom_friction geom_gap geom_margin geom_priority geom_solimp geom_solmix geom_solref jnt_range"
).split()


def measure(conditions: Conditions) -> Measurement:
    """Return rows of runs, with their contacts in the middle of the shake, and rows of
    settings.
    """
    cases = [*RUNS, *(KF_RUNS if compat.kf_is_read() else ())]
    traces = conditions.simulate(
        cases, contact_frames=conditions.contact_frames()[1:2], title="upgrade"
    )
    rows = [
        {"kind": "run", **summarize(case, trace), **row_columns(trace.contact_rows[0])}
        for case, trace in zip(cases, traces, strict=True)
    ]
    if not compat.kf_is_read():
        rows += [unread(case) for case in KF_RUNS]
    return Measurement(rows + setting_rows(conditions.device))


def row_columns(contacts: ContactRows) -> dict[str, object]:
    """Return the live contacts of a frame: their count, and the strongest one.

    ``friction_damping_per_s`` describes the behaviour of the friction rows instead of
    their parameters. They are set to the acceleration -b v, and this is the b of the
    faster row.
    """
    strongest = int(contacts.force_n[:, 0].argmax())
    velocity, reference = (
        contacts.velocity_m_s[strongest, 1:],
        contacts.reference_m_s2[strongest, 1:],
    )
    columns = grasp_columns(contacts) | {"frame": contacts.frame}
    if contacts.force_n[strongest, 0] <= 0.0:
        return columns | absent(["friction_damping_per_s"], "no contact carries force")
    faster = int(np.abs(velocity).argmax())
    return columns | {
        "friction_damping_per_s": float(-reference[faster] / velocity[faster])
    }


def unread(case: Case) -> dict[str, object]:
    """Return a row without numbers, for a run that would only repeat another one.

    The release does not use the parameter that differs.
    """
    reason = f"the contact solver of newton {newton.__version__} does not read kf"
    columns = (*SHAKE_COLUMNS, "friction_timeconst_s", "friction_damping_per_s")
    row = {"kind": "run", "case": case.name, "pad_kf": case.pad_kf}
    return row | absent(columns, reason)


def setting_rows(device: str) -> list[dict[str, object]]:
    """Return a row for each setting that the scene as shipped does not set itself.

    These are the final options of the solver, the defaults of a shape, and sums over
    the engine's arrays. The sums reveal a change in the conversion of the scene.
    """
    simulation = Simulation([replace(AS_SHIPPED, frame_count=1)], wp.get_device(device))
    simulation.step()  # some options are set only by a step
    engine, builder = simulation.solver.mjw_model, newton.ModelBuilder()
    settings = {
        "option": dict(numbers_of(engine.opt)),
        "default": dict(numbers_of(builder.ShapeConfig()))
        | {"rigid_gap": builder.rigid_gap},
        "sum": {
            name: float(getattr(engine, name).numpy().sum()) for name in ENGINE_ARRAYS
        },
    }
    return [
        {"kind": kind, "case": f"{kind}-{name}", "name": name, "value": value}
        for kind, values in settings.items()
        for name, value in values.items()
    ]
