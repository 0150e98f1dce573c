"""Rules on what a scene does when it is stepped; each change that they name has been measured."""

import contextlib
import copy
import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial

import mujoco
import numpy as np

from newton_lint.advice import either, for_option
from newton_lint.findings import Advice, Change, Finding
from newton_lint.law import EULER, IMPLICITFAST, M, clamped, normal_damping, stiffness
from newton_lint.pairs import HFIELD, PLANE
from newton_lint.rest import WINDOW_S, Rest, at_rest, is_servo, rest_of
from newton_lint.scene import Scene, changed
from newton_lint.scene_rules import WEIGHTLESS
from newton_lint.stepped import MOST_DOFS, Run, contact_forces, free_joints, run_of, starts
from newton_lint.target import Target

THROWN_M_S = 0.5
"""Speed that contacts can't give a body that lies or falls."""
CALMER = 0.5
"""Share of it that is left where a change mends it."""
OVERLAP_M, OVERLAP_SHARE = 1e-3, 0.05
"""Overlap at the start from which it is looked at, also as a share of the smaller geom."""
SUNK = 0.2
"""Share of half its thickness by which what lies is sunk."""
FORCE = 100.0
"""Times the weight of all that moves from which a force between links of one robot is out of proportion."""
LIMITED = 0.5
"""Share of steps in which the solver uses up its iterations."""
DIFFERS_M = 1e-3
"""What more iterations have to change for their number to be a finding: depth, or 100 times that in m/s."""
SAG, HELD, AGREES = 5e-3, 0.99, 0.7
"""Speed from which a joint sags [m/s or rad/s], share of frictionloss that holds, and of the predicted speed."""
MOST_FLYING, MOST_MET, LATEST_S, STOPS_S = 20, 20, 2.0, 0.1
"""Bodies whose flight is followed, geoms ahead of one, how late it may hit, and time in which what it hits stops it."""
MANY, FEW, CHEAPER = 1000, 64, 0.9
"""Vertices of a convex hull that are many, as many as do, and the share of the time that a step then takes."""
HINGE, MESH = int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtGeom.mjGEOM_MESH)
DRY_FRICTION = int(mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF)
Way = tuple[Callable[[mujoco.MjModel], None], dict[str, str], str]
"""A change of the model, what of it are options, and the rest of it in words."""
ITERATED = ("solver", "thrown", "unstable")
HELD_S = 2.0
"""Time for which a change has to hold, from each start, before it is said to mend what blows up."""


def stepped(scene: Scene, target: Target, runs: Sequence[Run]) -> list[Finding]:
    """Return what the runs show: what blows up, is thrown, overlaps, is pressed too hard or is not solved."""
    findings: dict[tuple, Finding] = {}
    if not runs:
        message = f"move, and more than {MOST_DOFS} are not stepped"
        return [Finding("unstepped", "", "nv", float(scene.model.nv), message, severity="note")]
    for index, run in enumerate(runs):
        rest = None if run.bad else rest_of(scene.model, run.data, run.start)
        early = (rule(scene, target, run, index) for rule in (_unstable, _tunnels, _overlapping, _sagging))
        late = (rule(scene, target, run, rest, index) for rule in (_sunk, at_rest) if rest)
        for finding in itertools.chain(*early, *late):
            key = finding.rule, finding.shape, finding.against
            if key not in findings or finding.value > findings[key].value:
                findings[key] = finding
    results = [*findings.values(), *_hulls(scene, target, runs[0])]
    # What the solver leaves overlapping is no fault of the places.
    unsolved = any("iterations=" in str(finding.advice) for finding in results if finding.rule in ITERATED)
    is_effect = {"overlap": unsolved}
    return [replace(item, severity="note") if is_effect.get(item.rule) else item for item in results]


def _again(target: Target, model: mujoco.MjModel, index: int, time_s: float) -> Run:
    name, data = list(starts(model, target))[index]
    return run_of(model, data, name, time_s)


def _ways(scene: Scene, data: mujoco.MjData, limited: bool) -> Iterator[Way]:
    """Yield changes that may calm a scene: options, then what servos bear whose force turns too fast for the step."""
    opt, half = scene.model.opt, 0.5 * scene.model.opt.timestep

    def option(**options: float) -> Callable[[mujoco.MjModel], None]:
        return lambda model: [setattr(model.opt, name, value) for name, value in options.items()] and None

    more = max(3, 10 * opt.iterations)
    if limited:
        yield option(iterations=more), {"iterations": str(more)}, ""
    # Euler integrates what depends on velocity explicitly, but for the damping of joints.
    implicit = {"integrator": "implicitfast"} if opt.integrator == EULER else {}
    if implicit:
        yield option(integrator=IMPLICITFAST), implicit, ""
    stiff = _stiff(scene.model, data)
    for what in ("kv", "kp", "armature") if stiff else ():
        yield partial(_calmer, stiff, what), implicit if what == "kv" else {}, _written(scene.model, stiff, what)
    yield option(timestep=half), {"timestep": f"{half:g}"}, ""
    yield option(timestep=0.5 * half), {}, f"a quarter of the time step, {0.5 * half:g},"


def _stiff(model: mujoco.MjModel, data: mujoco.MjData) -> list[tuple[int, int, float, float]]:
    """Return servos with kp h²/m beyond 1, with their dof, that number, and the mass m [kg or kg m²] of the dof.

    Implicit integrators bear 4 + 2 kv h/m, with any kp from kv = kp h/2 on; Euler 4 - 2 kv h/m.
    """
    mujoco.mj_forward(model, data)
    stiff, unit, moved = [], np.zeros((1, model.nv)), np.zeros((1, model.nv))
    for servo in np.flatnonzero(is_servo(model)).tolist():
        dof = int(model.jnt_dofadr[model.actuator_trnid[servo, 0]])
        unit[:] = 0.0
        unit[0, dof] = 1.0
        mujoco.mj_solveM(model, data, moved, unit)
        mass = 1.0 / max(float(moved[0, dof]), mujoco.mjMINVAL)
        pull = model.actuator_gainprm[servo, 0] * model.actuator_gear[servo, 0] ** 2
        if (ratio := float(pull * model.opt.timestep**2 / mass)) > 1.0:
            stiff.append((servo, dof, ratio, mass))
    return stiff


def _calmer(stiff: Sequence[tuple[int, int, float, float]], what: str, model: mujoco.MjModel) -> None:
    """Change what is too stiff: damping with which implicitfast bears it, or kp or inertia that any bears."""
    for servo, dof, ratio, mass in stiff:
        if what == "kv":
            model.actuator_biasprm[servo, 2] = -model.actuator_gainprm[servo, 0] * model.opt.timestep
        elif what == "kp":
            model.actuator_gainprm[servo, 0] /= ratio
            model.actuator_biasprm[servo, 1:3] /= ratio
        else:
            model.dof_armature[dof] += (ratio - 1.0) * mass
    if what == "kv" and model.opt.integrator == EULER:
        model.opt.integrator = IMPLICITFAST


def _written(model: mujoco.MjModel, stiff: Sequence[tuple[int, int, float, float]], what: str) -> str:
    after = copy.copy(model)
    _calmer(stiff, what, after)
    values = {
        "kv": [-after.actuator_biasprm[servo, 2] for servo, *_ in stiff],
        "kp": [after.actuator_gainprm[servo, 0] for servo, *_ in stiff],
        "armature": [after.dof_armature[dof] for _, dof, *_ in stiff],
    }[what]
    names = [model.joint(model.dof_jntid[dof]).name or f"dof {dof}" for _, dof, *_ in stiff]
    return ", ".join(f'{what}="{value:.3g}" on {name}' for name, value in zip(names[:3], values, strict=False))


def _unstable(scene: Scene, target: Target, run: Run, index: int) -> Iterator[Finding]:
    model, opt = scene.model, scene.model.opt
    fast = float(run.thrown_m_s.max(initial=0.0))
    begins = list(starts(model, target))

    def mended(good: Callable[[Run], bool], time_s: float = HELD_S) -> Advice | None:
        """Return the change that leaves a good run of some time from each start."""
        advices: list[Advice] = []
        for edit, options, text in _ways(scene, begins[index][1], run.at_limit > LIMITED):
            after = copy.copy(model)
            edit(after)
            tried = (
                _again(target, after, other, time_s)
                for other in range(index, index + 1 if time_s < HELD_S else len(begins))
            )
            if all(good(again) and again.time_s > 0.99 * time_s for again in tried):
                calms = "calms it, measured over 2 s"
                advices.append(for_option(scene, options, f"{text} {calms}" if text else calms))
        return either(*advices[:3]) if advices else None

    stiff = _stiff(model, begins[index][1]) if run.bad else []
    if run.bad:
        advice = mended(lambda after: not after.bad)
        message = f"after {run.time_s:.3g} s from {run.start} accelerations become infinite, and MuJoCo starts anew"
        for servo, _, ratio, _ in stiff[:1]:
            name = model.actuator(servo).name or model.joint(model.actuator_trnid[servo, 0]).name
            bears = "4 - 2 kv·h/m" if opt.integrator == EULER else "4 + 2 kv·h/m"
            message += f": servo {name} has a kp·h²/m of {ratio:.3g}, and the step bears {bears}"
        element = advice.changes[0].element if advice and advice.changes else None
        yield Finding("unstable", "", "", run.time_s, message, severity="error", element=element, advice=advice)
    elif fast > THROWN_M_S and mended(lambda after: after.thrown_m_s.max() < CALMER * fast, run.time_s):
        advice = mended(lambda after: not after.bad and after.thrown_m_s.max() < CALMER * fast)
        body = scene.bodies[model.jnt_bodyid[free_joints(model)[int(run.thrown_m_s.argmax())]]]
        message = f"is what contacts throw it off with from {run.start}, and nothing else drives it"
        yield Finding("thrown", body, "speed", fast, message, unit="m/s", severity="error", advice=advice)
    elif run.at_limit > LIMITED and opt.iterations:
        more = str(max(3, 10 * opt.iterations))
        after = _again(target, changed(model, iterations=int(more)), index, run.time_s)
        calmer = float(np.max(run.speeds_m_s - after.speeds_m_s, initial=0.0))
        if run.deepest_m - after.deepest_m > DIFFERS_M or calmer > 100.0 * DIFFERS_M:
            message = f"are used up in {run.at_limit:.0%} of the steps from {run.start}, and contacts are not solved"
            gain = f"deepest contact {M * run.deepest_m:.3g} → {M * after.deepest_m:.3g} mm"
            advice = for_option(scene, {"iterations": more}, gain)
            element, value = scene.source.option("iterations"), float(opt.iterations)
            yield Finding("solver", "", "iterations", value, message, element=element, advice=advice)


def _overlapping(scene: Scene, target: Target, run: Run, index: int) -> Iterator[Finding]:
    """Yield bodies that overlap at the start: as a warning where they are still jammed or thrown apart by it."""
    model, body_of = scene.model, scene.model.geom_bodyid
    touching = np.sort(body_of[run.data.contact.geom], axis=1)
    forces = contact_forces(model, run.data, range(len(touching)))[:, 0] * (0.0 if run.bad else 1.0)
    fast = dict(zip(model.jnt_bodyid[free_joints(model)].tolist(), run.thrown_m_s.tolist(), strict=True))
    weight = float(model.body_mass.sum() * np.linalg.norm(model.opt.gravity))
    worst: dict[tuple[int, int], tuple[float, tuple[int, int]]] = {}
    for pair, depth in run.first.items():
        sizes = [model.geom_rbound[geom] for geom in pair if model.geom_rbound[geom] > 0.0]
        if depth > max(OVERLAP_M, OVERLAP_SHARE * min(sizes, default=0.0)):
            bodies = min(body_of[list(pair)]), max(body_of[list(pair)])
            worst[bodies] = max(worst.get(bodies, (0.0, pair)), (depth, pair))
    for bodies, (depth, pair) in worst.items():
        force = float(forces[(touching == bodies).all(axis=1)].sum())
        jammed = weight > 0.0 and force > FORCE * weight
        thrown = max(fast.get(int(model.body_weldid[body]), 0.0) for body in bodies)
        hard = jammed or bool(run.bad) or thrown > THROWN_M_S
        one_tree = model.body_rootid[bodies[0]] == model.body_rootid[bodies[1]] or not any(scene.free[list(bodies)])
        names = [scene.bodies[body] for body in bodies]
        margin = " with their margin" if model.geom_margin[list(pair)].any() or model.pair_margin.any() else ""
        message = f"is how deep they overlap{margin} at {run.start}"
        if jammed:
            message += f": {force:.3g} N press them apart, {force / weight:.3g} times the weight of all that moves"
        elif thrown > THROWN_M_S:
            message += f": it throws them apart at {thrown:.2g} m/s"
        gain = f'<exclude body1="{names[0]}" body2="{names[1]}"/> in <contact> lets them pass through each other'
        exclude = Advice((Change("exclude", (("body1", names[0]), ("body2", names[1]))),), gain)
        advice = (
            exclude if one_tree else Advice((), f"{margin and 'lower the margin, or '}move one by {M * depth:.3g} mm")
        )
        # Robots come with a keyframe to start from: qpos0 of their links may overlap.
        severity = "note" if not hard or (model.nkey and run.start == "the start") else "warning"
        shape, partner = (scene.names[geom] for geom in pair)
        element, against = scene.source.geom(pair[1]) or scene.source.geom(pair[0]), (partner,)
        yield Finding("overlap", shape, "overlap", M * depth, message, against, None, "mm", severity, element, advice)


def _sunk(scene: Scene, target: Target, run: Run, rest: Rest, index: int) -> Iterator[Finding]:
    """Yield what lies and is pressed in by a share of its thickness, as what bears far more than its own weight is."""
    model, data, sizes = scene.model, rest.data, _thin(scene.model)
    speeds = np.linalg.norm(data.cvel[:, 3:], axis=1)
    distances = data.contact.dist.tolist()
    for contact, (pair, distance) in enumerate(zip(data.contact.geom.tolist(), distances, strict=True)):
        moves = WINDOW_S * max(speeds[model.geom_bodyid[pair]])
        rests = min(pair) >= 0 and moves < -distance
        thin, partner = sorted(pair, key=lambda geom: sizes[geom])
        if rests and -distance > SUNK * sizes[thin] and -distance > 2.0 * run.first.get(tuple(pair), 0.0):
            newtons = float(contact_forces(model, data, [contact])[0, 0])
            message = f"is how deep {newtons:.3g} N on a point press it in {rest}: a contact is only as stiff "
            message += "as its lighter body is heavy"  # R is of the sum of both body_invweight0
            against, depth, shape = (scene.names[partner],), -M * distance, scene.names[thin]
            advice = Advice((), "a shorter timeconst, a solimp nearer to 1, or masses nearer to each other")
            element = scene.source.geom(thin)
            yield Finding("depth", shape, "depth", depth, message, against, None, "mm", "note", element, advice)


def _thin(model: mujoco.MjModel) -> np.ndarray:
    """Return half the thickness of each geom where it is thinnest; infinite of what has no other side [m]."""
    sizes = np.where(model.geom_size > 0.0, model.geom_size, np.inf).min(axis=1)
    sizes[np.isin(model.geom_type, (PLANE, HFIELD))] = np.inf
    return sizes


def _tunnels(scene: Scene, target: Target, run: Run, index: int) -> Iterator[Finding]:
    """Yield what flies or falls through a geom that is too thin to stop it."""
    model, step_s, sizes = scene.model, scene.model.opt.timestep, _thin(scene.model)
    data = list(starts(model, target))[index][1]
    mujoco.mj_forward(model, data)
    weight = model.opt.gravity * (not model.opt.disableflags & WEIGHTLESS)
    for body in model.jnt_bodyid[free_joints(model)[:MOST_FLYING]].tolist():
        begin, flies = data.xipos[body], data.cvel[body, 3:]
        way = flies if np.linalg.norm(flies) > THROWN_M_S else weight
        ahead = way / max(float(np.linalg.norm(way)), mujoco.mjMINVAL)
        far, pair, geom, wall = _met(scene, data, body, ahead)
        first = float(flies @ ahead)
        speed = math.sqrt(max(first**2 + 2.0 * far * float(weight @ ahead), 0.0))
        time_s = 2.0 * far / max(first + speed, mujoco.mjMINVAL)
        if pair < 0 or time_s > LATEST_S or run.bad:
            continue
        contact, option = scene.contacts.contact(pair), scene.option
        dmax = clamped(contact.solimp[1])
        stiff = stiffness(contact, option, dmax) ** 0.5
        damped = 0.5 * (math.e - 1.0) * normal_damping(contact, option, dmax)
        deep = speed * max(step_s, 0.5 * step_s + 1.0 / max(stiff + damped, mujoco.mjMINVAL))  # within 2 %
        if deep > sizes[wall] + sizes[geom]:
            after = _again(target, model, index, time_s + STOPS_S).data
            moved = after.xipos[body] - begin - after.geom_xpos[wall] + data.geom_xpos[wall]
            if float(moved @ ahead) > far + 2.0 * sizes[wall] + sizes[geom]:
                message = f"takes it through {M * 2.0 * sizes[wall]:.3g} mm, {time_s:.2g} s after {run.start}"
                gain = f"{M * 2.2 * (deep - sizes[geom]):.3g} mm stop it, or a shorter time step and timeconst"
                shape, against, element = scene.names[geom], (scene.names[wall],), scene.source.geom(wall)
                finding = Finding("tunnel", shape, "speed", speed, message, against, None, "m/s", "error", element)
                yield replace(finding, advice=Advice((), gain))


def _met(scene: Scene, data: mujoco.MjData, body: int, ahead: np.ndarray) -> tuple[float, int, int, int]:
    """Return how far ahead of a body the first geom is that it can touch, their pair, the body's geom and that one."""
    body_of, contacts, hit, far = scene.model.geom_bodyid, scene.contacts, np.zeros(1, dtype=np.int32), 0.0
    for _ in range(MOST_MET if ahead.any() else 0):
        more = mujoco.mj_ray(scene.model, data, data.xipos[body] + far * ahead, ahead, None, 1, body, hit)
        if more < 0.0:
            break
        far += more + 1e-9  # mj_ray would hit the same surface again
        for geoms, partners in itertools.permutations((contacts.first, contacts.second)):
            for pair in np.flatnonzero((partners == hit[0]) & (body_of[geoms] == body)).tolist():
                return far, pair, int(geoms[pair]), int(hit[0])
    return far, -1, -1, -1


def _sagging(scene: Scene, target: Target, run: Run, index: int) -> Iterator[Finding]:
    """Yield joints that dry friction holds, and that creep as contacts do."""
    model = scene.model
    for dof, rate in _sags(model, run).items():
        joint = model.joint(model.dof_jntid[dof])
        unit, scale = ("°/s", math.degrees(1.0)) if joint.type[0] == HINGE else ("mm/s", M)
        advice = Advice((), gain := 'solimpfriction="0.999 0.999 0.001" on the joint slows it 100 times')
        if scene.engine.name == "mujoco":
            after = _sags(model, _again(target, changed(model, noslip_iterations=10), index, run.time_s)).get(dof, 0.0)
            slower = f"{scale * rate:.3g} → {scale * after:.3g} {unit}, in MuJoCo C"
            advice = for_option(scene, {"noslip_iterations": "10"}, f"{slower}; or {gain}, in all engines")
        bears = f"{abs(run.data.qfrc_bias[dof]):.3g} of the {model.dof_frictionloss[dof]:.3g}"
        message = f"is how fast it gives way to {bears} that frictionloss can bear, from {run.start}, at any impratio"
        name = joint.name or f"joint_{joint.id}"
        yield Finding("sag", name, "speed", scale * rate, message, unit=unit, advice=advice)


def _sags(model: mujoco.MjModel, run: Run) -> dict[int, float]:
    """Return speeds of joints that move as fast as their friction gives way to less than it can bear [m/s or rad/s]."""
    data, speeds = run.data, {}
    for row in () if run.bad else np.flatnonzero(data.efc_type == DRY_FRICTION).tolist():
        dof, force = int(data.efc_id[row]), max(abs(float(data.efc_force[row])), mujoco.mjMINVAL)
        rate, gives = abs(float(data.qvel[dof])), float(data.efc_R[row]) * force / float(data.efc_KBIP[row, 1])
        ratios = rate / gives, *(abs(float(load[dof])) / force for load in (data.qfrc_bias, data.qfrc_constraint))
        is_held = rate > SAG and force < HELD * model.dof_frictionloss[dof] and not data.qfrc_actuator[dof]
        if is_held and min(ratios) > AGREES and max(ratios) < 1.0 / AGREES:
            speeds[dof] = rate
    return speeds


def _hulls(scene: Scene, target: Target, run: Run) -> Iterator[Finding]:
    """Yield meshes that collide with more vertices than it takes, and what a step costs with fewer."""
    model = scene.model
    touch = (model.geom_contype | model.geom_conaffinity) != 0
    meshes = sorted({*model.geom_dataid[touch & (model.geom_type == MESH)].tolist()})
    graphs = {mesh: model.mesh_graphadr[mesh] for mesh in meshes}
    counts = {mesh: int(model.mesh_graph[start]) for mesh, start in graphs.items() if start >= 0}  # -1: no hull
    worst = max(counts, key=lambda mesh: counts[mesh], default=-1)
    if counts.get(worst, 0) < MANY or target.path is None:
        return
    with contextlib.suppress(ValueError, AttributeError):  # an old release has no MjSpec that could
        spec = mujoco.MjSpec.from_file(str(target.path))
        for mesh in spec.meshes:
            mesh.maxhullvert = FEW
        after = _again(target, spec.compile(), 0, run.time_s)
        before_us, after_us = (1e6 * cost_s * model.opt.timestep for cost_s in (run.cost_s, after.cost_s))
        message = f"vertices has its convex hull: a step takes {before_us:.3g} µs, and with {FEW} {after_us:.3g} µs"
        name, fewer = model.mesh(worst).name, Advice((), f'maxhullvert="{FEW}" on its <mesh>')
        advice = fewer if after_us < CHEAPER * before_us else None
        yield Finding("hull", name, "hull", counts[worst], message, severity="note", advice=advice)
