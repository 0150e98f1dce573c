"""PyBullet, with its own number of iterations, all of them used."""

import math

import apart
import pybullet

JOINTS = {"hinge": pybullet.JOINT_REVOLUTE, "slide": pybullet.JOINT_PRISMATIC}
FREE = {
    "linearDamping": 0.0,
    "angularDamping": 0.0,
    "activationState": pybullet.ACTIVATION_STATE_DISABLE_SLEEPING,
}
UPRIGHT = [0.0, 0.0, 0.0, 1.0]
ORIGIN = [0.0, 0.0, 0.0]

pybullet.connect(pybullet.DIRECT)


class World(apart.World):
    def __init__(self, scene):
        super().__init__(scene)
        pybullet.resetSimulation()
        pybullet.setGravity(*scene.gravity_m_s2)
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=scene.step_s, solverResidualThreshold=0.0
        )
        self.supports = [self.add_support(support) for support in scene.supports]
        self.body = self.add_body(scene.body)
        self.robot = self.add_robot(scene.robot) if scene.robot else None

    def add_support(self, support):
        shape = pybullet.createCollisionShape(
            pybullet.GEOM_BOX, halfExtents=support.half_size_m
        )
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
        pybullet.changeDynamics(
            body,
            0,
            localInertiaDiagonal=[support.inertia_kg_m2] * 3,
            lateralFriction=self.scene.friction,
            jointDamping=0.0,
            **FREE,
        )
        pybullet.changeDynamics(body, 0, jointLowerLimit=-1e9, jointUpperLimit=1e9)
        pybullet.setJointMotorControl2(body, 0, pybullet.VELOCITY_CONTROL, force=0.0)
        pybullet.resetJointState(body, 0, 0.0, support.speed)
        return body

    def add_body(self, body):
        if body.feet:
            shape = pybullet.createCollisionShapeArray(
                [pybullet.GEOM_SPHERE] * len(body.feet),
                radii=[body.foot_m] * len(body.feet),
                collisionFramePositions=body.feet,
            )
        else:
            shape = pybullet.createCollisionShape(
                pybullet.GEOM_BOX, halfExtents=body.half_size_m
            )
        number = pybullet.createMultiBody(
            body.mass_kg, shape, basePosition=body.position_m
        )
        # Bullet multiplies the two frictions.
        pybullet.changeDynamics(
            number,
            -1,
            localInertiaDiagonal=body.inertia_kg_m2,
            lateralFriction=1.0,
            **FREE,
        )
        pybullet.resetBaseVelocity(number, body.velocity_m_s, body.spin_rad_s)
        return number

    def add_robot(self, robot):
        """Add the robot without its motors, which would reach a target within a step."""
        number = pybullet.loadURDF(
            robot.file, useFixedBase=True, flags=pybullet.URDF_USE_INERTIA_FROM_FILE
        )
        infos = [
            pybullet.getJointInfo(number, joint)
            for joint in range(pybullet.getNumJoints(number))
        ]
        self.driven = [info[0] for info in infos if info[2] != pybullet.JOINT_FIXED]
        [self.tool] = [info[0] for info in infos if info[12].decode() == robot.tool]
        for joint in range(-1, len(infos)):
            pybullet.changeDynamics(
                number,
                joint,
                lateralFriction=self.scene.friction,
                jointDamping=0.0,
                **FREE,
            )
        for joint, position in zip(self.driven, self.scene.qpos, strict=True):
            pybullet.resetJointState(number, joint, position)
            pybullet.setJointMotorControl2(
                number, joint, pybullet.VELOCITY_CONTROL, force=0.0
            )
        return number

    def step(self):
        for number, support in zip(self.supports, self.scene.supports, strict=True):
            pybullet.setJointMotorControl2(
                number, 0, pybullet.TORQUE_CONTROL, force=support.force_n
            )
        if self.robot is not None:
            states = pybullet.getJointStates(self.robot, self.driven)
            positions, velocities, *_ = zip(*states, strict=True)
            pybullet.setJointMotorControlArray(
                self.robot,
                self.driven,
                pybullet.TORQUE_CONTROL,
                forces=self.drive(positions, velocities),
            )
        pybullet.stepSimulation()

    def poses(self):
        yield sum(pybullet.getBasePositionAndOrientation(self.body), ())
        if self.robot is not None:
            state = pybullet.getLinkState(
                self.robot, self.tool, computeForwardKinematics=True
            )
            yield sum(state[4:6], ())

    def forces(self):
        for contact in pybullet.getContactPoints(bodyA=self.body):
            yield contact[9], math.hypot(contact[10], contact[12]), -contact[8]
