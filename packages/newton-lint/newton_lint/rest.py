"""Rules on the state in which a scene comes to rest; each named change is measured."""

import copy
import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.advice import either, for_contact
from newton_lint.findings import Advice, Finding
from newton_lint.law import M
from newton_lint.pairs import HFIELD, PLANE
from newton_lint.scene import HINGE, Scene
from newton_lint.stepped import Run, Start, is_bad

# A scene rests if its fastest mean speed is below this [m/s or rad/s].
REST = 2e-3
# The mean speed is taken over this time.
WINDOW_S = 0.1
# A scene is stepped for at most this time.
LONGEST_S = 2.0
# Scenes that still move faster than this only give notes [m/s or rad/s].
WILD = 1.0
# Stepping stops after this processor time.
BUDGET_S = 0.4
LEAST = {"mm": 1e-3, "°": math.radians(1.0)}
"""Least depth, distance or angle that is reported [m or rad]."""
SCALE = {"mm": M, "°": math.degrees(1.0)}
# A finding is a warning if its value is above this multiple of the least one.
FAR = 5.0
# For limits of joints and tendons, this multiple applies instead.
MUCH = 3.0
# A change is recommended if it leaves less than this share of the value.
MENDS = 0.5
# A body is reported if it sinks by this share of half its thickness.
SUNK = 0.2
HARD = (0.999, 0.999, 0.001)
HARDEST = 'solref="{}" solimp="{}"'
THICKER = (2, 4, 8, 16, 32)
# A keyframe is reported if a motion of this speed starts there [m/s or rad/s].
LEAVES = 3.0
# The motion must start within this time.
LEAVES_S = 0.2
MOST_CONTACTS = int(mujoco.mjMAXCONPAIR)
SLIDE = int(mujoco.mjtJoint.mjJNT_SLIDE)
ON_JOINT = int(mujoco.mjtTrn.mjTRN_JOINT)
PLATES = tuple(range(mujoco.mjtGeom.mjGEOM_ELLIPSOID, mujoco.mjtGeom.mjGEOM_MESH + 1))
ELLIPSOID, CYLINDER, BOX, MESH = PLATES
UNSORTED = int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
MOST_CROSSINGS = 3
EQUALITY = int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
COUPLINGS = {
    int(getattr(mujoco.mjtEq, f"mjEQ_{name.upper()}")): name
    for name in ("connect", "weld", "joint", "tendon")
}
Edit = Callable[[MjModel, MjData], None]
Read = Callable[[MjModel, MjData], float]
Places = tuple[np.ndarray, np.ndarray]
"""Positions and orientations of all geoms."""


@dataclass(frozen=True)
class Rest:
    """A scene at rest, or after 2 s and, if it still moves, 2 s more with braking."""

    start: Start
    data: MjData
    speed: float
    """Fastest speed if the scene did not come to rest, else 0 [m/s or rad/s]."""
    places: Sequence[Places]
    """Positions every 0.1 s before the braking."""

    def __str__(self) -> str:
        if self.speed:
            moving = f"still moving at {self.speed:.2g} m/s or rad/s after 2 s"
            return f"(from {self.start.name}, {moving})"
        return f"at rest (from {self.start.name})"


@dataclass(frozen=True)
class Give:
    """A contact, limit, equality or servo that may yield, with possible changes."""

    finding: Finding
    """The finding without a value; $rest in its message is the state of the scene."""
    read: Read
    """Returns by how much it yields [m or rad]."""
    ways: Sequence[tuple[str, Edit]]
    """Changes, as they are written and as functions."""
    least: float = 0.0
    """Least value that is reported [m or rad]; 0 for the default of the unit."""
    far: float = FAR
    needs_way: bool = False
    """Whether to report it only if the first of the ways mends it."""

    def found(
        self, value: float, rest: str, severity: str, advice: Advice | None = None
    ) -> Finding:
        """Return the finding with a value [m or rad]."""
        return replace(
            self.finding,
            value=SCALE[self.finding.unit] * value,
            message=self.finding.message.replace("$rest", rest),
            severity=severity,
            advice=advice,
        )


def rest_of(model: MjModel, data: MjData, start: Start) -> Rest | None:
    """Step until nothing moves, or return None if the scene blows up.

    If the scene still moves after 2 s, it is stopped whenever it slows down.
    """
    data = copy.copy(data)
    moved = np.zeros(model.nv)
    speed = 0.0
    window = max(1, round(WINDOW_S / model.opt.timestep))
    places = [places_of(data)]
    for braked in (False, True):
        since = time.process_time()
        calm = 0
        energy = 0.0
        for _ in range(round(LONGEST_S / WINDOW_S)):
            last = data.qpos.copy()
            for _ in range(window):
                mujoco.mj_step(model, data)
                before = energy
                energy = data.qvel @ data.qvel
                if braked and energy < before:
                    data.qvel[:] = 0.0
                    energy = 0.0
            if is_bad(data):
                return None
            places += [] if braked else [places_of(data)]
            mujoco.mj_differentiatePos(
                model, moved, window * model.opt.timestep, last, data.qpos
            )
            fastest = np.abs(moved).max(initial=0.0)
            calm = calm + 1 if fastest < REST else 0
            if calm == 2 or time.process_time() - since > BUDGET_S:
                break
        speed = speed if braked else fastest
        if calm == 2:
            break
    return Rest(start, data, speed if speed >= REST else 0.0, places)


def places_of(data: MjData) -> Places:
    return data.geom_xpos.copy(), data.geom_xmat.copy()


def at_rest(scene: Scene, run: Run, rest: Rest) -> Iterator[Finding]:
    """Yield contacts, limits, equalities and servos that yield, and tunnelling."""
    model = scene.model
    afters = {}
    for rule in (_passed, _released, _crowded):
        yield from rule(scene, rest)
    gives = [
        *_depths(scene, run, rest),
        *_limits(model, rest.data),
        *_equalities(model, rest.data),
    ]
    for give in [*gives, *_servos(model, rest)]:
        unit = give.finding.unit
        least = give.least or LEAST[unit]
        if (value := give.read(model, rest.data)) <= least:
            continue
        gains = {}
        for text, edit in give.ways:
            if edit not in afters:  # An edit covers all findings of its rule at once.
                afters[edit] = _again(scene, rest.start, edit)
            if after := afters[edit]:
                left = max(0.0, give.read(model, after.data))
                if left < MENDS * value:
                    gains[text] = Advice(
                        f"Set {text}: this reduces it to {SCALE[unit] * left:.3g}"
                        f" {unit} (measured at rest)"
                    )
        if not give.needs_way or give.ways[0][0] in gains:
            is_certain = gains and rest.speed < WILD and value > give.far * least
            severity = "warning" if is_certain else "note"
            advice = either(*gains.values()) if gains else None
            yield give.found(value, str(rest), severity, advice)


def _again(scene: Scene, start: Start, edit: Edit) -> Rest | None:
    """Step a changed model to rest from the same start."""
    model = copy.copy(scene.model)
    data = start.data(model)
    edit(model, data)
    mujoco.mj_kinematics(model, data)
    return rest_of(model, data, start)


def _depths(scene: Scene, run: Run, rest: Rest) -> Iterator[Give]:
    """Yield geoms that sink by a millimetre or by a share of their thickness."""
    model = scene.model
    contacts = scene.contacts
    sizes = _thin(model)
    pairs = scene.pair_indices
    speeds = np.linalg.norm(rest.data.cvel[:, 3:], axis=1)
    solrefs: dict[int, tuple[float, float]] = {}

    def stiffer(model, data, hardest: bool = False) -> None:
        for contact, solref in solrefs.items():
            kind = "geom"
            rows = [contacts.first[contact], contacts.second[contact]]
            if contacts.outranked[contact]:
                rows = rows[:1]
            if contacts.named[contact] >= 0:
                kind = "pair"
                rows = [contacts.named[contact]]
            getattr(model, f"{kind}_solref")[rows] = shortest if hardest else solref
            if hardest:
                getattr(model, f"{kind}_solimp")[rows, :3] = HARD

    shortest = (2.0 * model.opt.timestep, 1.0)
    harder: Edit = partial(stiffer, hardest=True)
    for pair in dict.fromkeys(
        tuple(sorted(pair)) for pair in rest.data.contact.geom.tolist()
    ):
        # The pair may be that of a flex, or of a geom that is not read.
        if (contact := pairs.get(pair)) is None:
            continue

        def read(model, data, pair=pair) -> float:
            return -data.contact.dist[
                (np.sort(data.contact.geom, axis=1) == pair).all(axis=1)
            ].min(initial=0.0)

        depth = read(model, rest.data)
        bodies = model.geom_bodyid[list(pair)]
        thin, partner = sorted(pair, key=lambda geom: sizes[geom])
        lies = scene.free[bodies].sum() == 1 and model.body_weldid[bodies].min() == 0
        least = min(LEAST["mm"], SUNK * sizes[thin])
        moves = WINDOW_S * max(speeds[bodies])
        if depth <= max(least, moves) or (
            depth < 2.0 * run.first.get(pair, 0.0) and not lies
        ):
            continue
        share = min(LEAST["mm"] / depth, 0.4)
        first, second = contacts.solref[contact].tolist()
        shorter = max(first, 2.0 * model.opt.timestep) * share**0.5
        new = (
            (max(shorter, 2.0 * model.opt.timestep), second)
            if first > 0.0
            else (first / share, second / share**0.5)
        )
        solrefs[contact] = new
        changes = for_contact(
            scene, contact, partial(str.format, f"{new[0]:.3g} {new[1]:.3g}"), ""
        ).changes
        edits = [
            (", ".join(map(str, changes)), stiffer),
            (f"{HARDEST.format(_text(shortest), _text(HARD))} there", harder),
        ]
        is_certain = depth > 2.0 * run.first.get(pair, 0.0) and rest.speed < 0.1 * WILD
        finding = Finding(
            "depth",
            scene.names[thin],
            "depth",
            depth,
            message="$shape sinks $value into $against $rest because contact stiffness"
            " scales with the mass of the lighter body",
            against=(scene.names[partner],),
            unit="mm",
            element=scene.source.geom(thin),
        )
        far = sizes[thin] / least if is_certain else math.inf
        yield Give(finding, read, edits, least=least, far=far)


def _limits(model: MjModel, data: MjData) -> Iterator[Give]:
    """Yield joints and tendons that have a range, with the distance beyond it."""
    solref = (max(0.005, 2.0 * model.opt.timestep), 1.0)
    # The trnid of other actuators may be that of a tendon.
    servos = np.flatnonzero(is_servo(model))
    servos = servos[model.jnt_limited[model.actuator_trnid[servos, 0]] > 0]
    joints = model.actuator_trnid[servos, 0]
    gears = model.actuator_gear[servos, :1]
    ranges = model.jnt_range[joints] / np.where(gears == 0.0, 1.0, gears)

    def harder(model, data) -> None:
        model.jnt_solref[:] = solref
        model.tendon_solref_lim[:] = solref

    def clipped(model, data) -> None:
        data.ctrl[servos] = np.clip(
            data.ctrl[servos], ranges.min(axis=1), ranges.max(axis=1)
        )

    def give(kind: str, index: int, unit: str) -> Give:
        parameter = "length"
        values = "ten_length"
        at = index
        spans = model.tendon_range
        drives: list[int] = []
        if kind == "joint":
            parameter = "position"
            values = "qpos"
            at = model.jnt_qposadr[index]
            spans = model.jnt_range
            drives = servos[joints == index].tolist()
        low, high = spans[index].tolist()
        ways = [(f'solreflimit="{solref[0]:g} 1" on it', harder)]
        for servo in drives:
            told = data.ctrl[servo] * model.actuator_gear[servo, 0]
            if not low <= told <= high:
                actuator = model.actuator(servo).name or "its actuator"
                text = f'ctrlrange="{low:.4g} {high:.4g}" on {actuator}'
                ways = [(f"{text}, whose target is {told:.4g}", clipped)]

        def past(model, data) -> float:
            value = getattr(data, values)[at]
            return max(low - value, value - high)

        name = getattr(model, kind)(index).name or f"{kind}_{index}"
        message = "$shape is $value beyond its range $rest"
        finding = Finding("limit", name, parameter, 0.0, message=message, unit=unit)
        return Give(finding, past, ways, far=MUCH)

    for joint in np.flatnonzero(
        model.jnt_limited & np.isin(model.jnt_type, (HINGE, SLIDE))
    ).tolist():
        yield give("joint", joint, "°" if model.jnt_type[joint] == HINGE else "mm")
    for tendon in np.flatnonzero(model.tendon_limited).tolist():
        yield give("tendon", tendon, "°" if _turns(model, tendon) else "mm")


def unposed(model: MjModel, start: Start) -> Iterator[Finding]:
    """Yield joints that are beyond their range at the start itself."""
    data = start.data(model)
    for give in _limits(model, data):
        value = give.read(model, data)
        if give.finding.parameter == "position" and value > LEAST[give.finding.unit]:
            yield give.found(value, f"at {start.name}, before the first step", "note")


def _turns(model: MjModel, tendon: int) -> bool:
    """Return whether the length of a tendon is a sum of angles of hinges."""
    wrap = model.tendon_adr[tendon]
    of_joint = model.wrap_type[wrap] == int(mujoco.mjtWrap.mjWRAP_JOINT)
    return bool(of_joint and model.jnt_type[model.wrap_objid[wrap]] == HINGE)


def _equalities(model: MjModel, data: MjData) -> Iterator[Give]:
    """Yield equalities with their gap; for a weld, this is the translational gap."""
    solref = (2.0 * model.opt.timestep, 1.0)

    def harder(model, data) -> None:
        model.eq_solref[:] = solref
        model.eq_solimp[:, :3] = HARD

    for equality in np.unique(data.efc_id[data.efc_type == EQUALITY]).tolist():
        if (kind := COUPLINGS.get(int(model.eq_type[equality]))) is None:
            continue

        def gap(model, data, equality=equality) -> float:
            rows = (data.efc_type == EQUALITY) & (data.efc_id == equality)
            return np.linalg.norm(data.efc_pos[rows][:3])

        joint = int(model.eq_obj1id[equality])
        turns = (
            _turns(model, joint)
            if kind == "tendon"
            else kind == "joint" and model.jnt_type[joint] == HINGE
        )
        used = _text(model.eq_solref[equality])
        finding = Finding(
            "equality",
            model.eq(equality).name or f"equality_{equality}",
            "gap",
            0.0,
            message=f"$shape is $value open $rest; it is a {kind} equality with solref"
            f" {used}",
            unit="°" if turns else "mm",
        )
        hard = f"{HARDEST.format(_text(solref), _text(HARD))} on it"
        yield Give(finding, gap, [(hard, harder)])


def is_servo(model: MjModel) -> np.ndarray:
    """Return for each actuator whether it pulls a joint to a position."""
    gain = model.actuator_gainprm[:, 0]
    bias = model.actuator_biasprm[:, 1]
    on_joint = model.actuator_trntype == ON_JOINT
    return (
        on_joint
        & (gain > 0.0)
        & np.isclose(gain, -bias)
        & (model.actuator_dyntype == 0)
    )


def _servos(model: MjModel, rest: Rest) -> Iterator[Give]:
    """Yield servos that gravity pulls from their targets."""
    times = np.ones(model.nu)

    def stiffer(model, data) -> None:
        model.actuator_gainprm[:, 0] *= times
        model.actuator_biasprm[:, 1] *= times

    def light(model, data) -> None:
        model.opt.gravity[:] = 0.0

    for servo in np.flatnonzero(is_servo(model)).tolist():
        joint = int(model.actuator_trnid[servo, 0])
        if (
            model.jnt_type[joint] not in (HINGE, SLIDE)
            or rest.data.qfrc_constraint[model.jnt_dofadr[joint]]
        ):
            continue

        def short(model, data, servo=servo) -> float:
            return abs(data.ctrl[servo] - data.actuator_length[servo])

        unit = "°" if model.jnt_type[joint] == HINGE else "mm"
        times[servo] = max(1.0, math.ceil(short(model, rest.data) / LEAST[unit]))
        stiff = times[servo] * model.actuator_gainprm[servo, 0]
        finding = Finding(
            "servo",
            model.actuator(servo).name
            or model.joint(joint).name
            or f"actuator_{servo}",
            "error",
            0.0,
            message="$shape is $value from its target $rest because gravity pulls it",
            unit=unit,
        )
        edits = [
            ('gravcomp="1" on the bodies that it carries', light),
            (f'kp="{stiff:.4g}" on it', stiffer),
        ]
        yield Give(finding, short, edits, needs_way=True)


def _passed(scene: Scene, rest: Rest) -> Iterator[Finding]:
    """Yield a geom that passed through a plate, if a thicker plate would stop it."""
    model = scene.model
    contacts = scene.contacts
    data = rest.start.data(model)
    mujoco.mj_kinematics(model, data)
    pairs = np.stack([contacts.first, contacts.second], axis=1)
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    # Only plates that stand still count; moving bodies pass others without contact.
    walls = np.isin(model.geom_type, PLATES) & (
        model.body_weldid[model.geom_bodyid] == 0
    )
    pairs = pairs[walls[pairs[:, 1]]]
    for geom, wall in pairs[_crossing(model, pairs, [places_of(data), *rest.places])][
        :MOST_CROSSINGS
    ].tolist():
        axis = int(model.geom_aabb[wall, 3:].argmin())
        pair = np.array([[geom, wall]])
        thick = M * 2.0 * model.geom_aabb[wall, 3 + axis]
        distance = np.linalg.norm(data.geom_xpos[geom] - data.geom_xpos[wall])
        for times in THICKER:

            def thicker(model, data, wall=wall, axis=axis, times=times) -> None:
                kind = model.geom_type[wall]
                mesh = model.geom_dataid[wall]
                # The sizes of a cylinder are its radius and its half length.
                size = axis // 2 if kind == CYLINDER else axis
                model.geom_size[wall, size] *= times
                if kind == MESH:
                    model.mesh_vert[model.mesh_vertadr[mesh] :][
                        : model.mesh_vertnum[mesh], axis
                    ] *= times
                model.geom_aabb[wall, 3 + axis] *= times
                model.geom_rbound[wall] = np.linalg.norm(model.geom_aabb[wall, 3:])
                # The tree of bounding boxes was compiled for the old size.
                model.opt.disableflags |= UNSORTED

            after = (
                _again(scene, rest.start, thicker)
                if times * thick < 2.0 * M * distance
                else None
            )
            if after and not _crossing(model, pair, after.places).any():
                yield Finding(
                    "tunnel",
                    scene.names[geom],
                    "wall",
                    thick,
                    message="$shape passes through $against, which is only $value"
                    f" thick (from {rest.start.name})",
                    against=(scene.names[wall],),
                    unit="mm",
                    severity="error",
                    element=scene.source.geom(wall),
                    advice=Advice(
                        f"Use a thickness of {times * thick:.3g} mm, which stops it"
                        " (measured), or a softer drive"
                    ),
                )
                return


def _crossing(
    model: MjModel, pairs: np.ndarray, places: Sequence[Places]
) -> np.ndarray:
    """Return for each pair of a geom and a plate whether the geom passed through."""
    rows = np.arange(len(pairs))
    geoms, walls = pairs.T
    centres, sizes = np.split(model.geom_aabb[walls], 2, axis=1)
    axis = sizes.argmin(axis=1)
    crossing = np.zeros(len(pairs), dtype=bool)
    last = None
    for positions, axes in places:
        way = (
            np.einsum(
                "nji,nj->ni",
                axes[walls].reshape(-1, 3, 3),
                positions[geoms] - positions[walls],
            )
            - centres
        )
        if last is not None:
            before = last[rows, axis]
            after = way[rows, axis]
            is_through = before * after < 0.0
            share = np.where(
                is_through, before / np.where(is_through, before - after, 1.0), 0.0
            )
            across = np.abs(last + (way - last) * share[:, None])
            crossing |= is_through & (across <= sizes).all(axis=1)
        last = way
    return crossing


def _released(scene: Scene, rest: Rest) -> Iterator[Finding]:
    """Yield a keyframe without ctrl, whose servos pull their joints to 0."""
    model = scene.model
    servos = np.flatnonzero(is_servo(model))
    plain = rest.start.data(model)
    if rest.start.key is None or plain.ctrl[servos].any():
        return
    key = scene.source.key(rest.start.key)
    if key and "ctrl" in key.attributes:
        return
    told = rest.start.data(model)
    mujoco.mj_forward(model, told)
    told.ctrl[servos] = told.actuator_length[servos]
    before = _fastest(model, plain)
    after = _fastest(model, told)
    if before > LEAVES and after < MENDS * before:
        values = _text(told.ctrl)
        yield Finding(
            "keyframe",
            rest.start.name,
            "speed",
            before,
            message="$shape sets the scene in motion at $value m/s or rad/s because it"
            " has no ctrl and the servos pull to 0",
            element=key,
            advice=Advice(
                f'Add ctrl="{values}" to the <key>: this reduces the speed to'
                f" {after:.3g} m/s or rad/s (measured)"
            ),
        )


def _fastest(model: MjModel, data: MjData) -> float:
    fastest = 0.0
    for _ in range(round(LEAVES_S / model.opt.timestep)):
        mujoco.mj_step(model, data)
        fastest = max(fastest, np.abs(data.qvel).max(initial=0.0))
    return fastest


def _crowded(scene: Scene, rest: Rest) -> Iterator[Finding]:
    """Yield height fields with more cells under a geom than a pair has contacts."""
    model = scene.model
    names = scene.names
    data = rest.start.data(model)
    for _ in range(round(LEAVES_S / model.opt.timestep) if model.nhfield else 0):
        mujoco.mj_step(model, data)
        pairs, counts = np.unique(data.contact.geom, axis=0, return_counts=True)
        for pair in pairs[counts >= MOST_CONTACTS].tolist():
            field, geom = sorted(pair, key=lambda geom: model.geom_type[geom] != HFIELD)
            wide = model.hfield_size[model.geom_dataid[field]]
            ncol, nrow = (
                max(2, round(2.0 * side / (0.7 * model.geom_rbound[geom])))
                for side in wide[:2].tolist()
            )
            yield Finding(
                "hfield",
                names[geom],
                "",
                MOST_CONTACTS,
                message="$shape sinks through $against because it touches more cells"
                " than the $value contacts that MuJoCo makes for a pair",
                against=(names[field],),
                element=scene.source.geom(field),
                advice=Advice(
                    f'Set nrow="{nrow}" ncol="{ncol}" on the <hfield>: this makes its'
                    " cells about as large as the geoms on it"
                ),
            )
            return


def _thin(model: MjModel) -> np.ndarray:
    """Return half the least thickness of each geom, infinite for one-sided ones [m]."""
    sizes = np.where(model.geom_size > 0.0, model.geom_size, np.inf).min(axis=1)
    sizes[np.isin(model.geom_type, (PLANE, HFIELD))] = np.inf
    return sizes


def _text(values: Sequence[float]) -> str:
    return " ".join(f"{value:.4g}" for value in values)
