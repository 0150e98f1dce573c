"""PhysX on the CPU, as SAPIEN brings it: it solves by TGS, with patch friction."""

import math

import sapien
from apart import World
from sapien import physx


def load(scene):
    config = physx.PhysxBodyConfig()
    config.sleep_threshold = 0.0
    physx.set_body_config(config)
    physx.set_scene_config(gravity=scene.gravity_m_s2)
    stage = sapien.Scene([physx.PhysxCpuSystem()])
    stage.set_timestep(scene.step_s)
    material = physx.PhysxMaterial(scene.friction, scene.friction, 0.0)
    pushed = []
    for support in scene.supports:
        force = [support.force_n * value for value in support.axis]
        pushed.append((add_support(stage, support, material), force))
    bodies = [add_body(stage, scene.body, material)]
    joints = add_robot(stage, scene, bodies) if scene.robot else []

    def step(target):
        for support, force in pushed:
            support.add_force_torque(force, [0.0, 0.0, 0.0])
        for joint, wanted in zip(joints, target, strict=False):
            joint.set_drive_target(wanted)
        stage.step()

    def poses():
        for body in bodies:
            yield [*body.pose.p, *body.pose.q[1:], body.pose.q[0]]

    def forces():
        for contact in stage.get_contacts():
            for point in contact.points:
                normal = point.impulse @ point.normal / scene.step_s
                yield normal, math.nan, -point.separation

    return World(step, poses, forces)


def add(stage, shapes, mass_kg, inertia_kg_m2, position_m):
    """Add a body without damping."""
    body = physx.PhysxRigidDynamicComponent()
    for shape in shapes:
        body.attach(shape)
    body.mass = mass_kg
    body.inertia = inertia_kg_m2
    body.cmass_local_pose = sapien.Pose()
    body.linear_damping = body.angular_damping = 0.0
    entity = sapien.Entity()
    entity.add_component(body)
    entity.pose = sapien.Pose(position_m)
    stage.add_entity(entity)
    return body, entity


def add_support(stage, support, material):
    box = physx.PhysxCollisionShapeBox(support.half_size_m, material)
    inertia = [support.inertia_kg_m2] * 3
    body, _ = add(stage, [box], support.mass_kg, inertia, support.position_m)
    is_hinge = support.joint == "hinge"
    # All are locked, along x, y and z and about them, but for the joint's own axis.
    is_locked = [not value for value in support.axis]
    all_locked = [True] * 3
    slides, turns = (all_locked, is_locked) if is_hinge else (is_locked, all_locked)
    body.set_locked_motion_axes([*slides, *turns])
    body.disable_gravity = True
    if is_hinge:
        body.angular_velocity = [support.speed * value for value in support.axis]
    return body


def add_body(stage, body, material):
    shapes = []
    for position in body.feet:
        shapes.append(physx.PhysxCollisionShapeSphere(body.foot_m, material))
        shapes[-1].local_pose = sapien.Pose(position)
    if not body.feet:
        shapes.append(physx.PhysxCollisionShapeBox(body.half_size_m, material))
    added, entity = add(
        stage, shapes, body.mass_kg, body.inertia_kg_m2, body.position_m
    )
    added.linear_velocity = body.velocity_m_s
    added.angular_velocity = body.spin_rad_s
    return entity


def add_robot(stage, scene, bodies):
    """Add the robot, and its tool to the bodies; return its joints."""
    loader = stage.create_urdf_loader()
    loader.set_material(scene.friction, scene.friction, 0.0)
    robot = loader.load(scene.robot.file)
    robot.set_qpos(scene.qpos)
    robot.set_sleep_threshold(0.0)
    for link in robot.links:
        link.linear_damping = link.angular_damping = 0.0
    drives = zip(
        robot.active_joints, scene.robot.effort, scene.robot.armature, strict=True
    )
    for joint, effort, armature in drives:
        joint.set_drive_properties(scene.robot.ke, scene.robot.kd, effort)
        joint.set_armature([armature])
    bodies.append(robot.find_link_by_name(scene.robot.tool).entity)
    return robot.active_joints
