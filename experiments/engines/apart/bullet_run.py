"""A body on balls between supports, in PyBullet."""

import pybullet
from apart import sampled

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
    feet = pybullet.createCollisionShapeArray(
        shapeTypes=[pybullet.GEOM_SPHERE] * count, radii=[held["foot_m"]] * count, collisionFramePositions=held["feet"]
    )
    body = pybullet.createMultiBody(held["mass_kg"], feet, basePosition=held["place"])
    # Bullet multiplies the two frictions.
    pybullet.changeDynamics(body, -1, localInertiaDiagonal=held["inertia_kg_m2"], lateralFriction=1.0, **FREE)
    pybullet.resetBaseVelocity(body, held["velocity"], held["spin"])

    def step():
        for support, force in pushed:
            pybullet.setJointMotorControl2(support, 0, pybullet.TORQUE_CONTROL, force=force)
        pybullet.stepSimulation()

    return {"path": sampled(scene, step_s, lambda: pybullet.getBasePositionAndOrientation(body)[0], step)}


pybullet.connect(pybullet.DIRECT)
