"""A body on balls between supports, or a box that a robot holds, in PyBullet."""

import math

import pybullet
from apart import drive, sampled, shaken

JOINTS = {"hinge": pybullet.JOINT_REVOLUTE, "slide": pybullet.JOINT_PRISMATIC}
FREE = {"linearDamping": 0.0, "angularDamping": 0.0, "activationState": pybullet.ACTIVATION_STATE_DISABLE_SLEEPING}


def run(scene, step_s):
    """Run it with the engine's own number of iterations, all of them used."""
    pybullet.resetSimulation()
    pybullet.setGravity(0.0, 0.0, -scene["gravity_m_s2"])
    pybullet.setPhysicsEngineParameter(fixedTimeStep=step_s, solverResidualThreshold=0.0)
    pushed = []
    for support in scene["supports"]:
        shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=support["half_size"])
        upright, origin = [0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0]
        link = {
            **{"linkMasses": [support["mass_kg"]], "linkCollisionShapeIndices": [shape]},
            **{"linkVisualShapeIndices": [-1], "linkPositions": [origin], "linkOrientations": [upright]},
            **{"linkInertialFramePositions": [origin], "linkInertialFrameOrientations": [upright]},
            **{
                "linkParentIndices": [0],
                "linkJointTypes": [JOINTS[support["joint"]]],
                "linkJointAxis": [support["axis"]],
            },
        }
        body = pybullet.createMultiBody(baseMass=0.0, basePosition=support["place"], **link)
        inertia = [support["inertia_kg_m2"]] * 3
        pybullet.changeDynamics(
            body, 0, localInertiaDiagonal=inertia, lateralFriction=scene["friction"], jointDamping=0.0, **FREE
        )
        pybullet.changeDynamics(body, 0, jointLowerLimit=-1e9, jointUpperLimit=1e9)
        pybullet.setJointMotorControl2(body, 0, pybullet.VELOCITY_CONTROL, force=0.0)
        pybullet.resetJointState(body, 0, 0.0, support["speed"])
        pushed.append((body, support["force_n"]))
    held = scene["body"]
    count = len(held["feet"])
    if count:
        kinds, radii = [pybullet.GEOM_SPHERE] * count, [held["foot_m"]] * count
        shape = pybullet.createCollisionShapeArray(kinds, radii=radii, collisionFramePositions=held["feet"])
    else:
        shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=held["half_size"])
    body = pybullet.createMultiBody(held["mass_kg"], shape, basePosition=held["place"])
    # Bullet multiplies the two frictions.
    pybullet.changeDynamics(body, -1, localInertiaDiagonal=held["inertia_kg_m2"], lateralFriction=1.0, **FREE)
    pybullet.resetBaseVelocity(body, held["velocity"], held["spin"])
    if "robot" in scene:
        return shake(scene, step_s, body)

    def step():
        for support, force in pushed:
            pybullet.setJointMotorControl2(support, 0, pybullet.TORQUE_CONTROL, force=force)
        pybullet.stepSimulation()

    return {"path": sampled(scene, step_s, lambda: pybullet.getBasePositionAndOrientation(body)[0], step)}


def shake(scene, step_s, cube):
    """Add the robot and shake it, with drives from outside: the engine's own go to a target within a step."""
    flags = pybullet.URDF_USE_INERTIA_FROM_FILE
    robot = pybullet.loadURDF(scene["robot"], useFixedBase=True, flags=flags)
    infos = [pybullet.getJointInfo(robot, joint) for joint in range(pybullet.getNumJoints(robot))]
    driven = [info[0] for info in infos if info[2] != pybullet.JOINT_FIXED]
    [tool] = [info[0] for info in infos if info[12].decode() == scene["tool"]]
    for joint in range(-1, len(infos)):
        pybullet.changeDynamics(robot, joint, lateralFriction=scene["friction"], jointDamping=0.0, **FREE)
    for joint, place in zip(driven, scene["start"], strict=True):
        pybullet.resetJointState(robot, joint, place)
        pybullet.setJointMotorControl2(robot, joint, pybullet.VELOCITY_CONTROL, force=0.0)

    def step(target):
        places, speeds, *_ = zip(*pybullet.getJointStates(robot, driven), strict=True)
        forces = drive(scene, target, places, speeds)
        pybullet.setJointMotorControlArray(robot, driven, pybullet.TORQUE_CONTROL, forces=forces)
        pybullet.stepSimulation()

    def poses():
        yield sum(pybullet.getBasePositionAndOrientation(cube), ())
        yield sum(pybullet.getLinkState(robot, tool, computeForwardKinematics=True)[4:6], ())

    def contacts():
        for each in pybullet.getContactPoints(robot, cube):
            yield each[9], math.hypot(each[10], each[12]), -each[8]

    return shaken(scene, step_s, step, poses, contacts)


pybullet.connect(pybullet.DIRECT)
