"""Compute the joint angles that bring the TCP of a serial arm to a pose.

The Levenberg-Marquardt steps and the damping are the same as in ``newton.ik``, but only
the seven joints that move the TCP are included: δ = −Jᵀ (J Jᵀ + λ 1)⁻¹ r, which equals
−(JᵀJ + λ 1)⁻¹ Jᵀ r. The linear system is therefore 6×6, one thread solves a world, and
the kernel compiles in seconds.
"""

import newton
import numpy as np
import warp as wp

LAMBDA_INITIAL = wp.constant(0.1)
LAMBDA_FACTOR = wp.constant(2.0)
LAMBDA_MIN = wp.constant(1e-5)
LAMBDA_MAX = wp.constant(1e10)
LEAST_GAIN = wp.constant(1e-3)
"""The initial damping, its changes, and the part of the predicted gain that a step must
reach.

The values are the same as in ``newton.ik``.
"""


@wp.func
def residual(
    world: int,
    side: int,
    tip: wp.transform,
    target_position: wp.vec3,
    target_rotation: wp.quat,
    parent_pose: wp.array[wp.transform],
    child_pose: wp.array[wp.transform],
    axis: wp.array[wp.vec3],
    coordinate: wp.array[int],
    angles: wp.array3d[float],
    columns: wp.array3d[wp.spatial_vector],
):
    """Return the error of the TCP's position and its rotation vector.

    The Jacobian is written to ``columns``.
    """
    pose = wp.transform_identity()
    for joint in range(axis.shape[0]):
        pose = pose * parent_pose[joint]
        if coordinate[joint] >= 0:
            along = wp.transform_vector(pose, axis[joint])
            columns[world, side, joint] = wp.spatial_vector(
                wp.transform_get_translation(pose), along
            )
            turn = wp.quat_from_axis_angle(
                axis[joint], angles[world, side, coordinate[joint]]
            )
            pose = pose * wp.transform(wp.vec3(0.0), turn)
        pose = pose * child_pose[joint]
    pose = pose * tip
    place = wp.transform_get_translation(pose)
    for joint in range(axis.shape[0]):
        if coordinate[joint] >= 0:
            column = columns[world, side, joint]
            along = wp.spatial_bottom(column)
            columns[world, side, joint] = wp.spatial_vector(
                wp.cross(along, place - wp.spatial_top(column)), along
            )
    off = wp.transform_get_rotation(pose) * wp.quat_inverse(target_rotation)
    if off[3] < 0.0:
        off = -off
    vector = wp.vec3(off[0], off[1], off[2])
    length = wp.length(vector)
    scale = float(2.0)
    if length > 1e-8:
        scale = 2.0 * wp.atan2(length, off[3]) / length
    return wp.spatial_vector(place - target_position, scale * vector)


@wp.func
def solved(matrix: wp.spatial_matrix, right: wp.spatial_vector):
    """Return the x for which ``matrix`` x = ``right``, by a Cholesky decomposition."""
    lower = wp.spatial_matrix()
    for i in range(6):
        for j in range(i + 1):
            rest = matrix[i, j]
            for k in range(j):
                rest -= lower[i, k] * lower[j, k]
            if i == j:
                lower[i, j] = wp.sqrt(rest)
            else:
                lower[i, j] = rest / lower[j, j]
    x = wp.spatial_vector()
    for i in range(6):
        rest = right[i]
        for k in range(i):
            rest -= lower[i, k] * x[k]
        x[i] = rest / lower[i, i]
    for back in range(6):
        i = 5 - back
        rest = x[i]
        for k in range(i + 1, 6):
            rest -= lower[k, i] * x[k]
        x[i] = rest / lower[i, i]
    return x


@wp.kernel(enable_backward=False, module="unique", module_options={"max_unroll": 1})
def solve_arm(
    iterations: int,
    tip: wp.transform,
    target_position: wp.array[wp.vec3],
    target_rotation: wp.array[wp.vec4],
    parent_pose: wp.array[wp.transform],
    child_pose: wp.array[wp.transform],
    axis: wp.array[wp.vec3],
    coordinate: wp.array[int],
    angles: wp.array3d[float],
    columns: wp.array3d[wp.spatial_vector],
    joint_q: wp.array2d[float],
):
    """Move ``joint_q`` by one step in each world.

    Args:
        parent_pose: Pose of each joint in its parent body, shape [joints].
        child_pose: Pose of the child body in the joint, shape [joints].
        coordinate: Coordinate of the robot for each joint, −1 if it is fixed, shape
            [joints].
        angles: Present and proposed coordinates, shape [worlds, 2, coordinates].
        columns: Columns of the Jacobian at both, shape [worlds, 2, joints].
    """
    world = wp.tid()
    for joint in range(axis.shape[0]):
        if coordinate[joint] >= 0:
            angles[world, 0, coordinate[joint]] = joint_q[world, coordinate[joint]]
    place = target_position[world]
    turned = target_rotation[world]
    turn = wp.quat(turned[0], turned[1], turned[2], turned[3])
    side = int(0)  # noqa: RUF046 (a variable, which 0 would not be)
    damping = float(LAMBDA_INITIAL)
    off = residual(
        world,
        side,
        tip,
        place,
        turn,
        parent_pose,
        child_pose,
        axis,
        coordinate,
        angles,
        columns,
    )
    for _ in range(iterations):
        other = 1 - side
        matrix = damping * wp.identity(n=6, dtype=float)
        for joint in range(axis.shape[0]):
            if coordinate[joint] >= 0:
                matrix += wp.outer(
                    columns[world, side, joint], columns[world, side, joint]
                )
        x = solved(matrix, off)
        predicted = float(0.0)
        for joint in range(axis.shape[0]):
            at = coordinate[joint]
            if at >= 0:
                step = -wp.dot(columns[world, side, joint], x)
                predicted += (
                    0.5
                    * step
                    * (damping * step - wp.dot(columns[world, side, joint], off))
                )
                angles[world, other, at] = angles[world, side, at] + step
        off_there = residual(
            world,
            other,
            tip,
            place,
            turn,
            parent_pose,
            child_pose,
            axis,
            coordinate,
            angles,
            columns,
        )
        gain = 0.5 * (wp.dot(off, off) - wp.dot(off_there, off_there))
        if gain >= LEAST_GAIN * (predicted + 1e-8):
            side = other
            off = off_there
            damping = damping / LAMBDA_FACTOR
        else:
            damping = wp.clamp(damping * LAMBDA_FACTOR, LAMBDA_MIN, LAMBDA_MAX)
    for joint in range(axis.shape[0]):
        if coordinate[joint] >= 0:
            joint_q[world, coordinate[joint]] = angles[world, side, coordinate[joint]]


class ArmSolver:
    """Compute the inverse kinematics of the pose ``tip`` in ``body`` for all worlds.

    Args:
        target_position: Target positions, shape [worlds], vec3 [m].
        target_rotation: Target rotations, shape [worlds], vec4.

    Raises:
        ValueError: A joint on the path to the body is neither revolute nor fixed.
    """

    def __init__(
        self,
        robot: newton.Model,
        body: int,
        tip: wp.transform,
        target_position: wp.array,
        target_rotation: wp.array,
    ):
        kinds = robot.joint_type.numpy()
        parents, children = (
            robot.joint_parent.numpy().tolist(),
            robot.joint_child.numpy().tolist(),
        )
        joints: list[int] = []
        while body >= 0:
            joints.insert(0, children.index(body))
            body = parents[joints[0]]
        if not np.isin(
            kinds[joints], (newton.JointType.REVOLUTE, newton.JointType.FIXED)
        ).all():
            raise ValueError(f"one of joints {joints} neither turns nor is fixed")
        turns = kinds[joints] == newton.JointType.REVOLUTE
        first, axes, coordinates = (
            robot.joint_qd_start.numpy(),
            robot.joint_axis.numpy(),
            robot.joint_q_start.numpy(),
        )
        axis = [
            axes[first[joint]] if turn else np.zeros(3)
            for joint, turn in zip(joints, turns, strict=True)
        ]
        behind = [
            wp.transform_inverse(wp.transform(*pose))
            for pose in robot.joint_X_c.numpy()[joints]
        ]
        device, worlds = robot.device, target_position.shape[0]
        self.inputs = [
            tip,
            target_position,
            target_rotation,
            wp.array(
                robot.joint_X_p.numpy()[joints], dtype=wp.transform, device=device
            ),
            wp.array(
                np.array(behind, dtype=np.float32), dtype=wp.transform, device=device
            ),
            wp.array(axis, dtype=wp.vec3, device=device),
            wp.array(
                np.where(turns, coordinates[joints], -1), dtype=int, device=device
            ),
            wp.zeros((worlds, 2, robot.joint_coord_count), dtype=float, device=device),
            wp.zeros((worlds, 2, len(joints)), dtype=wp.spatial_vector, device=device),
        ]

    def step(self, joint_q: wp.array, iterations: int) -> None:
        """Queue steps that move ``joint_q`` towards the targets.

        The shape of ``joint_q`` is [worlds, coordinates].
        """
        inputs = [iterations, *self.inputs]
        wp.launch(
            solve_arm,
            dim=joint_q.shape[0],
            inputs=inputs,
            outputs=[joint_q],
            device=joint_q.device,
        )
