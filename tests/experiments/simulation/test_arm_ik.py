"""The arm's inverse kinematics, against Newton's."""

from dataclasses import replace

import newton
import newton.ik as ik
import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.arm_ik import ArmSolver
from experiments.simulation.scene import READY_POSE, build_scene
from experiments.simulation.task import APPROACH_HEIGHT

WORLD_COUNT = 3
FRAME_COUNT = 90


@pytest.fixture(scope="module")
def scene():
    newton.use_coord_layout_targets = True
    return build_scene([replace(AS_SHIPPED, frame_count=1)], wp.get_device("cpu"))


def test_joints_are_those_of_newton_s_solver(scene):
    """From the ready pose to above the cube, and along a shake: the same steps, so the same joints up to rounding."""
    tcp = scene.links["fr3_hand_tcp"]
    cube = scene.model.body_q.numpy()[scene.links["cube"].body, :3]
    start = np.tile(cube + (0.0, 0.0, float(APPROACH_HEIGHT)), (WORLD_COUNT, 1))
    place = wp.array(start, dtype=wp.vec3, device="cpu")
    turn = wp.full(WORLD_COUNT, wp.vec4(1.0, 0.0, 0.0, 0.0), dtype=wp.vec4, device="cpu")
    objectives = [
        ik.IKObjectivePosition(tcp.body, tcp.pose.p, place),
        ik.IKObjectiveRotation(tcp.body, tcp.pose.q, turn),
        ik.IKObjectiveJointLimit(scene.robot.joint_limit_lower, scene.robot.joint_limit_upper, weight=10.0),
    ]
    options = {"lambda_initial": 0.1, "jacobian_mode": ik.IKJacobianType.ANALYTIC}
    theirs = ik.IKSolver(scene.robot, WORLD_COUNT, objectives, **options)
    ours = ArmSolver(scene.robot, tcp.body, tcp.pose, place, turn)
    found, expected = (
        wp.array(np.tile(np.float32(READY_POSE), (WORLD_COUNT, 1)), dtype=float, device="cpu") for _ in range(2)
    )
    for frame in range(FRAME_COUNT):
        shake = max(0, frame - 30) / 60.0
        amplitude = np.outer(0.01 * np.arange(1, WORLD_COUNT + 1), (1.0, 0.65, 0.35))
        place.assign(np.float32(start + np.sin(2.0 * np.pi * shake) * amplitude))
        ours.step(found, AS_SHIPPED.ik_iterations)
        theirs.step(expected, expected, iterations=AS_SHIPPED.ik_iterations)
    assert found.numpy() == pytest.approx(expected.numpy(), abs=3e-5)
