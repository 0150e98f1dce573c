"""Compute the poses of a robot's links from joint positions (forward kinematics)."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np


@dataclass(frozen=True)
class Joint:
    """Describe a joint of a robot, and with it the link that it carries."""

    parent: str
    child: str
    kind: str  # ``fixed``, ``revolute`` or ``prismatic``
    origin: np.ndarray  # pose in the parent link [m], shape [4, 4]
    axis: np.ndarray  # shape [3]


def read_joints(path: Path) -> tuple[Joint, ...]:
    """Return the joints of a URDF file, each after the joint that carries it."""
    return tuple(
        Joint(
            parent=element.find("parent").get("link"),
            child=element.find("child").get("link"),
            kind=element.get("type"),
            origin=pose_matrix(
                _numbers(element, "origin", "xyz"), _numbers(element, "origin", "rpy")
            ),
            axis=_numbers(element, "axis", "xyz"),
        )
        for element in ElementTree.parse(path).getroot().iter("joint")
    )


def link_poses(
    joints: Sequence[Joint], positions: np.ndarray, base: np.ndarray
) -> dict[str, np.ndarray]:
    """Return the poses [m] of all links in the world, shape [frames, 4, 4] each.

    Args:
        positions: Positions of the moving joints in the order of the description
            [rad or m], shape [frames, joints].
        base: Position of the first link [m], shape [3].
    """
    matrices = {
        joints[0].parent: np.broadcast_to(
            pose_matrix(base, np.zeros(3)), (len(positions), 4, 4)
        )
    }
    moving = iter(positions.T.astype(np.float64))
    for joint in joints:
        pose = matrices[joint.parent] @ joint.origin
        matrices[joint.child] = (
            pose if joint.kind == "fixed" else pose @ _motion(joint, next(moving))
        )
    return matrices


def pose_matrix(position: np.ndarray, rpy: np.ndarray) -> np.ndarray:
    """Return the matrix of a pose in URDF, shape [4, 4].

    The rotations are about the fixed x, y and z axes in this order [rad], followed by
    the translation [m].
    """
    result = np.eye(4)
    for axis, angle in zip(np.eye(3), rpy, strict=True):
        result[:3, :3] = _turns(axis, np.array([angle]))[0] @ result[:3, :3]
    result[:3, 3] = position
    return result


def quaternion_matrices(position: np.ndarray, quaternion: np.ndarray) -> np.ndarray:
    """Return the matrices of positions [m] and unit quaternions (x, y, z, w).

    The shapes are [frames, 3] and [frames, 4].
    """
    quaternion = quaternion.astype(np.float64)
    cross = _cross_matrices(quaternion[:, :3])
    result = np.tile(np.eye(4), (len(position), 1, 1))
    result[:, :3, :3] += 2.0 * (quaternion[:, 3, None, None] * cross + cross @ cross)
    result[:, :3, 3] = position
    return result


def _motion(joint: Joint, value: np.ndarray) -> np.ndarray:
    result = np.tile(np.eye(4), (len(value), 1, 1))
    if joint.kind == "revolute":
        result[:, :3, :3] = _turns(joint.axis, value)
    else:
        result[:, :3, 3] = value[:, None] * joint.axis
    return result


def _turns(axis: np.ndarray, angle: np.ndarray) -> np.ndarray:
    cross = _cross_matrices(axis[None])[0]
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * cross + (1.0 - cosine) * (cross @ cross)


def _cross_matrices(vectors: np.ndarray) -> np.ndarray:
    """Return the matrix for each v that maps w to v × w, shape [vectors, 3, 3]."""
    return np.cross(np.eye(3), vectors[:, None])


def _numbers(element: ElementTree.Element, name: str, attribute: str) -> np.ndarray:
    child = element.find(name)
    return (
        np.zeros(3)
        if child is None
        else np.array(child.get(attribute).split(), dtype=float)
    )
