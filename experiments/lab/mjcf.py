"""Write a compiled model of the shake as MJCF, without rounding its numbers.

Engines that read only MJCF can then run it.
"""

from xml.etree.ElementTree import Element, SubElement, tostring

import mujoco
import numpy as np

JOINTS = ("free", "ball", "slide", "hinge")
GEOMS = {
    int(mujoco.mjtGeom.mjGEOM_PLANE): "plane",
    int(mujoco.mjtGeom.mjGEOM_BOX): "box",
}
CONES = ("pyramidal", "elliptic")
INTEGRATORS = ("Euler", "RK4", "implicit", "implicitfast")
SOLVERS = ("PGS", "CG", "Newton")


def mjcf_of(model: mujoco.MjModel, sites: dict[str, tuple[int, np.ndarray]]) -> str:
    """Return the MJCF of a model with position actuators.

    The model has boxes and planes on hinges, slides and free joints.

    Args:
        sites: Body and pose of each additional site by name. A pose has a position [m]
            and a quaternion (w, x, y, z), shape [7].
    """
    root = Element("mujoco", model="shake")
    SubElement(root, "compiler", angle="radian", autolimits="false")
    _add_option(root, model)
    bodies = {0: SubElement(root, "worldbody")}
    for body in range(model.nbody):
        if body:
            bodies[body] = _add_body(bodies[model.body_parentid[body]], model, body)
        for name, (of, pose) in sites.items():
            if of == body:
                SubElement(
                    bodies[body],
                    "site",
                    name=name,
                    pos=_text(pose[:3]),
                    quat=_text(pose[3:]),
                )
        first, count = model.body_geomadr[body], model.body_geomnum[body]
        for geom in range(first, first + count):
            _add_geom(bodies[body], model, geom)
    _add_excluded(SubElement(root, "contact"), model)
    _add_equalities(SubElement(root, "equality"), model)
    _add_actuators(SubElement(root, "actuator"), model)
    return tostring(root, encoding="unicode")


def _text(numbers) -> str:
    return " ".join(repr(float(number)) for number in np.atleast_1d(numbers))


def _switch(flag) -> str:
    return "true" if flag else "false"


def _add_option(root: Element, model: mujoco.MjModel) -> None:
    opt = model.opt
    numbers = (
        "timestep",
        "gravity",
        "impratio",
        "tolerance",
        "ls_tolerance",
        "ccd_tolerance",
    )
    option = SubElement(
        root, "option", {name: _text(getattr(opt, name)) for name in numbers}
    )
    option.set("cone", CONES[opt.cone])
    option.set("integrator", INTEGRATORS[opt.integrator])
    option.set("solver", SOLVERS[opt.solver])
    option.set("iterations", str(opt.iterations))
    option.set("ls_iterations", str(opt.ls_iterations))
    SubElement(option, "flag", multiccd="disable")


def _add_body(parent: Element, model: mujoco.MjModel, body: int) -> Element:
    pose = {"pos": _text(model.body_pos[body]), "quat": _text(model.body_quat[body])}
    name = model.body(body).name
    element = SubElement(
        parent, "body", pose, name=name, gravcomp=_text(model.body_gravcomp[body])
    )
    inertia = {
        "pos": _text(model.body_ipos[body]),
        "quat": _text(model.body_iquat[body]),
    }
    mass = {
        "mass": _text(model.body_mass[body]),
        "diaginertia": _text(model.body_inertia[body]),
    }
    SubElement(element, "inertial", inertia | mass)
    first, count = model.body_jntadr[body], model.body_jntnum[body]
    for joint in range(first, first + count):
        _add_joint(element, model, joint)
    return element


def _add_joint(body: Element, model: mujoco.MjModel, joint: int) -> None:
    name, kind = model.joint(joint).name, JOINTS[model.jnt_type[joint]]
    if kind == "free":
        SubElement(body, "freejoint", name=name)
        return
    dof, coordinate = model.jnt_dofadr[joint], model.jnt_qposadr[joint]
    SubElement(
        body,
        "joint",
        name=name,
        type=kind,
        pos=_text(model.jnt_pos[joint]),
        axis=_text(model.jnt_axis[joint]),
        ref=_text(model.qpos0[coordinate]),
        limited=_switch(model.jnt_limited[joint]),
        range=_text(model.jnt_range[joint]),
        solreflimit=_text(model.jnt_solref[joint]),
        solimplimit=_text(model.jnt_solimp[joint]),
        margin=_text(model.jnt_margin[joint]),
        stiffness=_text(np.ravel(model.jnt_stiffness[joint])[0]),
        springref=_text(model.qpos_spring[coordinate]),
        armature=_text(model.dof_armature[dof]),
        damping=_text(np.ravel(model.dof_damping[dof])[0]),
        frictionloss=_text(model.dof_frictionloss[dof]),
        actuatorgravcomp=_switch(model.jnt_actgravcomp[joint]),
        actuatorfrclimited=_switch(model.jnt_actfrclimited[joint]),
        actuatorfrcrange=_text(model.jnt_actfrcrange[joint]),
    )


def _add_geom(body: Element, model: mujoco.MjModel, geom: int) -> None:
    numbers = (
        "size",
        "pos",
        "quat",
        "friction",
        "solmix",
        "solref",
        "solimp",
        "margin",
        "gap",
    )
    counts = ("contype", "conaffinity", "condim", "priority")
    element = SubElement(
        body,
        "geom",
        {name: _text(getattr(model, f"geom_{name}")[geom]) for name in numbers},
    )
    for name in counts:
        element.set(name, str(getattr(model, f"geom_{name}")[geom]))
    element.set("name", model.geom(geom).name)
    element.set("type", GEOMS[model.geom_type[geom]])
    element.set("mass", "0")


def _add_excluded(contact: Element, model: mujoco.MjModel) -> None:
    for signature in model.exclude_signature.tolist():
        pair = (model.body(body).name for body in (signature >> 16, signature & 0xFFFF))
        SubElement(contact, "exclude", dict(zip(("body1", "body2"), pair, strict=True)))


def _add_equalities(equality: Element, model: mujoco.MjModel) -> None:
    # Newton 1.8 adds welds to the world that are inactive.
    for index in np.flatnonzero(model.eq_active0):
        joints = (model.eq_obj1id[index], model.eq_obj2id[index])
        names = (model.joint(joint).name for joint in joints)
        element = SubElement(
            equality, "joint", dict(zip(("joint1", "joint2"), names, strict=True))
        )
        element.set("polycoef", _text(model.eq_data[index][:5]))
        element.set("solref", _text(model.eq_solref[index]))
        element.set("solimp", _text(model.eq_solimp[index]))


def _add_actuators(actuators: Element, model: mujoco.MjModel) -> None:
    for index in range(model.nu):
        SubElement(
            actuators,
            "general",
            joint=model.joint(model.actuator_trnid[index, 0]).name,
            gainprm=_text(model.actuator_gainprm[index]),
            biastype="affine",
            biasprm=_text(model.actuator_biasprm[index]),
            gear=_text(model.actuator_gear[index]),
            ctrllimited="false",
            forcelimited="false",
        )
