"""Positions that rounding does not stop."""

import mujoco
import numpy as np
import pytest
import warp as wp
from stepping import BALL, in_two_worlds, take_steps

from experiments.simulation import compensated_positions

VELOCITY = 1e-5
"""A hundredth of what moves a position of 1 m to the next number in a time step [m/s]."""
STEP_COUNT = 300
PLACES = [0, 1, 2, 7]
"""Of a body that is free, and of one on a slide."""


class Solver:
    """What ``install`` asks of a solver, in two worlds that start at 1 m."""

    def __init__(self, integrator: str):
        model = mujoco.MjModel.from_xml_string(BALL.replace("implicitfast", integrator))
        model.opt.timestep, model.opt.gravity[:] = 0.001, 0.0
        data = mujoco.MjData(model)
        data.qpos[PLACES] = 1.0
        data.qvel[[0, 1, 2, 6]] = VELOCITY
        self.mjw_model, self.mjw_data = in_two_worlds(model, data)

    def moved(self) -> np.ndarray:
        """Positions less 1 m after STEP_COUNT steps, shape [worlds, 4]."""
        take_steps(self.mjw_model, self.mjw_data, STEP_COUNT)
        return self.mjw_data.qpos.numpy()[:, PLACES].astype(float) - 1.0


@pytest.mark.slow
@pytest.mark.parametrize("integrator", ["implicitfast", "RK4"])
def test_a_position_creeps_in_the_world_that_compensates_and_stands_in_the_other(integrator):
    with wp.ScopedDevice("cpu"):
        solver = Solver(integrator)
        compensated_positions.install(solver, worlds=[True, False])
        moved = solver.moved()
        expected = VELOCITY * 1e-3 * (STEP_COUNT - 1)  # the last step's sum is done in the next step
        assert moved[0] == pytest.approx(np.full(4, expected), abs=1.3e-7)
        assert (moved[1] == 0.0).all()


def test_a_position_that_is_set_is_kept():
    with wp.ScopedDevice("cpu"):
        solver = Solver("implicitfast")
        compensated_positions.install(solver)
        solver.moved()
        solver.mjw_data.qpos.fill_(0.25)
        take_steps(solver.mjw_model, solver.mjw_data, 2)
        assert (np.abs(solver.mjw_data.qpos.numpy()[:, PLACES] - 0.25) < 1e-7).all()
