# SPDX-License-Identifier: Apache-2.0
"""Adds the acceleration that contact friction leaves out, in MuJoCo Warp.

    import contact_bias
    contact_bias.install(solver)    # before the first step of a SolverMuJoCo

The engine solves each friction row for J q̈ = -b v, where v = J q̇ is the sliding
velocity. But the velocity of the contact changes by J q̈ + J̇ q̇, so a body that is held
by a moving arm slides at J̇ q̇ / b for as long as the arm moves. This module changes the
right-hand side to -b v - J̇ q̇.

MuJoCo Warp calls ``Model.callback.control`` in every step and in every stage of RK4,
after it has made the rows and the bias forces and before the solver runs. ``Data.cacc``
then holds the accelerations of all bodies for q̈ = 0. The module needs one kernel
launch with a few operations per contact and allocates no memory. The launch can be part
of a captured graph.

J̇ q̇ is the acceleration of the second body's material point at the contact, relative
to the first body's point, for q̈ = 0. If the bodies stick, they move together, so the
motion of the contact point and the rotation of its frame do not matter. Normal rows
are not changed by default. They control a distance, so their errors do not add up. On a
rolling body the material point accelerates towards the centre of the body, although the
distance does not change.
"""

from collections.abc import Sequence

import mujoco
import mujoco_warp
import warp as wp
from mujoco_warp._src.types import vec5

RUNGE_KUTTA = int(mujoco.mjtIntegrator.mjINT_RK4)
ELLIPTIC = int(mujoco.mjtCone.mjCONE_ELLIPTIC)
NO_ACTUATION = int(mujoco.mjtDisableBit.mjDSBL_ACTUATION)
NO_REFSAFE = int(mujoco.mjtDisableBit.mjDSBL_REFSAFE)
MIN_IMPEDANCE, MAX_IMPEDANCE = (
    wp.constant(mujoco.mjMINIMP),
    wp.constant(mujoco.mjMAXIMP),
)


def install(
    solver,
    *,
    centred: bool = False,
    normal: bool = False,
    worlds: Sequence[bool] | None = None,
) -> None:
    """Add the missing acceleration to the friction rows of all contacts.

    Args:
        solver: An object with ``mjw_model`` and ``mjw_data``, such as a
            ``newton.solvers.SolverMuJoCo`` that does not use MuJoCo's C engine.
        centred: Whether the rows use the mean sliding velocity of the last step,
            v - h J̇ q̇ / 2, instead of the velocity v at the end of the step. A step of
            length h moves a contact by this mean velocity, so without this option a
            semi-implicit integrator slides at -h J̇ q̇ / 2. RK4 does not have this error.
        normal: Whether to add the term to normal rows too. Bodies that are held in soft
            contacts then do not sway. Do not use this option for bodies that roll.
        worlds: A flag for each world that selects the worlds with the term. By default
            all worlds have it.

    If the model already has a control callback, that callback is called first.

    Raises:
        ValueError: The solver does not run MuJoCo Warp, its actuation is disabled (then
            MuJoCo Warp does not call the callback), or RK4 is used with ``centred``.
    """
    model = getattr(solver, "mjw_model", None)
    if model is None:
        raise ValueError(
            "contact_bias needs a solver with a mjw_model, one that runs MuJoCo Warp"
        )
    if model.opt.disableflags & NO_ACTUATION:
        raise ValueError(
            "contact_bias: MuJoCo Warp calls nothing while actuation is disabled; enable it"
        )
    if centred and model.opt.integrator == RUNGE_KUTTA:
        raise ValueError(
            "contact_bias: RK4 has no error of the step to take out; leave centred off"
        )
    data, before = solver.mjw_data, model.callback.control
    chosen = wp.array(
        [True] * data.nworld if worlds is None else list(worlds),
        dtype=bool,
        device=data.qpos.device,
    )

    def control(m: mujoco_warp.Model, d: mujoco_warp.Data) -> None:
        if before is not None:
            before(m, d)
        apply(m, d, chosen, centred=centred, normal=normal)

    model.callback.control = control


@wp.struct
class Rows:
    """The contacts of all worlds with their constraint rows, and the options."""

    elliptic: bool
    centred: bool
    normal: bool
    refsafe: bool
    timestep: wp.array(dtype=float)
    nacon: wp.array(dtype=int)
    worldid: wp.array(dtype=int)
    geom: wp.array(dtype=wp.vec2i)
    dim: wp.array(dtype=int)
    pos: wp.array(dtype=wp.vec3)
    dist: wp.array(dtype=float)
    frame: wp.array(dtype=wp.mat33)
    friction: wp.array(dtype=vec5)
    solref: wp.array(dtype=wp.vec2)
    solreffriction: wp.array(dtype=wp.vec2)
    solimp: wp.array(dtype=vec5)
    efc_address: wp.array2d(dtype=int)
    aref: wp.array2d(dtype=float)


def rows_of(
    m: mujoco_warp.Model, d: mujoco_warp.Data, *, centred: bool, normal: bool
) -> Rows:
    """Return the contacts and rows of the engine's data, with the options."""
    rows = Rows()
    rows.elliptic, rows.centred, rows.normal = (
        int(m.opt.cone) == ELLIPTIC,
        centred,
        normal,
    )
    rows.refsafe, rows.timestep = not m.opt.disableflags & NO_REFSAFE, m.opt.timestep
    rows.nacon, rows.aref = d.nacon, d.efc.aref
    for name in "worldid geom dim pos dist frame friction solref solreffriction solimp efc_address".split():
        setattr(rows, name, getattr(d.contact, name))
    return rows


def apply(
    m: mujoco_warp.Model,
    d: mujoco_warp.Data,
    worlds: wp.array,
    *,
    centred: bool,
    normal: bool,
) -> None:
    """Subtract J̇ q̇ from the reference accelerations of the rows.

    The control callback calls this function; see ``install`` for the options.
    """
    wp.launch(
        subtract_bias,
        dim=d.naconmax,
        inputs=[worlds, m.geom_bodyid, m.body_rootid, d.subtree_com, d.cvel, d.cacc]
        + [rows_of(m, d, centred=centred, normal=normal)],
        device=d.qpos.device,
    )


@wp.func
def material_acceleration(
    velocity: wp.spatial_vector, acceleration: wp.spatial_vector, offset: wp.vec3
) -> wp.vec3:
    """Return the acceleration of a body's point at an offset from its reference."""
    turning = wp.spatial_top(velocity)
    of_point = wp.spatial_bottom(velocity) + wp.cross(turning, offset)
    moved = wp.spatial_bottom(acceleration) + wp.cross(
        wp.spatial_top(acceleration), offset
    )
    return moved + wp.cross(turning, of_point)


@wp.func
def damping(solref: wp.vec2, solimp: vec5, timestep: float, refsafe: bool) -> float:
    """Return b of a row [1/s] (MuJoCo documentation, "Solver parameters")."""
    dmax = wp.clamp(solimp[1], MIN_IMPEDANCE, MAX_IMPEDANCE)
    result = -solref[1] / dmax
    if solref[1] > 0.0:
        timeconst = wp.where(refsafe, wp.max(solref[0], 2.0 * timestep), solref[0])
        result = 2.0 / (dmax * timeconst)
    return result


@wp.func
def is_solved(rows: Rows, worlds: wp.array[bool], contact: int) -> bool:
    """Return whether the solver has rows for a contact of two geoms in a chosen world."""
    if contact >= rows.nacon[0] or rows.efc_address[contact, 0] < 0:
        return False
    geoms = rows.geom[contact]  # Flexes have negative numbers.
    return geoms[0] >= 0 and geoms[1] >= 0 and worlds[rows.worldid[contact]]


@wp.func
def subtract(rows: Rows, contact: int, linear: wp.vec3, angular: wp.vec3):
    """Subtract a linear and an angular acceleration from the rows of a contact."""
    world, dim, frame = rows.worldid[contact], rows.dim[contact], rows.frame[contact]
    h = rows.timestep[world % rows.timestep.shape[0]]
    part = float(1.0)
    if rows.centred:
        part -= (
            0.5
            * h
            * damping(rows.solref[contact], rows.solimp[contact], h, rows.refsafe)
        )
    upright = wp.where(rows.normal, wp.dot(frame[0], linear) * part, 0.0)
    if rows.elliptic or dim == 1:
        rows.aref[world, rows.efc_address[contact, 0]] -= upright
    own = rows.solreffriction[contact]
    if rows.centred and rows.elliptic and (own[0] != 0.0 or own[1] != 0.0):
        part = 1.0 - 0.5 * h * damping(own, rows.solimp[contact], h, rows.refsafe)
    for direction in range(1, dim):  # Two axes slide, one spins and two roll.
        value = (
            wp.dot(frame[direction % 3], wp.where(direction < 3, linear, angular))
            * part
        )
        if rows.elliptic:
            row = rows.efc_address[contact, direction]
            if row >= 0:
                rows.aref[world, row] -= value
        else:
            # The two edges of the pyramid lean to either side of the normal.
            value *= rows.friction[contact][direction - 1]
            row = rows.efc_address[contact, 2 * direction - 2]
            opposite = rows.efc_address[contact, 2 * direction - 1]
            if row >= 0:
                rows.aref[world, row] -= upright + value
            if opposite >= 0:
                rows.aref[world, opposite] -= upright - value


@wp.kernel(enable_backward=False)
def subtract_bias(
    worlds: wp.array[bool],
    geom_body: wp.array[int],
    body_root: wp.array[int],
    centre: wp.array2d[wp.vec3],
    velocity: wp.array2d[wp.spatial_vector],
    acceleration: wp.array2d[wp.spatial_vector],
    rows: Rows,
):
    contact = wp.tid()
    if not is_solved(rows, worlds, contact):
        return
    world, place = rows.worldid[contact], rows.pos[contact]
    one, other = geom_body[rows.geom[contact][0]], geom_body[rows.geom[contact][1]]
    # Velocities and accelerations of a body refer to the centre of mass of its tree.
    # All accelerations contain gravity, even those of fixed bodies, so it cancels out.
    linear = material_acceleration(
        velocity[world, other],
        acceleration[world, other],
        place - centre[world, body_root[other]],
    ) - material_acceleration(
        velocity[world, one],
        acceleration[world, one],
        place - centre[world, body_root[one]],
    )
    angular = wp.spatial_top(acceleration[world, other]) - wp.spatial_top(
        acceleration[world, one]
    )
    subtract(rows, contact, linear, angular)
