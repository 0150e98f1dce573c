# SPDX-License-Identifier: Apache-2.0
"""Adds the acceleration that contacts leave out, even if bodies roll or spin.

    import contact_place    # needs contact_bias.py in the same folder
    contact_place.install(solver, normal=True)    # instead of contact_bias.install

``contact_bias`` uses the material points of both bodies at the contact. The contact of
curved bodies moves relative to these points, and its frame turns. Let p be the position
of the contact, v and ω the linear and angular velocity of the second body relative to
the first, and Ω the angular velocity of the frame. Then the rate of a row f · v, for
q̈ = 0, lacks

    f · (ω₂ × (ṗ - v₂) - ω₁ × (ṗ - v₁) + v × Ω),

and the rate of a row f · ω lacks f · (ω × Ω).

ṗ and ṅ follow from the curvatures of both surfaces, because the two surfaces have the
same normal at the contact at all times (D. Montana, "The kinematics of contact and
grasp", International Journal of Robotics Research 7, 1988). With this addition the rate
of a row is exactly J̇ q̇. For flat bodies that stick the addition is zero.

The module computes the curvatures of spheres, capsules, ellipsoids, and the sides and
rims of cylinders. Boxes have faces, edges and corners. Meshes and height fields are
treated as flat, because a body on a flat side touches it with its own corners. The
module needs one more kernel launch and allocates no memory. The launch can be part of a
captured graph.

A rate is valid for a moment, but it acts over a step h, and a soft contact takes 2/b to
settle. During this time the bodies turn relative to each other, the contact runs around
a rim, or the frame turns with a capsule that is nearly upright. If φ is the sum of these
angles, the rate may change by a fraction φ in this time, and an outdated rate would add
energy to the bodies. So only the share 1 - φ of the rate, which remains in any case, is
added to a row. If φ is 1 or more, the row is not changed.
"""

from collections.abc import Sequence

import mujoco
import mujoco_warp
import warp as wp

try:
    from . import contact_bias  # Both modules may be part of a package.
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
"""A contact is on an end, a rim or a face within this share of the geom's size."""
UPRIGHT = wp.constant(0.02)
"""A cylinder or capsule is upright if the sine of its tilt is below this value.

The direction in which it leans is then only noise.
"""
ALONG = wp.constant(1e-4)
"""Two surfaces touch along a line if the ratio of their curvatures is below this."""
UNIT = wp.constant(wp.mat22(1.0, 0.0, 0.0, 1.0))


def install(
    solver,
    *,
    centred: bool = False,
    normal: bool = False,
    worlds: Sequence[bool] | None = None,
) -> None:
    """Add the missing acceleration to the rows of all contacts.

    Args:
        solver: See ``contact_bias.install``, which this function calls.
        centred: See ``contact_bias.install``.
        normal: Whether to add the term to normal rows too, even if bodies roll.
        worlds: See ``contact_bias.install``.

    Raises:
        ValueError: See ``contact_bias.install``.
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
    """Subtract the part that ``contact_bias.apply`` does not subtract."""
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
    """A geom at a contact, in the two tangents of the contact."""

    bend: wp.mat22
    """Rotation of the outward normal per distance along the surface [1/m]."""
    sharp: wp.mat22
    """This projects onto directions across an edge, in which the contact cannot move."""
    varying: float
    """Relative change of the curvature per distance along the surface [1/m]."""


@wp.func
def velocity_at(velocity: wp.spatial_vector, offset: wp.vec3) -> wp.vec3:
    """Return the velocity of a body's point at an offset from its reference [m/s]."""
    return wp.spatial_bottom(velocity) + wp.cross(wp.spatial_top(velocity), offset)


@wp.func
def along(way: wp.vec3, x: wp.vec3, y: wp.vec3) -> wp.mat22:
    """Return w wᵀ of a vector w that is projected onto the plane of x and y."""
    part = wp.vec2(wp.dot(way, x), wp.dot(way, y))
    return wp.outer(part, part)


@wp.func
def flatness(part: float) -> float:
    """Return 1 if a component of a normal is zero, otherwise 0."""
    return wp.where(wp.abs(part) < NEAR, 1.0, 0.0)


@wp.func
def surface_of(
    kind: int, size: wp.vec3, at: wp.vec3, out: wp.vec3, x: wp.vec3, y: wp.vec3
) -> Surface:
    """Return the surface of a geom at a point, with all vectors in the geom's frame.

    Args:
        at: The position of the point.
        out: The normal at this point, which leads outward.
    """
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
        # The engine's contact position is rounded. A normal that leans towards the axis
        # does not belong to the side.
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
            # Meusnier's theorem
            surface.bend = along(tangent, x, y) * (sine / size[0])
            if is_end:
                surface.sharp = along(wp.cross(out, tangent), x, y)
                surface.varying = 1.0 / size[0]
    elif kind == BOX:
        # The normal is perpendicular to these axes.
        edge = wp.vec3(flatness(out[0]), flatness(out[1]), flatness(out[2]))
        if edge[0] + edge[1] + edge[2] == 1.0:
            surface.sharp = along(wp.normalize(wp.cross(out, edge)), x, y)
        elif edge[0] + edge[1] + edge[2] == 0.0:
            surface.sharp = UNIT
    return surface


@wp.func
def place_on(
    first: Surface, second: Surface, gap: float, turning: wp.vec2, sliding: wp.vec2
) -> wp.vec2:
    """Return the velocity of a contact over the first surface, which has no edge.

    Both normals turn at the same rate, ω₁ × n + S₁ u₁ = ω₂ × n - S₂ u₂, and the two
    contact points stay opposite each other, u₂ = (1 + gap S₁) u₁ - v. Across an edge of
    the second geom, u₂ is zero.

    Args:
        first: The surface that the velocity refers to.
        second: The surface that touches the first one.
        gap: Distance between the surfaces [m].
        turning: (ω₂ - ω₁) × n [rad/s].
        sliding: v, the velocity of the second body at its surface relative to the first
            one [m/s].
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
    """Return the velocity of a contact on a rim minus that of the lowest point [m/s].

    MuJoCo makes up to four contacts between a cylinder and a plane. All of them run
    around the rim with its lowest point, which moves at ``over``.
    """
    axis = wp.vec3(0.0, 0.0, 1.0)
    lowest = wp.normalize(wp.vec3(out[0], out[1], 0.0)) * radius
    round = wp.dot(over, wp.cross(axis, lowest)) / (radius * radius)
    return round * wp.cross(axis, at - lowest)


@wp.func
def lasting_part(rows: contact_bias.Rows, contact: int, turning: float) -> float:
    """Return the share of a row's rate that remains until the row has settled.

    Args:
        turning: How fast the direction of the rate changes [rad/s].
    """
    step = rows.timestep[rows.worldid[contact] % rows.timestep.shape[0]]
    settled = step + 2.0 / contact_bias.damping(
        rows.solref[contact], rows.solimp[contact], step, rows.refsafe
    )
    return wp.max(0.0, 1.0 - turning * settled)


@wp.func
def is_made_of(way: wp.vec3, normal: wp.vec3, tangent: wp.vec3) -> bool:
    """Return whether a tangent is along ``way`` projected onto the surface."""
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
    # MuJoCo Warp 4.0.0 makes contacts without a normal between a box and a rim.
    if wp.length_sq(n) < 0.5:
        return
    y = wp.cross(n, x)
    twist_1, twist_2 = velocity[world, geom_body[one]], velocity[world, geom_body[two]]
    # Velocities of a body refer to the centre of mass of its tree.
    arm_1 = position - centre[world, body_root[geom_body[one]]]
    arm_2 = position - centre[world, body_root[geom_body[two]]]
    v_1, v_2 = velocity_at(twist_1, arm_1), velocity_at(twist_2, arm_2)
    w_1, w_2 = wp.spatial_top(twist_1), wp.spatial_top(twist_2)
    v, w = v_2 - v_1, w_2 - w_1
    # The contact is in the middle between the two surfaces.
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
    # Two edges or corners touch: treat them as a corner of the second geom on a plane.
    if wp.trace(first.sharp) > 0.5 and wp.trace(second.sharp) > 0.5:
        first.bend = 0.0 * UNIT
        first.sharp = 0.0 * UNIT
        second.sharp = UNIT
    # The contact moves over both surfaces, which turns the normal by ``bent``.
    over_1, over_2 = wp.vec2(), wp.vec2()
    bent = wp.vec2()
    carrying = w_1
    if wp.trace(first.sharp) < 0.5:
        sliding = wp.vec2(wp.dot(v + slide, x), wp.dot(v + slide, y))
        over_1 = place_on(first, second, gap, turning, sliding)
        bent = first.bend * over_1
        over_2 = over_1 + gap * bent - sliding
    else:  # Seen from the second geom, the normal is -n.
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
    # The rate of the material points is already included. Remove its outdated share.
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
