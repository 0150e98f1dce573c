"""A body on balls between supports, or a box that a robot holds, in DART with Bullet's collision detector."""

import dartpy
import numpy as np
from apart import drive, sampled, shaken

dynamics = dartpy.dynamics


def run(scene, step_s):
    world = dartpy.simulation.World()
    world.setTimeStep(step_s)
    world.setGravity([0.0, 0.0, -scene["gravity_m_s2"]])
    world.setCollisionDetector(dartpy.collision.BulletCollisionDetector())
    pushed = []
    for number, support in enumerate(scene["supports"]):
        skeleton = dynamics.Skeleton(f"support{number}")
        hinge = support["joint"] == "hinge"
        make = skeleton.createRevoluteJointAndBodyNodePair if hinge else skeleton.createPrismaticJointAndBodyNodePair
        joint, body = make()
        joint.setAxis(support["axis"])
        body.setInertia(dynamics.Inertia(support["mass_kg"], np.zeros(3), support["inertia_kg_m2"] * np.eye(3)))
        box = dynamics.BoxShape(2.0 * np.array(support["half_size"]))
        shape(body, box, scene["friction"]).setRelativeTranslation(support["place"])
        world.addSkeleton(skeleton)
        skeleton.setVelocities([support["speed"]])
        pushed.append((skeleton, support["force_n"]))
    held = scene["body"]
    skeleton = dynamics.Skeleton("held")
    _, body = skeleton.createFreeJointAndBodyNodePair()
    body.setInertia(dynamics.Inertia(held["mass_kg"], np.zeros(3), np.diag(held["inertia_kg_m2"])))
    for place in held["feet"]:
        shape(body, dynamics.SphereShape(held["foot_m"]), scene["friction"]).setRelativeTranslation(place)
    if "half_size" in held:
        shape(body, dynamics.BoxShape(2.0 * np.array(held["half_size"])), scene["friction"])
    world.addSkeleton(skeleton)
    skeleton.setPositions([0.0, 0.0, 0.0, *held["place"]])
    skeleton.setVelocities([*held["spin"], *held["velocity"]])
    if "robot" in scene:
        return shake(scene, step_s, world, body)

    def step():
        for support, force in pushed:
            support.setForces([force])
        world.step()

    return {"path": sampled(scene, step_s, lambda: body.getWorldTransform().translation(), step)}


def shake(scene, step_s, world, cube):
    """Add the robot and shake it."""
    loader, options = dartpy.utils.DartLoader(), dartpy.utils.DartLoaderOptions()
    options.mDefaultRootJointType = dartpy.utils.DartLoaderRootJointType.FIXED
    loader.setOptions(options)
    robot = loader.parseSkeleton(scene["robot"])
    for body in robot.getBodyNodes():
        for node in body.getShapeNodes():
            if node.hasDynamicsAspect():
                node.getDynamicsAspect().setFrictionCoeff(scene["friction"])
    robot.setPositions(scene["start"])
    world.addSkeleton(robot)

    def step(target):
        robot.setForces(drive(scene, target, robot.getPositions(), robot.getVelocities()))
        world.step()

    def poses():
        for pose in (cube.getWorldTransform(), robot.getBodyNode(scene["tool"]).getWorldTransform()):
            turned = pose.quaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def contacts():
        for each in world.getLastCollisionResult().getContacts():
            normal = each.force @ each.normal
            yield normal, np.linalg.norm(each.force - normal * each.normal), each.penetrationDepth

    return shaken(scene, step_s, step, poses, contacts)


def shape(body, kind, friction):
    """Add a shape to a body."""
    node = body.createShapeNode(kind)
    node.createCollisionAspect()
    node.createDynamicsAspect()
    node.getDynamicsAspect().setFrictionCoeff(friction)
    return node
