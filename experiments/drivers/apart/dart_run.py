"""DART, with Bullet's collision detector."""

import apart
import dartpy
import numpy as np

dynamics = dartpy.dynamics


class World(apart.World):
    def __init__(self, scene):
        super().__init__(scene)
        self.world = dartpy.simulation.World()
        self.world.setTimeStep(scene.step_s)
        self.world.setGravity(scene.gravity_m_s2)
        self.world.setCollisionDetector(dartpy.collision.BulletCollisionDetector())
        self.supports = [self.add_support(support) for support in scene.supports]
        self.body = self.add_body(scene.body)
        self.robot = self.add_robot(scene.robot) if scene.robot else None

    def add_support(self, support):
        skeleton = dynamics.Skeleton(f"support{self.world.getNumSkeletons()}")
        if support.joint == "hinge":
            joint, body = skeleton.createRevoluteJointAndBodyNodePair()
        else:
            joint, body = skeleton.createPrismaticJointAndBodyNodePair()
        joint.setAxis(support.axis)
        inertia = support.inertia_kg_m2 * np.eye(3)
        body.setInertia(dynamics.Inertia(support.mass_kg, np.zeros(3), inertia))
        box = dynamics.BoxShape(2.0 * np.array(support.half_size_m))
        self.add_shape(body, box, support.position_m)
        self.world.addSkeleton(skeleton)
        skeleton.setVelocities([support.speed])
        return skeleton

    def add_body(self, body):
        skeleton = dynamics.Skeleton("held")
        _, node = skeleton.createFreeJointAndBodyNodePair()
        inertia = np.diag(body.inertia_kg_m2)
        node.setInertia(dynamics.Inertia(body.mass_kg, np.zeros(3), inertia))
        for position in body.feet:
            self.add_shape(node, dynamics.SphereShape(body.foot_m), position)
        if not body.feet:
            box = dynamics.BoxShape(2.0 * np.array(body.half_size_m))
            self.add_shape(node, box, np.zeros(3))
        self.world.addSkeleton(skeleton)
        skeleton.setPositions([0.0, 0.0, 0.0, *body.position_m])
        skeleton.setVelocities([*body.spin_rad_s, *body.velocity_m_s])
        return node

    def add_robot(self, robot):
        options = dartpy.utils.DartLoaderOptions()
        options.mDefaultRootJointType = dartpy.utils.DartLoaderRootJointType.FIXED
        loader = dartpy.utils.DartLoader()
        loader.setOptions(options)
        skeleton = loader.parseSkeleton(robot.file)
        for body in skeleton.getBodyNodes():
            for node in body.getShapeNodes():
                if node.hasDynamicsAspect():
                    node.getDynamicsAspect().setFrictionCoeff(self.scene.friction)
        skeleton.setPositions(self.scene.qpos)
        self.world.addSkeleton(skeleton)
        return skeleton

    def add_shape(self, body, shape, position_m):
        node = body.createShapeNode(shape)
        node.createCollisionAspect()
        node.createDynamicsAspect()
        node.getDynamicsAspect().setFrictionCoeff(self.scene.friction)
        node.setRelativeTranslation(position_m)

    def step(self):
        for skeleton, support in zip(self.supports, self.scene.supports, strict=True):
            skeleton.setForces([support.force_n])
        if self.robot:
            positions = self.robot.getPositions()
            velocities = self.robot.getVelocities()
            self.robot.setForces(self.drive(positions, velocities))
        self.world.step()

    def poses(self):
        bodies = [self.body]
        if self.robot:
            bodies.append(self.robot.getBodyNode(self.scene.robot.tool))
        for body in bodies:
            pose = body.getWorldTransform()
            turned = pose.quaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def forces(self):
        for contact in self.world.getLastCollisionResult().getContacts():
            normal = contact.force @ contact.normal
            tangential = np.linalg.norm(contact.force - normal * contact.normal)
            yield normal, tangential, contact.penetrationDepth
