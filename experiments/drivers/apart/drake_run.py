"""Drake: discrete with SAP, TAMSI or a lagged cone, or in continuous time."""

import itertools
import math

import numpy as np
from apart import World
from pydrake import geometry
from pydrake.math import RigidTransform
from pydrake.multibody import plant as multibody
from pydrake.multibody import tree
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.parsing import Parser
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder
from pydrake.systems.primitives import ConstantVectorSource

STIFFNESS_N_M = 1e4
DISSIPATION_S_M = 10.0
RELAXATION_S = 0.02
HYDROELASTIC_PA = 1e7
ACCURACY = 1e-6


def load(scene, contact, stiction_m_s, approximation="sap"):
    """Load it with ``contact`` point or hydroelastic; a step of 0 is continuous time."""
    config = multibody.MultibodyPlantConfig(
        time_step=scene.step_s, contact_model=contact, stiction_tolerance=stiction_m_s
    )
    if scene.step_s:
        config.discrete_contact_approximation = approximation
    builder = DiagramBuilder()
    plant, graph = multibody.AddMultibodyPlant(config, builder)
    plant.mutable_gravity_field().set_gravity_vector(scene.gravity_m_s2)
    rigid = material(scene, contact, is_rigid=True)
    joints = [add_support(plant, support, rigid) for support in scene.supports]
    body = add_body(plant, scene.body, material(scene, contact, is_rigid=False))
    bodies = [body]
    if scene.robot:
        robot = add_robot(plant, graph, scene)
        bodies.append(plant.GetBodyByName(scene.robot.tool))
    plant.Finalize()
    forces_n = [support.force_n for support in scene.supports if support.force_n]
    if forces_n:
        source = builder.AddSystem(ConstantVectorSource(forces_n))
        builder.Connect(source.get_output_port(), plant.get_actuation_input_port())
    simulator = Simulator(builder.Build())
    if not scene.step_s:
        simulator.get_mutable_integrator().set_target_accuracy(ACCURACY)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetFreeBodyPose(context, body, RigidTransform(scene.body.position_m))
    velocity = SpatialVelocity(scene.body.spin_rad_s, scene.body.velocity_m_s)
    plant.SetFreeBodySpatialVelocity(context, body, velocity)
    for joint, support in zip(joints, scene.supports, strict=True):
        if support.joint == "hinge":
            joint.set_angular_rate(context, support.speed)
    if scene.robot:
        plant.SetPositions(context, robot, scene.qpos)
    samples = itertools.count(1)

    def step(target):
        if scene.robot:
            desired = np.concatenate([target, np.zeros(len(target))])
            plant.get_desired_state_input_port(robot).FixValue(context, desired)
        simulator.AdvanceTo(scene.sample_s * next(samples))

    def poses():
        for each in bodies:
            pose = plant.EvalBodyPoseInWorld(context, each)
            turned = pose.rotation().ToQuaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def forces():
        found = plant.get_contact_results_output_port().Eval(context)
        for total, normal, depth_m in touches(found):
            along = total @ normal
            yield abs(along), np.linalg.norm(total - along * normal), depth_m

    return World(step, poses, forces, step_count=1)


def touches(found):
    """Yield force [N], normal and depth [m] of each contact; a surface has no depth."""
    for number in range(found.num_point_pair_contacts()):
        info = found.point_pair_contact_info(number)
        pair = info.point_pair()
        yield info.contact_force(), pair.nhat_BA_W, pair.depth
    for number in range(found.num_hydroelastic_contacts()):
        info = found.hydroelastic_contact_info(number)
        surface = info.contact_surface()
        faces = range(surface.num_faces())
        across = sum(surface.area(face) * surface.face_normal(face) for face in faces)
        normal = across / np.linalg.norm(across)
        yield info.F_Ac_W().translational(), normal, math.nan


def add_support(plant, support, material):
    name = f"support{plant.num_bodies()}"
    body = add_rigid_body(plant, name, support.mass_kg, [support.inertia_kg_m2] * 3)
    box = geometry.Box(*(2.0 * np.array(support.half_size_m)))
    pose = RigidTransform(support.position_m)
    plant.RegisterCollisionGeometry(body, pose, box, name, material)
    make = tree.RevoluteJoint if support.joint == "hinge" else tree.PrismaticJoint
    frames = plant.world_frame(), body.body_frame()
    joint = plant.AddJoint(make(name, *frames, support.axis))
    if support.force_n:
        plant.AddJointActuator(name, joint)
    return joint


def add_body(plant, body, material):
    added = add_rigid_body(plant, "held", body.mass_kg, body.inertia_kg_m2)
    ball = geometry.Sphere(body.foot_m)
    shapes = [(RigidTransform(position), ball) for position in body.feet]
    if not body.feet:
        box = geometry.Box(*(2.0 * np.array(body.half_size_m)))
        shapes.append((RigidTransform(), box))
    for number, shape in enumerate(shapes):
        plant.RegisterCollisionGeometry(added, *shape, f"shape{number}", material)
    return added


def add_rigid_body(plant, name, mass_kg, inertia_kg_m2):
    inertia = tree.RotationalInertia(*inertia_kg_m2)
    make = tree.SpatialInertia.MakeFromCentralInertia
    return plant.AddRigidBody(name, make(mass_kg, np.zeros(3), inertia))


def add_robot(plant, graph, scene):
    """Add the robot, rigid where surfaces meet, with its drives."""
    material = geometry.DefaultProximityProperties(
        compliance_type="rigid", point_stiffness=STIFFNESS_N_M
    )
    material.static_friction = material.dynamic_friction = scene.friction
    material.hunt_crossley_dissipation = DISSIPATION_S_M
    material.relaxation_time = RELAXATION_S
    config = geometry.SceneGraphConfig(default_proximity_properties=material)
    graph.set_config(config)
    robot = scene.robot
    [model] = Parser(plant).AddModels(robot.file)
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("base"))
    joints = map(plant.get_joint, plant.GetJointIndices(model))
    driven = [joint for joint in joints if joint.num_positions()]
    gains = tree.PdControllerGains(p=robot.ke, d=robot.kd)
    drives = zip(driven, robot.effort, robot.armature, strict=True)
    for joint, effort, armature in drives:
        actuator = plant.AddJointActuator(joint.name(), joint, effort)
        actuator.set_default_rotor_inertia(armature)
        actuator.set_controller_gains(gains)
    return model


def material(scene, contact, is_rigid):
    found = geometry.ProximityProperties()
    if contact == "hydroelastic" and is_rigid:
        geometry.AddRigidHydroelasticProperties(0.1, found)
    elif contact == "hydroelastic":
        fine_m = scene.body.foot_m / 5.0
        geometry.AddCompliantHydroelasticProperties(fine_m, HYDROELASTIC_PA, found)
    friction = multibody.CoulombFriction(scene.friction, scene.friction)
    geometry.AddContactMaterial(DISSIPATION_S_M, STIFFNESS_N_M, friction, found)
    found.AddProperty("material", "relaxation_time", RELAXATION_S)
    return found
