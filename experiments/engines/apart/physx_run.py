"""A body on balls between supports, or a box that a robot holds, in PhysX on the CPU as SAPIEN brings it.

It solves by TGS, with patch friction.
"""

import math

import sapien
from apart import sampled, shaken
from sapien import physx


def run(scene, step_s):
    config = physx.PhysxBodyConfig()
    config.sleep_threshold = 0.0
    physx.set_body_config(config)
    physx.set_scene_config(gravity=[0.0, 0.0, -scene["gravity_m_s2"]])
    stage = sapien.Scene([physx.PhysxCpuSystem()])
    stage.set_timestep(step_s)
    material = physx.PhysxMaterial(scene["friction"], scene["friction"], 0.0)
    pushed = []
    for support in scene["supports"]:
        box = physx.PhysxCollisionShapeBox(support["half_size"], material)
        hinge = support["joint"] == "hinge"
        # Free along or about the axis alone: x, y, z, and about x, y, z.
        free = [not hinge and bool(value) for value in support["axis"]] + [hinge and bool(v) for v in support["axis"]]
        body, _ = add(stage, [box], support["mass_kg"], [support["inertia_kg_m2"]] * 3, support["place"])
        body.set_locked_motion_axes([not each for each in free])
        body.disable_gravity = True
        if hinge:
            body.angular_velocity = [support["speed"] * value for value in support["axis"]]
        pushed.append((body, [support["force_n"] * value for value in support["axis"]]))
    held, feet = scene["body"], []
    for place in held["feet"]:
        feet.append(physx.PhysxCollisionShapeSphere(held["foot_m"], material))
        feet[-1].local_pose = sapien.Pose(place)
    if "half_size" in held:
        feet = [physx.PhysxCollisionShapeBox(held["half_size"], material)]
    body, entity = add(stage, feet, held["mass_kg"], held["inertia_kg_m2"], held["place"])
    body.linear_velocity, body.angular_velocity = held["velocity"], held["spin"]
    if "robot" in scene:
        return shake(scene, step_s, stage, entity)

    def step():
        for support, force in pushed:
            support.add_force_torque(force, [0.0, 0.0, 0.0])
        stage.step()

    return {"path": sampled(scene, step_s, lambda: entity.pose.p, step)}


def shake(scene, step_s, stage, cube):
    """Add the robot and shake it."""
    loader = stage.create_urdf_loader()
    loader.set_material(scene["friction"], scene["friction"], 0.0)
    robot = loader.load(scene["robot"])
    robot.set_qpos(scene["start"])
    robot.set_sleep_threshold(0.0)
    for link in robot.links:
        link.linear_damping = link.angular_damping = 0.0
    for joint, effort, armature in zip(robot.active_joints, scene["effort"], scene["armature"], strict=True):
        joint.set_drive_properties(scene["ke"], scene["kd"], effort)
        joint.set_armature([armature])
    tool = robot.find_link_by_name(scene["tool"]).entity

    def step(target):
        for joint, wanted in zip(robot.active_joints, target, strict=True):
            joint.set_drive_target(wanted)
        stage.step()

    def contacts():
        for each in stage.get_contacts():
            for point in each.points:
                yield point.impulse @ point.normal / step_s, math.nan, -point.separation

    def poses():
        return [[*each.p, *each.q[1:], each.q[0]] for each in (cube.pose, tool.pose)]

    return shaken(scene, step_s, step, poses, contacts)


def add(stage, shapes, mass_kg, inertia, place):
    """Add a body without damping, in its place."""
    body, entity = physx.PhysxRigidDynamicComponent(), sapien.Entity()
    for shape in shapes:
        body.attach(shape)
    body.mass, body.inertia, body.cmass_local_pose = mass_kg, inertia, sapien.Pose()
    body.linear_damping = body.angular_damping = 0.0
    entity.add_component(body)
    entity.pose = sapien.Pose(place)
    stage.add_entity(entity)
    return body, entity
