"""Positions that rounding does not stop."""

import mujoco
import mujoco_warp as mjw
import numpy as np
import pytest
import warp as wp
from stepping import take_steps

from experiments.simulation import compensated_positions

CREEP = """
<mujoco>
  <option integrator="{integrator}" timestep="0.001" gravity="0 0 0"/>
  <worldbody>
    <body> <joint type="slide" axis="1 0 0"/> <geom size="0.1"/> </body>
    <body pos="1 1 0"> <freejoint/> <geom size="0.1"/> </body>
  </worldbody>
</mujoco>
"""
VELOCITY = 1e-5
"""A hundredth of what moves a position of 1 m to the next number in a time step [m/s]."""
STEP_COUNT = 300


class Solver:
    """What ``install`` asks of a solver, in two worlds that start at 1 m."""

    def __init__(self, integrator: str):
        model = mujoco.MjModel.from_xml_string(CREEP.format(integrator=integrator))
        data = mujoco.MjData(model)
        data.qpos[0] = 1.0
        data.qvel[:3] = VELOCITY
        self.mjw_model = mjw.put_model(model)
        self.mjw_data = mjw.put_data(model, data, nworld=2)

    def moved(self) -> np.ndarray:
        """Positions less 1 m after STEP_COUNT steps, shape [worlds, 3]."""
        take_steps(self.mjw_model, self.mjw_data, STEP_COUNT)
        return self.mjw_data.qpos.numpy()[:, :3].astype(float) - 1.0


@pytest.mark.slow
@pytest.mark.parametrize("integrator", ["implicitfast", "RK4"])
def test_a_position_creeps_in_the_world_that_compensates_and_stands_in_the_other(integrator):
    with wp.ScopedDevice("cpu"):
        solver = Solver(integrator)
        compensated_positions.install(solver, worlds=[True, False])
        moved = solver.moved()
        expected = VELOCITY * 1e-3 * (STEP_COUNT - 1)  # the last step's sum is done in the next step
        assert moved[0] == pytest.approx(np.full(3, expected), abs=1.3e-7)
        assert (moved[1] == 0.0).all()


def test_a_position_that_is_set_is_kept():
    with wp.ScopedDevice("cpu"):
        solver = Solver("implicitfast")
        compensated_positions.install(solver)
        solver.moved()
        solver.mjw_data.qpos.fill_(0.25)
        mjw.step(solver.mjw_model, solver.mjw_data)
        mjw.step(solver.mjw_model, solver.mjw_data)
        assert (np.abs(solver.mjw_data.qpos.numpy()[:, :3] - 0.25) < 1e-7).all()
