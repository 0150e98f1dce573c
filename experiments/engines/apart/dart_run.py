"""A body on balls between supports, in DART with its own defaults, but for Bullet's collision detector."""

import dartpy
import numpy as np
from apart import sampled

dynamics = dartpy.dynamics


def run(scene, step_s):
    world = dartpy.simulation.World()
    world.setTimeStep(step_s)
    world.setGravity([0.0, 0.0, -scene["gravity_m_s2"]])
    world.setCollisionDetector(dartpy.collision.BulletCollisionDetector())
    pushed = []
    for number, support in enumerate(scene["supports"]):
        skeleton = dynamics.Skeleton(f"support{number}")
        hinge = support["joint"] == "hinge"
        make = skeleton.createRevoluteJointAndBodyNodePair if hinge else skeleton.createPrismaticJointAndBodyNodePair
        joint, body = make()
        joint.setAxis(support["axis"])
        body.setInertia(dynamics.Inertia(support["mass_kg"], np.zeros(3), support["inertia_kg_m2"] * np.eye(3)))
        box = dynamics.BoxShape(2.0 * np.array(support["half_size"]))
        shape(body, box, scene["friction"]).setRelativeTranslation(support["place"])
        world.addSkeleton(skeleton)
        skeleton.setVelocities([support["speed"]])
        pushed.append((skeleton, support["force_n"]))
    held = scene["body"]
    skeleton = dynamics.Skeleton("held")
    _, body = skeleton.createFreeJointAndBodyNodePair()
    body.setInertia(dynamics.Inertia(held["mass_kg"], np.zeros(3), np.diag(held["inertia_kg_m2"])))
    for place in held["feet"]:
        shape(body, dynamics.SphereShape(held["foot_m"]), scene["friction"]).setRelativeTranslation(place)
    world.addSkeleton(skeleton)
    skeleton.setPositions([0.0, 0.0, 0.0, *held["place"]])
    skeleton.setVelocities([*held["spin"], *held["velocity"]])

    def step():
        for support, force in pushed:
            support.setForces([force])
        world.step()

    path = sampled(scene, step_s, lambda: body.getWorldTransform().translation(), step)
    to_body = body.getWorldTransform().inverse()
    touched = [
        [*to_body.multiply(each.point), each.force @ each.normal]
        for each in world.getLastCollisionResult().getContacts()
    ]
    return {"path": path, "contacts": [list(map(float, each)) for each in touched]}


def shape(body, kind, friction):
    """Add a shape to a body."""
    node = body.createShapeNode(kind)
    node.createCollisionAspect()
    node.createDynamicsAspect()
    node.getDynamicsAspect().setFrictionCoeff(friction)
    return node
