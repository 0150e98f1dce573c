# SPDX-License-Identifier: Apache-2.0
"""The acceleration that contacts leave out, exact for bodies that roll, spin and slide, without a patch.

    import contact_place                         # contact_bias.py lies beside it
    contact_place.install(solver, normal=True)   # in place of contact_bias.install, with the same options

``contact_bias`` takes the material points of both bodies at the contact. A contact of curved bodies moves against these
points, and its frame turns. With p the place of the contact, v and ω the velocity there and the angular velocity of the
second body against the first, and Ω that of the frame, the rate of a row f · v for q̈ = 0 lacks

    f · (ω₂ × (ṗ - v₂) - ω₁ × (ṗ - v₁) + v × Ω),   of a row f · ω    f · (ω × Ω).

ṗ and ṅ follow from the curvatures of both surfaces, since the normal that each of them carries along stays the same
(D. Montana, "The kinematics of contact and grasp", International Journal of Robotics Research 7, 1988). With this added
a row gets the rate of itself, J̇ q̇. Where flat bodies stick it adds nothing.

Curvatures are those of the engine's geoms where the contact lies: of spheres, capsules, ellipsoids, sides and rims of
cylinders; boxes have faces, edges and corners. Meshes and height fields count as flat; what lies along a flat side
touches it with corners of its own. One more launch, no memory; it can be part of a captured graph.

A rate holds for the moment. It is given for a step h, and a soft contact takes 2/b to settle. Until then the bodies
turn against each other, and the place runs round a rim or the frame with a capsule that nearly stands, by φ together:
the rate may have changed by φ of itself, and what is no longer there would put energy into the bodies. So a row gets
the 1 - φ of it that is left in any case, and from a radian on nothing, as without the term.
"""

from collections.abc import Sequence

import mujoco
import mujoco_warp
import warp as wp

try:
    from . import contact_bias  # if both are part of a package
except ImportError:
    import contact_bias

PLANE, SPHERE = (
    wp.constant(int(mujoco.mjtGeom.mjGEOM_PLANE)),
    wp.constant(int(mujoco.mjtGeom.mjGEOM_SPHERE)),
)
CAPSULE, BOX = (
    wp.constant(int(mujoco.mjtGeom.mjGEOM_CAPSULE)),
    wp.constant(int(mujoco.mjtGeom.mjGEOM_BOX)),
)
CYLINDER = wp.constant(int(mujoco.mjtGeom.mjGEOM_CYLINDER))
ELLIPSOID = wp.constant(int(mujoco.mjtGeom.mjGEOM_ELLIPSOID))
NEAR = wp.constant(1e-3)
"""Share of a geom's size: so near to an end, a rim or a face a contact lies on it."""
UPRIGHT = wp.constant(0.02)
"""Sine of the tilt below which a cylinder or capsule stands upright: which way it leans is noise then."""
ALONG = wp.constant(1e-4)
"""Share of the other curvature, below which two surfaces lie along each other."""
UNIT = wp.constant(wp.mat22(1.0, 0.0, 0.0, 1.0))


def install(
    solver,
    *,
    centred: bool = False,
    normal: bool = False,
    worlds: Sequence[bool] | None = None,
) -> None:
    """Give the rows of all contacts the acceleration that they leave out.

    Args:
        solver: As for ``contact_bias.install``, which is called with it.
        centred: As there.
        normal: Whether normal rows get it too. It is right for bodies that roll.
        worlds: For each world whether it is given to its contacts; all when left out.

    Raises:
        ValueError: As there.
    """
    contact_bias.install(solver, centred=centred, normal=normal, worlds=worlds)
    model, data = solver.mjw_model, solver.mjw_data
    chosen = wp.array(
        [True] * data.nworld if worlds is None else list(worlds),
        dtype=bool,
        device=data.qpos.device,
    )
    of_points = model.callback.control

    def control(m: mujoco_warp.Model, d: mujoco_warp.Data) -> None:
        of_points(m, d)
        apply(m, d, chosen, centred=centred, normal=normal)

    model.callback.control = control


def apply(
    m: mujoco_warp.Model,
    d: mujoco_warp.Data,
    worlds: wp.array,
    *,
    centred: bool,
    normal: bool,
) -> None:
    """Subtract from what the rows ask for what ``contact_bias.apply`` lacks; where that is called."""
    wp.launch(
        subtract_place,
        dim=d.naconmax,
        inputs=[
            worlds,
            m.geom_type,
            m.geom_size,
            m.geom_bodyid,
            m.body_rootid,
            d.subtree_com,
            d.cvel,
            d.cacc,
        ]
        + [
            d.geom_xpos,
            d.geom_xmat,
            contact_bias.rows_of(m, d, centred=centred, normal=normal),
        ],
        device=d.qpos.device,
    )


@wp.struct
class Surface:
    """A geom where a contact lies on it, in the contact's two tangents."""

    bend: wp.mat22
    """Turn of the outward normal for a way along the surface [1/m]."""
    sharp: wp.mat22
    """Projection on the ways across an edge, along which the place cannot move."""
    varying: float
    """Part of itself by which the bend turns or changes, for a way along the surface [1/m]."""


@wp.func
def velocity_at(velocity: wp.spatial_vector, offset: wp.vec3) -> wp.vec3:
    """Return the velocity of a body's point [m/s], ``offset`` from where its spatial velocity refers to."""
    return wp.spatial_bottom(velocity) + wp.cross(wp.spatial_top(velocity), offset)


@wp.func
def along(way: wp.vec3, x: wp.vec3, y: wp.vec3) -> wp.mat22:
    """Return w wᵀ of a vector w in the plane of x and y."""
    part = wp.vec2(wp.dot(way, x), wp.dot(way, y))
    return wp.outer(part, part)


@wp.func
def flatness(part: float) -> float:
    """Return 1 where a part of a normal is none, else 0."""
    return wp.where(wp.abs(part) < NEAR, 1.0, 0.0)


@wp.func
def surface_of(
    kind: int, size: wp.vec3, at: wp.vec3, out: wp.vec3, x: wp.vec3, y: wp.vec3
) -> Surface:
    """Find how a geom is bent at ``at``, where its outward normal is ``out``; all in the geom's frame."""
    surface = Surface()
    axis = wp.vec3(0.0, 0.0, 1.0)
    lean = wp.vec3(out[0], out[1], 0.0)
    sine = wp.length(lean)
    if kind == SPHERE:
        surface.bend = UNIT / size[0]
    elif kind == CAPSULE:
        if wp.abs(at[2] - size[0] * out[2]) > (1.0 - NEAR) * size[1]:
            surface.bend = UNIT / size[0]
        else:
            surface.bend = along(wp.cross(axis, lean) / sine, x, y) / size[0]
    elif kind == ELLIPSOID:
        inverse = wp.vec3(
            1.0 / (size[0] * size[0]),
            1.0 / (size[1] * size[1]),
            1.0 / (size[2] * size[2]),
        )
        across, by_x, by_y = (
            wp.cw_mul(inverse, at),
            wp.cw_mul(inverse, x),
            wp.cw_mul(inverse, y),
        )
        mixed = wp.dot(x, by_y)
        surface.bend = wp.mat22(
            wp.dot(x, by_x), mixed, mixed, wp.dot(y, by_y)
        ) / wp.length(across)
        surface.varying = 1.0 / wp.max(size)
    elif kind == CYLINDER:
        # The engine's place is rounded; a normal that leans to the axis is none of the side.
        is_end = (
            wp.abs(at[2]) > size[1] - NEAR * wp.min(size[0], size[1])
            or wp.abs(out[2]) > UPRIGHT
        )
        is_side = (
            at[0] * at[0] + at[1] * at[1]
            > (1.0 - NEAR) * (1.0 - NEAR) * size[0] * size[0]
        )
        if is_end and is_side and sine < UPRIGHT:
            surface.sharp = UNIT
        elif is_side:
            tangent = wp.cross(axis, lean) / sine
            surface.bend = along(tangent, x, y) * (
                sine / size[0]
            )  # by Meusnier's theorem
            if is_end:
                surface.sharp = along(wp.cross(out, tangent), x, y)
                surface.varying = 1.0 / size[0]
    elif kind == BOX:
        edge = wp.vec3(
            flatness(out[0]), flatness(out[1]), flatness(out[2])
        )  # along no face's normal
        if edge[0] + edge[1] + edge[2] == 1.0:
            surface.sharp = along(wp.normalize(wp.cross(out, edge)), x, y)
        elif edge[0] + edge[1] + edge[2] == 0.0:
            surface.sharp = UNIT
    return surface


@wp.func
def place_on(
    first: Surface, second: Surface, gap: float, turning: wp.vec2, sliding: wp.vec2
) -> wp.vec2:
    """Find how fast the place of a contact moves over the first surface, which has no edge.

    What the first normal turns by, ω₁ × n + S₁ u₁, is what the second one does, ω₂ × n - S₂ u₂, and the two places stay
    one above the other, u₂ = (1 + gap S₁) u₁ - v. Across an edge of the second geom u₂ is zero.

    Args:
        first, second: Surfaces.
        gap: Between them [m].
        turning: (ω₂ - ω₁) × n [rad/s].
        sliding: v, velocity of the second body against the first at its own surface [m/s].
    """
    carried = UNIT + gap * first.bend
    bend = first.bend + second.bend * carried
    sharp = second.sharp
    smooth = UNIT - sharp
    bent = smooth * (first.bend + second.bend) * smooth
    scale = wp.trace(bent)
    if scale <= 0.0 or (wp.trace(sharp) > 0.5 and scale < ALONG * wp.trace(first.bend)):
        return wp.inverse(carried) * sliding
    if wp.trace(sharp) < 0.5 and wp.determinant(bent) < ALONG * scale * scale:
        sharp = UNIT - bent / scale
        smooth = bent / scale
    return wp.inverse(smooth * bend / scale + sharp * carried) * (
        smooth * (turning + second.bend * sliding) / scale + sharp * sliding
    )


@wp.func
def round_the_rim(radius: float, at: wp.vec3, out: wp.vec3, over: wp.vec3) -> wp.vec3:
    """Find by how much more than the lowest place of a rim, which moves at ``over``, a contact at ``at`` moves [m/s].

    MuJoCo puts up to four contacts between a cylinder and a plane, which all go round with the lowest place.
    """
    axis = wp.vec3(0.0, 0.0, 1.0)
    lowest = wp.normalize(wp.vec3(out[0], out[1], 0.0)) * radius
    round = wp.dot(over, wp.cross(axis, lowest)) / (radius * radius)
    return round * wp.cross(axis, at - lowest)


@wp.func
def lasting_part(rows: contact_bias.Rows, contact: int, turning: float) -> float:
    """Return the part of a row's rate that is left once it has settled, of a rate that turns at ``turning`` [rad/s]."""
    step = rows.timestep[rows.worldid[contact] % rows.timestep.shape[0]]
    settled = step + 2.0 / contact_bias.damping(
        rows.solref[contact], rows.solimp[contact], step, rows.refsafe
    )
    return wp.max(0.0, 1.0 - turning * settled)


@wp.func
def is_made_of(way: wp.vec3, normal: wp.vec3, tangent: wp.vec3) -> bool:
    """Tell whether the engine made a tangent of ``way``, less what of it is along the normal."""
    upright, level = wp.dot(way, normal), wp.dot(way, tangent)
    return (
        level * level > UPRIGHT * UPRIGHT
        and wp.abs(level * level + upright * upright - 1.0) < 1e-5
    )


@wp.kernel(enable_backward=False)
def subtract_place(
    worlds: wp.array[bool],
    geom_type: wp.array[int],
    geom_size: wp.array2d[wp.vec3],
    geom_body: wp.array[int],
    body_root: wp.array[int],
    centre: wp.array2d[wp.vec3],
    velocity: wp.array2d[wp.spatial_vector],
    acceleration: wp.array2d[wp.spatial_vector],
    geom_position: wp.array2d[wp.vec3],
    geom_frame: wp.array2d[wp.mat33],
    rows: contact_bias.Rows,
):
    contact = wp.tid()
    if not contact_bias.is_solved(rows, worlds, contact):
        return
    world, position = rows.worldid[contact], rows.pos[contact]
    one, two = rows.geom[contact][0], rows.geom[contact][1]
    n, x = rows.frame[contact][0], rows.frame[contact][1]
    if (
        wp.length_sq(n) < 0.5
    ):  # MuJoCo Warp 4.0.0 has contacts with no normal, between a box and a cylinder's rim
        return
    y = wp.cross(n, x)
    twist_1, twist_2 = velocity[world, geom_body[one]], velocity[world, geom_body[two]]
    # Velocities of a body refer to the centre of mass of its tree.
    arm_1 = position - centre[world, body_root[geom_body[one]]]
    arm_2 = position - centre[world, body_root[geom_body[two]]]
    v_1, v_2 = velocity_at(twist_1, arm_1), velocity_at(twist_2, arm_2)
    w_1, w_2 = wp.spatial_top(twist_1), wp.spatial_top(twist_2)
    v, w = v_2 - v_1, w_2 - w_1
    # Where the two surfaces are: half of their distance to either side.
    gap = rows.dist[contact]
    half = 0.5 * gap * n
    mat_1, mat_2 = (
        wp.transpose(geom_frame[world, one]),
        wp.transpose(geom_frame[world, two]),
    )
    at_1 = mat_1 * (position - half - geom_position[world, one])
    at_2 = mat_2 * (position + half - geom_position[world, two])
    size_1, size_2 = (
        geom_size[world % geom_size.shape[0], one],
        geom_size[world % geom_size.shape[0], two],
    )
    first = surface_of(geom_type[one], size_1, at_1, mat_1 * n, mat_1 * x, mat_1 * y)
    second = surface_of(
        geom_type[two], size_2, at_2, -(mat_2 * n), mat_2 * x, mat_2 * y
    )
    turn, slide = wp.cross(w, n), wp.cross(w, half)
    turning = wp.vec2(wp.dot(turn, x), wp.dot(turn, y))
    if (
        wp.trace(first.sharp) > 0.5 and wp.trace(second.sharp) > 0.5
    ):  # side by side, a corner of the second one
        first.bend = 0.0 * UNIT
        first.sharp = 0.0 * UNIT
        second.sharp = UNIT
    over_1, over_2 = wp.vec2(), wp.vec2()  # velocity of the place over both surfaces
    bent = wp.vec2()  # what its way bends the normal by
    carrying = w_1
    if wp.trace(first.sharp) < 0.5:
        sliding = wp.vec2(wp.dot(v + slide, x), wp.dot(v + slide, y))
        over_1 = place_on(first, second, gap, turning, sliding)
        bent = first.bend * over_1
        over_2 = over_1 + gap * bent - sliding
    else:  # the same from the other side, from where the normal is -n
        sliding = wp.vec2(wp.dot(slide - v, x), wp.dot(slide - v, y))
        over_2 = place_on(second, first, gap, turning, sliding)
        bent = -(second.bend * over_2)
        over_1 = over_2 - gap * bent - sliding
        carrying = w_2
    rate = wp.cross(carrying, n) + bent[0] * x + bent[1] * y
    way, way_rate = wp.vec3(0.0, 1.0, 0.0), wp.vec3()
    if n[1] <= -0.5 or n[1] >= 0.5:
        way = wp.vec3(0.0, 0.0, 1.0)
    axis = wp.transpose(mat_2) * wp.vec3(0.0, 0.0, 1.0)
    if geom_type[one] == PLANE and geom_type[two] == CAPSULE and is_made_of(axis, n, x):
        way, way_rate = axis, wp.cross(w_2, axis)
    spin, with_axis = float(0.0), float(0.0)
    if is_made_of(way, n, x):
        with_axis = wp.dot(way_rate, y) / wp.dot(way, x)
        spin = with_axis - wp.dot(way, n) * wp.dot(rate, y) / wp.dot(way, x)
    turning_frame = wp.cross(n, rate) + spin * n
    over = over_1 + over_2
    place = 0.5 * (slide + over[0] * x + over[1] * y)
    if (
        geom_type[one] == PLANE
        and geom_type[two] == CYLINDER
        and wp.trace(second.sharp) < 1.5
    ):
        on_rim = place - 0.5 * slide - 0.5 * (v + slide)
        ahead = wp.transpose(mat_2) * round_the_rim(
            size_2[0], at_2, -(mat_2 * n), mat_2 * on_rim
        )
        place += ahead - 0.5 * wp.dot(ahead, n) * n
    linear = wp.cross(w, place) + wp.cross(v, turning_frame + 0.5 * (w_1 + w_2))
    angular = wp.cross(w, turning_frame)
    # The rate of the material points is there already; of that too, what does not last goes.
    running = wp.length(over_1) * first.varying + wp.length(over_2) * second.varying
    part = lasting_part(rows, contact, wp.length(w) + running + wp.abs(with_axis))
    rate_1, rate_2 = (
        acceleration[world, geom_body[one]],
        acceleration[world, geom_body[two]],
    )
    points = contact_bias.material_acceleration(twist_2, rate_2, arm_2)
    points -= contact_bias.material_acceleration(twist_1, rate_1, arm_1)
    turned = wp.spatial_top(rate_2) - wp.spatial_top(rate_1)
    linear, angular = (
        part * linear - (1.0 - part) * points,
        part * angular - (1.0 - part) * turned,
    )
    contact_bias.subtract(rows, contact, linear, angular)
