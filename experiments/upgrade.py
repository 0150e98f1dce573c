"""What to compare between releases: the headline runs, their live contact rows, and the one cause that is known."""

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
"""What the engine makes of any smaller timeconst: two time steps."""
RUNS = (  # Runs of every release. The last two take a timeconst of its own from the friction rows, or give them one.
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
KF_RUNS = (  # the same through what a user can set, where the release reads it
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
    """Return rows of runs, with their contacts in the middle of the shake, and of settings."""
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
    """Return the live contacts of a frame: how many, and the rows of the one that carries most force.

    ``friction_damping_per_s`` is what the friction rows do rather than what is stored for them: they aim at the
    acceleration -b v, and this is b, from the one of the two that moves faster.
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
    """Return a row without numbers, for a run that would only repeat the one without the parameter."""
    reason = f"the contact solver of newton {newton.__version__} does not read kf"
    columns = (*SHAKE_COLUMNS, "friction_timeconst_s", "friction_damping_per_s")
    row = {"kind": "run", "case": case.name, "pad_kf": case.pad_kf}
    return row | absent(columns, reason)


def setting_rows(device: str) -> list[dict[str, object]]:
    """Return a row for each setting that the scene as shipped does not make itself.

    Those are the options that the solver ends up with, the defaults of a shape, and sums over the engine's arrays, in
    which a change of how the scene is converted shows.
    """
    simulation = Simulation([replace(AS_SHIPPED, frame_count=1)], wp.get_device(device))
    simulation.step()  # a step sets the options that are set last
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
