"""The pairs of geoms that MuJoCo may make contacts of: all of ``mj_collision`` but what distance decides."""

import mujoco
import numpy as np

from newton_lint.grouping import alike

PLANE, HFIELD = int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD)
OFF = int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
UNFILTERED = int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
MOST_PAIRS = 1_000_000
ALIKE = (100, 10, 1)
"""Geoms that are read of those alike where all make more pairs, until they make no more."""
SAID = ("type", "contype", "conaffinity", "condim", "priority", "solmix", "solref", "solimp", "friction")


def pairs_of(model: mujoco.MjModel) -> tuple[np.ndarray, np.ndarray]:
    """Return geoms of each pair, the lower first, of shape [pair_count, 2], and the ``<pair>`` that names it, or -1."""
    if model.opt.disableflags & OFF:
        return np.zeros((0, 2), dtype=int), np.zeros(0, dtype=int)
    named = np.sort(np.stack([model.pair_geom1, model.pair_geom2], axis=1), axis=1).astype(int)
    which = np.flatnonzero(collidable(model, named))
    pairs = _unnamed(model)
    pairs = pairs[~np.isin(_key(pairs, model.ngeom), _key(named, model.ngeom))]
    return np.concatenate([named[which], pairs]), np.append(which, np.full(len(pairs), -1))


def collidable(model: mujoco.MjModel, pairs: np.ndarray) -> np.ndarray:
    """Tell whether these geoms can collide: two planes or height fields can't."""
    return ~np.isin(model.geom_type[pairs], (PLANE, HFIELD)).all(axis=1)


def read(model: mujoco.MjModel) -> np.ndarray:
    """Return the geoms that can collide; of many that are alike the first ones."""
    geoms = np.flatnonzero(model.geom_contype | model.geom_conaffinity)
    weld = model.body_weldid[model.geom_bodyid]
    columns = [column for name in SAID for column in np.atleast_2d(getattr(model, f"geom_{name}").T)]
    for most in ALIKE:
        own = np.bincount(weld[geoms]).astype(float)
        if 0.5 * (own.sum() ** 2 - (own**2).sum()) <= MOST_PAIRS:
            return geoms
        _, kind = alike(*(column[geoms] for column in columns), weld[geoms] == 0)
        order = np.argsort(kind, kind="stable")
        begins = np.cumsum(np.bincount(kind)) - np.bincount(kind)
        geoms = np.sort(geoms[order[np.arange(len(geoms)) - begins[kind[order]] < most]])
    return geoms[: round((2 * MOST_PAIRS) ** 0.5)]


def _unnamed(model: mujoco.MjModel) -> np.ndarray:
    """Return pairs that their bits, bodies and excludes leave, in the order of the model."""
    geoms = read(model)
    contype, conaffinity = model.geom_contype[geoms], model.geom_conaffinity[geoms]
    own = model.body_weldid[model.geom_bodyid[geoms]]
    rows = [np.zeros((0, 2), dtype=int)]
    for weld in np.flatnonzero(np.bincount(own)):  # what is fixed together makes no pairs, however many geoms it has
        mine, others = np.flatnonzero(own == weld), np.flatnonzero(own > weld)
        there = (contype[mine, None] & conaffinity[others] | conaffinity[mine, None] & contype[others]) != 0
        first, second = np.nonzero(there)
        rows.append(np.stack([geoms[mine[first]], geoms[others[second]]], axis=1))
    pairs = np.sort(np.concatenate(rows), axis=1)
    body = model.geom_bodyid[pairs]
    weld = model.body_weldid[body]
    there = (model.body_dofnum[weld] > 0).any(axis=1) & collidable(model, pairs)
    if not model.opt.disableflags & UNFILTERED:
        parent = model.body_weldid[model.body_parentid[weld]]
        related = (weld[:, 0] == parent[:, 1]) | (weld[:, 1] == parent[:, 0])
        there &= ~(related & (weld != 0).all(axis=1))
    low, high = body.min(axis=1).astype(np.int64), body.max(axis=1)
    there &= ~np.isin((low << 16) + high, model.exclude_signature)
    return pairs[there]


def _key(pairs: np.ndarray, geom_count: int) -> np.ndarray:
    return pairs[:, 0].astype(np.int64) * geom_count + pairs[:, 1]
