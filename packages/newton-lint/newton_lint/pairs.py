"""The pairs of geoms that MuJoCo may make contacts of: all of ``mj_collision`` but what distance decides."""

import math

import mujoco
import numpy as np
from mujoco import MjModel

PLANE = int(mujoco.mjtGeom.mjGEOM_PLANE)
HFIELD = int(mujoco.mjtGeom.mjGEOM_HFIELD)
OFF = int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(
    mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
)
UNFILTERED = int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
MOST_PAIRS = 1_000_000


def pairs_of(model: MjModel) -> tuple[np.ndarray, np.ndarray]:
    """Return geoms of each pair, the lower first, of shape [pair_count, 2], and the ``<pair>`` that names it, or -1."""
    if model.opt.disableflags & OFF:
        return np.zeros((0, 2), dtype=int), np.zeros(0, dtype=int)
    named = np.sort(
        np.stack([model.pair_geom1, model.pair_geom2], axis=1), axis=1
    ).astype(int)
    indices = np.flatnonzero(
        collidable(model, named)
    )  # neither bits nor bodies nor <exclude> keep a <pair> apart
    pairs = _unnamed(model)
    pairs = pairs[
        ~np.isin(_key(pairs, model.ngeom), _key(named, model.ngeom))
    ]  # mj_collision merges duplicates
    return np.concatenate([named[indices], pairs]), np.append(
        indices, np.full(len(pairs), -1)
    )


def collidable(model: MjModel, pairs: np.ndarray) -> np.ndarray:
    """Tell whether these geoms can collide: mjCOLLISIONFUNC has nothing for two planes or height fields."""
    return ~np.isin(model.geom_type[pairs], (PLANE, HFIELD)).all(axis=1)


def read(model: MjModel) -> np.ndarray:
    """Return the geoms that can collide, or where they make too many pairs some of them, as far apart as that takes."""
    geoms = np.flatnonzero(model.geom_contype | model.geom_conaffinity)
    counts = np.bincount(model.body_weldid[model.geom_bodyid[geoms]]).astype(float)
    many = 0.5 * (counts.sum() ** 2 - (counts**2).sum()) > MOST_PAIRS
    return (
        geoms[:: math.ceil(len(geoms) / (2.0 * MOST_PAIRS) ** 0.5)] if many else geoms
    )


def _unnamed(model: MjModel) -> np.ndarray:
    """Return pairs that their bits, bodies and excludes leave, in the order of the model."""
    geoms = read(model)
    contype = model.geom_contype[geoms]
    conaffinity = model.geom_conaffinity[geoms]
    welds = model.body_weldid[model.geom_bodyid[geoms]]
    rows = [np.zeros((0, 2), dtype=int)]
    for weld in np.flatnonzero(
        np.bincount(welds)
    ):  # what is fixed together makes no pairs, however many geoms it has
        low = np.flatnonzero(welds == weld)
        high = np.flatnonzero(welds > weld)
        first, second = np.nonzero(
            contype[low, None] & conaffinity[high]
            | conaffinity[low, None] & contype[high]
        )
        rows.append(np.stack([geoms[low[first]], geoms[high[second]]], axis=1))
    pairs = np.sort(np.concatenate(rows), axis=1)
    body = model.geom_bodyid[pairs]
    weld = model.body_weldid[body]
    # From here on filterBodyPair of engine_collision_driver.c: on what has no dofs no force can act.
    collides = (model.body_dofnum[weld] > 0).any(axis=1) & collidable(model, pairs)
    if not model.opt.disableflags & UNFILTERED:
        parent = model.body_weldid[model.body_parentid[weld]]
        related = (weld[:, 0] == parent[:, 1]) | (weld[:, 1] == parent[:, 0])
        collides &= ~(
            related & (weld != 0).all(axis=1)
        )  # the world is no parent: else nothing would stand on a floor
    low = body.min(axis=1).astype(np.int64)
    high = body.max(axis=1)
    collides &= ~np.isin(
        (low << 16) + high, model.exclude_signature
    )  # as mj_collision packs two bodies
    return pairs[collides]


def _key(pairs: np.ndarray, geom_count: int) -> np.ndarray:
    return pairs[:, 0].astype(np.int64) * geom_count + pairs[:, 1]
