"""Build the scene: an FR3 arm and a cube on the ground for each case of a batch."""

from collections.abc import Sequence
from dataclasses import dataclass
from xml.etree import ElementTree

import newton
import numpy as np
import warp as wp
from newton import GeoType, ModelBuilder, ShapeFlags
from newton.solvers import SolverMuJoCo

from experiments.facts.case import Case
from experiments.simulation.worlds import model_of
from measured_report.files.root import ROOT

ROBOT = ROOT / "assets/fr3.urdf"
BASELINE = Case(name="")
ROBOT_POSITION = (-0.5, -0.5, 0.0)
READY_POSE = (0.0, 0.5, 0.0, -1.5, 0.0, 2.0, np.pi / 4.0, 0.035, 0.035)
"""Joint coordinates [rad, rad, …, m, m] with which the search for the approach pose
starts.
"""
ARM_DOF_COUNT = 7
ROBOT_DOF_COUNT = 9
TARGET_KE = 400.0
TARGET_KD = 40.0
EFFORT_LIMIT = (87.0,) * 4 + (12.0,) * 3 + (100.0,) * 2
ARMATURE = (0.3,) * 4 + (0.11,) * 3 + (0.15,) * 2
PAD_SOLIMP = (0.7, 0.95, 0.0001, 0.5, 2.0)
CUBE_EDGE = 0.04
CUBE_POSITION = (0.0, -0.44, 0.02)
CUBE_IN_HAND = (0.0, -0.44, 0.22)
"""Start position of a cube in the hand.

The task would lift a cube from the ground to this height.
"""
# Distance [m] of the pads' faces from the origins of the fingers.
PAD_FACE = 2e-5
# Newton's mark of a shape with an explicit solref, which ke and kd do not determine.
SOLREF_MODE_RAW = 1
GROUND_MU = 0.8

TRACKED_BODIES = (
    "cube",
    "fr3_hand_tcp",
    "fr3_hand",
    "fr3_leftfinger",
    "fr3_rightfinger",
    "fr3_link7",
)
"""Bodies in a trace, in this order; they are found by the last part of their label."""
FINGERS = ("fr3_leftfinger", "fr3_rightfinger")
# Bodies that do not move, and therefore need no gravity compensation.
FIXED_BODIES = (
    "base",
    "fr3_link0",
)


def body_index(builder_or_model, name: str) -> int:
    """Return the index of the first body whose label ends with ``name``.

    Raise KeyError if there is none.
    """
    for index, label in enumerate(builder_or_model.body_label):
        if label.rsplit("/", 1)[-1] == name:
            return index
    raise KeyError(f"the scene has no body {name}")


@dataclass(frozen=True)
class Link:
    """Describe the body that contains a link, and the pose of the link.

    The link has its own body unless links with fixed joints are merged.
    """

    body: int  # index of the body within one world
    pose: wp.transform  # pose of the link in the body's frame


@dataclass(frozen=True)
class Scene:
    """A finalized batch with the indices of its parts within one world."""

    model: newton.Model  # all worlds and the ground
    robot: newton.Model  # only the arm, for the inverse kinematics
    links: dict[str, Link]  # places of TRACKED_BODIES
    pads: tuple[int, ...]  # shape indices of the finger boxes
    cube: int  # shape index of the cube


def robot_builder(case: Case) -> tuple[ModelBuilder, dict[str, Link]]:
    """Return the arm as shipped, and its links.

    This includes targets, limits, gravity compensation, and the solimp and priority of
    the fingers.
    """
    builder = ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    builder.rigid_gap = BASELINE.robot_gap_m
    builder.add_urdf(
        _robot_source(case),
        xform=wp.transform(ROBOT_POSITION, wp.quat_identity()),
        floating=False,
        enable_self_collisions=False,
    )
    if not case.hand_collides:
        hand = body_index(builder, "fr3_hand")
        for shape in range(builder.shape_count):
            if builder.shape_body[shape] == hand:
                builder.shape_flags[shape] &= ~ShapeFlags.COLLIDE_SHAPES
    links = _find_links(builder, case)
    dofs = slice(ROBOT_DOF_COUNT)
    builder.joint_q[dofs] = READY_POSE
    builder.joint_target_q[dofs] = READY_POSE
    builder.joint_target_ke[dofs] = [TARGET_KE] * ROBOT_DOF_COUNT
    builder.joint_target_kd[dofs] = [TARGET_KD] * ROBOT_DOF_COUNT
    builder.joint_effort_limit[dofs] = EFFORT_LIMIT
    builder.joint_armature[dofs] = ARMATURE

    moving = [
        body
        for body, label in enumerate(builder.body_label)
        if label.rsplit("/", 1)[-1] not in FIXED_BODIES
    ]
    _set(builder, "mujoco:gravcomp", dict.fromkeys(moving, 1.0))
    _set(builder, "mujoco:jnt_actgravcomp", dict.fromkeys(range(ARM_DOF_COUNT), True))
    pads = pad_shapes(builder)
    _set(builder, "mujoco:geom_solimp", dict.fromkeys(pads, PAD_SOLIMP))
    _set(builder, "mujoco:geom_priority", dict.fromkeys(pads, case.pad_priority))

    if case.pad_shape == "convex-mesh":
        for shape in pads:
            half_extents = builder.shape_scale[shape]
            builder.shape_type[shape] = GeoType.CONVEX_MESH
            builder.shape_source[shape] = newton.Mesh.create_box(
                *half_extents,
                duplicate_vertices=False,
                compute_normals=False,
                compute_uvs=False,
            )
            builder.shape_scale[shape] = (1.0, 1.0, 1.0)
    return builder, links


def _find_links(builder: ModelBuilder, case: Case) -> dict[str, Link]:
    """Return the tracked links of the robot.

    Without ``fixed_joints``, links that do not move relative to each other become one
    body.
    """
    bodies = {name: body_index(builder, name) for name in TRACKED_BODIES[1:]}
    if case.fixed_joints:
        return {
            name: Link(body, wp.transform_identity()) for name, body in bodies.items()
        }
    merged = builder.collapse_fixed_joints()
    parent, pose = merged["body_merged_parent"], merged["body_merged_transform"]
    return {
        name: Link(
            merged["body_remap"][parent.get(body, body)],
            pose.get(body, wp.transform_identity()),
        )
        for name, body in bodies.items()
    }


def pad_shapes(builder: ModelBuilder) -> tuple[int, ...]:
    """Return the colliding shapes of the two fingers."""
    fingers = {body_index(builder, name) for name in FINGERS}
    return tuple(
        shape
        for shape in range(builder.shape_count)
        if builder.shape_body[shape] in fingers
        and builder.shape_flags[shape] & ShapeFlags.COLLIDE_SHAPES
    )


def build_scene(cases: list[Case], device: wp.Device) -> Scene:
    """Build one world for each case; the cases must have the same ``batch_key``."""
    case = cases[0]
    built: list[tuple[ModelBuilder, dict[str, Link]]] = []

    def build(world_count: int) -> newton.Model:
        # Use new builders each time: finalizing a mesh again frees the memory to which
        # the first model points.
        built.append(_world_builder(case))
        scene = ModelBuilder()
        scene.replicate(built[-1][0], world_count)
        scene.add_ground_plane(
            cfg=ModelBuilder.ShapeConfig(mu=GROUND_MU, gap=BASELINE.ground_gap_m)
        )
        return scene.finalize(device=device)

    model = model_of(len(cases), build)
    world, links = built[-1]
    robot = robot_builder(case)[0].finalize(device=device)
    result = Scene(
        model, robot, links, pads=pad_shapes(world), cube=world.shape_count - 1
    )
    _apply_world_parameters(result, cases)
    return result


def _world_builder(case: Case) -> tuple[ModelBuilder, dict[str, Link]]:
    """Return the robot with the cube as its last body and shape, and the links."""
    robot, links = robot_builder(case)
    world = ModelBuilder()
    SolverMuJoCo.register_custom_attributes(world)
    world.add_builder(robot)
    cube = world.add_body(
        xform=wp.transform(CUBE_POSITION, wp.quat_identity()), label="cube"
    )
    half = 0.5 * CUBE_EDGE
    material = ModelBuilder.ShapeConfig(
        density=BASELINE.cube_density_kg_m3,
        ke=BASELINE.cube_ke,
        kd=BASELINE.cube_kd,
        mu=BASELINE.cube_mu,
    )
    world.add_shape_box(cube, hx=half, hy=half, hz=half, cfg=material, label="cube")
    return world, {"cube": Link(cube, wp.transform_identity()), **links}


def _rows(host: np.ndarray, world_count: int) -> np.ndarray:
    """Return an array by world, shape [worlds, …].

    Parts that do not belong to a world, such as the ground, are left out.
    """
    return host[: host.shape[0] // world_count * world_count].reshape(
        world_count, -1, *host.shape[1:]
    )


def _write(array: wp.array, indices: Sequence[int], values: np.ndarray) -> None:
    """Write one value for each world at each of ``indices`` within the world."""
    host = array.numpy()
    rows = _rows(host, len(values))
    for index in indices:
        rows[:, index] = values
    array.assign(host)


def _apply_world_parameters(scene: Scene, cases: list[Case]) -> None:
    """Write the parameters of each case into its world's part of the model's arrays."""
    model, pads, cube, body = (
        scene.model,
        scene.pads,
        (scene.cube,),
        (scene.links["cube"].body,),
    )

    def column(name: str) -> np.ndarray:
        return np.array([getattr(case, name) for case in cases], dtype=np.float32)

    for name in ("ke", "kd", "mu"):
        _write(getattr(model, f"shape_material_{name}"), pads, column(f"pad_{name}"))
        _write(getattr(model, f"shape_material_{name}"), cube, column(f"cube_{name}"))
    _write(model.shape_material_kf, pads, column("pad_kf"))
    robot_shapes = [
        shape for shape in range(model.shape_count // len(cases)) if shape != scene.cube
    ]
    _write(model.shape_gap, robot_shapes, column("robot_gap_m"))
    _write(model.shape_gap, cube, column("cube_gap_m"))
    gap = model.shape_gap.numpy()
    gap[-1] = cases[0].ground_gap_m
    model.shape_gap.assign(gap)

    solimp = np.tile(np.array(PAD_SOLIMP, dtype=np.float32), (len(cases), 1))
    solimp[:, 1] = column("pad_dmax")
    _write(model.mujoco.geom_solimp, pads, solimp)
    if any(case.pad_direct for case in cases):
        mode = _rows(model.mujoco.solref_mode.numpy(), len(cases))[:, pads[0]]
        _write(
            model.mujoco.solref,
            pads,
            -np.stack([column("pad_ke"), column("pad_kd")], axis=1),
        )
        _write(
            model.mujoco.solref_mode,
            pads,
            np.where(column("pad_direct"), SOLREF_MODE_RAW, mode),
        )
    model.set_gravity(np.outer(-column("gravity_m_s2"), (0.0, 0.0, 1.0)))

    size = column("cube_edge_m") / np.float32(CUBE_EDGE)
    mass = column("cube_density_kg_m3") / BASELINE.cube_density_kg_m3 * size**3
    for array, indices, scale in (
        (model.shape_scale, cube, size),
        (model.shape_collision_radius, cube, size),
        (model.body_mass, body, mass),
        (model.body_inv_mass, body, mass**-1),
        (model.body_inertia, body, mass * size**2),
        (model.body_inv_inertia, body, (mass * size**2) ** -1),
    ):
        values = _rows(array.numpy(), len(cases))[:, indices[0]]
        _write(array, indices, values * scale.reshape(-1, *[1] * (values.ndim - 1)))

    starts = np.array([cube_start(case) for case in cases])
    poses = _rows(model.body_q.numpy(), len(cases))[:, body[0]].copy()
    poses[:, :3] = starts
    _write(model.body_q, body, poses)
    for axis in range(3):
        _write(model.joint_q, (ROBOT_DOF_COUNT + axis,), starts[:, axis])
    touching = 0.5 * column("cube_edge_m") + PAD_FACE - column("start_overlap_m")
    opening = np.where(column("cube_in_hand"), touching, READY_POSE[-1])
    _write(model.joint_q, range(ARM_DOF_COUNT, ROBOT_DOF_COUNT), opening)


def cube_start(case: Case) -> tuple[float, float, float]:
    """Return the position of the cube's centre [m] before the first frame."""
    x, y, z = CUBE_IN_HAND
    if not case.cube_in_hand:
        x, y, _ = CUBE_POSITION
        z = 0.5 * case.cube_edge_m - case.start_overlap_m
    return x + case.cube_offset_m, y, z


def _set(builder: ModelBuilder, name: str, values: dict[int, object]) -> None:
    attribute = builder.custom_attributes[name]
    attribute.values = {**(attribute.values or {}), **values}


def _robot_source(case: Case) -> str:
    if case.visuals:
        return str(ROBOT)
    robot = ElementTree.parse(ROBOT).getroot()
    for link in robot.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    return ElementTree.tostring(robot, encoding="unicode")
