"""Run the task on the device: approach, descend, grasp, lift and shake.

The state of the task has one entry per world.
"""

import numpy as np
import warp as wp

from experiments.facts.case import Case
from experiments.simulation.arm_ik import ArmSolver
from experiments.simulation.scene import (
    ARM_DOF_COUNT,
    CUBE_IN_HAND,
    READY_POSE,
    ROBOT_DOF_COUNT,
    Scene,
)

FRAME_RATE = 60
APPROACH, DESCEND, GRASP, LIFT, SHAKE = range(5)
# Minimum duration of each phase [s]; the shake has no end.
PHASE_SECONDS = (
    0.25,
    1.0,
    0.75,
    1.5,
)

FINGER_OPEN = wp.constant(0.035)
APPROACH_HEIGHT = wp.constant(0.10)
LIFT_HEIGHT = wp.constant(0.20)
SHAKE_RATIO_Y = wp.constant(0.65)
SHAKE_RATIO_Z = wp.constant(0.35)
POSITION_TOLERANCE = wp.constant(0.005)
ROTATION_TOLERANCE = wp.constant(float(np.radians(2.0)))
FRAME_DT = wp.constant(1.0 / FRAME_RATE)
# Number of IK solves from the ready pose to the approach pose.
APPROACH_SOLVE_COUNT = 30


@wp.func
def tool_down() -> wp.quat:
    return wp.quat(1.0, 0.0, 0.0, 0.0)


@wp.kernel
def set_targets(
    body_q: wp.array2d[wp.transform],
    cube: int,
    phase_start: wp.array[wp.transform],
    phase: wp.array[int],
    phase_seconds: wp.array[float],
    amplitude: wp.array[float],
    frequency: wp.array[float],
    in_hand: wp.array[bool],
    finger_closed: wp.array[float],
    elapsed: wp.array[float],
    goal: wp.array[wp.transform],
    target_position: wp.array[wp.vec3],
    target_rotation: wp.array[wp.vec4],
    target_finger: wp.array[float],
):
    """Advance the phase clock by a frame and set the targets of the TCP and the
    fingers.
    """
    world = wp.tid()
    t = elapsed[world] + FRAME_DT
    elapsed[world] = t

    start = phase_start[world]
    start_position = wp.transform_get_translation(start)
    position = start_position
    rotation = wp.transform_get_rotation(start)
    cube_position = wp.transform_get_translation(body_q[world, cube])
    finger_start = FINGER_OPEN
    finger_end = FINGER_OPEN

    now = phase[world]
    if now == APPROACH:
        position = cube_position + wp.vec3(0.0, 0.0, APPROACH_HEIGHT)
        rotation = tool_down()
    elif now == DESCEND:
        position = cube_position
        rotation = tool_down()
    elif now == GRASP:
        finger_end = finger_closed[world]
    elif now == LIFT:
        position = start_position + wp.vec3(
            0.0, 0.0, wp.where(in_hand[world], 0.0, LIFT_HEIGHT)
        )
        finger_start = finger_closed[world]
        finger_end = finger_closed[world]
    else:
        angle = 2.0 * wp.pi * frequency[world] * t
        position = start_position + amplitude[world] * wp.vec3(
            wp.sin(angle),
            SHAKE_RATIO_Y * wp.sin(2.0 * angle),
            SHAKE_RATIO_Z * wp.sin(1.5 * angle),
        )
        finger_start = finger_closed[world]
        finger_end = finger_closed[world]

    goal[world] = wp.transform(position, rotation)
    blend = float(1.0)
    if now < SHAKE:
        progress = wp.min(1.0, t / phase_seconds[now])
        blend = progress * progress * (3.0 - 2.0 * progress)
    blended = wp.quat_slerp(wp.transform_get_rotation(start), rotation, blend)
    target_position[world] = (1.0 - blend) * start_position + blend * position
    target_rotation[world] = wp.vec4(blended[0], blended[1], blended[2], blended[3])
    target_finger[world] = (1.0 - blend) * finger_start + blend * finger_end


@wp.kernel
def apply_targets(
    body_q: wp.array2d[wp.transform],
    tcp_body: int,
    tcp_pose: wp.transform,
    phase_seconds: wp.array[float],
    in_hand: wp.array[bool],
    goal: wp.array[wp.transform],
    solution: wp.array2d[float],
    target_finger: wp.array[float],
    joint_target: wp.array2d[float],
    phase: wp.array[int],
    elapsed: wp.array[float],
    phase_start: wp.array[wp.transform],
):
    """Command the joints, and end the phase when its time and goal are reached."""
    world = wp.tid()
    for dof in range(ARM_DOF_COUNT):
        joint_target[world, dof] = solution[world, dof]
    for dof in range(ARM_DOF_COUNT, ROBOT_DOF_COUNT):
        joint_target[world, dof] = target_finger[world]

    now = phase[world]
    if now == SHAKE:
        return
    if elapsed[world] < phase_seconds[now]:
        return
    pose = body_q[world, tcp_body] * tcp_pose
    distance = wp.length(
        wp.transform_get_translation(pose) - wp.transform_get_translation(goal[world])
    )
    between = wp.transform_get_rotation(pose) * wp.quat_inverse(
        wp.transform_get_rotation(goal[world])
    )
    angle = 2.0 * wp.atan2(
        wp.length(wp.vec3(between[0], between[1], between[2])), wp.abs(between[3])
    )
    # A cube in the hand is only held still before the shake, and may be heavy enough to
    # pull the arm down.
    if in_hand[world] or (distance < POSITION_TOLERANCE and angle < ROTATION_TOLERANCE):
        phase[world] = now + 1
        elapsed[world] = 0.0
        phase_start[world] = pose


class Task:
    """The state of the task in each world, and its inverse kinematics.

    The arm is solved to the approach pose. ``solution``, shape [worlds, 9], is the
    start of the next solve.
    """

    def __init__(self, scene: Scene, cases: list[Case]):
        self.device, world_count = scene.model.device, len(cases)
        self.cube, self.tcp = scene.links["cube"], scene.links["fr3_hand_tcp"]
        self.ik_iterations = cases[0].ik_iterations

        def floats(values) -> wp.array:
            return wp.array(list(values), dtype=float, device=self.device)

        in_hand = np.array([case.cube_in_hand for case in cases])
        self.in_hand = wp.array(in_hand, dtype=bool, device=self.device)
        self.phase = wp.array(
            np.where(in_hand, LIFT, APPROACH), dtype=int, device=self.device
        )
        self.phase_seconds = floats(PHASE_SECONDS)
        self.elapsed, self.target_finger = (
            wp.zeros(world_count, dtype=float, device=self.device) for _ in range(2)
        )
        self.phase_start, self.goal = (
            wp.zeros(world_count, dtype=wp.transform, device=self.device)
            for _ in range(2)
        )
        self.amplitude = floats(case.shake_amplitude_m for case in cases)
        self.frequency = floats(case.shake_frequency_hz for case in cases)
        self.finger_closed = floats(case.finger_closed_m for case in cases)
        cube_position = scene.model.body_q.numpy().reshape(world_count, -1, 7)[
            :, self.cube.body, :3
        ]
        above = cube_position + np.array((0.0, 0.0, APPROACH_HEIGHT), dtype=np.float32)
        starts = np.where(
            in_hand[:, None], np.array(CUBE_IN_HAND, dtype=np.float32), above
        )
        self.target_position = wp.array(starts, dtype=wp.vec3, device=self.device)
        self.target_rotation = wp.full(
            world_count, wp.vec4(1.0, 0.0, 0.0, 0.0), dtype=wp.vec4, device=self.device
        )
        self.solver = ArmSolver(
            scene.robot,
            self.tcp.body,
            self.tcp.pose,
            self.target_position,
            self.target_rotation,
        )
        self.solution = wp.array(
            np.tile(np.float32(READY_POSE), (world_count, 1)),
            dtype=float,
            device=self.device,
        )
        for _ in range(APPROACH_SOLVE_COUNT):
            self.solve()

    def command(self, body_q: wp.array, joint_target: wp.array) -> None:
        """Queue the joint targets of this frame, and end the phase if it is over.

        Args:
            body_q: Body poses, shape [worlds, bodies].
            joint_target: Joint position targets to write, shape [worlds, coordinates].
        """
        wp.launch(
            apply_targets,
            dim=body_q.shape[0],
            inputs=[
                body_q,
                self.tcp.body,
                self.tcp.pose,
                self.phase_seconds,
                self.in_hand,
                self.goal,
                self.solution,
            ]
            + [self.target_finger],
            outputs=[joint_target, self.phase, self.elapsed, self.phase_start],
            device=self.device,
        )

    def plan(self, body_q: wp.array) -> None:
        """Queue the targets of the TCP and the fingers for the next frame."""
        wp.launch(
            set_targets,
            dim=body_q.shape[0],
            inputs=[
                body_q,
                self.cube.body,
                self.phase_start,
                self.phase,
                self.phase_seconds,
            ]
            + [self.amplitude, self.frequency, self.in_hand, self.finger_closed],
            outputs=[
                self.elapsed,
                self.goal,
                self.target_position,
                self.target_rotation,
                self.target_finger,
            ],
            device=self.device,
        )

    def solve(self) -> None:
        """Queue the inverse kinematics of the planned target."""
        self.solver.step(self.solution, self.ik_iterations)
