"""Adds the missing term of ``contact_bias`` in MuJoCo's C engine."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import TYPE_CHECKING

import mujoco
import numpy as np

if TYPE_CHECKING:
    from newton.solvers import SolverMuJoCo

ELLIPTIC = int(mujoco.mjtCone.mjCONE_ELLIPTIC)


def install(
    solver: SolverMuJoCo, *, centred: bool = False, normal: bool = False
) -> None:
    """Add J̇ q̇ to the friction rows of a solver's contacts in every step.

    See ``contact_bias.install`` for ``centred`` and ``normal``.
    """

    def control(engine: mujoco.MjModel, data: mujoco.MjData) -> None:
        subtract_bias(engine, data, centred=centred, normal=normal)

    def step(engine: mujoco.MjModel, data: mujoco.MjData) -> None:
        # MuJoCo calls the callback for every model, so it is set only during this step.
        mujoco.set_mjcb_control(control)
        try:
            mujoco.mj_step(engine, data)
        finally:
            mujoco.set_mjcb_control(None)

    # Newton steps the engine with this function.
    solver._mujoco = SimpleNamespace(mj_step=step)


def watch_steps(solver: SolverMuJoCo, around: Callable[..., None]) -> None:
    """Replace the step of a solver with ``around(old_step, engine, data)``."""
    step = solver._mujoco.mj_step
    solver._mujoco = SimpleNamespace(
        mj_step=lambda engine, data: around(step, engine, data)
    )


def subtract_bias(
    engine: mujoco.MjModel,
    data: mujoco.MjData,
    *,
    centred: bool = False,
    normal: bool = False,
) -> None:
    """Subtract J̇ q̇ from the reference accelerations of the rows.

    MuJoCo calls ``mjcb_control`` after it has made the rows and before it solves them.
    """
    for contact in data.contact:
        if contact.efc_address >= 0:
            linear, angular = velocity_product(engine, data, contact)
            axes = contact.frame.reshape(3, 3)
            missing = np.concatenate([axes @ linear, axes @ angular])
            subtract(engine, data, contact, missing, centred=centred, normal=normal)


def subtract(
    engine: mujoco.MjModel,
    data: mujoco.MjData,
    contact: mujoco.MjContact,
    missing: np.ndarray,
    *,
    centred: bool,
    normal: bool,
) -> None:
    """Subtract the missing accelerations of a contact from its rows.

    Args:
        missing: Three linear and three angular accelerations in the contact frame.
    """
    row, dim, is_elliptic = (
        contact.efc_address,
        contact.dim,
        engine.opt.cone == ELLIPTIC,
    )
    missing = missing[:dim]
    missing[0] *= normal
    if centred:
        solref = (
            contact.solreffriction
            if is_elliptic and contact.solreffriction.any()
            else contact.solref
        )
        half = 0.5 * engine.opt.timestep
        missing[0] *= 1.0 - half * damping(engine, contact.solref, contact.solimp)
        missing[1:] *= 1.0 - half * damping(engine, solref, contact.solimp)
    if is_elliptic or dim == 1:
        data.efc_aref[row : row + dim] -= missing
    else:
        leaning = contact.friction[: dim - 1] * missing[1:]
        data.efc_aref[row : row + 2 * dim - 2] -= (
            missing[0] + np.stack([leaning, -leaning], axis=1).ravel()
        )


def velocity_product(
    engine: mujoco.MjModel, data: mujoco.MjData, contact: mujoco.MjContact
) -> tuple[np.ndarray, np.ndarray]:
    """Return J̇ q̇ of the second geom relative to the first, at a contact.

    Returns:
        The linear part [m/s²] and the angular part [rad/s²], which have the shape [3].
    """
    of_geom = np.zeros((2, 2, 3, engine.nv))
    for (linear, angular), geom in zip(of_geom, contact.geom, strict=True):
        mujoco.mj_jacDot(
            engine, data, linear, angular, contact.pos, engine.geom_bodyid[geom]
        )
    linear, angular = (of_geom[1] - of_geom[0]) @ data.qvel
    return linear, angular


def damping(engine: mujoco.MjModel, solref: np.ndarray, solimp: np.ndarray) -> float:
    """Return b of a row [1/s] (MuJoCo documentation, "Solver parameters")."""
    timeconst, second = solref
    dmax = np.clip(solimp[1], mujoco.mjMINIMP, mujoco.mjMAXIMP)
    if second <= 0.0:
        return -second / dmax
    if not engine.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_REFSAFE:
        timeconst = max(timeconst, 2.0 * engine.opt.timestep)
    return 2.0 / (dmax * timeconst)
