"""PyBullet, with its own number of iterations, all of them used."""

import math

import pybullet
from apart import World, drive

JOINTS = {"hinge": pybullet.JOINT_REVOLUTE, "slide": pybullet.JOINT_PRISMATIC}
FREE = {
    "linearDamping": 0.0,
    "angularDamping": 0.0,
    "jointDamping": 0.0,
    "activationState": pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
}
UPRIGHT = [0.0, 0.0, 0.0, 1.0]
ORIGIN = [0.0, 0.0, 0.0]

pybullet.connect(pybullet.DIRECT)


def load(scene):
    pybullet.resetSimulation()
    pybullet.setGravity(*scene.gravity_m_s2)
    pybullet.setPhysicsEngineParameter(
        fixedTimeStep=scene.step_s, solverResidualThreshold=0.0
    )
    pushed = [(add_support(each, scene.friction), each) for each in scene.supports]
    body = add_body(scene.body)
    if scene.robot:
        robot, driven, tool = add_robot(scene)

    def step(target):
        for support, each in pushed:
            push(support, 0, pybullet.TORQUE_CONTROL, each.force_n)
        if scene.robot:
            states = pybullet.getJointStates(robot, driven)
            positions, velocities, *_ = zip(*states, strict=True)
            forces = drive(scene.robot, target, positions, velocities)
            for joint, force in zip(driven, forces, strict=True):
                push(robot, joint, pybullet.TORQUE_CONTROL, force)
        pybullet.stepSimulation()

    def poses():
        yield sum(pybullet.getBasePositionAndOrientation(body), ())
        if scene.robot:
            state = pybullet.getLinkState(robot, tool, computeForwardKinematics=True)
            yield sum(state[4:6], ())

    def forces():
        for contact in pybullet.getContactPoints(bodyA=body):
            yield contact[9], math.hypot(contact[10], contact[12]), -contact[8]

    return World(step, poses, forces)


def push(body, joint, mode, force):
    pybullet.setJointMotorControl2(body, joint, mode, force=force)


def add_support(support, friction):
    box = pybullet.GEOM_BOX
    shape = pybullet.createCollisionShape(box, halfExtents=support.half_size_m)
    body = pybullet.createMultiBody(
        baseMass=0.0,
        basePosition=support.position_m,
        linkMasses=[support.mass_kg],
        linkCollisionShapeIndices=[shape],
        linkVisualShapeIndices=[-1],
        linkPositions=[ORIGIN],
        linkOrientations=[UPRIGHT],
        linkInertialFramePositions=[ORIGIN],
        linkInertialFrameOrientations=[UPRIGHT],
        linkParentIndices=[0],
        linkJointTypes=[JOINTS[support.joint]],
        linkJointAxis=[support.axis],
    )
    inertia = [support.inertia_kg_m2] * 3
    change = pybullet.changeDynamics
    change(body, 0, localInertiaDiagonal=inertia, lateralFriction=friction, **FREE)
    change(body, 0, jointLowerLimit=-1e9, jointUpperLimit=1e9)
    push(body, 0, pybullet.VELOCITY_CONTROL, 0.0)
    pybullet.resetJointState(body, 0, 0.0, support.speed)
    return body


def add_body(body):
    if body.feet:
        shape = pybullet.createCollisionShapeArray(
            [pybullet.GEOM_SPHERE] * len(body.feet),
            radii=[body.foot_m] * len(body.feet),
            collisionFramePositions=body.feet,
        )
    else:
        box = pybullet.GEOM_BOX
        shape = pybullet.createCollisionShape(box, halfExtents=body.half_size_m)
    number = pybullet.createMultiBody(body.mass_kg, shape, basePosition=body.position_m)
    inertia = body.inertia_kg_m2
    # Bullet multiplies the two frictions.
    pybullet.changeDynamics(
        number, -1, localInertiaDiagonal=inertia, lateralFriction=1.0, **FREE
    )
    pybullet.resetBaseVelocity(number, body.velocity_m_s, body.spin_rad_s)
    return number


def add_robot(scene):
    """Add the robot without its motors, which would reach a target within a step."""
    flags = pybullet.URDF_USE_INERTIA_FROM_FILE
    robot = pybullet.loadURDF(scene.robot.file, useFixedBase=True, flags=flags)
    count = pybullet.getNumJoints(robot)
    infos = [pybullet.getJointInfo(robot, joint) for joint in range(count)]
    driven = [info[0] for info in infos if info[2] != pybullet.JOINT_FIXED]
    [tool] = [info[0] for info in infos if info[12].decode() == scene.robot.tool]
    for joint in range(-1, count):
        pybullet.changeDynamics(robot, joint, lateralFriction=scene.friction, **FREE)
    for joint, position in zip(driven, scene.qpos, strict=True):
        pybullet.resetJointState(robot, joint, position)
        push(robot, joint, pybullet.VELOCITY_CONTROL, 0.0)
    return robot, driven, tool
