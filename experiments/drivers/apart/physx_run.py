"""PhysX on the CPU, as SAPIEN brings it: it solves by TGS, with patch friction."""

import math

import apart
import sapien
from sapien import physx


class World(apart.World):
    def __init__(self, scene):
        super().__init__(scene)
        config = physx.PhysxBodyConfig()
        config.sleep_threshold = 0.0
        physx.set_body_config(config)
        physx.set_scene_config(gravity=scene.gravity_m_s2)
        self.stage = sapien.Scene([physx.PhysxCpuSystem()])
        self.stage.set_timestep(scene.step_s)
        self.material = physx.PhysxMaterial(scene.friction, scene.friction, 0.0)
        self.supports = [self.add_support(support) for support in scene.supports]
        self.bodies = [self.add_body(scene.body)]
        self.driven = self.add_robot(scene.robot) if scene.robot else []

    def add(self, shapes, mass_kg, inertia_kg_m2, position_m):
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
        self.stage.add_entity(entity)
        return body, entity

    def add_support(self, support):
        box = physx.PhysxCollisionShapeBox(support.half_size_m, self.material)
        inertia = [support.inertia_kg_m2] * 3
        body, _ = self.add([box], support.mass_kg, inertia, support.position_m)
        # Locked are x, y and z, and the turns about them, but for the joint's own axis.
        is_locked = [not value for value in support.axis]
        is_hinge = support.joint == "hinge"
        all_locked = [True] * 3
        body.set_locked_motion_axes(
            all_locked + is_locked if is_hinge else is_locked + all_locked
        )
        body.disable_gravity = True
        if is_hinge:
            body.angular_velocity = [support.speed * value for value in support.axis]
        return body

    def add_body(self, body):
        shapes = []
        for position in body.feet:
            shapes.append(physx.PhysxCollisionShapeSphere(body.foot_m, self.material))
            shapes[-1].local_pose = sapien.Pose(position)
        if not body.feet:
            box = physx.PhysxCollisionShapeBox(body.half_size_m, self.material)
            shapes.append(box)
        component, entity = self.add(
            shapes, body.mass_kg, body.inertia_kg_m2, body.position_m
        )
        component.linear_velocity = body.velocity_m_s
        component.angular_velocity = body.spin_rad_s
        return entity

    def add_robot(self, robot):
        loader = self.stage.create_urdf_loader()
        loader.set_material(self.scene.friction, self.scene.friction, 0.0)
        articulation = loader.load(robot.file)
        articulation.set_qpos(self.scene.qpos)
        articulation.set_sleep_threshold(0.0)
        for link in articulation.links:
            link.linear_damping = link.angular_damping = 0.0
        joints = articulation.active_joints
        for joint, effort, armature in zip(
            joints, robot.effort, robot.armature, strict=True
        ):
            joint.set_drive_properties(robot.ke, robot.kd, effort)
            joint.set_armature([armature])
        self.bodies.append(articulation.find_link_by_name(robot.tool).entity)
        return joints

    def step(self):
        for body, support in zip(self.supports, self.scene.supports, strict=True):
            force = [support.force_n * value for value in support.axis]
            body.add_force_torque(force, [0.0, 0.0, 0.0])
        for joint, target in zip(self.driven, self.target, strict=False):
            joint.set_drive_target(target)
        self.stage.step()

    def poses(self):
        for body in self.bodies:
            yield [*body.pose.p, *body.pose.q[1:], body.pose.q[0]]

    def forces(self):
        for contact in self.stage.get_contacts():
            for point in contact.points:
                normal = point.impulse @ point.normal / self.scene.step_s
                yield normal, math.nan, -point.separation
