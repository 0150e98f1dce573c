"""The pairs of geoms that MuJoCo may make contacts of: all of ``mj_collision`` but what distance decides."""

import mujoco
import numpy as np

PLANE, HFIELD = int(mujoco.mjtGeom.mjGEOM_PLANE), int(mujoco.mjtGeom.mjGEOM_HFIELD)
OFF = int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_CONSTRAINT)
CHUNK = 512
"""Geoms whose pairs are looked for at once."""
UNFILTERED = int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)


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


def _unnamed(model: mujoco.MjModel) -> np.ndarray:
    """Return pairs that their bits, bodies and excludes leave, in the order of the model."""
    geoms = np.flatnonzero(model.geom_contype | model.geom_conaffinity)
    contype, conaffinity = model.geom_contype[geoms], model.geom_conaffinity[geoms]
    own = model.body_weldid[model.geom_bodyid[geoms]]
    rows = []
    for begin in range(0, len(geoms), CHUNK):  # one body of many geoms is a large matrix and few pairs
        part = slice(begin, begin + CHUNK)
        there = ((contype[part, None] & conaffinity) | (contype & conaffinity[part, None])) != 0
        there &= own[part, None] != own
        there &= np.arange(begin, min(begin + CHUNK, len(geoms)))[:, None] < np.arange(len(geoms))
        first, second = np.nonzero(there)
        rows.append(np.stack([geoms[first + begin], geoms[second]], axis=1))
    pairs = np.concatenate(rows) if rows else np.zeros((0, 2), dtype=int)
    body = model.geom_bodyid[pairs]
    weld = model.body_weldid[body]
    there = (weld[:, 0] != weld[:, 1]) & (model.body_dofnum[weld] > 0).any(axis=1) & collidable(model, pairs)
    if not model.opt.disableflags & UNFILTERED:
        parent = model.body_weldid[model.body_parentid[weld]]
        related = (weld[:, 0] == parent[:, 1]) | (weld[:, 1] == parent[:, 0])
        there &= ~(related & (weld != 0).all(axis=1))
    low, high = body.min(axis=1).astype(np.int64), body.max(axis=1)
    there &= ~np.isin((low << 16) + high, model.exclude_signature)
    return pairs[there]


def _key(pairs: np.ndarray, geom_count: int) -> np.ndarray:
    return pairs[:, 0].astype(np.int64) * geom_count + pairs[:, 1]
