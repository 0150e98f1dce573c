# SPDX-License-Identifier: Apache-2.0
"""The acceleration that contact friction leaves out, put back into MuJoCo Warp without a patch.

    import contact_bias
    contact_bias.install(solver)    # a newton.solvers.SolverMuJoCo on MuJoCo Warp, before its first step

A friction row asks for J q̈ = -b v, where v = J q̇ is the sliding velocity. What the contact then does is J q̈ + J̇ q̇, so
a body that is held by a moving arm slides at J̇ q̇ / b for as long as the arm moves. With this the rows ask for
J q̈ = -b v - J̇ q̇. MuJoCo Warp calls ``Model.callback.control`` once the rows and the bias forces are there and before
the solver, in every step and in every stage of RK4; ``Data.cacc`` then holds what all bodies accelerate at with q̈ = 0.
One launch, a few operations a contact, no memory; it can be part of a captured graph.

J̇ q̇ is the acceleration of the two bodies' material points at the contact, second against first, for q̈ = 0. Where the
bodies stick they move as one, so that where the contact moves to and how its frame turns make no difference. Normal
rows are left as they are unless asked for: they hold a distance, in which nothing adds up, and on a rolling body the
material point's acceleration, to the centre, is not that of the distance.
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
MIN_IMPEDANCE, MAX_IMPEDANCE = wp.constant(mujoco.mjMINIMP), wp.constant(mujoco.mjMAXIMP)


def install(solver, *, centred: bool = False, normal: bool = False, worlds: Sequence[bool] | None = None) -> None:
    """Give the friction rows of all contacts the acceleration that they leave out.

    Args:
        solver: What has a ``mjw_model``: a ``newton.solvers.SolverMuJoCo`` that does not use MuJoCo's C engine.
        centred: Whether the rows also see the sliding velocity of the last step's motion, v - h J̇ q̇ / 2, instead of v
            at its end. A step of h moves a contact by that mean, so that without it a semi-implicit integrator
            slides at -h J̇ q̇ / 2. RK4 has no such error.
        normal: Whether normal rows get it too, which takes out the swaying of what is held in soft contacts. Not for
            bodies that roll.
        worlds: For each world whether it is given to its contacts; all when left out.

    A control callback that is there already is called before it.

    Raises:
        ValueError: The solver has no model of MuJoCo Warp, has no actuation, for which the callback is left out, or RK4
            with ``centred``.
    """
    model = getattr(solver, "mjw_model", None)
    if model is None:
        raise ValueError("contact_bias needs a solver with a mjw_model, one that runs MuJoCo Warp")
    if model.opt.disableflags & NO_ACTUATION:
        raise ValueError("contact_bias: MuJoCo Warp calls nothing while actuation is disabled; enable it")
    if centred and model.opt.integrator == RUNGE_KUTTA:
        raise ValueError("contact_bias: RK4 has no error of the step to take out; leave centred off")
    data, before = solver.mjw_data, model.callback.control
    chosen = wp.array([True] * data.nworld if worlds is None else list(worlds), dtype=bool, device=data.qpos.device)

    def control(m: mujoco_warp.Model, d: mujoco_warp.Data) -> None:
        if before is not None:
            before(m, d)
        apply(m, d, chosen, centred=centred, normal=normal)

    model.callback.control = control


def apply(m: mujoco_warp.Model, d: mujoco_warp.Data, worlds: wp.array, *, centred: bool, normal: bool) -> None:
    """Subtract J̇ q̇ from what the rows ask for, as in ``install``; where ``Model.callback.control`` is called."""
    contact = d.contact
    wp.launch(
        subtract_bias,
        dim=d.naconmax,
        inputs=[worlds, m.opt.timestep, m.opt.disableflags, int(m.opt.cone) == ELLIPTIC, centred, normal]
        + [m.geom_bodyid, m.body_rootid]
        + [d.subtree_com, d.cvel, d.cacc, d.nacon, contact.worldid, contact.geom, contact.dim, contact.pos]
        + [contact.frame, contact.friction, contact.solref, contact.solreffriction, contact.solimp]
        + [contact.efc_address],
        outputs=[d.efc.aref],
        device=d.qpos.device,
    )


@wp.func
def material_acceleration(velocity: wp.spatial_vector, acceleration: wp.spatial_vector, offset: wp.vec3) -> wp.vec3:
    """Return the acceleration of a body's point: the spatial one moved by ``offset``, and its velocity's turning."""
    turning = wp.spatial_top(velocity)
    of_point = wp.spatial_bottom(velocity) + wp.cross(turning, offset)
    moved = wp.spatial_bottom(acceleration) + wp.cross(wp.spatial_top(acceleration), offset)
    return moved + wp.cross(turning, of_point)


@wp.func
def damping(solref: wp.vec2, solimp: vec5, timestep: float, refsafe: bool) -> float:
    """Return b [1/s] of a row, as the engine makes it of solref and solimp (documentation, "Solver parameters")."""
    dmax = wp.clamp(solimp[1], MIN_IMPEDANCE, MAX_IMPEDANCE)
    result = -solref[1] / dmax
    if solref[1] > 0.0:
        timeconst = wp.where(refsafe, wp.max(solref[0], 2.0 * timestep), solref[0])
        result = 2.0 / (dmax * timeconst)
    return result


@wp.kernel(enable_backward=False)
def subtract_bias(
    worlds: wp.array[bool],
    timestep: wp.array[float],
    disableflags: int,
    elliptic: bool,
    centred: bool,
    normal: bool,
    geom_body: wp.array[int],
    body_root: wp.array[int],
    centre: wp.array2d[wp.vec3],
    velocity: wp.array2d[wp.spatial_vector],
    acceleration: wp.array2d[wp.spatial_vector],
    contact_count: wp.array[int],
    contact_world: wp.array[int],
    geom: wp.array[wp.vec2i],
    dim: wp.array[int],
    position: wp.array[wp.vec3],
    frame: wp.array[wp.mat33],
    friction: wp.array[vec5],
    solref: wp.array[wp.vec2],
    solref_friction: wp.array[wp.vec2],
    solimp: wp.array[vec5],
    address: wp.array2d[int],
    reference: wp.array2d[float],
):
    contact = wp.tid()
    if contact >= contact_count[0] or address[contact, 0] < 0:  # the second is not in the solver
        return
    first, second = geom[contact][0], geom[contact][1]
    if first < 0 or second < 0:  # a flex
        return
    world = contact_world[contact]
    if not worlds[world]:
        return
    one, other = geom_body[first], geom_body[second]
    # Velocities and accelerations of a body refer to the centre of mass of its tree. Gravity is in all accelerations,
    # those of what does not move included, and drops out of the difference.
    linear = material_acceleration(
        velocity[world, other], acceleration[world, other], position[contact] - centre[world, body_root[other]]
    ) - material_acceleration(
        velocity[world, one], acceleration[world, one], position[contact] - centre[world, body_root[one]]
    )
    angular = wp.spatial_top(acceleration[world, other]) - wp.spatial_top(acceleration[world, one])
    h = timestep[world % timestep.shape[0]]
    refsafe = (disableflags & NO_REFSAFE) == 0
    part = float(1.0)
    if centred:
        part -= 0.5 * h * damping(solref[contact], solimp[contact], h, refsafe)
    upright = wp.where(normal, wp.dot(frame[contact][0], linear) * part, 0.0)
    if elliptic or dim[contact] == 1:
        reference[world, address[contact, 0]] -= upright
    own = solref_friction[contact]
    if centred and elliptic and (own[0] != 0.0 or own[1] != 0.0):
        part = 1.0 - 0.5 * h * damping(own, solimp[contact], h, refsafe)
    for direction in range(1, dim[contact]):  # two of sliding, one of spin, two of rolling
        value = wp.dot(frame[contact][direction % 3], wp.where(direction < 3, linear, angular)) * part
        if elliptic:
            row = address[contact, direction]
            if row >= 0:
                reference[world, row] -= value
        else:
            # Two edges of the pyramid, which lean to either side of the normal by the friction.
            value *= friction[contact][direction - 1]
            row = address[contact, 2 * direction - 2]
            opposite = address[contact, 2 * direction - 1]
            if row >= 0:
                reference[world, row] -= upright + value
            if opposite >= 0:
                reference[world, opposite] -= upright - value
