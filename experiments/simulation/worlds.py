"""Extrapolate a model of many equal worlds from models with two and three worlds.

Newton's builder processes Python lists world by world, which takes minutes for many
thousands of worlds. But the worlds are equal. Every number in the model is either the
same in all worlds, or it is an index that depends linearly on the number of the world
and on the world count. Two models determine both coefficients.
"""

from collections.abc import Callable
from functools import cached_property

import newton
import numpy as np
import warp as wp

WORLDS_BUILT = 3  # largest number of worlds for which Newton builds the model
NOT_EXTENDED = ("bvh", "_bvh", "body_shapes", "_shape_contact_pair_counts")
"""Prefixes of attributes that are not extended.

They are only needed for casting rays, are rebuilt here, or are caches.
"""


class UnequalWorlds(ValueError):
    """Signal a part of a model that differs between worlds; the message names it."""


def model_of(world_count: int, build: Callable[[int], newton.Model]) -> newton.Model:
    """Return the model that ``build(world_count)`` would return.

    It is built for a few worlds, and extrapolated for more. Parts that do not belong to
    a world must have been added after the worlds. The extrapolated model does not
    support ray casting.

    Raises:
        UnequalWorlds: A part of the model is not linear in the worlds.
    """
    if world_count <= WORLDS_BUILT:
        return build(world_count)
    model = _extended(
        build(WORLDS_BUILT - 1), build(WORLDS_BUILT), world_count, "model"
    )
    model.body_shapes = {body: [] for body in range(-1, model.body_count)}
    for shape, body in enumerate(model.shape_body.numpy().tolist()):
        model.body_shapes[body].append(shape)
    if hasattr(model, "_shape_contact_pair_counts"):
        model._shape_contact_pair_counts = {}
    return model


def _extended(two: object, three: object, count: int, name: str) -> object:
    if isinstance(three, wp.array):
        if three.shape == two.shape:
            return three
        fewer, rows = two.numpy(), three.numpy()
        # Pointers to objects that the model of three worlds and the new one hold.
        if three.dtype is wp.uint64:
            stride = len(rows) - len(fewer)
            fewer = np.delete(rows, range(stride), axis=0)
        return wp.array(
            _extended_array(fewer, rows, count, name),
            dtype=three.dtype,
            device=three.device,
        )
    if isinstance(three, np.ndarray):
        return (
            three
            if three.shape == two.shape
            else _extended_array(two, three, count, name)
        )
    if isinstance(three, int):
        return three if three == two else three + (count - WORLDS_BUILT) * (three - two)
    if isinstance(three, list):
        return (
            three if len(three) == len(two) else _extended_list(two, three, count, name)
        )
    if (
        not type(three).__module__.startswith("newton.")
        or callable(three)
        or not hasattr(three, "__dict__")
    ):
        return three
    # Newton's set of pairs is lazy, so that a plain copy would contain the pairs of
    # three worlds.
    extended = type(three).__new__(type(three))
    vars(extended).update(vars(three))
    for attribute, value in vars(three).items():
        if isinstance(getattr(type(three), attribute, None), cached_property):
            del vars(extended)[attribute]
        elif not attribute.startswith(NOT_EXTENDED):
            vars(extended)[attribute] = _extended(
                vars(two)[attribute], value, count, f"{name}.{attribute}"
            )
    return extended


def _extended_array(
    two: np.ndarray, three: np.ndarray, count: int, name: str
) -> np.ndarray:
    """Return the rows of all worlds, then the rows outside of worlds.

    Integers may grow from world to world and with the number of worlds. All other
    values must be equal in all worlds. The shape is [count * rows per world + rest, …].
    """
    stride = len(three) - len(two)
    fewer, fewer_rest = _cut(two, WORLDS_BUILT - 1, stride)
    worlds, tail = _cut(three, WORLDS_BUILT, stride)
    is_index = np.issubdtype(three.dtype, np.signedinteger)
    by_world, by_count, by_count_rest = (
        (worlds[1] - worlds[0], worlds[0] - fewer[0], tail - fewer_rest)
        if is_index
        else (None, None, None)
    )

    def at(world_count: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the rows of ``world_count`` worlds, and the rest."""
        first, end, more = worlds[0], tail, world_count - WORLDS_BUILT
        if not is_index:
            return np.broadcast_to(first, (world_count, *first.shape)), end
        first, end = first + more * by_count, end + more * by_count_rest
        steps = np.arange(world_count, dtype=three.dtype).reshape(-1, *[1] * first.ndim)
        return (first + steps * by_world).astype(three.dtype), end.astype(three.dtype)

    for actual, expected in zip(
        (worlds, tail, fewer, fewer_rest),
        (*at(len(worlds)), *at(len(fewer))),
        strict=True,
    ):
        if actual.tobytes() != expected.tobytes():
            raise UnequalWorlds(
                f"{name} does not repeat world by world: build these worlds one by one"
            )
    many, end = at(count)
    return np.concatenate([many.reshape(-1, *three.shape[1:]), end])


def _extended_list(two: list, three: list, count: int, name: str) -> list:
    stride = len(three) - len(two)
    world, tail = three[:stride], three[WORLDS_BUILT * stride :]
    if three != world * WORLDS_BUILT + tail:
        raise UnequalWorlds(
            f"{name} does not repeat world by world: build these worlds one by one"
        )
    return world * count + tail


def _cut(
    rows: np.ndarray, world_count: int, stride: int
) -> tuple[np.ndarray, np.ndarray]:
    split = world_count * stride
    return rows[:split].reshape(world_count, stride, *rows.shape[1:]), rows[split:]
