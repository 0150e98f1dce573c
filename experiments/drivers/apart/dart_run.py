"""DART, with Bullet's collision detector."""

import dartpy
import numpy as np
from apart import World, drive

dynamics = dartpy.dynamics


def load(scene):
    world = dartpy.simulation.World()
    world.setTimeStep(scene.step_s)
    world.setGravity(scene.gravity_m_s2)
    world.setCollisionDetector(dartpy.collision.BulletCollisionDetector())
    pushed = []
    for number, support in enumerate(scene.supports):
        skeleton = make_support(f"support{number}", support, scene.friction)
        world.addSkeleton(skeleton)
        skeleton.setVelocities([support.speed])
        pushed.append((skeleton, support.force_n))
    skeleton, body = make_body(scene.body, scene.friction)
    world.addSkeleton(skeleton)
    skeleton.setPositions([0.0, 0.0, 0.0, *scene.body.position_m])
    skeleton.setVelocities([*scene.body.spin_rad_s, *scene.body.velocity_m_s])
    bodies = [body]
    if scene.robot:
        robot = load_robot(scene)
        world.addSkeleton(robot)
        bodies.append(robot.getBodyNode(scene.robot.tool))

    def step(target):
        for support, force in pushed:
            support.setForces([force])
        if scene.robot:
            state = robot.getPositions(), robot.getVelocities()
            robot.setForces(drive(scene.robot, target, *state))
        world.step()

    def poses():
        for each in bodies:
            pose = each.getWorldTransform()
            turned = pose.quaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def forces():
        for contact in world.getLastCollisionResult().getContacts():
            normal = contact.force @ contact.normal
            tangential = np.linalg.norm(contact.force - normal * contact.normal)
            yield normal, tangential, contact.penetrationDepth

    return World(step, poses, forces)


def make_support(name, support, friction):
    skeleton = dynamics.Skeleton(name)
    if support.joint == "hinge":
        joint, body = skeleton.createRevoluteJointAndBodyNodePair()
    else:
        joint, body = skeleton.createPrismaticJointAndBodyNodePair()
    joint.setAxis(support.axis)
    inertia = support.inertia_kg_m2 * np.eye(3)
    body.setInertia(dynamics.Inertia(support.mass_kg, np.zeros(3), inertia))
    box = dynamics.BoxShape(2.0 * np.array(support.half_size_m))
    add_shape(body, box, friction).setRelativeTranslation(support.position_m)
    return skeleton


def make_body(body, friction):
    skeleton = dynamics.Skeleton("held")
    _, node = skeleton.createFreeJointAndBodyNodePair()
    inertia = np.diag(body.inertia_kg_m2)
    node.setInertia(dynamics.Inertia(body.mass_kg, np.zeros(3), inertia))
    for position in body.feet:
        ball = dynamics.SphereShape(body.foot_m)
        add_shape(node, ball, friction).setRelativeTranslation(position)
    if not body.feet:
        add_shape(node, dynamics.BoxShape(2.0 * np.array(body.half_size_m)), friction)
    return skeleton, node


def add_shape(body, shape, friction):
    node = body.createShapeNode(shape)
    node.createCollisionAspect()
    node.createDynamicsAspect()
    node.getDynamicsAspect().setFrictionCoeff(friction)
    return node


def load_robot(scene):
    options = dartpy.utils.DartLoaderOptions()
    options.mDefaultRootJointType = dartpy.utils.DartLoaderRootJointType.FIXED
    loader = dartpy.utils.DartLoader()
    loader.setOptions(options)
    robot = loader.parseSkeleton(scene.robot.file)
    for body in robot.getBodyNodes():
        for node in body.getShapeNodes():
            if node.hasDynamicsAspect():
                node.getDynamicsAspect().setFrictionCoeff(scene.friction)
    robot.setPositions(scene.qpos)
    return robot
