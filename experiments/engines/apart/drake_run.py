"""A body on balls between supports, in Drake: discrete with SAP, TAMSI or a lagged cone, or continuous."""

import numpy as np
from apart import samples
from pydrake.geometry import (
    AddCompliantHydroelasticProperties,
    AddContactMaterial,
    AddRigidHydroelasticProperties,
    Box,
    ProximityProperties,
    Sphere,
)
from pydrake.math import RigidTransform
from pydrake.multibody.math import SpatialVelocity
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.multibody.tree import PrismaticJoint, RevoluteJoint, RotationalInertia, SpatialInertia
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
    plant, _ = AddMultibodyPlant(config, builder)
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
    path = [held["place"]]
    for time_s in samples(scene):
        simulator.AdvanceTo(time_s)
        path.append(plant.EvalBodyPoseInWorld(context, body).translation().tolist())
    to_body = plant.EvalBodyPoseInWorld(context, body).inverse()
    found = plant.get_contact_results_output_port().Eval(context)
    touched = [[*to_body.multiply(place).tolist(), normal] for place, normal in contacts(found)]
    return {"path": path, "contacts": touched}


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


def contacts(found):
    """Yield the contacts, places and normal forces [N]: points, or the middles of the faces of contact surfaces."""
    for number in range(found.num_point_pair_contacts()):
        info = found.point_pair_contact_info(number)
        yield info.contact_point(), abs(info.contact_force() @ info.point_pair().nhat_BA_W)
    for number in range(found.num_hydroelastic_contacts()):
        surface = found.hydroelastic_contact_info(number).contact_surface()
        pressure = surface.tri_e_MN() if surface.is_triangle() else surface.poly_e_MN()
        for face in range(surface.num_faces()):
            place = surface.centroid(face)
            yield place, surface.area(face) * pressure.EvaluateCartesian(face, place)
