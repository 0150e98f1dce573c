"""Test that a model expanded from a few worlds equals the model that Newton builds, and
runs in the same way.
"""

from dataclasses import replace

import newton
import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED, LEAN
from experiments.simulation import scene, worlds
from experiments.simulation.worlds import NOT_EXTENDED

CASES = {
    "as-shipped": AS_SHIPPED,
    "lean": LEAN,
    "mesh": replace(AS_SHIPPED, pad_shape="convex-mesh"),
}


def arrays(part: object, name: str = "") -> dict[str, np.ndarray]:
    """Return every array and number of a model by name, except pointers."""
    if isinstance(part, wp.array):
        return {} if part.dtype is wp.uint64 else {name: part.numpy()}
    if isinstance(part, (np.ndarray, int, list)):
        return (
            {}
            if name.endswith(("_source", "_keep_alive"))
            else {name: np.asarray(part)}
        )
    if (
        not type(part).__module__.startswith("newton.")
        or callable(part)
        or not hasattr(part, "__dict__")
    ):
        return {}
    found = {}
    for key, value in vars(part).items():
        if key != "counts" and not key.startswith(
            tuple(set(NOT_EXTENDED) - {"body_shapes"})
        ):
            found |= arrays(value, f"{name}.{key}")
    return found


@pytest.mark.parametrize("name", CASES)
def test_a_model_that_is_worked_out_is_the_one_that_is_built(name, monkeypatch):
    newton.use_coord_layout_targets = True
    cases = [replace(CASES[name], pad_ke=1e3 * (world + 1)) for world in range(6)]
    extended = scene.build_scene(cases, wp.get_device("cpu")).model
    monkeypatch.setattr(worlds, "WORLDS_BUILT", len(cases))
    built = scene.build_scene(cases, wp.get_device("cpu")).model
    found, expected = arrays(extended), arrays(built)
    assert found.keys() == expected.keys()
    assert len(found) > 100
    different = [
        name for name in found if found[name].tobytes() != expected[name].tobytes()
    ]
    assert different == []
    assert extended.body_shapes == built.body_shapes
    assert np.count_nonzero(extended.shape_source_ptr.numpy()) == np.count_nonzero(
        built.shape_source_ptr.numpy()
    )
    pairs = [model.shape_collision_filter_pairs for model in (extended, built)]
    assert set(pairs[0]) == set(pairs[1])
