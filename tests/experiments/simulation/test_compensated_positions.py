"""Test positions whose motion is not lost to rounding."""

import mujoco
import numpy as np
import pytest
import warp as wp
from stepping import BALL, in_two_worlds, take_steps

from experiments.simulation import compensated_positions

VELOCITY = 1e-5
"""Speed that moves a position of 1 m in one time step by a hundredth of the distance to
the next number [m/s].
"""
STEP_COUNT = 300
PLACES = [0, 1, 2, 7]
"""Indices of position coordinates: a free body, and a body on a slide."""


class Solver:
    """Provides the parts of a solver that ``install`` uses, with two worlds that start
    at 1 m.
    """

    def __init__(self, integrator: str):
        model = mujoco.MjModel.from_xml_string(BALL.replace("implicitfast", integrator))
        model.opt.timestep, model.opt.gravity[:] = 0.001, 0.0
        data = mujoco.MjData(model)
        data.qpos[PLACES] = 1.0
        data.qvel[[0, 1, 2, 6]] = VELOCITY
        self.mjw_model, self.mjw_data = in_two_worlds(model, data)

    def moved(self) -> np.ndarray:
        """Return positions minus 1 m after STEP_COUNT steps, shape [worlds, 4]."""
        take_steps(self.mjw_model, self.mjw_data, STEP_COUNT)
        return self.mjw_data.qpos.numpy()[:, PLACES].astype(float) - 1.0


@pytest.mark.slow
@pytest.mark.parametrize("integrator", ["implicitfast", "RK4"])
def test_a_position_creeps_in_the_world_that_compensates_and_stands_in_the_other(
    integrator,
):
    with wp.ScopedDevice("cpu"):
        solver = Solver(integrator)
        compensated_positions.install(solver, worlds=[True, False])
        moved = solver.moved()
        expected = (
            VELOCITY * 1e-3 * (STEP_COUNT - 1)
        )  # the sum of the last step is computed in the next step
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


def test_the_stages_of_a_step_of_rk4_weigh_as_simpsons_rule_has_it():
    weights = compensated_positions.STAGE_WEIGHTS
    assert weights == pytest.approx(np.array([1.0, 2.0, 2.0, 1.0]) / 6.0)
    mean, velocity = (
        wp.array([[each]], dtype=float, device="cpu") for each in (9.0, 4.0)
    )
    for weight, first, expected in ((0.5, True, 2.0), (0.25, False, 3.0)):
        inputs = [weight, first, velocity]
        wp.launch(
            compensated_positions.add_stage,
            dim=(1, 1),
            inputs=inputs,
            outputs=[mean],
            device="cpu",
        )
        assert mean.numpy()[0, 0] == expected


def test_sums_keep_what_rounding_takes_joint_by_joint():
    """Test three positions of a free joint and one of a hinge, but not of a ball joint:
    single precision with compensation agrees with double precision.
    """
    random = np.random.default_rng(0)
    velocity = random.normal(0.0, 1e-4, (1, 10)).astype(np.float32)
    start = np.float32(1.0) + random.uniform(0.0, 1.0, (1, 12)).astype(np.float32)
    arrays = [
        wp.array(each, dtype=float, device="cpu")
        for each in (start, np.full((1, 12), np.nan), np.zeros((1, 12)))
    ]
    joints = [
        (0, 1, 3),
        (0, 7, 11),
        (0, 6, 9),
    ]  # free, ball and hinge joint, and the first indices of their positions and velocities
    kinds = [wp.array(each, dtype=int, device="cpu") for each in joints]
    inputs = [
        wp.array([True], dtype=bool, device="cpu"),
        wp.array([0.001], dtype=float, device="cpu"),
        *kinds,
    ]
    inputs.append(wp.array(velocity, dtype=float, device="cpu"))
    for _ in range(1001):  # the first step takes the present position
        wp.launch(
            compensated_positions.add_step,
            dim=(1, 3),
            inputs=inputs,
            outputs=arrays,
            device="cpu",
        )
    moved, lost = arrays[0].numpy().astype(float) - start, arrays[2].numpy()
    expected = np.zeros(12)
    expected[[0, 1, 2, 11]] = velocity[
        0, [0, 1, 2, 9]
    ]  # in 1000 steps of a millisecond
    assert moved[0] + lost[0] == pytest.approx(expected, abs=1e-9)
    for way, kept in (
        (0.9e-6, True),
        (1.4e-6, False),
    ):  # relative to 2 m; with a larger error, the position counts as set
        place = np.float32(2.0 * (1.0 + way))
        state = [
            wp.array([[each] * 12], dtype=float, device="cpu")
            for each in (place, 2.0, 0.0)
        ]
        still = [*inputs[:-1], wp.zeros((1, 10), dtype=float, device="cpu")]
        wp.launch(
            compensated_positions.add_step,
            dim=(1, 3),
            inputs=still,
            outputs=state,
            device="cpu",
        )
        assert state[0].numpy()[0, 11] == (2.0 if kept else place)
