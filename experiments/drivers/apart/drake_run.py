"""Drake: discrete with SAP, TAMSI or a lagged cone, or in continuous time."""

import math

import apart
import numpy as np
from pydrake import geometry
from pydrake.math import RigidTransform
from pydrake.multibody import tree
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder
from pydrake.systems.primitives import ConstantVectorSource

STIFFNESS_N_M = 1e4
DISSIPATION_S_M = 10.0
RELAXATION_S = 0.02
HYDROELASTIC_PA = 1e7
ACCURACY = 1e-6


class World(apart.World):
    """A scene with ``contact`` point or hydroelastic; a step of 0 is continuous time."""

    def __init__(self, scene, contact, stiction_m_s, approximation="sap"):
        super().__init__(scene)
        config = MultibodyPlantConfig(
            time_step=scene.step_s,
            contact_model=contact,
            stiction_tolerance=stiction_m_s,
        )
        if scene.step_s:
            config.discrete_contact_approximation = approximation
        self.contact = contact
        self.sample = 0
        builder = DiagramBuilder()
        self.plant, self.graph = AddMultibodyPlant(config, builder)
        self.plant.mutable_gravity_field().set_gravity_vector(scene.gravity_m_s2)
        joints = [self.add_support(support) for support in scene.supports]
        self.body = self.add_body(scene.body)
        if scene.robot:
            self.robot = self.add_robot(scene.robot)
        self.plant.Finalize()
        forces = [support.force_n for support in scene.supports if support.force_n]
        if forces:
            source = builder.AddSystem(ConstantVectorSource(forces))
            port = self.plant.get_actuation_input_port()
            builder.Connect(source.get_output_port(), port)
        self.simulator = Simulator(builder.Build())
        if not scene.step_s:
            self.simulator.get_mutable_integrator().set_target_accuracy(ACCURACY)
        self.context = self.plant.GetMyMutableContextFromRoot(
            self.simulator.get_mutable_context()
        )
        self.start(scene, joints)

    def start(self, scene, joints):
        pose = RigidTransform(scene.body.position_m)
        self.plant.SetFreeBodyPose(self.context, self.body, pose)
        velocity = SpatialVelocity(scene.body.spin_rad_s, scene.body.velocity_m_s)
        self.plant.SetFreeBodySpatialVelocity(self.context, self.body, velocity)
        for joint, support in zip(joints, scene.supports, strict=True):
            if support.joint == "hinge":
                joint.set_angular_rate(self.context, support.speed)
        if scene.robot:
            self.plant.SetPositions(self.context, self.robot, scene.qpos)

    def add_support(self, support):
        name = f"support{self.plant.num_bodies()}"
        inertia = [support.inertia_kg_m2] * 3
        body = self.add_rigid_body(name, support.mass_kg, inertia)
        box = geometry.Box(*(2.0 * np.array(support.half_size_m)))
        pose = RigidTransform(support.position_m)
        material = self.material(rigid=True)
        self.plant.RegisterCollisionGeometry(body, pose, box, name, material)
        make = tree.RevoluteJoint if support.joint == "hinge" else tree.PrismaticJoint
        joint = self.plant.AddJoint(
            make(name, self.plant.world_frame(), body.body_frame(), support.axis)
        )
        if support.force_n:
            self.plant.AddJointActuator(name, joint)
        return joint

    def add_body(self, body):
        added = self.add_rigid_body("held", body.mass_kg, body.inertia_kg_m2)
        shapes = [
            (RigidTransform(position), geometry.Sphere(body.foot_m))
            for position in body.feet
        ]
        if not body.feet:
            box = geometry.Box(*(2.0 * np.array(body.half_size_m)))
            shapes.append((RigidTransform(), box))
        for number, (pose, shape) in enumerate(shapes):
            material = self.material(rigid=False)
            name = f"shape{number}"
            self.plant.RegisterCollisionGeometry(added, pose, shape, name, material)
        return added

    def add_rigid_body(self, name, mass_kg, inertia_kg_m2):
        inertia = tree.SpatialInertia.MakeFromCentralInertia(
            mass_kg, np.zeros(3), tree.RotationalInertia(*inertia_kg_m2)
        )
        return self.plant.AddRigidBody(name, inertia)

    def add_robot(self, robot):
        """Add the robot, rigid where surfaces meet, with its drives."""
        material = geometry.DefaultProximityProperties(
            compliance_type="rigid", point_stiffness=STIFFNESS_N_M
        )
        material.static_friction = material.dynamic_friction = self.scene.friction
        material.hunt_crossley_dissipation = DISSIPATION_S_M
        material.relaxation_time = RELAXATION_S
        self.graph.set_config(
            geometry.SceneGraphConfig(default_proximity_properties=material)
        )
        [model] = Parser(self.plant).AddModels(robot.file)
        base = self.plant.GetFrameByName("base")
        self.plant.WeldFrames(self.plant.world_frame(), base)
        joints = map(self.plant.get_joint, self.plant.GetJointIndices(model))
        driven = [joint for joint in joints if joint.num_positions()]
        for joint, effort, armature in zip(
            driven, robot.effort, robot.armature, strict=True
        ):
            actuator = self.plant.AddJointActuator(joint.name(), joint, effort)
            actuator.set_default_rotor_inertia(armature)
            gains = tree.PdControllerGains(p=robot.ke, d=robot.kd)
            actuator.set_controller_gains(gains)
        return model

    def material(self, rigid):
        found = geometry.ProximityProperties()
        if self.contact == "hydroelastic" and rigid:
            geometry.AddRigidHydroelasticProperties(0.1, found)
        elif self.contact == "hydroelastic":
            resolution_m = self.scene.body.foot_m / 5.0
            geometry.AddCompliantHydroelasticProperties(
                resolution_m, HYDROELASTIC_PA, found
            )
        friction = CoulombFriction(self.scene.friction, self.scene.friction)
        geometry.AddContactMaterial(DISSIPATION_S_M, STIFFNESS_N_M, friction, found)
        found.AddProperty("material", "relaxation_time", RELAXATION_S)
        return found

    def advance(self):
        if self.scene.robot:
            desired = np.concatenate([self.target, np.zeros(len(self.target))])
            port = self.plant.get_desired_state_input_port(self.robot)
            port.FixValue(self.context, desired)
        self.sample += 1
        self.simulator.AdvanceTo(self.scene.sample_s * self.sample)

    def poses(self):
        bodies = [self.body]
        if self.scene.robot:
            bodies.append(self.plant.GetBodyByName(self.scene.robot.tool))
        for body in bodies:
            pose = self.plant.EvalBodyPoseInWorld(self.context, body)
            turned = pose.rotation().ToQuaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def forces(self):
        for total, normal, depth_m in self.contacts():
            along = total @ normal
            yield abs(along), np.linalg.norm(total - along * normal), depth_m

    def contacts(self):
        """Yield force [N], normal and depth [m] of each contact; a surface has no depth."""
        found = self.plant.get_contact_results_output_port().Eval(self.context)
        for number in range(found.num_point_pair_contacts()):
            info = found.point_pair_contact_info(number)
            pair = info.point_pair()
            yield info.contact_force(), pair.nhat_BA_W, pair.depth
        for number in range(found.num_hydroelastic_contacts()):
            info = found.hydroelastic_contact_info(number)
            surface = info.contact_surface()
            across = sum(
                surface.area(face) * surface.face_normal(face)
                for face in range(surface.num_faces())
            )
            normal = across / np.linalg.norm(across)
            yield info.F_Ac_W().translational(), normal, math.nan
