"""Compare the scene as MJCF with the engine's own model, number by number."""

from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from experiments.facts.case import LEAN
from experiments.lab import scene_mjcf
from experiments.simulation.simulation import Simulation

UNREAD = "_sizes names name_ nbuffer nnames signature geom_rgba bvh_ jnt_range actfrcrange".split()
"""Arrays that no step reads: names, colours, boxes of the midphase, and ranges of
joints without a limit.
"""


def test_compiled_it_is_the_model_that_newton_makes():
    own = Simulation(
        [replace(LEAN, backend="mujoco")], wp.get_device("cpu")
    ).solver.mj_model
    compiled = mujoco.MjModel.from_xml_string(scene_mjcf())
    names = [
        name
        for name in dir(own)
        if isinstance(getattr(own, name), np.ndarray | int | float)
    ]
    for name in names:
        if (
            name.startswith("_")
            or any(part in name for part in UNREAD)
            or "site" in name
        ):
            continue
        found, wanted = (
            np.asarray(getattr(compiled, name)),
            np.asarray(getattr(own, name)),
        )
        assert found.shape == wanted.shape, name
        assert np.allclose(found, wanted, rtol=1e-6, atol=1e-7), name
    for name in (
        "timestep",
        "impratio",
        "tolerance",
        "ls_tolerance",
        "cone",
        "integrator",
        "solver",
        "disableflags",
    ):
        assert getattr(compiled.opt, name) == getattr(own.opt, name), name
