"""A body on balls between supports, or a box that a robot holds, in Drake.

It is discrete with SAP, TAMSI or a lagged cone, or continuous.
"""

import itertools
import math

import numpy as np
from apart import samples, shaken
from pydrake.geometry import (
    AddCompliantHydroelasticProperties,
    AddContactMaterial,
    AddRigidHydroelasticProperties,
    Box,
    DefaultProximityProperties,
    ProximityProperties,
    SceneGraphConfig,
    Sphere,
)
from pydrake.math import RigidTransform
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.multibody.tree import PdControllerGains, PrismaticJoint, RevoluteJoint, RotationalInertia, SpatialInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder
from pydrake.systems.primitives import ConstantVectorSource

STIFFNESS_N_M = 1e4
DISSIPATION_S_M = 10.0
RELAXATION_S = 0.02
HYDROELASTIC_PA = 1e7
ACCURACY = 1e-6


def run(scene, step_s, contact, stiction_m_s, approximation="sap"):
    """Run it with ``contact`` point or hydroelastic; a step of 0 is continuous time."""
    builder = DiagramBuilder()
    config = MultibodyPlantConfig(time_step=step_s, contact_model=contact, stiction_tolerance=stiction_m_s)
    if step_s:
        config.discrete_contact_approximation = approximation
    plant, graph = AddMultibodyPlant(config, builder)
    plant.mutable_gravity_field().set_gravity_vector([0.0, 0.0, -scene["gravity_m_s2"]])
    forces, supports = [], []
    for number, support in enumerate(scene["supports"]):
        inertia = RotationalInertia(*[support["inertia_kg_m2"]] * 3)
        spatial = SpatialInertia.MakeFromCentralInertia(support["mass_kg"], np.zeros(3), inertia)
        body = plant.AddRigidBody(f"support{number}", spatial)
        shape, material = Box(*(2.0 * np.array(support["half_size"]))), properties(scene, contact, rigid=True)
        plant.RegisterCollisionGeometry(body, RigidTransform(support["place"]), shape, f"support{number}", material)
        make = RevoluteJoint if support["joint"] == "hinge" else PrismaticJoint
        frames = f"joint{number}", plant.world_frame(), body.body_frame()
        joint = plant.AddJoint(make(*frames, support["axis"]))
        supports.append((joint, support))
        if support["force_n"]:
            plant.AddJointActuator(f"actuator{number}", joint)
            forces.append(support["force_n"])
    held = scene["body"]
    inertia = RotationalInertia(*held["inertia_kg_m2"])
    body = plant.AddRigidBody("held", SpatialInertia.MakeFromCentralInertia(held["mass_kg"], np.zeros(3), inertia))
    for number, place in enumerate(held["feet"]):
        ball, material = Sphere(held["foot_m"]), properties(scene, contact, rigid=False)
        plant.RegisterCollisionGeometry(body, RigidTransform(place), ball, f"foot{number}", material)
    if "robot" in scene:
        box, material = Box(*(2.0 * np.array(held["half_size"]))), properties(scene, contact, rigid=False)
        plant.RegisterCollisionGeometry(body, RigidTransform(), box, "box", material)
        robot = add_robot(scene, plant, graph)
    plant.Finalize()
    if forces:
        builder.Connect(
            builder.AddSystem(ConstantVectorSource(forces)).get_output_port(), plant.get_actuation_input_port()
        )
    simulator = Simulator(builder.Build())
    if not step_s:
        simulator.get_mutable_integrator().set_target_accuracy(ACCURACY)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetFreeBodyPose(context, body, RigidTransform(held["place"]))
    plant.SetFreeBodySpatialVelocity(context, body, SpatialVelocity(held["spin"], held["velocity"]))
    for joint, support in supports:
        if support["joint"] == "hinge":
            joint.set_angular_rate(context, support["speed"])
    if "robot" in scene:
        plant.SetPositions(context, robot, scene["start"])
        return shake(scene, step_s, simulator, plant, context, robot)
    path = [held["place"]]
    for time_s in samples(scene):
        simulator.AdvanceTo(time_s)
        path.append(plant.EvalBodyPoseInWorld(context, body).translation().tolist())
    return {"path": path}


def add_robot(scene, plant, graph):
    """Add the robot, rigid where surfaces meet, with its drives."""
    material = DefaultProximityProperties(compliance_type="rigid", point_stiffness=STIFFNESS_N_M)
    material.static_friction = material.dynamic_friction = scene["friction"]
    material.hunt_crossley_dissipation, material.relaxation_time = DISSIPATION_S_M, RELAXATION_S
    graph.set_config(SceneGraphConfig(default_proximity_properties=material))
    [robot] = Parser(plant).AddModels(scene["robot"])
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("base"))
    joints = [plant.get_joint(index) for index in plant.GetJointIndices(robot)]
    driven = [joint for joint in joints if joint.num_positions()]
    for joint, effort, armature in zip(driven, scene["effort"], scene["armature"], strict=True):
        actuator = plant.AddJointActuator(joint.name(), joint, effort)
        actuator.set_default_rotor_inertia(armature)
        actuator.set_controller_gains(PdControllerGains(p=scene["ke"], d=scene["kd"]))
    return robot


def shake(scene, step_s, simulator, plant, context, robot):
    times = (step_s * (index + 1) for index in itertools.count())

    def step(target):
        wanted = np.concatenate([target, np.zeros(len(target))])
        plant.get_desired_state_input_port(robot).FixValue(context, wanted)
        simulator.AdvanceTo(next(times))

    def poses():
        for name in ("held", scene["tool"]):
            pose = plant.EvalBodyPoseInWorld(context, plant.GetBodyByName(name))
            turned = pose.rotation().ToQuaternion()
            yield [*pose.translation(), turned.x(), turned.y(), turned.z(), turned.w()]

    def contacts():
        for total, normal, depth in touches(plant.get_contact_results_output_port().Eval(context)):
            along = total @ normal
            yield abs(along), np.linalg.norm(total - along * normal), depth

    return shaken(scene, step_s, step, poses, contacts)


def touches(found):
    """Yield the force [N], the normal and the depth [m] of each contact; a surface has no depth."""
    for number in range(found.num_point_pair_contacts()):
        info = found.point_pair_contact_info(number)
        yield info.contact_force(), info.point_pair().nhat_BA_W, info.point_pair().depth
    for number in range(found.num_hydroelastic_contacts()):
        info = found.hydroelastic_contact_info(number)
        surface = info.contact_surface()
        across = sum(surface.area(face) * surface.face_normal(face) for face in range(surface.num_faces()))
        yield info.F_Ac_W().translational(), across / np.linalg.norm(across), math.nan


def properties(scene, contact, rigid):
    """Make the material of a shape."""
    found = ProximityProperties()
    if contact == "hydroelastic" and rigid:
        AddRigidHydroelasticProperties(0.1, found)
    elif contact == "hydroelastic":
        AddCompliantHydroelasticProperties(scene["body"]["foot_m"] / 5.0, HYDROELASTIC_PA, found)
    friction = CoulombFriction(scene["friction"], scene["friction"])
    AddContactMaterial(DISSIPATION_S_M, STIFFNESS_N_M, friction, found)
    found.AddProperty("material", "relaxation_time", RELAXATION_S)
    return found
