"""The part of the term that ``contact_place`` adds, in MuJoCo's C engine and double precision; all contacts at once."""

from dataclasses import dataclass

import mujoco
import numpy as np

from experiments.simulation import contact_bias_c

PLANE, SPHERE, CAPSULE, ELLIPSOID, CYLINDER, BOX = (
    int(getattr(mujoco.mjtGeom, f"mjGEOM_{name}"))
    for name in ("PLANE", "SPHERE", "CAPSULE", "ELLIPSOID", "CYLINDER", "BOX")
)
NEAR, UPRIGHT, ALONG = 1e-3, 0.02, 1e-4
"""Bounds as in Warp."""
UNIT = np.eye(2)


def subtract_bias(engine: mujoco.MjModel, data: mujoco.MjData, *, centred: bool = False, normal: bool = False) -> None:
    """Subtract J̇ q̇ from what the rows ask for: that of material points, and what moving contacts add."""
    contact_bias_c.subtract_bias(engine, data, centred=centred, normal=normal)
    subtract_place(engine, data, centred=centred, normal=normal)


def subtract_place(engine: mujoco.MjModel, data: mujoco.MjData, *, centred: bool = False, normal: bool = False) -> None:
    """Subtract what ``contact_bias_c.subtract_bias`` lacks, where that is called."""
    held = [contact for contact in data.contact if contact.efc_address >= 0 and min(contact.geom) >= 0]
    for contact, missing in zip(held, missing_rates(engine, data, held), strict=True):
        axes = contact.frame.reshape(3, 3)
        points = np.concatenate([axes @ rate for rate in contact_bias_c.velocity_product(engine, data, contact)])
        part = lasting_part(engine, data, contact)
        missing = part * missing - (1.0 - part) * points
        contact_bias_c.subtract(engine, data, contact, missing, centred=centred, normal=normal)


def lasting_part(engine: mujoco.MjModel, data: mujoco.MjData, contact: mujoco.MjContact) -> float:
    """Return the part of its rate that a contact's rows get, as in Warp."""
    first, second = data.cvel[engine.geom_bodyid[contact.geom], :3]
    angle = 2.0 * np.linalg.norm(second - first) / contact_bias_c.damping(engine, contact.solref, contact.solimp)
    return max(0.0, 1.0 - angle**2)


@dataclass(frozen=True)
class Side:
    """A geom of each contact, where the contact lies on it, in the contact's two tangents."""

    velocity: np.ndarray
    """Velocity of its body's point at the contact [m/s], shape [contacts, 3]."""
    turning: np.ndarray
    """Angular velocity [rad/s], shape [contacts, 3]."""
    bend: np.ndarray
    """Turn of its outward normal for a way along it [1/m], shape [contacts, 2, 2]."""
    sharp: np.ndarray
    """Projection on the ways across an edge, shape [contacts, 2, 2]."""


def missing_rates(engine: mujoco.MjModel, data: mujoco.MjData, contacts: list[mujoco.MjContact]) -> np.ndarray:
    """Find what a moving place and a turning frame add to the rates of each contact's rows, shape [contacts, 6]."""
    if not contacts:
        return np.zeros((0, 6))
    geoms = np.array([contact.geom for contact in contacts])
    position = np.array([contact.pos for contact in contacts])
    frame = np.array([contact.frame for contact in contacts]).reshape(-1, 3, 3)
    gap = np.array([contact.dist for contact in contacts])[:, None]
    n, x = frame[:, 0], frame[:, 1]
    tangents = np.stack([x, np.cross(n, x)], axis=1)
    one = side_of(engine, data, geoms[:, 0], position, gap, n, tangents)
    two = side_of(engine, data, geoms[:, 1], position, gap, -n, tangents)
    v, w = two.velocity - one.velocity, two.turning - one.turning
    turn, slide = np.cross(w, n), 0.5 * gap * np.cross(w, n)
    both = (is_sharp(one) & is_sharp(two))[:, None, None]
    bends = np.where(both, 0.0, one.bend), two.bend
    sharps = np.where(both, 0.0, one.sharp), np.where(both, UNIT, two.sharp)
    # From the side that has no edge; from the second one the normal is -n.
    other = (is_sharp(one) & ~both[:, 0, 0])[:, None]
    sign = np.where(other, -1.0, 1.0)
    first, second = (np.where(other[..., None], *pair) for pair in (bends[::-1], bends))
    sliding = in_plane(tangents, slide + sign * v)
    way = place_on(first, second, np.where(other[..., None], *sharps), gap, in_plane(tangents, turn), sliding)
    bent = np.einsum("cij,cj->ci", first, way)
    over = np.einsum("ci,cir->cr", 2.0 * way + gap * bent - sliding, tangents)
    rate = np.cross(np.where(other, two.turning, one.turning), n) + sign * np.einsum("ci,cir->cr", bent, tangents)
    of_frame = np.cross(n, rate) + frame_spin(engine, data, geoms, two.turning, n, tangents, rate)[:, None] * n
    place = 0.5 * (slide + over) + rims_ahead(
        engine, data, geoms, position + 0.5 * gap * n, n, 0.5 * (over - v - slide)
    )
    linear = np.cross(w, place) + np.cross(v, of_frame + 0.5 * (one.turning + two.turning))
    parts = np.stack([linear, np.cross(w, of_frame)], axis=1)
    return np.einsum("cri,csi->csr", frame, parts).reshape(-1, 6)


def is_sharp(side: Side) -> np.ndarray:
    return np.trace(side.sharp, axis1=1, axis2=2) > 0.5


def in_plane(tangents: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Return the components of vectors, shape [contacts, 3], along two tangents: shape [contacts, 2]."""
    return np.einsum("cir,cr->ci", tangents, vectors)


def side_of(engine: mujoco.MjModel, data: mujoco.MjData, geoms, place, gap, out, tangents) -> Side:
    """Find the geoms of one side; ``out`` are their outward normals."""
    bodies, frames = engine.geom_bodyid[geoms], data.geom_xmat[geoms].reshape(-1, 3, 3)
    twist = data.cvel[bodies]  # refers to the centre of mass of the body's tree
    velocity = twist[:, 3:] + np.cross(twist[:, :3], place - data.subtree_com[engine.body_rootid[bodies]])
    at = place - 0.5 * gap * out - data.geom_xpos[geoms]
    at, normals = (np.einsum("cri,cr->ci", frames, vectors) for vectors in (at, out))
    local = np.einsum("cri,cjr->cji", frames, tangents)
    each = zip(engine.geom_type[geoms], engine.geom_size[geoms], at, normals, local, strict=True)
    surfaces = [surface_of(*of_geom) for of_geom in each]
    bend, sharp = (np.array(parts) for parts in zip(*surfaces, strict=True))
    return Side(velocity, twist[:, :3], bend, sharp)


def surface_of(
    kind: int, size: np.ndarray, at: np.ndarray, out: np.ndarray, tangents: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Find ``bend`` and ``sharp`` of a geom at ``at``, in its own frame."""
    flat, sine = 0.0 * UNIT, np.hypot(out[0], out[1])
    if kind == SPHERE or (kind == CAPSULE and abs(at[2] - size[0] * out[2]) > (1.0 - NEAR) * size[1]):
        return UNIT / size[0], flat
    if kind == CAPSULE:
        return along(tangents, np.array([-out[1], out[0], 0.0]) / sine) / size[0], flat
    if kind == ELLIPSOID:
        return (tangents / size**2) @ tangents.T / np.linalg.norm(at / size**2), flat
    if kind == CYLINDER:
        is_end = abs(at[2]) > size[1] - NEAR * min(size[:2])
        if np.hypot(at[0], at[1]) <= (1.0 - NEAR) * size[0]:
            return flat, flat
        if is_end and sine < UPRIGHT:
            return flat, UNIT
        tangent = np.array([-out[1], out[0], 0.0]) / sine
        bend = along(tangents, tangent) * sine / size[0]
        return bend, along(tangents, np.cross(out, tangent)) if is_end else flat
    if kind == BOX:
        is_along = np.abs(out) < NEAR
        if is_along.sum() == 1:
            across = np.cross(out, is_along)
            return flat, along(tangents, across / np.linalg.norm(across))
        return flat, flat if is_along.any() else UNIT
    return flat, flat


def along(tangents: np.ndarray, way: np.ndarray) -> np.ndarray:
    """Return w wᵀ of a vector w in the plane of the tangents."""
    return np.outer(tangents @ way, tangents @ way)


def place_on(first, second, sharp, gap, turning, sliding) -> np.ndarray:
    """Find how fast the places move over the first surfaces, as in Warp; shape [contacts, 2]."""
    carried = UNIT + gap[..., None] * first
    smooth = UNIT - sharp
    bent = smooth @ (first + second) @ smooth
    scale = np.trace(bent, axis1=1, axis2=2)[:, None, None]
    edge = np.trace(sharp, axis1=1, axis2=2)[:, None, None] > 0.5
    held = (scale <= 0.0) | (edge & (scale < ALONG * np.trace(first, axis1=1, axis2=2)[:, None, None]))
    scale = np.where(held, 1.0, scale)
    flat = ~held & ~edge & (np.linalg.det(bent)[:, None, None] < ALONG * scale**2)
    sharp = np.where(held, UNIT, np.where(flat, UNIT - bent / scale, sharp))
    smooth = UNIT - sharp
    wanted = smooth @ (turning[..., None] + second @ sliding[..., None]) / scale + sharp @ sliding[..., None]
    return np.linalg.solve(smooth @ (first + second @ carried) / scale + sharp @ carried, wanted)[..., 0]


def rims_ahead(engine: mujoco.MjModel, data: mujoco.MjData, geoms, position, n, on_rim) -> np.ndarray:
    """Find by how much more than the lowest place of a cylinder's rim its contacts with a plane move, as in Warp."""
    kinds, second = engine.geom_type[geoms], geoms[:, 1]
    axis = data.geom_xmat[second].reshape(-1, 3, 3)[:, :, 2]
    lowest = (n * axis).sum(axis=1, keepdims=True) * axis - n
    sine = np.linalg.norm(lowest, axis=1, keepdims=True)
    rolls = ((kinds == (PLANE, CYLINDER)).all(axis=1) & (sine[:, 0] >= UPRIGHT))[:, None]
    radius = engine.geom_size[second, :1]
    lowest *= radius / np.where(rolls, sine, 1.0)
    turns = (on_rim * np.cross(axis, lowest)).sum(axis=1, keepdims=True) / np.where(rolls, radius, 1.0) ** 2
    ahead = turns * np.cross(axis, position - data.geom_xpos[second] - lowest)
    return np.where(rolls, ahead - 0.5 * (ahead * n).sum(axis=1, keepdims=True) * n, 0.0)


def frame_spin(engine: mujoco.MjModel, data: mujoco.MjData, geoms, turning, n, tangents, rate) -> np.ndarray:
    """Find how fast the frames turn about their normals [rad/s], shape [contacts].

    The first tangent is what the normal leaves of an axis: of y in the world, of z where the normal is near to it
    (``mju_makeFrame``), or of a capsule on a plane.
    """
    x, y = tangents[:, 0], tangents[:, 1]
    world = np.where((np.abs(n[:, 1]) < 0.5)[:, None], (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    axis = data.geom_xmat[geoms[:, 1]].reshape(-1, 3, 3)[:, :, 2]
    kinds = engine.geom_type[geoms]
    lying = (kinds[:, 0] == PLANE) & (kinds[:, 1] == CAPSULE) & is_made_of(axis, n, x)
    way = np.where(lying[:, None], axis, world)
    way_rate = np.where(lying[:, None], np.cross(turning, axis), 0.0)
    upright, level = (np.einsum("cr,cr->c", way, vectors) for vectors in (n, x))
    found = np.einsum("cr,cr->c", way_rate - upright[:, None] * rate, y)
    return np.where(is_made_of(way, n, x), found / np.where(level == 0.0, 1.0, level), 0.0)


def is_made_of(way: np.ndarray, n: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Tell whether the tangents x are what the normals leave of ``way``."""
    upright, level = (np.einsum("cr,cr->c", way, vectors) for vectors in (n, x))
    return (level**2 > UPRIGHT**2) & (np.abs(level**2 + upright**2 - 1.0) < 1e-5)
