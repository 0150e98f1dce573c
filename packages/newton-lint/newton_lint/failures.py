"""Rules on scenes that blow up, throw bodies, vibrate or start with overlaps."""

import math
from collections.abc import Iterator

import mujoco
import numpy as np
from mujoco import MjModel

from newton_lint.changes import (
    Change,
    Changes,
    of_contact,
    of_element,
    of_option,
    of_servo,
    text_of,
)
from newton_lint.findings import Finding, number
from newton_lint.law import EULER, M
from newton_lint.ledger import Run, free_joints
from newton_lint.pairs import where
from newton_lint.scene import FREE, ON_JOINT, Scene
from newton_lint.trials import THROWN_M_S, Symptom

LIMITED = 0.5
"""The solver is at its limit if this share of the samples uses all iterations."""
OVERLAP_M = 1e-3
"""An overlap at the start is reported if it is at least this deep."""
OVERLAP_SHARE = 0.05
"""It must also exceed this share of the radius of the smaller geom."""
FORCE = 100.0
"""Bodies are jammed if a force exceeds this multiple of the total weight."""
JITTERS = 0.5
"""Velocities that alternate by more than this are jitter [m/s or rad/s]."""
LIGHT = 0.1
"""An armature is recommended for joints with less mass or inertia [kg or kg m²]."""
BOUNCY = 0.7
"""Contacts below this damping ratio bounce."""
RATTLES_MM_S = 5.0
"""A contact rattles if the geoms still approach or part at this speed."""
MISSES = 5.0
"""A bounce is wrong if the speed of the rebound is wrong by more than this [%]."""
SHORTER = (0.5, 0.25, 0.1)
"""Shares of the time step that are tried."""
ITERATED = ("solver", "thrown", "unstable")
"""Rules that recommend more iterations if the solver is at its limit."""


def unstable(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield a run that diverges, throws a body or does not converge."""
    model = scene.model
    opt = model.opt
    if run.bad:
        why = "accelerations become infinite, and MuJoCo resets the state"
        # A stiff servo is the likely cause, because its limit is known in closed form.
        for servo, _, ratio, mass in _stiff(model, run)[:1]:
            way = 2.0 if opt.integrator == EULER else -2.0
            most = 4.0 + way * model.actuator_biasprm[servo, 2] * opt.timestep / mass
            name = scene.name("actuator", servo)
            why = f"servo {name} has a kv that is too high for an explicit integrator"
            if most > 0.0:
                why = f"servo {name} has a kp·h²/m of {number(ratio)}, and only values"
                why += f" below {number(most)} are stable"
        finding = Finding(
            "unstable",
            "",
            "",
            run.time_s,
            f"The simulation blows up within {run.time_s:.3g} s"
            f" from {run.start.name} because {why}",
            severity="error",
        )
        yield Symptom(finding, lambda run: float(run.bad), list(_calming(scene, run)))
        return
    fast = run.thrown_m_s.max(initial=0.0)
    if fast > THROWN_M_S:
        joint = free_joints(model)[run.thrown_m_s.argmax()]
        yield Symptom(
            Finding(
                "thrown",
                scene.bodies[model.jnt_bodyid[joint]],
                "speed",
                fast,
                f"$shape flies off at $value (from {run.start.name}) because contacts"
                " give it more energy than it had",
                unit="m/s",
                severity="error",
            ),
            lambda run: run.thrown_m_s.max(initial=0.0),
            list(_calming(scene, run)),
            needs_cure=True,
        )
    elif run.at_limit > LIMITED and opt.iterations:
        more = _more_iterations(scene)
        finding = Finding(
            "solver",
            "",
            "iterations",
            float(opt.iterations),
            f"The solver uses all $value iterations in {run.at_limit:.0%} of the"
            f" steps from {run.start.name}, so the contacts are not solved",
        )

        def error(run: Run) -> float:
            return M * run.deepest_m + 10.0 * run.speeds_m_s.max(initial=0.0)

        effect = "makes them converge"
        yield Symptom(finding, error, [more], needs_cure=True, effect=effect)


def _calming(scene: Scene, run: Run) -> Iterator[Changes]:
    """Yield changes that may stabilize a scene: options, then servo parameters."""
    model = scene.model
    if run.at_limit > LIMITED:
        yield _more_iterations(scene)
    # Euler integrates velocity-dependent forces explicitly, except joint damping.
    implicit: Changes = ()
    if model.opt.integrator == EULER:
        implicit = of_option(scene, integrator="implicitfast")
        yield implicit
    if stiff := _stiff(model, run):
        yield from _calmed(scene, stiff, implicit)
    yield from shorter_steps(scene)


def _more_iterations(scene: Scene) -> Changes:
    return of_option(scene, iterations=str(max(3, 10 * scene.model.opt.iterations)))


def shorter_steps(scene: Scene) -> list[Changes]:
    """Return changes to shorter time steps, the longest one first."""
    step = scene.model.opt.timestep
    return [of_option(scene, timestep=f"{share * step:.3g}") for share in SHORTER]


def _stiff(model: MjModel, run: Run) -> list[tuple[int, int, float, float]]:
    """Return servos whose kp h²/m is above 1.

    Implicit integrators are stable up to 4 + 2 kv h/m, and with any kp if kv is at
    least kp h/2. Euler is stable up to 4 - 2 kv h/m.

    Returns:
        Servo, dof, kp h²/m, and the mass or inertia m of the dof [kg or kg m²].
    """
    data = run.start.data(model)
    mujoco.mj_forward(model, data)
    stiff = []
    unit = np.zeros((1, model.nv))
    moved = np.zeros((1, model.nv))
    for servo in where(is_servo(model)):
        dof = model.jnt_dofadr[model.actuator_trnid[servo, 0]]
        unit[:] = 0.0
        unit[0, dof] = 1.0
        # The acceleration under a unit force is the inverse of the effective mass, which
        # includes the bodies that the joint carries.
        mujoco.mj_solveM(model, data, moved, unit)
        mass = 1.0 / max(moved[0, dof], mujoco.mjMINVAL)
        pull = model.actuator_gainprm[servo, 0] * model.actuator_gear[servo, 0] ** 2
        if (ratio := pull * model.opt.timestep**2 / mass) > 1.0:
            stiff.append((servo, dof, ratio, mass))
    return stiff


def _calmed(
    scene: Scene, stiff: list[tuple[int, int, float, float]], implicit: Changes
) -> Iterator[Changes]:
    """Yield changes of kv, of kp and of the armature that make stiff servos stable."""
    model = scene.model
    damped: Changes = ()
    weaker: Changes = ()
    heavier: Changes = ()
    for servo, dof, ratio, mass in stiff:
        gain = model.actuator_gainprm[servo, 0]
        damping = -model.actuator_biasprm[servo, 2]
        damped += of_servo(scene, servo, gain, gain * model.opt.timestep)
        # The stability limit is linear in kp, so kp / ratio brings kp·h²/m to 1.
        weaker += of_servo(scene, servo, gain / ratio, damping / ratio)
        armature = model.dof_armature[dof] + (ratio - 1.0) * mass
        joint = model.dof_jntid[dof]
        heavier += of_element(scene, "joint", joint, armature=f"{armature:.3g}")
    yield damped + implicit
    yield weaker
    yield heavier


def is_servo(model: MjModel) -> np.ndarray:
    """Return whether each actuator pulls a joint to a position."""
    gain = model.actuator_gainprm[:, 0]
    bias = model.actuator_biasprm[:, 1]
    on_joint = model.actuator_trntype == ON_JOINT
    return on_joint & (gain > 0.0) & np.isclose(gain, -bias)


def overlapping(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield bodies that overlap at the start.

    It is a warning if they are jammed or thrown apart, otherwise a note.
    """
    model = scene.model
    body_of = model.geom_bodyid
    last = run.samples[-1].touches
    touching = np.sort(body_of[last.geoms], axis=1)
    thrown = np.zeros(model.nbody)
    # Bodies without a free joint keep 0.
    thrown[model.jnt_bodyid[free_joints(model)]] = run.thrown_m_s
    weight = model.body_mass.sum() * np.linalg.norm(model.opt.gravity)
    root = scene.source.root
    # A single robot usually stands on the origin because its base will be attached
    # later by another file or by code.
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

    def speed(bodies: tuple[int, ...]) -> float:
        return thrown[model.body_weldid[list(bodies)]].max()

    loose = [bodies for bodies in worst if scene.free[list(bodies)].all()]
    # A heap of loose bodies is probably scattered by code, so one pair represents it.
    heap = sorted(loose, key=lambda bodies: (speed(bodies), worst[bodies]))
    for bodies, (depth, pair) in worst.items():
        if bodies in heap[:-1]:
            continue
        force = last.normal_n[(touching == bodies).all(axis=1)].sum()
        jammed = not run.bad and weight > 0.0 and force > FORCE * weight
        has_margin = model.geom_margin[list(pair)].any()
        margin = " including their margin" if has_margin else ""
        message = f"$shape overlaps $against by $value{margin} at {run.start.name}"
        if bodies in heap[1:]:
            message += f" (the fastest of {len(heap)} pairs)"
        first, second = model.body_weldid[list(bodies)].tolist()
        # filterBodyPair
        parent = model.body_weldid[model.body_parentid[second]]
        # MuJoCo ignores contacts of a base with its children only if the base can move.
        is_base = is_piece and first == 0 == parent
        if jammed:
            message += (
                f", and {number(force)} N press them apart, which is"
                f" {number(force / weight)} times the weight of all moving bodies"
            )
        elif speed(bodies) > THROWN_M_S:
            message += f", which throws them apart at {number(speed(bodies), 2)} m/s"
        if is_base:
            message += "; MuJoCo ignores this contact if the base can move"
        hard = jammed or run.bad or speed(bodies) > THROWN_M_S
        partner, shape = (scene.names[geom] for geom in pair)

        def overlap(run: Run, pair=pair) -> float:
            return M * run.first.get(pair, 0.0)

        yield Symptom(
            Finding(
                "overlap",
                shape,
                "overlap",
                M * depth,
                message,
                against=(partner,),
                unit="mm",
                severity="warning" if hard and not is_base else "note",
                hint=f"Move one of them by {number(M * depth)} mm.",
            ),
            overlap,
            list(_separating(scene, run, bodies, pair, depth)),
        )


def _separating(
    scene: Scene, run: Run, bodies: tuple[int, ...], pair: tuple[int, int], depth: float
) -> Iterator[Changes]:
    """Yield changes that remove an overlap: an exclude or another initial position.

    The contact with the ground is never excluded.
    """
    model = scene.model
    roots = model.body_rootid[list(bodies)]
    if roots[0] == roots[1] and 0 not in bodies:
        names = tuple(
            (f"body{number}", scene.bodies[body])
            for number, body in enumerate(bodies, 1)
        )
        yield (Change("exclude", (), names, "<contact>"),)
        return
    touches = run.samples[0].touches
    row = where(touches.between(pair))
    for body in sorted(bodies, reverse=True):
        free = where(
            (model.jnt_bodyid == model.body_rootid[body]) & (model.jnt_type == FREE)
        )
        if not (free and row):
            continue
        # The normal of a contact points from its first geom to its second one.
        is_second = model.geom_bodyid[touches.geoms[row[0], 1]] == body
        away = touches.normal[row[0]] * (1.0 if is_second else -1.0)
        if run.start.key is None:
            root = model.body_rootid[body]
            # Without a gap of 0.1 mm, rounding in the file could leave a contact.
            place = model.body_pos[root] + (depth + 1e-4) * away
            yield of_element(scene, "body", root, pos=text_of(place))


def jittering(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield the joint that vibrates most from one time step to the next."""
    model = scene.model
    if not model.nv or run.jitter.max() < JITTERS:
        return
    dof = run.jitter.argmax()
    joint = model.dof_jntid[dof]
    is_free = model.jnt_type[joint] == FREE
    name = (
        scene.bodies[model.jnt_bodyid[joint]] if is_free else scene.name("joint", joint)
    )
    linear = model.jnt_type[joint] == 2 or (
        is_free and dof - model.jnt_dofadr[joint] < 3
    )
    ways = list(_calming(scene, run))
    # Joints that merely follow the vibrating one jump less, and need no armature.
    jumping = run.jitter > 0.1 * run.jitter[dof]
    light = jumping & (model.jnt_type[model.dof_jntid] >= 2) & (model.dof_M0 < LIGHT)
    for times in (100.0, 10.0) if light.any() else ():
        changes: Changes = ()
        for index in where(light):
            value = model.dof_armature[index] + times * model.dof_M0[index]
            joint = model.dof_jntid[index]
            changes += of_element(scene, "joint", joint, armature=f"{value:.2g}")
        ways.insert(0, changes)
    finding = Finding(
        "jitter",
        name,
        "speed",
        run.jitter[dof],
        "$shape vibrates by $value from one time step to the next"
        f"{origin(run)} because the time step is too long for its inertia and the forces on it",
        unit="m/s" if linear else "rad/s",
    )
    yield Symptom(finding, lambda run: run.jitter.max(), ways, needs_cure=True)


def bouncing(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield contacts with a damping ratio below 1 that rattle or bounce wrongly."""
    contacts = scene.contacts
    first, second = contacts.solref.T
    ratios = contacts.dampratio
    # Without damping (a second number of 0) the ratio is 0 in both forms.
    is_bouncy = ((first > 0.0) == (second > 0.0)) | (second == 0.0)
    for pair in run.pairs:
        contact = scene.pair_index(pair)
        if contact is None or not (is_bouncy[contact] and ratios[contact] < BOUNCY):
            continue
        ratio = abs(ratios[contact])
        # A linear spring and damper returns exp(-π ζ / √(1 - ζ²)) of the speed.
        rebound = math.exp(-math.pi * ratio / math.sqrt(1.0 - ratio**2))
        bodies = scene.model.geom_bodyid[list(pair)]
        free = [body for body in bodies if scene.free[body]]
        kept = _restitution(scene, run, pair, free[0]) if len(free) == 1 else None
        if kept is not None:
            yield from _misjudged(scene, run, pair, free[0], rebound, kept)
        else:
            yield from _rattling(scene, run, contact, pair, ratio, rebound)


def _misjudged(
    scene: Scene,
    run: Run,
    pair: tuple[int, ...],
    body: int,
    rebound: float,
    kept: float,
) -> Iterator[Symptom]:
    """Yield a body that bounces with an energy that its damping ratio does not imply."""

    def error(run: Run) -> float:
        kept = _restitution(scene, run, pair, body)
        return 100.0 if kept is None else 100.0 * abs(kept - rebound)

    if (miss := error(run)) < MISSES:
        return
    yield Symptom(
        Finding(
            "bounce",
            scene.bodies[body],
            "rebound",
            miss,
            f"$shape rebounds with {kept:.0%} of its speed instead of the"
            f" {rebound:.0%} that the solref implies{origin(run)}, because a bounce"
            " lasts only a few time steps",
            unit="%",
        ),
        error,
        shorter_steps(scene),
        effect="reduces the error to {}",
    )


def _restitution(
    scene: Scene, run: Run, pair: tuple[int, ...], body: int
) -> float | None:
    """Return the share of its speed that a body keeps in a bounce, or None."""
    model = scene.model
    joint = where(model.jnt_bodyid == model.body_weldid[body])[0]
    dof = model.jnt_dofadr[joint]
    gravity = model.opt.gravity
    flights: list[list[float]] = [[]]
    lowest = math.inf
    for sample in run.samples:
        touches = sample.touches
        # Potential energy per mass, so that the sample may lie anywhere in a flight.
        place = -sample.arrays["xpos"][body] @ gravity
        if touches.between(pair).any():
            lowest = min(lowest, place)
            flights += [[]] if flights[-1] else []
            continue
        speed = sample.arrays["qvel"][dof : dof + 3]
        flights[-1].append(0.5 * speed @ speed + place)
    # A single sample may be a gap of a rattling contact.
    energies = [np.mean(flight) - lowest for flight in flights if len(flight) > 2]
    rebounds = [energy for energy in energies if energy > 0.01]
    if len(rebounds) < 2:
        return None
    # Energies are proportional to the square of the speed.
    return (rebounds[-1] / rebounds[0]) ** (0.5 / (len(rebounds) - 1))


def _rattling(
    scene: Scene,
    run: Run,
    contact: int,
    pair: tuple[int, ...],
    ratio: float,
    rebound: float,
) -> Iterator[Symptom]:
    """Yield a contact whose geoms still part and meet."""

    if (value := _rattle_mm_s(run, pair)) < RATTLES_MM_S:
        return
    timeconst, damping = scene.contacts.solref[contact].tolist()
    if timeconst <= 0.0:
        timeconst = 2.0 / max(-damping, 1e-9)
    # ratio · timeconst keeps the stiffness of the contact; the timeconst alone keeps
    # its damping.
    stiff = max(2.0 * scene.option.timestep_s, ratio * timeconst)
    ways = [
        of_contact(scene, contact, f"{min(new, 0.02):.3g} 1".format)
        for new in (stiff, max(timeconst, stiff))
    ]
    model = scene.model
    bodies = model.geom_bodyid[list(pair)]
    is_finger = np.isin(model.jnt_bodyid[model.jnt_type >= 2], bodies).any()
    # The world and the robot come first in most files.
    shape, partner = (scene.names[geom] for geom in pair[::-1])
    yield Symptom(
        Finding(
            "bounce",
            shape,
            "dampratio",
            value,
            f"$shape keeps bouncing on $against at $value{origin(run)} because the"
            f" damping ratio of their contact is {ratio:.2g}, so it rebounds with"
            f" {rebound:.0%} of its speed",
            against=(partner,),
            unit="mm/s",
            # A loose body may be meant to bounce.
            severity="warning" if is_finger else "note",
        ),
        lambda run: _rattle_mm_s(run, pair),
        ways,
        needs_cure=True,
    )


def _rattle_mm_s(run: Run, pair: tuple[int, ...]) -> float:
    """Return the mean speed at which two geoms part and meet after 0.5 s [mm/s]."""
    speeds: list[float] = []
    for sample in run.samples[len(run.samples) // 4 :]:
        touches = sample.touches
        rows = touches.between(pair)
        along = (touches.velocity_m_s[rows] * touches.normal[rows]).sum(axis=1)
        speeds.extend(np.abs(along).tolist())
    return M * float(np.mean(speeds)) if speeds else 0.0


def origin(run: Run) -> str:
    """Return the start of a run in parentheses, unless it is the default."""
    return "" if run.start.name == "the start" else f" (from {run.start.name})"
