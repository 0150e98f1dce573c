"""What a scene comes to rest as, and the rules on it: each change that they name has been measured in the same way."""

import copy
import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.advice import for_contact
from newton_lint.findings import Advice, Finding
from newton_lint.law import M
from newton_lint.pairs import HFIELD, PLANE
from newton_lint.scene import HINGE, Scene
from newton_lint.source import Element
from newton_lint.stepped import Run, Start, is_bad

# Mean speed up to which a scene rests [m/s or rad/s], time over which it is taken, and for which rest is waited.
REST = 2e-3
WINDOW_S = 0.1
LONGEST_S = 2.0
# Speed after 2 s from which what it came to is a note [m/s or rad/s], and time of the processor to wait for it.
WILD = 1.0
BUDGET_S = 0.4
LEAST = {"mm": 1e-3, "°": math.radians(1.0)}
"""What a contact, a limit, an equality or a servo gives that is said, of what slides and of what turns [m or rad]."""
SCALE = {"mm": M, "°": math.degrees(1.0)}
# Times this from which it is a warning, and of a limit.
FAR = 5.0
MUCH = 3.0
# Share of it that a named change leaves at most, and of half its thickness by which what lies is sunk.
MENDS = 0.5
SUNK = 0.2
HARD = (0.999, 0.999, 0.001)
HARDEST = 'solref="{}" solimp="{}"'
THICKER = (2, 4, 8, 16, 32)
# Speed at which a keyframe is left from which it is said [m/s or rad/s], and time in which it is looked for.
LEAVES = 3.0
LEAVES_S = 0.2
MOST_CONTACTS = int(mujoco.mjMAXCONPAIR)
SLIDE = int(mujoco.mjtJoint.mjJNT_SLIDE)
ON_JOINT = int(mujoco.mjtTrn.mjTRN_JOINT)
ELLIPSOID, CYLINDER, BOX, MESH = PLATES = tuple(
    range(mujoco.mjtGeom.mjGEOM_ELLIPSOID, mujoco.mjtGeom.mjGEOM_MESH + 1)
)
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
"""Where geoms are, and their axes."""


@dataclass(frozen=True)
class Rest:
    """A scene in which nothing moves any more, or what it came to in 2 s and, without its speed, in 2 s more."""

    start: Start
    data: MjData
    speed: float
    """What moved fastest when it was not waited for any longer; 0 where nothing did [m/s or rad/s]."""
    places: Sequence[Places]
    """On the way, every 0.1 s."""

    def __str__(self) -> str:
        return f"at rest, from {self.start}{f', still moving at {self.speed:.2g} after 2 s' if self.speed else ''}"


@dataclass(frozen=True)
class Give:
    """What may give, by how much it does, and changes that may mend it, with how they are written."""

    rule: str
    name: str
    parameter: str
    message: str
    read: Read
    ways: Sequence[tuple[str, Edit]]
    unit: str = "mm"
    least: float = 0.0
    """By itself that of the unit [m or rad]."""
    far: float = FAR
    against: tuple[str, ...] = ()
    element: Element | None = None
    needs_way: bool = False
    """Whether it is a fault only where the first of the ways mends it."""


def rest_of(model: MjModel, data: MjData, start: Start) -> Rest | None:
    """Step on until nothing moves; what swings on is braked whenever it slows. None where it blows up."""
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
                    data.qvel[:] = energy = 0.0
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
    """Yield contacts, limits, equalities and servos that give, and what has gone through a wall."""
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
        scale = SCALE[give.unit]
        least = give.least or LEAST[give.unit]
        if (value := give.read(model, rest.data)) <= least:
            continue
        for _, edit in give.ways:
            if edit not in afters:  # all that a rule finds is changed at once
                afters[edit] = _again(scene, rest.start, edit)
        mended = [
            (text, give.read(model, after.data))
            for text, edit in give.ways
            if (after := afters[edit])
        ]
        mended = [
            (text, max(0.0, after)) for text, after in mended if after < MENDS * value
        ]
        if not give.needs_way or (mended and mended[0][0] == give.ways[0][0]):
            gains = [
                f"{text}: {scale * value:.3g} → {scale * after:.3g} {give.unit} at rest"
                for text, after in mended
            ]
            is_certain = mended and rest.speed < WILD and value > give.far * least
            yield Finding(
                give.rule,
                give.name,
                give.parameter,
                scale * value,
                f"{give.message} {rest}",
                give.against,
                None,
                give.unit,
                "warning" if is_certain else "note",
                give.element,
                Advice("; or ".join(gains)) if gains else None,
            )


def _again(scene: Scene, start: Start, edit: Edit) -> Rest | None:
    """Step a changed model from the same start to its rest."""
    model = copy.copy(scene.model)
    data = start.data(model)
    edit(model, data)
    mujoco.mj_kinematics(model, data)
    return rest_of(model, data, start)


def _depths(scene: Scene, run: Run, rest: Rest) -> Iterator[Give]:
    """Yield what is pressed in by a millimetre or a share of its thickness, whatever overlaps from the start aside."""
    model = scene.model
    contacts = scene.contacts
    sizes = _thin(scene.model)
    pairs = scene.pair_indices
    speeds = np.linalg.norm(rest.data.cvel[:, 3:], axis=1)
    solrefs: dict[int, tuple[float, float]] = {}

    def stiffer(model, data, hardest: bool = False) -> None:
        for contact, solref in solrefs.items():
            first, second, named = (
                int(getattr(contacts, side)[contact])
                for side in ("first", "second", "named")
            )
            rows = (
                [named]
                if named >= 0
                else [first]
                if contacts.outranked[contact]
                else [first, second]
            )
            kind = "pair" if named >= 0 else "geom"
            getattr(model, f"{kind}_solref")[rows] = shortest if hardest else solref
            if hardest:
                getattr(model, f"{kind}_solimp")[rows, :3] = HARD

    shortest = 2.0 * model.opt.timestep, 1.0
    harder: Edit = partial(stiffer, hardest=True)
    for pair in dict.fromkeys(
        tuple(sorted(pair)) for pair in rest.data.contact.geom.tolist()
    ):
        if (contact := pairs.get(pair)) is None:  # a flex, or one of many alike
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
        ways = [
            (", ".join(map(str, changes)), stiffer),
            (HARDEST.format(_text(shortest), _text(HARD)), harder),
        ]
        is_certain = depth > 2.0 * run.first.get(pair, 0.0) and rest.speed < 0.1 * WILD
        yield Give(
            "depth",
            scene.names[thin],
            "depth",
            "is how deep it is pressed in, as a contact is only as stiff as its lighter body is heavy,",
            read,
            ways,
            "mm",
            least,
            sizes[thin] / least if is_certain else math.inf,
            (scene.names[partner],),
            scene.source.geom(thin),
        )


def _limits(model: MjModel, data: MjData) -> Iterator[Give]:
    """Yield joints and tendons with a range, and how far beyond it they lie."""
    solref = max(0.005, 2.0 * model.opt.timestep), 1.0
    servos = np.flatnonzero(
        is_servo(model)
    )  # the trnid of others may be that of a tendon
    servos = servos[model.jnt_limited[model.actuator_trnid[servos, 0]] > 0]
    gears = np.where(
        model.actuator_gear[servos, :1] == 0.0, 1.0, model.actuator_gear[servos, :1]
    )
    ranges = model.jnt_range[model.actuator_trnid[servos, 0]] / gears

    def harder(model, data) -> None:
        model.jnt_solref[:] = model.tendon_solref_lim[:] = solref

    def clipped(model, data) -> None:
        data.ctrl[servos] = np.clip(
            data.ctrl[servos], ranges.min(axis=1), ranges.max(axis=1)
        )

    def give(
        name: str,
        parameter: str,
        span: np.ndarray,
        unit: str,
        field: str,
        at: int,
        joint: int = -1,
    ) -> Give:
        low, high = span.tolist()
        ways = [(f'solreflimit="{solref[0]:g} 1" on it', harder)]
        for servo in servos[model.actuator_trnid[servos, 0] == joint].tolist():
            if (
                not low
                <= (told := data.ctrl[servo] * model.actuator_gear[servo, 0])
                <= high
            ):
                actuator = model.actuator(servo).name or "its actuator"
                ways = [
                    (
                        f'ctrlrange="{low:.4g} {high:.4g}" on {actuator}, which asks for {told:.4g}',
                        clipped,
                    )
                ]

        def past(model, data) -> float:
            value = getattr(data, field)[at]
            return max(low - value, value - high)

        return Give(
            "limit",
            name,
            parameter,
            "is how far it is beyond its range",
            past,
            ways,
            unit,
            far=MUCH,
        )

    for joint in np.flatnonzero(
        model.jnt_limited & np.isin(model.jnt_type, (HINGE, SLIDE))
    ).tolist():
        unit = "°" if model.jnt_type[joint] == HINGE else "mm"
        name = model.joint(joint).name or f"joint_{joint}"
        yield give(
            name,
            "position",
            model.jnt_range[joint],
            unit,
            "qpos",
            model.jnt_qposadr[joint],
            joint,
        )
    for tendon in np.flatnonzero(model.tendon_limited).tolist():
        name = model.tendon(tendon).name or f"tendon_{tendon}"
        unit = "°" if _turns(model, tendon) else "mm"
        yield give(
            name, "length", model.tendon_range[tendon], unit, "ten_length", tendon
        )


def unposed(model: MjModel, start: Start) -> Iterator[Finding]:
    """Yield joints that a start puts beyond their range: nobody starts there."""
    data = start.data(model)
    for give in _limits(model, data):
        if (
            give.parameter == "position"
            and (value := give.read(model, data)) > LEAST[give.unit]
        ):
            yield Finding(
                give.rule,
                give.name,
                give.parameter,
                SCALE[give.unit] * value,
                f"{give.message} at {start}, before the first step",
                unit=give.unit,
                severity="note",
            )


def _turns(model: MjModel, tendon: int) -> bool:
    """Tell whether a tendon is the sum of angles, as a fixed one of hinges."""
    wrap = model.tendon_adr[tendon]
    of_joint = model.wrap_type[wrap] == int(mujoco.mjtWrap.mjWRAP_JOINT)
    return bool(of_joint and model.jnt_type[model.wrap_objid[wrap]] == HINGE)


def _equalities(model: MjModel, data: MjData) -> Iterator[Give]:
    """Yield equalities, and how far they are open; of a weld's six rows the last three are of rotation."""
    solref = 2.0 * model.opt.timestep, 1.0

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
        yield Give(
            "equality",
            model.eq(equality).name or f"equality_{equality}",
            "gap",
            f"is how far this {kind} is open with a solref of {_text(model.eq_solref[equality])}",
            gap,
            [(f"{HARDEST.format(_text(solref), _text(HARD))} on it", harder)],
            "°" if turns else "mm",
        )


def is_servo(model: MjModel) -> np.ndarray:
    """Tell of each actuator whether it pulls a joint to a position."""
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
    """Yield servos, and how far gravity pulls them from what they are told."""
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
        yield Give(
            "servo",
            model.actuator(servo).name
            or model.joint(joint).name
            or f"actuator_{servo}",
            "error",
            "is how far gravity pulls it from its target",
            short,
            [
                ('gravcomp="1" on the bodies that it carries', light),
                (
                    f'kp="{times[servo] * model.actuator_gainprm[servo, 0]:.4g}" on it',
                    stiffer,
                ),
            ],
            unit,
            needs_way=True,
        )


def _passed(scene: Scene, rest: Rest) -> Iterator[Finding]:
    """Yield what has fallen, flown or been driven through a plate that a thicker one would have stopped."""
    model = scene.model
    contacts = scene.contacts
    data = rest.start.data(model)
    mujoco.mj_kinematics(model, data)
    pairs = np.stack([contacts.first, contacts.second], axis=1)
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    # What moves is passed by on all sides within a tenth of a second.
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
                model.geom_size[wall, axis // 2 if kind == CYLINDER else axis] *= (
                    times  # its radius, then its length
                )
                if kind == MESH:
                    model.mesh_vert[model.mesh_vertadr[mesh] :][
                        : model.mesh_vertnum[mesh], axis
                    ] *= times
                model.geom_aabb[wall, 3 + axis] *= times
                model.geom_rbound[wall] = np.linalg.norm(model.geom_aabb[wall, 3:])
                model.opt.disableflags |= UNSORTED  # whose tree of boxes is compiled

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
                    f"thick, and it has gone through it, from {rest.start}",
                    (scene.names[wall],),
                    None,
                    "mm",
                    "error",
                    scene.source.geom(wall),
                    Advice(
                        f"a thickness of {times * thick:.3g} mm stops it, measured; or a softer drive"
                    ),
                )
                return


def _crossing(
    model: MjModel, pairs: np.ndarray, places: Sequence[Places]
) -> np.ndarray:
    """Tell of geoms and plates whether the geom has gone from one side of the plate to the other, and through it."""
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
    """Yield a keyframe that does not say what its servos are told, so that they pull to 0."""
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
        yield Finding(
            "keyframe",
            rest.start.name,
            "speed",
            before,
            "m/s or rad/s is how fast it is left, since it has no ctrl and servos pull to 0",
            element=key,
            advice=Advice(
                f'ctrl="{_text(told.ctrl)}" in the <key>: {before:.3g} → {after:.3g} m/s or rad/s'
            ),
        )


def _fastest(model: MjModel, data: MjData) -> float:
    fastest = 0.0
    for _ in range(round(LEAVES_S / model.opt.timestep)):
        mujoco.mj_step(model, data)
        fastest = max(fastest, np.abs(data.qvel).max(initial=0.0))
    return fastest


def _crowded(scene: Scene, rest: Rest) -> Iterator[Finding]:
    """Yield height fields under which a geom has as many contacts as a pair gets: those of the far side are missing."""
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
                f"{MOST_CONTACTS} contacts are all that a pair gets, and more cells touch it: it sinks through",
                (names[field],),
                element=scene.source.geom(field),
                advice=Advice(
                    f'nrow="{nrow}" ncol="{ncol}" on the <hfield>: cells about as large as what stands on them'
                ),
            )
            return


def _thin(model: MjModel) -> np.ndarray:
    """Return half the thickness of each geom where it is thinnest; infinite of what has no other side [m]."""
    sizes = np.where(model.geom_size > 0.0, model.geom_size, np.inf).min(axis=1)
    sizes[np.isin(model.geom_type, (PLANE, HFIELD))] = np.inf
    return sizes


def _text(values: Sequence[float]) -> str:
    return " ".join(f"{value:.4g}" for value in values)
