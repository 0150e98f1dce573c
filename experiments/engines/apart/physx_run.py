"""A body on balls between supports, in PhysX on the CPU, as SAPIEN brings it: TGS, patch friction."""

import sapien
from apart import sampled
from sapien import physx


def run(scene, step_s):
    config = physx.PhysxBodyConfig()
    config.sleep_threshold = 0.0
    physx.set_body_config(config)
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
    body, entity = add(stage, feet, held["mass_kg"], held["inertia_kg_m2"], held["place"])
    body.linear_velocity, body.angular_velocity = held["velocity"], held["spin"]

    def step():
        for support, force in pushed:
            support.add_force_torque(force, [0.0, 0.0, 0.0])
        stage.step()

    return {"path": sampled(scene, step_s, lambda: entity.pose.p, step)}


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
