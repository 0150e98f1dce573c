"""Rules on what a scene does when it is stepped; each change that they name has been measured."""

import contextlib
import math
from collections.abc import Callable, Iterator, Sequence

import mujoco
import numpy as np

from newton_lint.advice import for_option
from newton_lint.findings import Advice, Change, Finding
from newton_lint.law import EULER, IMPLICITFAST, M
from newton_lint.pairs import HFIELD, PLANE
from newton_lint.scene import Scene
from newton_lint.stepped import MOST_DOFS, Run, changed, contact_forces, free_joints, run, starts
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
MANY, FEW = 1000, 64
"""Vertices of a convex hull that are many, and as many as do."""
HINGE, MESH = int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtGeom.mjGEOM_MESH)
DRY_FRICTION = int(mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF)
Way = tuple[dict[str, float], dict[str, str]]
"""Options of the model, and how they are written."""


def stepped(scene: Scene, target: Target, runs: Sequence[Run]) -> list[Finding]:
    """Return what the runs show: what blows up, is thrown, overlaps, is pressed too hard or is not solved."""
    found: dict[tuple, Finding] = {}
    if not runs:
        message = f"move, and more than {MOST_DOFS} are not stepped"
        return [Finding("unstepped", "", (), "nv", float(scene.model.nv), None, "1", message, "note")]
    for index, each in enumerate(runs):
        overlaps = _overlapping(scene, each, len(runs) > 1)
        sags = _sagging(scene, target, each, index)
        for finding in (*_unstable(scene, target, each, index), *overlaps, *_sunk(scene, each), *sags):
            found.setdefault((finding.rule, finding.shape, finding.against), finding)
    return [*found.values(), *_hulls(scene, target, runs[0])]


def _again(target: Target, model: mujoco.MjModel, index: int, time_s: float) -> Run:
    name, data = list(starts(model, target))[index]
    return run(model, data, name, time_s)


def _unstable(scene: Scene, target: Target, seen: Run, index: int) -> Iterator[Finding]:
    model, opt = scene.model, scene.model.opt
    half = 0.5 * opt.timestep
    more = {"iterations": max(3, 10 * opt.iterations)}
    ways: list[Way] = [(more, {"iterations": str(more["iterations"])})] if seen.at_limit > LIMITED else []
    ways += [({"integrator": IMPLICITFAST}, {"integrator": "implicitfast"})] if opt.integrator == EULER else []
    ways += [({"timestep": half}, {"timestep": f"{half:g}"}), ({"timestep": 0.25 * opt.timestep}, {})]
    fast = float(seen.thrown_m_s.max(initial=0.0))

    def mended(good: Callable[[Run], bool]) -> Advice | None:
        for options, said in ways:
            if good(_again(target, changed(model, **options), index, seen.time_s)):
                gain = "measured: that calms it" if said else "a quarter of the time step does: contacts are too stiff"
                return for_option(scene, said, gain)
        return None

    if seen.bad:
        advice = mended(lambda after: not after.bad)
        message = f"is the engine's warning after {seen.time_s:.3g} s from {seen.start}: the simulation blows up"
        element = advice.changes[0].element if advice and advice.changes else None
        yield Finding("unstable", "", (), seen.bad, 1.0, None, "1", message, "error", element, advice)
    elif fast > THROWN_M_S and (advice := mended(lambda after: after.thrown_m_s.max() < CALMER * fast)):
        body = scene.bodies[model.jnt_bodyid[free_joints(model)[int(seen.thrown_m_s.argmax())]]]
        message = f"is what contacts throw it off with from {seen.start}, and nothing else drives it"
        yield Finding("thrown", body, (), "speed", fast, None, "m/s", message, "error", None, advice)
    elif seen.at_limit > LIMITED and opt.iterations:
        after = _again(target, changed(model, **more), index, seen.time_s)
        calmer = float(np.max(seen.speeds_m_s - after.speeds_m_s, initial=0.0))
        if seen.deepest_m - after.deepest_m > DIFFERS_M or calmer > 100.0 * DIFFERS_M:
            message = f"are used up in {seen.at_limit:.0%} of the steps from {seen.start}, and contacts are not solved"
            gain = f"deepest contact {M * seen.deepest_m:.3g} → {M * after.deepest_m:.3g} mm"
            advice = for_option(scene, ways[0][1], gain)
            element = scene.source.option("iterations")
            yield Finding(
                *("solver", "", (), "iterations", float(opt.iterations), None, "1", message, "warning", element, advice)
            )


def _overlapping(scene: Scene, seen: Run, has_keyframes: bool) -> Iterator[Finding]:
    """Yield bodies that overlap at the start: as a warning where they are still jammed or thrown apart by it."""
    model, body = scene.model, scene.model.geom_bodyid
    touching = np.sort(body[seen.data.contact.geom], axis=1)
    forces = contact_forces(model, seen.data, range(len(touching)))[:, 0] * (0.0 if seen.bad else 1.0)
    fast = dict(zip(model.jnt_bodyid[free_joints(model)].tolist(), seen.thrown_m_s.tolist(), strict=True))
    weight = float(model.body_mass.sum() * np.linalg.norm(model.opt.gravity))
    worst: dict[tuple[int, int], tuple[float, tuple[int, int]]] = {}
    for pair, depth in seen.first.items():
        sizes = [model.geom_rbound[geom] for geom in pair if model.geom_rbound[geom] > 0.0]
        if depth > max(OVERLAP_M, OVERLAP_SHARE * min(sizes, default=0.0)):
            bodies = min(body[list(pair)]), max(body[list(pair)])
            worst[bodies] = max(worst.get(bodies, (0.0, pair)), (depth, pair))
    for bodies, (depth, pair) in worst.items():
        force = float(forces[(touching == bodies).all(axis=1)].sum())
        jammed = weight > 0.0 and force > FORCE * weight
        thrown = max(fast.get(int(model.body_weldid[each]), 0.0) for each in bodies)
        hard = jammed or bool(seen.bad) or thrown > THROWN_M_S
        one_tree = model.body_rootid[bodies[0]] == model.body_rootid[bodies[1]] or not any(scene.free[list(bodies)])
        names = [scene.bodies[each] for each in bodies]
        margin = " with their margin" if model.geom_margin[list(pair)].any() or model.pair_margin.any() else ""
        message = f"is how deep they overlap{margin} at {seen.start}"
        if jammed:
            message += f": {force:.3g} N press them apart, {force / weight:.3g} times the weight of all that moves"
        elif thrown > THROWN_M_S:
            message += f": it throws them apart at {thrown:.2g} m/s"
        own = f'<exclude body1="{names[0]}" body2="{names[1]}"/> in <contact> lets them pass through each other'
        exclude = Advice((Change("exclude", (("body1", names[0]), ("body2", names[1]))),), own)
        advice = exclude if one_tree else Advice((), f"move one by {M * depth:.3g} mm")
        is_note = not hard or (has_keyframes and seen.start == "the start")
        geoms = [scene.names[geom] for geom in pair]
        yield Finding(
            *("overlap", geoms[0], (geoms[1],), "overlap", M * depth, None, "mm", message),
            severity="note" if is_note else "warning",
            element=scene.source.geom(pair[1]) or scene.source.geom(pair[0]),
            advice=advice,
        )


def _sunk(scene: Scene, seen: Run) -> Iterator[Finding]:
    """Yield what lies and is pressed in by a share of its thickness, as what bears far more than its own weight is."""
    model, data = scene.model, seen.data
    sizes = np.where(model.geom_size > 0.0, model.geom_size, np.inf).min(axis=1)
    sizes[np.isin(model.geom_type, (PLANE, HFIELD))] = np.inf
    speeds = np.linalg.norm(data.cvel[:, 3:], axis=1)
    for index, (pair, distance) in enumerate(zip(data.contact.geom.tolist(), data.contact.dist.tolist(), strict=True)):
        moves = 0.5 * seen.time_s * max(speeds[model.geom_bodyid[pair]])
        rests = not seen.bad and min(pair) >= 0 and moves < -distance
        thin, other = sorted(pair, key=lambda geom: sizes[geom])
        if rests and -distance > SUNK * sizes[thin] and -distance > 2.0 * seen.first.get(tuple(pair), 0.0):
            newtons, after = float(contact_forces(model, data, [index])[0, 0]), f"{seen.time_s:.2g} s from {seen.start}"
            message = f"is how deep {newtons:.3g} N on a point press it in after {after}: a contact is only as stiff "
            told = ("depth", scene.names[thin], (scene.names[other],), "depth", -M * distance, None, "mm")
            advice = Advice((), "a shorter timeconst, a solimp nearer to 1, or masses nearer to each other")
            element = scene.source.geom(thin)
            yield Finding(*told, f"{message}as its lighter body is heavy", "note", element, advice)


def _sagging(scene: Scene, target: Target, seen: Run, index: int) -> Iterator[Finding]:
    """Yield joints that dry friction holds, and that creep as contacts do."""
    model = scene.model
    for dof, rate in _sags(model, seen).items():
        joint = model.joint(model.dof_jntid[dof])
        unit, scale = ("°/s", math.degrees(1.0)) if joint.type[0] == HINGE else ("mm/s", M)
        advice = Advice((), gain := 'solimpfriction="0.999 0.999 0.001" on the joint slows it 100 times')
        if scene.engine.name == "mujoco":
            after = _sags(model, _again(target, changed(model, noslip_iterations=10), index, seen.time_s)).get(dof, 0.0)
            said = f"{scale * rate:.3g} → {scale * after:.3g} {unit}, in MuJoCo C"
            advice = for_option(scene, {"noslip_iterations": "10"}, f"{said}; or {gain}, in all engines")
        bears = f"{abs(seen.data.qfrc_bias[dof]):.3g} of the {model.dof_frictionloss[dof]:.3g}"
        message = f"is how fast it gives way to {bears} that frictionloss can bear, from {seen.start}, at any impratio"
        told = ("sag", joint.name or f"joint_{joint.id}", (), "speed", scale * rate, None, unit, message)
        yield Finding(*told, advice=advice)


def _sags(model: mujoco.MjModel, seen: Run) -> dict[int, float]:
    """Return speeds of joints that move as fast as their friction gives way to less than it can bear [m/s or rad/s]."""
    data, found = seen.data, {}
    for row in () if seen.bad else np.flatnonzero(data.efc_type == DRY_FRICTION).tolist():
        dof, force = int(data.efc_id[row]), max(abs(float(data.efc_force[row])), mujoco.mjMINVAL)
        rate, gives = abs(float(data.qvel[dof])), float(data.efc_R[row]) * force / float(data.efc_KBIP[row, 1])
        alike = rate / gives, *(abs(float(each[dof])) / force for each in (data.qfrc_bias, data.qfrc_constraint))
        is_held = rate > SAG and force < HELD * model.dof_frictionloss[dof] and not data.qfrc_actuator[dof]
        if is_held and min(alike) > AGREES and max(alike) < 1.0 / AGREES:
            found[dof] = rate
    return found


def _hulls(scene: Scene, target: Target, seen: Run) -> Iterator[Finding]:
    """Yield meshes that collide with more vertices than it takes, and what a step costs with fewer."""
    model = scene.model
    touch = (model.geom_contype | model.geom_conaffinity) != 0
    meshes = sorted({*model.geom_dataid[touch & (model.geom_type == MESH)].tolist()})
    places = {mesh: model.mesh_graphadr[mesh] for mesh in meshes}
    counts = {mesh: int(model.mesh_graph[start]) for mesh, start in places.items() if start >= 0}
    worst = max(counts, key=counts.get, default=-1)
    if counts.get(worst, 0) < MANY or target.path is None:
        return
    with contextlib.suppress(ValueError, AttributeError):  # an old release has no MjSpec that could
        spec = mujoco.MjSpec.from_file(str(target.path))
        for mesh in spec.meshes:
            mesh.maxhullvert = FEW
        after = _again(target, spec.compile(), 0, seen.time_s)
        before_us, after_us = (1e6 * each.cost_s * model.opt.timestep for each in (seen, after))
        message = f"vertices has its convex hull: a step takes {before_us:.3g} µs, and with {FEW} {after_us:.3g} µs"
        told = ("hull", model.mesh(worst).name, (), "hull", counts[worst], None, "1", message, "note")
        yield Finding(*told, advice=Advice((), f'maxhullvert="{FEW}" on its <mesh>'))
