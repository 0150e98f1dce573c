"""The left-out term of ``contact_bias`` in MuJoCo's C engine and double precision."""

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
    """Give the friction rows of a solver's contacts J̇ q̇ back, in every step; ``centred`` and ``normal`` as in Warp."""

    def control(engine: mujoco.MjModel, data: mujoco.MjData) -> None:
        subtract_bias(engine, data, centred=centred, normal=normal)

    def step(engine: mujoco.MjModel, data: mujoco.MjData) -> None:
        mujoco.set_mjcb_control(
            control
        )  # one for all models, so only as long as this one is stepped
        try:
            mujoco.mj_step(engine, data)
        finally:
            mujoco.set_mjcb_control(None)

    solver._mujoco = SimpleNamespace(
        mj_step=step
    )  # what Newton calls to step the engine


def watch_steps(solver: SolverMuJoCo, around: Callable[..., None]) -> None:
    """Have ``around`` make a solver's steps: it is given what made them so far, and the engine's model and data."""
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
    """Subtract J̇ q̇ from what the rows ask for, where MuJoCo calls ``mjcb_control``: rows are made, not yet solved."""
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
    """Subtract from the rows of a contact what they lack along and about the axes of its frame, shape [6]."""
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
    """Return J̇ q̇ of a contact's second geom against its first, linear [m/s²] and angular [rad/s²], shape [3]."""
    of_geom = np.zeros((2, 2, 3, engine.nv))
    for (linear, angular), geom in zip(of_geom, contact.geom, strict=True):
        mujoco.mj_jacDot(
            engine, data, linear, angular, contact.pos, engine.geom_bodyid[geom]
        )
    linear, angular = (of_geom[1] - of_geom[0]) @ data.qvel
    return linear, angular


def damping(engine: mujoco.MjModel, solref: np.ndarray, solimp: np.ndarray) -> float:
    """Return b [1/s] of a row (MuJoCo documentation, "Solver parameters")."""
    timeconst, second = solref
    dmax = np.clip(solimp[1], mujoco.mjMINIMP, mujoco.mjMAXIMP)
    if second <= 0.0:
        return -second / dmax
    if not engine.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_REFSAFE:
        timeconst = max(timeconst, 2.0 * engine.opt.timestep)
    return 2.0 / (dmax * timeconst)
