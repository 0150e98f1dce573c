"""The scene: an FR3 arm and a cube on the ground, once for each case of a batch."""

from dataclasses import dataclass
from xml.etree import ElementTree

import newton
import numpy as np
import warp as wp
from newton import GeoType, ModelBuilder, ShapeFlags
from newton.solvers import SolverMuJoCo

from experiments.facts.case import CUBE_GAP_DEFAULT, Case
from experiments.simulation.worlds import model_of
from measured_report.files.root import ROOT

ROBOT = ROOT / "assets/fr3.urdf"
ROBOT_POSITION = (-0.5, -0.5, 0.0)
READY_POSE = (0.0, 0.5, 0.0, -1.5, 0.0, 2.0, np.pi / 4.0, 0.035, 0.035)
"""Joint coordinates [rad, rad, …, m, m] from which the approach pose is solved."""
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
"""Where a cube starts that is in the hand: as high above its place on the ground as the task lifts it."""
PAD_FACE = 2e-5
"""How far [m] the faces of the pads stand beyond the origins of the fingers."""
SOLREF_MODE_RAW = 1
"""Newton's mark of a shape whose solref is given as it is, and not by ke and kd."""
GROUND_MU = 0.8

TRACKED_BODIES = ("cube", "fr3_hand_tcp", "fr3_hand", "fr3_leftfinger", "fr3_rightfinger", "fr3_link7")
"""Bodies whose poses a trace keeps, in this order; found by the last part of their label."""
FINGERS = ("fr3_leftfinger", "fr3_rightfinger")
FIXED_BODIES = ("base", "fr3_link0")
"""Bodies that do not move, so need no gravity compensation."""


def body_index(builder_or_model, name: str) -> int:
    """Return the index of the first body whose label ends with ``name``; KeyError if there is none."""
    for index, label in enumerate(builder_or_model.body_label):
        if label.rsplit("/", 1)[-1] == name:
            return index
    raise KeyError(f"the scene has no body {name}")


@dataclass(frozen=True)
class Link:
    """Where a link of the description is: on a body, which is its own unless fixed joints are left out."""

    body: int
    """Index of the body, within one world."""
    pose: wp.transform
    """Pose of the link in the body's frame."""


@dataclass(frozen=True)
class Scene:
    """A finalized batch and where to find things in it. Indices are within one world."""

    model: newton.Model
    """All worlds and the ground."""
    robot: newton.Model
    """The arm alone, once: what inverse kinematics works on."""
    links: dict[str, Link]
    """Where each of TRACKED_BODIES is."""
    pads: tuple[int, ...]
    """Shape indices of the finger boxes."""
    cube: int
    """Shape index of the cube."""


def robot_builder(case: Case) -> tuple[ModelBuilder, dict[str, Link]]:
    """Return the arm as it is shipped: targets, limits, gravity compensation, finger solimp and priority; and its
    links."""
    builder = ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    builder.rigid_gap = Case(name="").robot_gap_m
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
    links = _find_links(builder, merge=not case.fixed_joints)
    dofs = slice(ROBOT_DOF_COUNT)
    builder.joint_q[dofs] = READY_POSE
    builder.joint_target_q[dofs] = READY_POSE
    builder.joint_target_ke[dofs] = [TARGET_KE] * ROBOT_DOF_COUNT
    builder.joint_target_kd[dofs] = [TARGET_KD] * ROBOT_DOF_COUNT
    builder.joint_effort_limit[dofs] = EFFORT_LIMIT
    builder.joint_armature[dofs] = ARMATURE

    moving = [body for body, label in enumerate(builder.body_label) if label.rsplit("/", 1)[-1] not in FIXED_BODIES]
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
                *half_extents, duplicate_vertices=False, compute_normals=False, compute_uvs=False
            )
            builder.shape_scale[shape] = (1.0, 1.0, 1.0)
    return builder, links


def _find_links(builder: ModelBuilder, *, merge: bool) -> dict[str, Link]:
    """Return the tracked links of the robot; with ``merge`` links that are fixed to one another become one body."""
    names = TRACKED_BODIES[1:]
    bodies = {name: body_index(builder, name) for name in names}
    if not merge:
        return {name: Link(body, wp.transform_identity()) for name, body in bodies.items()}
    merged = builder.collapse_fixed_joints()
    parent, pose = merged["body_merged_parent"], merged["body_merged_transform"]
    return {
        name: Link(merged["body_remap"][parent.get(body, body)], pose.get(body, wp.transform_identity()))
        for name, body in bodies.items()
    }


def pad_shapes(builder: ModelBuilder) -> tuple[int, ...]:
    """Return the shapes of the two fingers that collide."""
    fingers = {body_index(builder, name) for name in FINGERS}
    return tuple(
        shape
        for shape in range(builder.shape_count)
        if builder.shape_body[shape] in fingers and builder.shape_flags[shape] & ShapeFlags.COLLIDE_SHAPES
    )


def build_scene(cases: list[Case], device: wp.Device) -> Scene:
    """Build one world per case; the cases must have the same ``batch_key``."""
    case = cases[0]
    built: list[_World] = []

    def build(world_count: int) -> newton.Model:
        # Each from builders of its own: finalizing a mesh a second time frees what the first model points to.
        built.append(_world_builder(case))
        scene = ModelBuilder()
        scene.replicate(built[-1].builder, world_count)
        scene.add_ground_plane(cfg=ModelBuilder.ShapeConfig(mu=GROUND_MU, gap=Case(name="").ground_gap_m))
        return scene.finalize(device=device)

    model = model_of(len(cases), build)
    world = built[-1]
    result = Scene(
        model=model,
        robot=robot_builder(case)[0].finalize(device=device),
        links={"cube": Link(world.cube_body, wp.transform_identity()), **world.links},
        pads=world.pads,
        cube=world.cube_shape,
    )
    _apply_world_parameters(result, cases, world.cube_body)
    return result


@dataclass(frozen=True)
class _World:
    """One world to be built, and where to find things in it."""

    builder: ModelBuilder
    links: dict[str, Link]
    pads: tuple[int, ...]
    cube_body: int
    cube_shape: int


def _world_builder(case: Case) -> _World:
    robot, links = robot_builder(case)
    world = ModelBuilder()
    SolverMuJoCo.register_custom_attributes(world)
    world.add_builder(robot)
    cube_body = world.add_body(xform=wp.transform(CUBE_POSITION, wp.quat_identity()), label="cube")
    half = 0.5 * CUBE_EDGE
    baseline = Case(name="")
    cube_cfg = ModelBuilder.ShapeConfig(
        density=baseline.cube_density_kg_m3, ke=baseline.cube_ke, kd=baseline.cube_kd, mu=baseline.cube_mu
    )
    assert world.rigid_gap == CUBE_GAP_DEFAULT, "newton changed ModelBuilder.rigid_gap: as shipped is no longer 0.1"
    cube_shape = world.add_shape_box(cube_body, hx=half, hy=half, hz=half, cfg=cube_cfg, label="cube")
    return _World(world, links, pad_shapes(robot), cube_body, cube_shape)


@dataclass(frozen=True)
class _Worlds:
    """The cases as columns, to be written into each world's part of the model's arrays."""

    cases: list[Case]

    def column(self, name: str) -> np.ndarray:
        return np.array([getattr(case, name) for case in self.cases], dtype=np.float32)

    def rows(self, array: wp.array) -> np.ndarray:
        """Return a copy of ``array`` on the host, shape [worlds, …]; what belongs to no world, as the ground, is left
        out."""
        host, count = array.numpy(), len(self.cases)
        return host[: host.shape[0] // count * count].reshape(count, -1, *host.shape[1:])

    def write(self, array: wp.array, indices, values: np.ndarray) -> None:
        """Write one value for each world at each of ``indices`` within the world."""
        host = array.numpy()
        rows = self.rows(array)
        for index in indices:
            rows[:, index] = values
        host[: rows.shape[0] * rows.shape[1]] = rows.reshape(-1, *host.shape[1:])
        array.assign(host)


def _apply_world_parameters(scene: Scene, cases: list[Case], cube_body: int) -> None:
    model, worlds = scene.model, _Worlds(cases)
    column, write = worlds.column, worlds.write
    pads, cube = scene.pads, (scene.cube,)
    robot_shapes = [shape for shape in range(model.shape_count // len(cases)) if shape != scene.cube]
    write(model.shape_material_ke, pads, column("pad_ke"))
    write(model.shape_material_kd, pads, column("pad_kd"))
    write(model.shape_material_mu, pads, column("pad_mu"))
    write(model.shape_material_kf, pads, column("pad_kf"))
    write(model.shape_material_ke, cube, column("cube_ke"))
    write(model.shape_material_kd, cube, column("cube_kd"))
    write(model.shape_material_mu, cube, column("cube_mu"))
    write(model.shape_gap, robot_shapes, column("robot_gap_m"))
    write(model.shape_gap, cube, column("cube_gap_m"))
    gap = model.shape_gap.numpy()
    gap[-1] = cases[0].ground_gap_m
    model.shape_gap.assign(gap)

    solimp = np.tile(np.array(PAD_SOLIMP, dtype=np.float32), (len(cases), 1))
    solimp[:, 1] = column("pad_dmax")
    write(model.mujoco.geom_solimp, pads, solimp)
    if any(case.pad_direct for case in cases):
        mode = worlds.rows(model.mujoco.solref_mode)[:, pads[0]]
        write(model.mujoco.solref, pads, -np.stack([column("pad_ke"), column("pad_kd")], axis=1))
        write(model.mujoco.solref_mode, pads, np.where(column("pad_direct"), SOLREF_MODE_RAW, mode))

    model.set_gravity(np.outer(-column("gravity_m_s2"), (0.0, 0.0, 1.0)))
    _scale_cube(scene, worlds, cube_body)
    _place_cube(scene, worlds, cube_body)


def _scale_cube(scene: Scene, worlds: _Worlds, cube_body: int) -> None:
    model, shape = scene.model, (scene.cube,)
    size = worlds.column("cube_edge_m") / np.float32(CUBE_EDGE)
    mass = worlds.column("cube_density_kg_m3") / Case(name="").cube_density_kg_m3 * size**3
    for array, indices, scale in (
        (model.shape_scale, shape, size),
        (model.shape_collision_radius, shape, size),
        (model.body_mass, (cube_body,), mass),
        (model.body_inv_mass, (cube_body,), mass**-1),
        (model.body_inertia, (cube_body,), mass * size**2),
        (model.body_inv_inertia, (cube_body,), (mass * size**2) ** -1),
    ):
        values = worlds.rows(array)[:, indices[0]]
        worlds.write(array, indices, values * scale.reshape(-1, *[1] * (values.ndim - 1)))


def _place_cube(scene: Scene, worlds: _Worlds, cube_body: int) -> None:
    model = scene.model
    place = np.array([cube_start(case) for case in worlds.cases])
    poses = worlds.rows(model.body_q)[:, cube_body]
    poses[:, :3] = place
    worlds.write(model.body_q, (cube_body,), poses)
    for axis in range(3):
        worlds.write(model.joint_q, (ROBOT_DOF_COUNT + axis,), place[:, axis])
    touching = 0.5 * worlds.column("cube_edge_m") + PAD_FACE - worlds.column("start_overlap_m")
    opening = np.where(worlds.column("cube_in_hand"), touching, READY_POSE[-1])
    worlds.write(model.joint_q, range(ARM_DOF_COUNT, ROBOT_DOF_COUNT), opening)


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
