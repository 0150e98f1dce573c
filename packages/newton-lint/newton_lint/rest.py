"""What a scene comes to rest as, and the rules on it: each change that they name has been measured in the same way."""

import copy
import itertools
import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

from newton_lint.findings import Advice, Finding
from newton_lint.law import M
from newton_lint.pairs import HFIELD
from newton_lint.scene import Scene
from newton_lint.stepped import BAD, Run, starts
from newton_lint.target import Target

REST, WINDOW_S, LONGEST_S = 2e-3, 0.1, 2.0
"""Mean speed up to which a scene rests [m/s or rad/s], time over which it is taken, and for which rest is waited."""
BUDGET_S = 0.4
"""Time of the processor after which it is not waited for any longer."""
OPEN_M, OPEN_RAD = 1e-3, math.radians(1.0)
"""What a limit, an equality or a servo gives that is said, of what slides and of what turns."""
FAR, MUCH = 5.0, 3.0
"""Times this from which it is a warning, and of a limit."""
MENDS = 0.5
"""Share of it that a change leaves at most, which is then named."""
HARD = (0.999, 0.999, 0.001)
THICKER = (4, 16, 64)
LEAVES, LEAVES_S = 3.0, 0.2
"""Speed at which a keyframe is left from which it is said [m/s or rad/s], and time in which it is looked for."""
MOST_CONTACTS = int(mujoco.mjMAXCONPAIR)
HINGE, SLIDE, BOX = int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE), int(mujoco.mjtGeom.mjGEOM_BOX)
EQUALITY = int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
COUPLINGS = {
    int(getattr(mujoco.mjtEq, f"mjEQ_{name.upper()}")): name for name in ("connect", "weld", "joint", "tendon")
}


@dataclass(frozen=True)
class Rest:
    """A scene in which nothing moves any more, or what it came to in 2 s and, without its speed, in 2 s more."""

    start: str
    data: mujoco.MjData
    speed: float
    """What moved fastest when it was not waited for any longer; 0 where nothing did [m/s or rad/s]."""

    def __str__(self) -> str:
        return f"at rest, from {self.start}{f', still moving at {self.speed:.2g} after 2 s' if self.speed else ''}"


Edit = Callable[[mujoco.MjModel, mujoco.MjData], None]
Read = Callable[[mujoco.MjModel, mujoco.MjData], float]


@dataclass(frozen=True)
class Give:
    """What may give, by how much it does, and changes that may mend it, with how they are written."""

    rule: str
    name: str
    parameter: str
    message: str
    turns: bool
    read: Read
    ways: list[tuple[str, Edit]]
    needs_way: bool = False
    """Whether it is a fault only where one of the ways mends it."""


def rest_of(model: mujoco.MjModel, data: mujoco.MjData, start: str, seconds: float = LONGEST_S) -> Rest | None:
    """Step on until nothing moves; what swings on is braked whenever it slows. None where it blows up."""
    data, moved, speed = copy.copy(data), np.zeros(model.nv), 0.0
    window = max(1, round(WINDOW_S / model.opt.timestep))
    for braked in (False, True):
        since, calm, energy = time.process_time(), 0, 0.0
        for _ in range(max(1, round(seconds / WINDOW_S))):
            last = data.qpos.copy()
            for _ in range(window):
                mujoco.mj_step(model, data)
                before, energy = energy, float(data.qvel @ data.qvel)
                if braked and energy < before:
                    data.qvel[:] = energy = 0.0
            if any(data.warning[number].number for number in BAD):
                return None
            mujoco.mj_differentiatePos(model, moved, window * model.opt.timestep, last, data.qpos)
            fastest = float(np.abs(moved).max(initial=0.0))
            calm = calm + 1 if fastest < REST else 0
            if calm == 2 or time.process_time() - since > BUDGET_S:
                break
        speed = speed if braked else fastest
        if calm == 2:
            break
    return Rest(start, data, speed if speed >= REST else 0.0)


def at_rest(scene: Scene, target: Target, run: Run, rest: Rest, index: int) -> Iterator[Finding]:
    """Yield limits, equalities and servos that give, and what has gone through a wall."""
    model = scene.model
    for rule in (_passed, _released, _crowded):
        yield from rule(scene, target, rest, index)
    for give in (*_limits(model, rest.data), *_equalities(model, rest.data), *_servos(model, rest)):
        unit, scale, least = ("°", math.degrees(1.0), OPEN_RAD) if give.turns else ("mm", M, OPEN_M)
        if (value := give.read(model, rest.data)) <= least:
            continue
        afters = [(text, _again(scene, target, index, edit)) for text, edit in give.ways]
        mended = [(text, give.read(model, after.data)) for text, after in afters if after]
        mended = [(text, after) for text, after in mended if after < MENDS * value]
        if mended or not give.needs_way:
            texts = [f"{text}: {scale * value:.3g} → {scale * after:.3g} {unit} at rest" for text, after in mended]
            severity = "warning" if mended and value > (MUCH if give.rule == "limit" else FAR) * least else "note"
            advice = Advice((), "; or ".join(texts)) if texts else None
            message = f"{give.message} {rest}"
            yield Finding(
                give.rule, give.name, give.parameter, scale * value, message, (), None, unit, severity, advice=advice
            )


def _again(scene: Scene, target: Target, index: int, edit: Edit) -> Rest | None:
    """Step a changed model from the same start to its rest."""
    model = copy.copy(scene.model)
    start, data = list(starts(model, target))[index]
    edit(model, data)
    return rest_of(model, data, start)


def _limits(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[Give]:
    """Yield joints and tendons with a range, and how far beyond it they lie."""
    solref = max(0.005, 2.0 * model.opt.timestep), 1.0
    for joint in np.flatnonzero(model.jnt_limited & np.isin(model.jnt_type, (HINGE, SLIDE))).tolist():
        place, (low, high) = model.jnt_qposadr[joint], model.jnt_range[joint].tolist()

        def past(model, data, place=place, low=low, high=high) -> float:
            return float(max(low - data.qpos[place], data.qpos[place] - high))

        def harder(model, data, joint=joint) -> None:
            model.jnt_solref[joint] = solref

        ways = [(f'solreflimit="{solref[0]:g} 1" on it', harder)]
        for servo in np.flatnonzero((model.actuator_trnid[:, 0] == joint) & is_servo(model)).tolist():
            if not low <= data.ctrl[servo] * model.actuator_gear[servo, 0] <= high:

                def clipped(model, data, servo=servo, low=low, high=high) -> None:
                    data.ctrl[servo] = min(max(data.ctrl[servo], low), high)

                text = f'ctrlrange="{low:.4g} {high:.4g}" on {model.actuator(servo).name or "its actuator"}'
                ways = [(f"{text}, which asks for {data.ctrl[servo]:.4g}", clipped)]
        name, turns = model.joint(joint).name or f"joint_{joint}", bool(model.jnt_type[joint] == HINGE)
        yield Give("limit", name, "position", "is how far it is beyond its range", turns, past, ways)
    for tendon in np.flatnonzero(model.tendon_limited).tolist():

        def longer(model, data, tendon=tendon) -> float:
            low, high = model.tendon_range[tendon]
            return float(max(low - data.ten_length[tendon], data.ten_length[tendon] - high))

        def shorter(model, data, tendon=tendon) -> None:
            model.tendon_solref_lim[tendon] = solref

        name, ways = (
            model.tendon(tendon).name or f"tendon_{tendon}",
            [(f'solreflimit="{solref[0]:g} 1" on it', shorter)],
        )
        yield Give("limit", name, "length", "is how far it is beyond its range", False, longer, ways)


def _equalities(model: mujoco.MjModel, data: mujoco.MjData) -> Iterator[Give]:
    """Yield equalities, and how far they are open; of a weld's six rows the last three are of rotation."""
    for equality in np.unique(data.efc_id[data.efc_type == EQUALITY]).tolist():
        if (kind := COUPLINGS.get(int(model.eq_type[equality]))) is None:
            continue

        def gap(model, data, equality=equality) -> float:
            rows = (data.efc_type == EQUALITY) & (data.efc_id == equality)
            return float(np.linalg.norm(data.efc_pos[rows][:3]))

        def harder(model, data, equality=equality) -> None:
            model.eq_solref[equality], model.eq_solimp[equality, :3] = (2.0 * model.opt.timestep, 1.0), HARD

        solref = " ".join(f"{entry:g}" for entry in model.eq_solref[equality])
        turns = kind == "joint" and model.jnt_type[model.eq_obj1id[equality]] == HINGE
        text = f'solref="{2.0 * model.opt.timestep:g} 1" solimp="{" ".join(map(str, HARD))}" on it'
        message = f"is how far this {kind} is open with a solref of {solref}"
        name = model.eq(equality).name or f"equality_{equality}"
        yield Give("equality", name, "gap", message, bool(turns), gap, [(text, harder)])


def is_servo(model: mujoco.MjModel) -> np.ndarray:
    """Tell of each actuator whether it pulls a joint to a position."""
    gain, bias = model.actuator_gainprm[:, 0], model.actuator_biasprm[:, 1]
    on_joint = model.actuator_trntype == int(mujoco.mjtTrn.mjTRN_JOINT)
    return on_joint & (gain > 0.0) & np.isclose(gain, -bias) & (model.actuator_dyntype == 0)


def _servos(model: mujoco.MjModel, rest: Rest) -> Iterator[Give]:
    """Yield servos, and how far gravity pulls them from what they are told."""
    for servo in np.flatnonzero(is_servo(model)).tolist() if model.nkey == 0 or rest.start != "the start" else ():
        joint = int(model.actuator_trnid[servo, 0])
        if model.jnt_type[joint] not in (HINGE, SLIDE) or rest.data.qfrc_constraint[model.jnt_dofadr[joint]]:
            continue
        turns = bool(model.jnt_type[joint] == HINGE)

        def short(model, data, servo=servo) -> float:
            return abs(float(data.ctrl[servo] - data.actuator_length[servo]))

        times = math.ceil(short(model, rest.data) / (OPEN_RAD if turns else OPEN_M))

        def stiffer(model, data, servo=servo, times=times) -> None:
            model.actuator_gainprm[servo, 0] *= times
            model.actuator_biasprm[servo, 1] *= times
            model.actuator_biasprm[servo, 2] *= math.sqrt(times)

        def light(model, data) -> None:
            model.opt.gravity[:] = 0.0

        name = model.actuator(servo).name or model.joint(joint).name or f"actuator_{servo}"
        ways = [('gravcomp="1" on the bodies that it carries', light)]
        ways += [(f'kp="{times * model.actuator_gainprm[servo, 0]:.4g}" on it', stiffer)]
        yield Give("servo", name, "error", "is how far gravity pulls it from its target", turns, short, ways, True)


def _passed(scene: Scene, target: Target, rest: Rest, index: int) -> Iterator[Finding]:
    """Yield what joints have driven through a box that a thicker one would have stopped."""
    model, contacts = scene.model, scene.contacts
    data = list(starts(model, target))[index][1]
    mujoco.mj_kinematics(model, data)
    for pair in zip(contacts.first.tolist(), contacts.second.tolist(), strict=True):
        for geom, wall in itertools.permutations(pair):
            if model.geom_type[wall] != BOX or scene.free[model.geom_bodyid[geom]]:
                continue
            axis = int(model.geom_size[wall].argmin())
            if _crosses(model, data, rest.data, geom, wall, axis):
                for times in THICKER:

                    def thicker(model, data, wall=wall, axis=axis, times=times) -> None:
                        model.geom_size[wall, axis] *= times
                        model.geom_rbound[wall] = np.linalg.norm(model.geom_size[wall])
                        model.geom_aabb[wall, 3:] = model.geom_size[wall]

                    after, thick = _again(scene, target, index, thicker), M * 2.0 * model.geom_size[wall, axis]
                    if after and not _crosses(model, data, after.data, geom, wall, axis):
                        names, message = scene.names, f"thick, and it is on the other side of it {rest}"
                        advice = Advice(
                            (), f"a thickness of {times * thick:.3g} mm stops it, measured; or a softer drive"
                        )
                        element, against = scene.source.geom(wall), (names[wall],)
                        yield Finding(
                            "tunnel", names[geom], "wall", thick, message, against, None, "mm", "error", element, advice
                        )
                        break


def _crosses(model: mujoco.MjModel, first: mujoco.MjData, last: mujoco.MjData, geom: int, wall: int, axis: int) -> bool:
    """Tell whether a geom is on the other side of a box than at first, by a way through it."""
    ways = [
        data.geom_xmat[wall].reshape(3, 3).T @ (data.geom_xpos[geom] - data.geom_xpos[wall]) for data in (first, last)
    ]
    before, after = ways[0][axis], ways[1][axis]
    if before * after >= 0.0:
        return False
    across = ways[0] + (ways[1] - ways[0]) * before / (before - after)
    return bool((np.abs(across) <= model.geom_size[wall]).all())


def _released(scene: Scene, target: Target, rest: Rest, index: int) -> Iterator[Finding]:
    """Yield a keyframe that does not say what its servos are told, so that they pull to 0."""
    model = scene.model
    servos = np.flatnonzero(is_servo(model))
    begins = [list(starts(model, target))[index][1] for _ in range(2)]
    if target.data is not None or not index or begins[0].ctrl[servos].any():
        return
    mujoco.mj_forward(model, begins[1])
    lengths = begins[1].actuator_length
    begins[1].ctrl[servos] = lengths[servos]
    before, after = (_fastest(model, data) for data in begins)
    if before > LEAVES and after < MENDS * before:
        ctrl = " ".join(f"{value:.4g}" for value in begins[1].ctrl)
        advice = Advice((), f'ctrl="{ctrl}" in the <key>: {before:.3g} → {after:.3g} m/s or rad/s')
        message = "m/s or rad/s is how fast it is left, since it has no ctrl and servos pull to 0"
        yield Finding("keyframe", rest.start, "speed", before, message, advice=advice)


def _fastest(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    fastest = 0.0
    for _ in range(round(LEAVES_S / model.opt.timestep)):
        mujoco.mj_step(model, data)
        fastest = max(fastest, float(np.abs(data.qvel).max(initial=0.0)))
    return fastest


def _crowded(scene: Scene, target: Target, rest: Rest, index: int) -> Iterator[Finding]:
    """Yield height fields under which a geom has as many contacts as a pair gets: those of the far side are missing."""
    model = scene.model
    data = list(starts(model, target))[index][1]
    for _ in range(round(LEAVES_S / model.opt.timestep) if model.nhfield else 0):
        mujoco.mj_step(model, data)
        pairs, counts = np.unique(data.contact.geom, axis=0, return_counts=True)
        for pair in pairs[counts >= MOST_CONTACTS].tolist():
            field, geom = sorted(pair, key=lambda geom: model.geom_type[geom] != HFIELD)
            wide = model.hfield_size[model.geom_dataid[field]]
            ncol, nrow = (max(2, round(2.0 * side / (0.7 * model.geom_rbound[geom]))) for side in wide[:2].tolist())
            message = "contacts are all that a pair gets, and more cells touch it: it sinks through"
            advice = Advice(
                (), f'nrow="{nrow}" ncol="{ncol}" on the <hfield>: cells about as large as what stands on them'
            )
            names, element = scene.names, scene.source.geom(field)
            yield Finding(
                "hfield",
                names[geom],
                "",
                MOST_CONTACTS,
                f"{MOST_CONTACTS} {message}",
                (names[field],),
                element=element,
                advice=advice,
            )
            return
