"""Rules on what a scene does when it is stepped; each change that they name has been measured."""

import copy
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.advice import either, for_option
from newton_lint.findings import Advice, Change, Finding
from newton_lint.law import EULER, IMPLICITFAST, M
from newton_lint.rest import ON_JOINT, at_rest, is_servo, rest_of, unposed
from newton_lint.scene import HINGE, Scene, changed
from newton_lint.stepped import MOST_DOFS, Run, contact_forces, free_joints, run_of

# Speed that contacts can't give a body that lies or falls, and share of it that is left where a change mends it.
THROWN_M_S = 0.5
CALMER = 0.5
# Overlap at the start from which it is looked at, also as a share of the smaller geom.
OVERLAP_M = 1e-3
OVERLAP_SHARE = 0.05
# Times the weight of all from which a force in a robot is out of proportion, and steps that use up all iterations.
FORCE = 100.0
LIMITED = 0.5
# What more iterations have to change for their number to be a finding: depth and share, or 100 times that in m/s.
DIFFERS_M = 1e-3
DIFFERS = 0.1
# Speed from which a joint sags [m/s or rad/s], share of frictionloss that holds, and of the predicted speed.
SAG = 5e-3
HELD = 0.99
AGREES = 0.7
DRY_FRICTION = int(mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF)
Way = tuple[MjModel, dict[str, str], str]
"""A changed model, what of the change are options, and the rest of it in words."""
ITERATED = ("solver", "thrown", "unstable")
EFFECTS = ("depth", "equality", "limit", "servo", "tunnel")
BASE = "on a base that moves MuJoCo leaves this contact out"
"""Said of links of a piece, as a gripper or the base of a URDF, that is fixed to the world by itself alone."""
HELD_S = 2.0
"""Time for which a change has to hold, from each start, before it is said to mend what blows up."""


def stepped(scene: Scene, runs: Sequence[Run]) -> list[Finding]:
    """Return what the runs show: what blows up, is thrown, overlaps, is pressed too hard or is not solved."""
    findings: dict[tuple, Finding] = {}
    if not runs:
        return [
            Finding(
                "unstepped",
                "",
                "nv",
                float(scene.model.nv),
                f"move, and more than {MOST_DOFS} are not stepped",
                severity="note",
            )
        ]
    for index, run in enumerate(runs):
        rest = None if run.bad else rest_of(scene.model, run.data, run.start)
        ill_posed = list(unposed(scene.model, run.start))
        is_idle = run.start.name == "the start" and bool(scene.model.nkey or ill_posed)
        items = [
            *ill_posed,
            *_unstable(scene, runs[index:]),
            *_overlapping(scene, run),
            *_sagging(scene, run),
        ]
        items += at_rest(scene, run, rest) if rest else ()
        # What the solver leaves overlapping is no fault of the places, nor what an overlap jams one of what gives.
        unsolved = any(
            "iterations=" in str(item.advice) for item in items if item.rule in ITERATED
        )
        overlaps = (item for item in items if item.rule == "overlap")
        jammed = any(
            item.severity == "warning" or BASE in item.message for item in overlaps
        )
        effects = ("overlap",) * unsolved + EFFECTS * jammed
        for item in items:
            is_note = (
                item.rule in effects
                or BASE in item.message
                or (is_idle and item.rule not in ITERATED)
            )
            finding = replace(item, severity="note") if is_note else item
            key = (item.rule, item.shape, item.against)
            findings[key] = max(
                findings.get(key, finding),
                finding,
                key=lambda item: (item.severity != "note", item.value),
            )
    return list(findings.values())


def _ways(scene: Scene, data: MjData, limited: bool) -> Iterator[Way]:
    """Yield changes that may calm a scene: options, then what servos bear whose force turns too fast for the step."""
    model = scene.model
    half = 0.5 * scene.model.opt.timestep
    if limited:
        more = max(3, 10 * model.opt.iterations)
        yield changed(model, iterations=more), {"iterations": str(more)}, ""
    # Euler integrates what depends on velocity explicitly, but for the damping of joints.
    implicit = {"integrator": "implicitfast"} if model.opt.integrator == EULER else {}
    if implicit:
        yield changed(model, integrator=IMPLICITFAST), implicit, ""
    stiff = _stiff(model, data)
    for what in ("kv", "kp", "armature") if stiff else ():
        after = (
            changed(model, integrator=IMPLICITFAST)
            if implicit and what == "kv"
            else copy.copy(model)
        )
        yield after, implicit if what == "kv" else {}, _calmed(after, stiff, what)
    yield changed(model, timestep=half), {"timestep": f"{half:g}"}, ""
    yield (
        changed(model, timestep=0.5 * half),
        {},
        f"a quarter of the time step, {0.5 * half:g},",
    )


def _stiff(model: MjModel, data: MjData) -> list[tuple[int, int, float, float]]:
    """Return servos with kp h²/m beyond 1, with their dof, that number, and the mass m [kg or kg m²] of the dof.

    Implicit integrators bear 4 + 2 kv h/m, with any kp from kv = kp h/2 on; Euler 4 - 2 kv h/m.
    """
    mujoco.mj_forward(model, data)
    stiff = []
    unit = np.zeros((1, model.nv))
    moved = np.zeros((1, model.nv))
    for servo in np.flatnonzero(is_servo(model)).tolist():
        dof = int(model.jnt_dofadr[model.actuator_trnid[servo, 0]])
        unit[:] = 0.0
        unit[0, dof] = 1.0
        mujoco.mj_solveM(model, data, moved, unit)
        mass = 1.0 / max(moved[0, dof], mujoco.mjMINVAL)
        pull = model.actuator_gainprm[servo, 0] * model.actuator_gear[servo, 0] ** 2
        if (ratio := pull * model.opt.timestep**2 / mass) > 1.0:
            stiff.append((servo, dof, ratio, mass))
    return stiff


def _calmed(
    model: MjModel, stiff: Sequence[tuple[int, int, float, float]], what: str
) -> str:
    """Change what is too stiff, and say how: damping with which implicitfast bears it, or kp or inertia that any do."""
    texts = []
    more = ""
    for servo, dof, ratio, mass in stiff:
        if what == "kv":
            value = model.actuator_gainprm[servo, 0] * model.opt.timestep
            model.actuator_biasprm[servo, 2] = -value
        elif what == "kp":
            model.actuator_gainprm[servo, 0] /= ratio
            model.actuator_biasprm[servo, 1:3] /= ratio
            value = model.actuator_gainprm[servo, 0]
            less = -model.actuator_biasprm[servo, 2]
            more = f' kv="{less:.3g}"' if less else ""
        else:
            model.dof_armature[dof] += (ratio - 1.0) * mass
            value = model.dof_armature[dof]
        texts.append(
            f'{what}="{value:.3g}"{more} on {model.joint(model.dof_jntid[dof]).name or f"dof {dof}"}'
        )
    return ", ".join(texts)


def _unstable(scene: Scene, runs: Sequence[Run]) -> Iterator[Finding]:
    """Yield what blows up, is thrown or is not solved in the first of the runs; the others follow it."""
    run = runs[0]
    model = scene.model
    opt = scene.model.opt
    fast = run.thrown_m_s.max(initial=0.0)
    begin = run.start.data(model)

    def mended(good: Callable[[Run], bool], time_s: float = HELD_S) -> Advice | None:
        """Return the change that leaves a good run of some time from each start."""
        advices: list[Advice] = []
        for after, options, text in _ways(scene, begin, run.at_limit > LIMITED):
            others = runs[:1] if time_s < HELD_S else runs
            tried = (run_of(after, other.start, time_s) for other in others)
            if all(good(again) and again.time_s > 0.99 * time_s for again in tried):
                calms = "calms it, measured over 2 s"
                advices.append(
                    for_option(scene, options, f"{text} {calms}" if text else calms)
                )
        return either(*advices[:3]) if advices else None

    if run.bad:
        advice = mended(lambda after: not after.bad)
        message = f"after {run.time_s:.3g} s from {run.start} accelerations become infinite, and MuJoCo starts anew"
        for servo, _, ratio, _ in _stiff(model, begin)[:1]:
            name = (
                model.actuator(servo).name
                or model.joint(model.actuator_trnid[servo, 0]).name
            )
            bears = "4 - 2 kv·h/m" if opt.integrator == EULER else "4 + 2 kv·h/m"
            message += f": servo {name} has a kp·h²/m of {ratio:.3g}, and the step bears {bears}"
        element = advice.changes[0].element if advice and advice.changes else None
        yield Finding(
            "unstable",
            "",
            "",
            run.time_s,
            message,
            severity="error",
            element=element,
            advice=advice,
        )
    elif fast > THROWN_M_S and mended(
        lambda after: after.thrown_m_s.max() < CALMER * fast, run.time_s
    ):
        body = model.jnt_bodyid[free_joints(model)[int(run.thrown_m_s.argmax())]]
        yield Finding(
            "thrown",
            scene.bodies[body],
            "speed",
            fast,
            f"is what contacts throw it off with from {run.start}, and nothing else drives it",
            unit="m/s",
            severity="error",
            advice=mended(
                lambda after: not after.bad and after.thrown_m_s.max() < CALMER * fast
            ),
        )
    elif run.at_limit > LIMITED and opt.iterations:
        more = str(max(3, 10 * opt.iterations))
        after = run_of(changed(model, iterations=int(more)), run.start, run.time_s)
        calmer = np.max(run.speeds_m_s - after.speeds_m_s, initial=0.0)
        if (
            run.deepest_m - after.deepest_m > max(DIFFERS_M, DIFFERS * run.deepest_m)
            or calmer > 100.0 * DIFFERS_M
        ):
            gain = f"deepest contact {M * run.deepest_m:.3g} → {M * after.deepest_m:.3g} mm"
            yield Finding(
                "solver",
                "",
                "iterations",
                float(opt.iterations),
                f"are used up in {run.at_limit:.0%} of the steps from {run.start}, and contacts are not solved",
                element=scene.source.option("iterations"),
                advice=for_option(scene, {"iterations": more}, gain),
            )


def _overlapping(scene: Scene, run: Run) -> Iterator[Finding]:
    """Yield bodies that overlap at the start: as a warning where they are still jammed or thrown apart by it."""
    model = scene.model
    body_of = scene.model.geom_bodyid
    touching = np.sort(body_of[run.data.contact.geom], axis=1)
    forces = contact_forces(model, run.data, range(len(touching)))[:, 0] * (
        0.0 if run.bad else 1.0
    )
    fast = dict(
        zip(
            model.jnt_bodyid[free_joints(model)].tolist(),
            run.thrown_m_s.tolist(),
            strict=True,
        )
    )
    weight = model.body_mass.sum() * np.linalg.norm(model.opt.gravity)
    root = scene.source.root
    is_piece = (root is not None and root.tag == "robot") or len(
        {*model.body_rootid[body_of].tolist()}
    ) == 1
    worst: dict[tuple[int, int], tuple[float, tuple[int, int]]] = {}
    for pair, depth in run.first.items():
        sizes = [
            model.geom_rbound[geom] for geom in pair if model.geom_rbound[geom] > 0.0
        ]
        if depth > max(OVERLAP_M, OVERLAP_SHARE * min(sizes, default=0.0)):
            bodies = min(body_of[list(pair)]), max(body_of[list(pair)])
            worst[bodies] = max(worst.get(bodies, (0.0, pair)), (depth, pair))
    loose = (bodies for bodies in worst if scene.free[list(bodies)].all())
    # A heap of loose bodies is for code to scatter: one pair stands for all.
    heap = sorted(
        loose,
        key=lambda bodies: (
            max(fast.get(int(body), 0.0) for body in bodies),
            worst[bodies],
        ),
    )
    for bodies, (depth, pair) in worst.items():
        if bodies in heap[:-1]:
            continue
        force = forces[(touching == bodies).all(axis=1)].sum()
        jammed = weight > 0.0 and force > FORCE * weight
        thrown = max(fast.get(int(model.body_weldid[body]), 0.0) for body in bodies)
        hard = jammed or run.bad or thrown > THROWN_M_S
        one_tree = model.body_rootid[bodies[0]] == model.body_rootid[
            bodies[1]
        ] or not any(scene.free[list(bodies)])
        names = [scene.bodies[body] for body in bodies]
        margin = (
            " with their margin"
            if model.geom_margin[list(pair)].any() or model.pair_margin.any()
            else ""
        )
        more = f" (the fastest of {len(heap)} pairs)" if bodies in heap[1:] else ""
        message = f"is how deep they overlap{margin} at {run.start}{more}"
        if jammed:
            message += f": {force:.3g} N press them apart, {force / weight:.3g} times the weight of all that moves"
        elif thrown > THROWN_M_S:
            message += f": it throws them apart at {thrown:.2g} m/s"
        first, second = model.body_weldid[list(bodies)].tolist()
        if (
            is_piece and first == 0 == model.body_weldid[model.body_parentid[second]]
        ):  # filterBodyPair
            message += f"; {BASE}"
        exclude = Advice(
            f'<exclude body1="{names[0]}" body2="{names[1]}"/> in <contact> lets them pass through each other',
            (Change("exclude", (("body1", names[0]), ("body2", names[1]))),),
        )
        apart = Advice(
            f"{margin and 'lower the margin, or '}move one by {M * depth:.3g} mm"
        )
        shape, partner = (scene.names[geom] for geom in pair)
        yield Finding(
            "overlap",
            shape,
            "overlap",
            M * depth,
            message,
            (partner,),
            None,
            "mm",
            "warning" if hard else "note",
            scene.source.geom(pair[1]) or scene.source.geom(pair[0]),
            exclude if one_tree else apart,
        )


def _sagging(scene: Scene, run: Run) -> Iterator[Finding]:
    """Yield joints that dry friction holds, and that creep as contacts do."""
    model = scene.model
    sags = _sags(model, run)
    later = (
        _sags(model, run_of(model, run.start, HELD_S)) if sags else {}
    )  # what a weld draws to its place rests
    for dof, rate in sags.items():
        if later.get(dof, 0.0) <= AGREES * rate:
            continue
        joint = model.joint(model.dof_jntid[dof])
        unit, scale = (
            ("°/s", math.degrees(1.0)) if joint.type[0] == HINGE else ("mm/s", M)
        )
        advice = Advice(
            gain := 'solimpfriction="0.999 0.999 0.001" on the joint slows it 100 times'
        )
        if scene.engine.name == "mujoco":
            again = run_of(changed(model, noslip_iterations=10), run.start, run.time_s)
            after = _sags(model, again).get(dof, 0.0)
            slower = f"{scale * rate:.3g} → {scale * after:.3g} {unit}, in MuJoCo C"
            advice = for_option(
                scene,
                {"noslip_iterations": "10"},
                f"{slower}; or {gain}, in all engines",
            )
        bears = f"{abs(run.data.qfrc_bias[dof]):.3g} of the {model.dof_frictionloss[dof]:.3g}"
        yield Finding(
            "sag",
            joint.name or f"joint_{joint.id}",
            "speed",
            scale * rate,
            f"is how fast it gives way to {bears} that frictionloss can bear, from {run.start}, at any impratio",
            unit=unit,
            advice=advice,
        )


def _sags(model: MjModel, run: Run) -> dict[int, float]:
    """Return speeds of joints that move as fast as their friction gives way to less than it can bear [m/s or rad/s]."""
    data = run.data
    speeds = {}
    driven = model.jnt_dofadr[
        model.actuator_trnid[model.actuator_trntype == ON_JOINT, 0]
    ]
    for row in (
        () if run.bad else np.flatnonzero(data.efc_type == DRY_FRICTION).tolist()
    ):
        dof = int(data.efc_id[row])
        force = max(abs(data.efc_force[row]), mujoco.mjMINVAL)
        rate = abs(data.qvel[dof])
        gives = data.efc_R[row] * force / data.efc_KBIP[row, 1]
        ratios = (
            rate / gives,
            *(
                abs(load[dof]) / force
                for load in (data.qfrc_bias, data.qfrc_constraint)
            ),
        )
        is_held = (
            rate > SAG
            and force < HELD * model.dof_frictionloss[dof]
            and dof not in driven
        )
        if is_held and min(ratios) > AGREES and max(ratios) < 1.0 / AGREES:
            speeds[dof] = rate
    return speeds
