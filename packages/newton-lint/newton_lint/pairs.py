"""Finds the pairs of geoms that may touch, by the filters of ``mj_collision``."""

import math

import mujoco
import numpy as np
from mujoco import MjModel

PLANE = int(mujoco.mjtGeom.mjGEOM_PLANE)
HFIELD = int(mujoco.mjtGeom.mjGEOM_HFIELD)
MESH = int(mujoco.mjtGeom.mjGEOM_MESH)
OFF = int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(
    mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
)
UNFILTERED = int(mujoco.mjtDisableBit.mjDSBL_FILTERPARENT)
PARAMETERS = (
    "solref",
    "solimp",
    "solmix",
    "friction",
    "condim",
    "priority",
    "contype",
    "conaffinity",
)
"""Arrays in which geoms of one kind agree."""
MOST_PAIRS = 2_000_000
"""If there are more pairs than this, only a sample is read."""


def where(mask: np.ndarray) -> list[int]:
    """Return the indices at which a mask is true."""
    return np.flatnonzero(mask).tolist()


def pairs_of(model: MjModel) -> tuple[np.ndarray, np.ndarray]:
    """Return all pairs that may touch.

    Returns:
        The geoms of each pair, the lower one first, of shape [pair_count, 2], and the
        index of the ``<pair>`` that names them, or -1.
    """
    if model.opt.disableflags & OFF:
        return np.zeros((0, 2), dtype=int), np.zeros(0, dtype=int)
    named = np.sort(
        np.stack([model.pair_geom1, model.pair_geom2], axis=1), axis=1
    ).astype(int)
    # No mask, body or <exclude> filters a <pair>.
    indices = np.flatnonzero(collidable(model, named))
    pairs = _unnamed(model)
    # mj_collision merges duplicates.
    pairs = pairs[~np.isin(keys_of(pairs), keys_of(named))]
    return np.concatenate([named[indices], pairs]), np.append(
        indices, np.full(len(pairs), -1)
    )


def collidable(model: MjModel, pairs: np.ndarray) -> np.ndarray:
    """Return whether geoms can collide; two planes or height fields cannot."""
    return ~np.isin(model.geom_type[pairs], (PLANE, HFIELD)).all(axis=1)


def masks_of(model: MjModel) -> np.ndarray:
    """Return the bits of both masks of each geom, which are 0 if it is only visual."""
    return model.geom_contype | model.geom_conaffinity


def kinds_of(model: MjModel, *of_bodies: np.ndarray) -> np.ndarray:
    """Number geoms; those with equal parameters and bodies have equal numbers."""
    columns = [getattr(model, f"geom_{name}") for name in PARAMETERS]
    columns += [values[model.geom_bodyid] for values in of_bodies]
    return numbered(*columns)


def numbered(*columns: np.ndarray) -> np.ndarray:
    """Number rows so that equal rows have equal numbers."""
    rows = np.column_stack(columns)
    return np.unique(rows, axis=0, return_inverse=True)[1].ravel()


def read(model: MjModel) -> np.ndarray:
    """Return the geoms that can collide, or, of many, a sample with each kind."""
    geoms = np.flatnonzero(masks_of(model))
    welds = model.body_weldid[model.geom_bodyid[geoms]]
    counts = np.bincount(welds).astype(float)
    if 0.5 * (counts.sum() ** 2 - (counts**2).sum()) < MOST_PAIRS:
        return geoms
    kinds = kinds_of(model, model.body_weldid > 0)[geoms]
    _, firsts = np.unique(kinds, return_index=True)
    stride = math.ceil(len(geoms) / (2.0 * MOST_PAIRS) ** 0.5)
    return np.union1d(geoms[firsts], geoms[::stride])


def _unnamed(model: MjModel) -> np.ndarray:
    """Return the pairs that masks, bodies and excludes permit."""
    geoms = read(model)
    contype = model.geom_contype[geoms]
    conaffinity = model.geom_conaffinity[geoms]
    welds = model.body_weldid[model.geom_bodyid[geoms]]
    rows = [np.zeros((0, 2), dtype=int)]
    # Bodies that are welded together make no pairs among themselves.
    for weld in np.flatnonzero(np.bincount(welds)):
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
    # The rest follows filterBodyPair in engine_collision_driver.c. No force can act on
    # bodies without dofs.
    collides = (model.body_dofnum[weld] > 0).any(axis=1) & collidable(model, pairs)
    if not model.opt.disableflags & UNFILTERED:
        parent = model.body_weldid[model.body_parentid[weld]]
        related = (weld[:, 0] == parent[:, 1]) | (weld[:, 1] == parent[:, 0])
        # The world does not count as a parent, or nothing would rest on a floor.
        collides &= ~(related & (weld != 0).all(axis=1))
    low = body.min(axis=1).astype(np.int64)
    high = body.max(axis=1)
    # mj_collision packs two bodies into one number like this.
    collides &= ~np.isin((low << 16) + high, model.exclude_signature)
    return pairs[collides]


def keys_of(pairs: np.ndarray) -> np.ndarray:
    """Return a number for each pair of geoms, which does not depend on their order."""
    return (pairs.min(axis=1).astype(np.int64) << 32) + pairs.max(axis=1)
