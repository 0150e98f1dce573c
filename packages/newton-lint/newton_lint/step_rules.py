"""Rules on the motion of a stepped scene; each named change is measured."""

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

# Contacts cannot give a resting or falling body this speed.
THROWN_M_S = 0.5
# A change mends a thrown body if less than this share of its speed remains.
CALMER = 0.5
# An overlap at the start is reported from this depth on [m].
OVERLAP_M = 1e-3
# It must also exceed this share of the radius of the smaller geom.
OVERLAP_SHARE = 0.05
# Bodies are jammed if a force exceeds this multiple of the total weight.
FORCE = 100.0
# The solver is at its limit if this share of the steps uses all iterations.
LIMITED = 0.5
# Too few iterations are reported if more of them reduce the depth by this [m], or a
# speed by 100 times as much [m/s].
DIFFERS_M = 1e-3
# The depth must also change by this share.
DIFFERS = 0.1
# A joint sags from this speed on [m/s or rad/s].
SAG = 5e-3
# Its friction force must be below this share of the frictionloss.
HELD = 0.99
# Its speed must be at least this share of the predicted speed.
AGREES = 0.7
DRY_FRICTION = int(mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF)
Way = tuple[MjModel, dict[str, str], str]
"""A changed model, the changed options, and a text for the other changes."""
ITERATED = ("solver", "thrown", "unstable")
EFFECTS = ("depth", "equality", "limit", "servo", "tunnel")
BASE = "MuJoCo ignores this contact if the base can move"
"""Ends a message about a robot or gripper that is fixed to the world by itself."""
HELD_S = 2.0
"""A change mends an unstable scene if the scene is stable for this time."""


def stepped(scene: Scene, runs: Sequence[Run]) -> list[Finding]:
    """Return the findings on runs of a scene from its starts."""
    findings: dict[tuple, Finding] = {}
    if not runs:
        message = (
            f"The scene has {scene.model.nv} degrees of freedom and is not stepped,"
            f" because the limit is {MOST_DOFS}"
        )
        nv = float(scene.model.nv)
        return [Finding("unstepped", "", "nv", nv, message=message, severity="note")]
    for index, run in enumerate(runs):
        rest_state = None if run.bad else rest_of(scene.model, run.data, run.start)
        ill_posed = list(unposed(scene.model, run.start))
        is_idle = run.start.name == "the start" and bool(scene.model.nkey or ill_posed)
        items = [
            *ill_posed,
            *_unstable(scene, runs[index:]),
            *_overlapping(scene, run),
            *_sagging(scene, run),
        ]
        items += at_rest(scene, run, rest_state) if rest_state else ()
        # Overlaps that the solver leaves are not faults of the initial positions, and
        # effects of a jam are not faults of their own.
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
    """Yield changes that may stabilize a scene: options, then servo parameters."""
    model = scene.model
    half = 0.5 * model.opt.timestep
    if limited:
        iterations = max(3, 10 * model.opt.iterations)
        yield changed(model, iterations=iterations), {"iterations": str(iterations)}, ""
    # Euler integrates velocity-dependent forces explicitly, except joint damping.
    implicit = {"integrator": "implicitfast"} if model.opt.integrator == EULER else {}
    if implicit:
        yield changed(model, integrator=IMPLICITFAST), implicit, ""
    stiff = _stiff(model, data)
    for name in ("kv", "kp", "armature") if stiff else ():
        after = (
            changed(model, integrator=IMPLICITFAST)
            if implicit and name == "kv"
            else copy.copy(model)
        )
        yield after, implicit if name == "kv" else {}, _calmed(after, stiff, name)
    yield changed(model, timestep=half), {"timestep": f"{half:g}"}, ""
    shorter = changed(model, timestep=0.5 * half)
    yield shorter, {}, f"a timestep of {0.5 * half:g}"


def _stiff(model: MjModel, data: MjData) -> list[tuple[int, int, float, float]]:
    """Return servos whose kp h²/m is above 1.

    Implicit integrators are stable up to 4 + 2 kv h/m, and with any kp if kv is at
    least kp h/2. Euler is stable up to 4 - 2 kv h/m.

    Returns:
        Servo, dof, kp h²/m, and the mass or inertia m of the dof [kg or kg m²].
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
    model: MjModel, stiff: Sequence[tuple[int, int, float, float]], name: str
) -> str:
    """Change a parameter of stiff servos until the step is stable, and describe it."""
    texts = []
    suffix = ""
    for servo, dof, ratio, mass in stiff:
        if name == "kv":
            value = model.actuator_gainprm[servo, 0] * model.opt.timestep
            model.actuator_biasprm[servo, 2] = -value
        elif name == "kp":
            model.actuator_gainprm[servo, 0] /= ratio
            model.actuator_biasprm[servo, 1:3] /= ratio
            value = model.actuator_gainprm[servo, 0]
            less = -model.actuator_biasprm[servo, 2]
            suffix = f' kv="{less:.3g}"' if less else ""
        else:
            model.dof_armature[dof] += (ratio - 1.0) * mass
            value = model.dof_armature[dof]
        joint = model.joint(model.dof_jntid[dof]).name or f"dof {dof}"
        texts.append(f'{name}="{value:.3g}"{suffix} on {joint}')
    return ", ".join(texts)


def _unstable(scene: Scene, runs: Sequence[Run]) -> Iterator[Finding]:
    """Yield a finding if the first run diverges, throws a body or does not converge.

    Args:
        runs: The run in question, then those from later starts.
    """
    run = runs[0]
    model = scene.model
    opt = model.opt
    fast = run.thrown_m_s.max(initial=0.0)
    begin = run.start.data(model)

    def mended(good: Callable[[Run], bool], time_s: float = HELD_S) -> Advice | None:
        """Return the changes that give a good run of some time from each start."""
        advices: list[Advice] = []
        for after, options, text in _ways(scene, begin, run.at_limit > LIMITED):
            others = runs[:1] if time_s < HELD_S else runs
            tried = (run_of(after, other.start, time_s) for other in others)
            if all(good(again) and again.time_s > 0.99 * time_s for again in tried):
                effect = "calms it (measured, 2 s)"
                if options and text:
                    effect = f"together with {text} {effect}"
                elif text:
                    effect = f"Set {text}: this {effect}"
                advices.append(for_option(scene, options, effect))
        return either(*advices[:3]) if advices else None

    if run.bad:
        advice = mended(lambda after: not after.bad)
        message = (
            f"The simulation blows up after {run.time_s:.3g} s from {run.start.name}:"
            " accelerations become infinite, and MuJoCo resets the state"
        )
        for servo, _, ratio, _ in _stiff(model, begin)[:1]:
            joint = model.joint(model.actuator_trnid[servo, 0])
            name = model.actuator(servo).name or joint.name
            most = "4 - 2 kv·h/m" if opt.integrator == EULER else "4 + 2 kv·h/m"
            message += (
                f"; servo {name} has a kp·h²/m of {ratio:.3g}, and the time step is"
                f" stable only up to {most}"
            )
        element = advice.changes[0].element if advice and advice.changes else None
        yield Finding(
            "unstable",
            "",
            "",
            run.time_s,
            message=message,
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
            message="$shape flies off at $value because contacts throw it"
            f" (from {run.start.name}); nothing else drives it",
            unit="m/s",
            severity="error",
            advice=mended(
                lambda after: not after.bad and after.thrown_m_s.max() < CALMER * fast
            ),
        )
    elif run.at_limit > LIMITED and opt.iterations:
        iterations = str(max(3, 10 * opt.iterations))
        after = run_of(
            changed(model, iterations=int(iterations)), run.start, run.time_s
        )
        calmer = np.max(run.speeds_m_s - after.speeds_m_s, initial=0.0)
        if (
            run.deepest_m - after.deepest_m > max(DIFFERS_M, DIFFERS * run.deepest_m)
            or calmer > 100.0 * DIFFERS_M
        ):
            gain = (
                f"reduces the deepest contact from {M * run.deepest_m:.3g} to"
                f" {M * after.deepest_m:.3g} mm (measured)"
            )
            yield Finding(
                "solver",
                "",
                "iterations",
                float(opt.iterations),
                message=f"The solver uses all $value iterations in {run.at_limit:.0%}"
                f" of the steps from {run.start.name}, so contacts are not solved",
                element=scene.source.option("iterations"),
                advice=for_option(scene, {"iterations": iterations}, gain),
            )


def _overlapping(scene: Scene, run: Run) -> Iterator[Finding]:
    """Yield bodies that overlap at the start.

    It is a warning if they are jammed or thrown apart, otherwise a note.
    """
    model = scene.model
    body_of = model.geom_bodyid
    touching = np.sort(body_of[run.data.contact.geom], axis=1)
    forces = contact_forces(model, run.data, range(len(touching)))[:, 0]
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
    worst: dict[tuple[int, ...], tuple[float, tuple[int, int]]] = {}
    for pair, depth in run.first.items():
        # A plane has the radius 0.
        sizes = filter(None, model.geom_rbound[list(pair)].tolist())
        if depth > max(OVERLAP_M, OVERLAP_SHARE * min(sizes, default=0.0)):
            bodies = tuple(sorted(body_of[list(pair)].tolist()))
            worst[bodies] = max(worst.get(bodies, (0.0, pair)), (depth, pair))
    loose = (bodies for bodies in worst if scene.free[list(bodies)].all())
    # A heap of loose bodies is probably scattered by code, so one pair represents it.
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
        jammed = not run.bad and weight > 0.0 and force > FORCE * weight
        thrown = max(fast.get(int(model.body_weldid[body]), 0.0) for body in bodies)
        hard = jammed or run.bad or thrown > THROWN_M_S
        root1, root2 = model.body_rootid[list(bodies)]
        one_tree = root1 == root2 or not scene.free[list(bodies)].any()
        names = [scene.bodies[body] for body in bodies]
        margin = (
            " including their margin"
            if model.geom_margin[list(pair)].any() or model.pair_margin.any()
            else ""
        )
        suffix = f" (the fastest of {len(heap)} pairs)" if bodies in heap[1:] else ""
        message = f"$shapes and $against overlap by $value{margin} at {run.start.name}{suffix}"
        if jammed:
            message += (
                f"; {force:.3g} N press them apart, {force / weight:.3g} times the"
                " weight of all moving bodies"
            )
        elif thrown > THROWN_M_S:
            message += f"; this throws them apart at {thrown:.2g} m/s"
        first, second = model.body_weldid[list(bodies)].tolist()
        # filterBodyPair
        if is_piece and first == 0 == model.body_weldid[model.body_parentid[second]]:
            message += f"; {BASE}"
        exclude = Advice(
            "lets them pass through each other",
            (Change("exclude", (("body1", names[0]), ("body2", names[1]))),),
        )
        move = "Lower the margin, or move" if margin else "Move"
        separation = Advice(f"{move} one of them by {M * depth:.3g} mm")
        shape, partner = (scene.names[geom] for geom in pair)
        yield Finding(
            "overlap",
            shape,
            "overlap",
            M * depth,
            message=message,
            against=(partner,),
            unit="mm",
            severity="warning" if hard else "note",
            element=scene.source.geom(pair[1]) or scene.source.geom(pair[0]),
            advice=exclude if one_tree else separation,
        )


def _sagging(scene: Scene, run: Run) -> Iterator[Finding]:
    """Yield joints that dry friction should hold, but that creep as contacts do."""
    model = scene.model
    sags = _sags(model, run)
    # A joint that a weld draws to its place comes to rest later.
    later = _sags(model, run_of(model, run.start, HELD_S)) if sags else {}
    for dof, rate in sags.items():
        if later.get(dof, 0.0) <= AGREES * rate:
            continue
        joint = model.joint(model.dof_jntid[dof])
        is_hinge = joint.type[0] == HINGE
        unit = "°/s" if is_hinge else "mm/s"
        scale = math.degrees(1.0) if is_hinge else M
        advice = Advice(
            'Set solimpfriction="0.999 0.999 0.001" on the joint: this slows it about'
            " 100 times in all engines"
        )
        if scene.engine.name == "mujoco":
            again = run_of(changed(model, noslip_iterations=10), run.start, run.time_s)
            after = _sags(model, again).get(dof, 0.0)
            gain = f"reduces it to {scale * after:.3g} {unit} in MuJoCo C (measured)"
            noslip = for_option(scene, {"noslip_iterations": "10"}, gain)
            advice = either(noslip, advice)
        load = abs(run.data.qfrc_bias[dof])
        loss = model.dof_frictionloss[dof]
        yield Finding(
            "sag",
            joint.name or f"joint_{joint.id}",
            "speed",
            scale * rate,
            message=f"$shape sags at $value under a load of {load:.3g} although its"
            f" frictionloss is {loss:.3g} (from {run.start.name}); impratio has no"
            " effect",
            unit=unit,
            advice=advice,
        )


def _sags(model: MjModel, run: Run) -> dict[int, float]:
    """Return the speeds of sagging joints by dof [m/s or rad/s].

    A joint sags if it moves at the speed at which its friction row yields to a force
    that is below its frictionloss.
    """
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
