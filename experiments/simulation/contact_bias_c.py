"""The left-out term of ``contact_bias`` in MuJoCo's C engine and double precision."""

import mujoco
import numpy as np

ELLIPTIC = int(mujoco.mjtCone.mjCONE_ELLIPTIC)


def subtract_bias(engine: mujoco.MjModel, data: mujoco.MjData, *, centred: bool = False, normal: bool = False) -> None:
    """Give the friction rows of contacts J̇ q̇ back, in ``mjcb_control``: rows are made then, and not yet solved.

    ``centred`` and ``normal`` are as in Warp.
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
    """Subtract from the rows of a contact what they lack along and about the axes of its frame, shape [6]."""
    row, dim, is_elliptic = contact.efc_address, contact.dim, engine.opt.cone == ELLIPTIC
    missing = missing[:dim]
    missing[0] *= normal
    if centred:
        solref = contact.solreffriction if is_elliptic and contact.solreffriction.any() else contact.solref
        half = 0.5 * engine.opt.timestep
        missing[0] *= 1.0 - half * damping(engine, contact.solref, contact.solimp)
        missing[1:] *= 1.0 - half * damping(engine, solref, contact.solimp)
    if is_elliptic or dim == 1:
        data.efc_aref[row : row + dim] -= missing
    else:
        leaning = contact.friction[: dim - 1] * missing[1:]
        data.efc_aref[row : row + 2 * dim - 2] -= missing[0] + np.stack([leaning, -leaning], axis=1).ravel()


def velocity_product(
    engine: mujoco.MjModel, data: mujoco.MjData, contact: mujoco.MjContact
) -> tuple[np.ndarray, np.ndarray]:
    """Return J̇ q̇ of a contact's second geom against its first, linear [m/s²] and angular [rad/s²], shape [3]."""
    of_geom = np.zeros((2, 2, 3, engine.nv))
    for (linear, angular), geom in zip(of_geom, contact.geom, strict=True):
        mujoco.mj_jacDot(engine, data, linear, angular, contact.pos, engine.geom_bodyid[geom])
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
