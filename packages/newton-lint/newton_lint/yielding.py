"""Rules on contacts, joints, equalities and servos that yield to their load."""

import math
from collections.abc import Iterator, Sequence

import mujoco
import numpy as np
from mujoco import MjModel

from newton_lint.changes import (
    Changes,
    elliptic,
    of_contacts,
    of_element,
    of_geom,
    of_option,
    of_servo,
    text_of,
)
from newton_lint.failures import is_servo, origin, shorter_steps
from newton_lint.findings import Finding, number, rounded
from newton_lint.law import DEFAULT_SOLREF, M
from newton_lint.ledger import Run
from newton_lint.pairs import HFIELD, PLANE, where
from newton_lint.scene import HINGE, ON_JOINT, SLIDE, Scene
from newton_lint.scene_rules import STEEP
from newton_lint.trials import Read, Symptom

LEAST = 1.0
"""Least depth, distance or angle that is reported [mm or °]."""
FAR = 5.0
"""A finding is a warning above this distance or angle [mm or °]."""
MUCH = 3.0
"""For limits of joints and tendons, this one applies instead."""
THIN = 0.1
"""A depth is reported if it is at least this share of the thickness of a geom."""
DEEP_MM = 2.0
"""A depth of at least this is a warning."""
PADDED = 0.5
"""A dmin below this one makes a contact soft on purpose."""
HARD = "0.999 0.999 0.001"
FEW_ALIKE = 3
SAGS = 5e-3
"""A joint that is at least this fast creeps [m/s or rad/s]."""
HELD = 0.99
"""The friction of a joint must be below this share of its frictionloss."""
AGREES = 0.7
"""Measured and predicted values agree within this ratio."""
LEAST_SWING = 0.1
"""A reading swings if it still changes by this share of its swing, or of its mean."""
THICKER = (2, 4, 8, 16, 32)
MOST_CONTACTS = int(mujoco.mjMAXCONPAIR)
DRY_FRICTION = int(mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF)
PLATES = tuple(range(mujoco.mjtGeom.mjGEOM_ELLIPSOID, mujoco.mjtGeom.mjGEOM_MESH + 1))
ELLIPSOID, CYLINDER, BOX, MESH = PLATES
SITE = int(mujoco.mjtObj.mjOBJ_SITE)
COUPLINGS = {
    int(getattr(mujoco.mjtEq, f"mjEQ_{name.upper()}")): name
    for name in ("connect", "weld", "joint", "tendon")
}


def when(run: Run, *bodies: int) -> str:
    """Return the time of a reading in words: "at rest" only if these bodies rest."""
    state = "at rest" if run.still[list(bodies)].all() else "after 2 s"
    return f"{state}{origin(run)}"


def scale(unit: str) -> float:
    return math.degrees(1.0) if unit.startswith("°") else M


def stiffest(scene: Scene) -> str:
    """Return the shortest solref that the time step permits."""
    return f"{2.0 * scene.option.timestep_s:.3g} 1"


def depths(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield geoms that sink by a millimetre or by a share of their thickness."""
    model = scene.model
    contacts = scene.contacts
    sizes = M * _thin(model)
    # A dict keeps the order, so that the findings of two runs have the same order.
    late = dict.fromkeys(
        tuple(pair) for sample in run.late for pair in sample.touches.pairs.tolist()
    )
    sunk = [
        contact
        for pair in late
        if M * depth_m(run, pair) > 0.3 * LEAST
        and (contact := scene.pair_index(pair)) is not None
    ]
    for pair in late:
        # The pair may be of a geom that is not read.
        if (contact := scene.pair_index(pair)) is None:
            continue

        def read(run: Run, pair=pair) -> float:
            return M * depth_m(run, pair)

        depth = read(run)
        bodies = model.geom_bodyid[list(pair)].tolist()
        thin, partner = sorted(pair, key=lambda geom: sizes[geom])
        least = min(LEAST, THIN * 2.0 * sizes[thin])
        # A body that moves sinks into one that does not.
        is_static = model.body_weldid[model.geom_bodyid[[thin, partner]]] == 0
        shape, partner = (partner, thin) if is_static[0] else (thin, partner)
        lies = scene.free[bodies].sum() == 1 and model.body_weldid[bodies].min() == 0
        first = M * run.first.get(pair, 0.0)
        # A pair that overlaps at the start is reported by the rule overlap.
        if depth <= least or (depth < 2.0 * first and not lies):
            continue
        rests = run.still[bodies].all()
        lasts = min(late_depths(run, pair)) > 0.5 * depth / M
        # The stiffness of a contact depends on the product of the two numbers. That of
        # a direct solref, which is always chosen on purpose, is large.
        is_soft = contacts.solref[contact].prod() > DEFAULT_SOLREF[0]
        mu = contacts.friction[contact, 0]
        # Such a contact was chosen to be soft at first, and hard within its width.
        dmin, _, width_m, *_ = contacts.solimp[contact]
        is_padded = not is_soft and dmin < PADDED and depth < M * width_m
        much = LEAST if is_soft else DEEP_MM
        severe = depth > min(much, max(2.0 * THIN * sizes[thin], 0.2))
        if scene.option.cone == "pyramidal" and mu > STEEP:
            why = f"a friction of {number(mu)} softens contacts with a pyramidal cone"
        elif is_soft:
            solref = text_of(contacts.solref[contact])
            why = f"the solref of their contact ({solref}) is too soft for the load"
        else:
            why = "contact stiffness scales with the mass of the lighter body"
        yield Symptom(
            Finding(
                "depth",
                scene.names[shape],
                "depth",
                depth,
                f"$shape sinks $value into $against {when(run, *bodies)}",
                against=(scene.names[partner],),
                unit="mm",
                severity="warning"
                if (
                    (severe and rests)
                    or (lasts and depth > DEEP_MM)
                    or depth > sizes[thin]
                )
                and depth > 2.0 * first
                and not is_padded
                else "note",
            ),
            read,
            list(_stiffening(scene, contact, depth, sunk)),
            needs_cure=not rests,
            why=why,
        )


def depth_m(run: Run, pair: Sequence[int]) -> float:
    """Return the mean of the deepest contact of two geoms in the late samples [m]."""
    return float(np.mean(late_depths(run, pair)))


def late_depths(run: Run, pair: Sequence[int]) -> list[float]:
    return [
        sample.touches.depth_m[sample.touches.between(pair)].max(initial=0.0)
        for sample in run.late
    ]


def _stiffening(
    scene: Scene, contact: int, depth_mm: float, sunk: Sequence[int]
) -> Iterator[Changes]:
    """Yield changes that make a contact stiffer, alone or with others.

    Args:
        sunk: All contacts that sink.
    """
    contacts = scene.contacts
    least = 2.0 * scene.option.timestep_s
    # The depth at a constant impedance is proportional to timeconst².
    share = min(0.3 / depth_mm, 0.1)

    def stiffer(old: Sequence[float]) -> str:
        first, second = old
        if first > 0.0:
            timeconst = share**0.5 * first * max(second, 1.0)
            return f"{max(timeconst, least):.2g} 1"
        # For a direct solref, the damping grows with the root of the stiffness.
        return f"{first / share:.3g} {second / share**0.5:.3g}"

    def hardest(_: Sequence[float]) -> str:
        return stiffest(scene)

    if scene.option.cone == "pyramidal" and contacts.friction[contact, 0] > STEEP:
        yield elliptic(scene)
    alike = [
        pair
        for pair in sunk
        if np.array_equal(contacts.solref[pair], contacts.solref[contact])
    ]
    # Many equal contacts share one change instead of having one each.
    group = alike if len(alike) > FEW_ALIKE else [contact]
    yield of_contacts(scene, group, stiffer)
    yield of_contacts(scene, group, hardest)
    yield of_contacts(scene, group, hardest, HARD)
    # A body between two others sinks into one of them if only the other gets stiffer.
    yield of_contacts(scene, sunk, hardest, HARD)


def noslip(scene: Scene) -> list[Changes]:
    """Return changes that add the noslip pass, unless the engine may not have it."""
    if scene.engine.name != "mujoco":
        return []
    return [of_option(scene, noslip_iterations="10")]


def limits(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield joints and tendons that have a range, with the distance beyond it."""
    model = scene.model
    solref = f"{max(0.005, 2.0 * model.opt.timestep):.3g} 1"
    servos = np.flatnonzero(is_servo(model))
    ctrl = run.start.data(model).ctrl
    is_single = np.isin(model.jnt_type, (HINGE, SLIDE))
    joints = where(model.jnt_limited & is_single)
    tendons = where(model.tendon_limited)
    for kind, index in [
        *(("joint", joint) for joint in joints),
        *(("tendon", tendon) for tendon in tendons),
    ]:
        why = "the solref of its limit is too soft for the load"
        ways: list[Changes] = []
        moving = [*range(model.nbody)]
        if kind == "joint":
            low, high = model.jnt_range[index].tolist()
            moving = [model.jnt_bodyid[index]]
            values = "qpos"
            at = model.jnt_qposadr[index]
            for servo in servos[model.actuator_trnid[servos, 0] == index].tolist():
                gear = model.actuator_gear[servo, 0]
                target = ctrl[servo] * gear
                if not low <= target <= high:
                    why = (
                        f"{scene.name('actuator', servo)} pulls it to a target of"
                        f" {number(target)}"
                    )
                    span = text_of(sorted((low / gear, high / gear)))
                    ways.append(of_element(scene, "actuator", servo, ctrlrange=span))
        else:
            low, high = model.tendon_range[index].tolist()
            values = "ten_length"
            at = index
        unit = unit_of(model, kind, index)
        ways.append(of_element(scene, kind, index, solreflimit=solref))
        read = past(values, at, low, high, unit)
        start = run.samples[0].arrays[values][at]
        first = scale(unit) * max(low - start, start - high)
        if first > LEAST:
            why = f"it starts {rounded(first, unit)} beyond it"
        if (value := read(run)) > LEAST:
            finding = Finding(
                "limit",
                scene.name(kind, index),
                "position" if kind == "joint" else "length",
                value,
                f"$shape is $value beyond its range {when(run, *moving)}",
                unit=unit,
                severity="warning" if value > MUCH else "note",
            )
            # A robot that falls or flails passes its limits for other reasons.
            moves = first <= LEAST and not run.still[moving].all()
            yield Symptom(finding, read, ways, needs_cure=moves, why=why)


def past(name: str, at: int, low: float, high: float, unit: str) -> Read:
    """Return a reading of how far a value is, or swings about, beyond its range."""

    def read(run: Run) -> float:
        values = np.array([sample.arrays[name][at] for sample in run.samples])
        centre = _centre(values, len(run.late))
        return scale(unit) * max(low - centre, centre - high, 0.0)

    return read


def unit_of(model: MjModel, kind: str, index: int) -> str:
    """Return the unit of the position of a joint or of the length of a tendon."""
    if kind == "tendon":
        wrap = model.tendon_adr[index]
        if model.wrap_type[wrap] != int(mujoco.mjtWrap.mjWRAP_JOINT):
            return "mm"
        # The length is a sum of joint positions.
        index = model.wrap_objid[wrap]
    return "°" if model.jnt_type[index] == HINGE else "mm"


def equality_unit(model: MjModel, equality: int) -> str:
    """Return the unit in which the gap of an equality is measured."""
    kind = COUPLINGS.get(model.eq_type[equality], "")
    is_place = kind not in ("joint", "tendon")
    return "mm" if is_place else unit_of(model, kind, model.eq_obj1id[equality])


def coupled(scene: Scene, equality: int) -> list[int]:
    """Return the two bodies of a connect or weld equality, or []."""
    model = scene.model
    if COUPLINGS.get(model.eq_type[equality]) not in ("connect", "weld"):
        return []
    ids = [model.eq_obj1id[equality], model.eq_obj2id[equality]]
    is_site = model.eq_objtype[equality] == SITE
    return [model.site_bodyid[index] for index in ids] if is_site else ids


def equalities(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield equalities with their gap; for a weld, this is the translational gap."""
    model = scene.model
    for equality in run.samples[-1].gaps:
        if (kind := COUPLINGS.get(model.eq_type[equality])) is None:
            continue
        unit = equality_unit(model, equality)

        def gap(run: Run, equality=equality, unit=unit) -> float:
            gaps = [sample.gaps.get(equality, 0.0) for sample in run.samples]
            return scale(unit) * _centre(np.array(gaps), len(run.late))

        if (value := gap(run)) <= LEAST:
            continue
        name = scene.name("equality", equality)
        solref = text_of(model.eq_solref[equality])
        hard = {"solref": stiffest(scene)}
        ways = [
            of_element(scene, "equality", equality, **attributes)
            for attributes in (hard, hard | {"solimp": HARD})
        ]
        moving = coupled(scene, equality) or range(model.nbody)
        finding = Finding(
            "equality",
            name,
            "gap",
            value,
            f"$shape is $value open {when(run, *moving)}",
            unit=unit,
            severity="warning" if value > FAR else "note",
        )
        why = f"its solref ({solref}) is too soft for the load on this {kind} equality"
        yield Symptom(finding, gap, ways, why=why)


def _centre(values: np.ndarray, late: int) -> float:
    """Return the value about which a reading swings, or its mean in the late samples."""
    mean = values[-late:].mean()
    ways = np.sign(np.diff(values))
    # Turning points of the swing: the sign of the slope changes there.
    turns = values[1:-1][(ways[1:] * ways[:-1]) < 0.0][-3:]
    if len(turns) < 3:
        return mean
    # A swing that ended, or that is small, has a good mean.
    if np.ptp(values[-late:]) < LEAST_SWING * max(abs(mean), np.ptp(turns)):
        return mean
    # This mean is exact for a decaying oscillation in which each half swing is
    # smaller by the same amount.
    return turns @ (0.25, 0.5, 0.25)


def servos(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield servos that gravity pulls from their targets."""
    model = scene.model
    ctrl = run.start.data(model).ctrl.copy()
    limited = model.actuator_ctrllimited > 0
    ctrl[limited] = np.clip(ctrl[limited], *model.actuator_ctrlrange[limited].T)
    for servo in where(is_servo(model) & (model.actuator_dyntype == 0)):
        joint = model.actuator_trnid[servo, 0]
        dof = model.jnt_dofadr[joint]
        body = model.jnt_bodyid[joint]
        # A servo that presses against a contact or a limit need not reach its target.
        is_blocked = abs(run.mean("qfrc_constraint")[dof]) > 1e-9
        if model.jnt_type[joint] not in (HINGE, SLIDE) or is_blocked:
            continue
        unit = unit_of(model, "joint", joint)

        def short(run: Run, servo=servo, unit=unit) -> float:
            length = run.mean("actuator_length")[servo]
            return scale(unit) * abs(ctrl[servo] - length)

        if (value := short(run)) <= LEAST or not run.still[body]:
            continue
        weightless: Changes = ()
        for child in range(1, model.nbody):
            if body in _ancestors(model, child):
                weightless += of_element(scene, "body", child, gravcomp="1")
        force = abs(run.data.actuator_force[servo])
        limit = model.actuator_forcerange[servo]
        is_weak = model.actuator_forcelimited[servo] and force > HELD * limit.max()
        # The error is proportional to 1/kp; half of the least error leaves a margin.
        times = math.ceil(2.0 * value / LEAST)
        gain = times * model.actuator_gainprm[servo, 0]
        # The damping ratio stays the same if kv grows with the root of kp.
        damping = -(times**0.5) * model.actuator_biasprm[servo, 2]
        finding = Finding(
            "servo",
            scene.name("actuator", servo),
            "error",
            value,
            f"$shape is $value from its target {when(run, body)} because gravity"
            f" pulls it and its {'forcerange' if is_weak else 'kp'} is low",
            unit=unit,
            severity="warning" if value > FAR else "note",
        )
        ways = [weightless, of_servo(scene, servo, gain, damping)]
        if is_weak:
            spans = (text_of(times * limit) for times in (2.0, 8.0))
            ways[1:] = [
                of_element(scene, "actuator", servo, forcerange=span) for span in spans
            ]
        yield Symptom(finding, short, ways, needs_cure=True)


def _ancestors(model: MjModel, body: int) -> Iterator[int]:
    """Yield a body and the bodies that carry it."""
    while body:
        yield body
        body = model.body_parentid[body]


def sagging(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield joints that creep although their friction exceeds the load."""
    model = scene.model
    data = run.data
    followers = model.eq_obj1id[model.eq_type == int(mujoco.mjtEq.mjEQ_JOINT)]
    driven = model.jnt_dofadr[
        np.append(model.actuator_trnid[is_servo(model), 0], followers)
    ]
    idle = (model.actuator_trntype == ON_JOINT) & (run.start.data(model).ctrl == 0.0)
    undriven = model.jnt_dofadr[model.actuator_trnid[idle, 0]]
    for row in where(data.efc_type[: data.nefc] == DRY_FRICTION):
        dof = data.efc_id[row]
        joint = model.dof_jntid[dof]

        unit = f"{unit_of(model, 'joint', joint)}/s"

        def creep(run: Run, joint=joint, unit=unit) -> float:
            begin = run.late[0]
            end = run.late[-1]
            address = model.jnt_qposadr[joint]
            moved = end.arrays["qpos"][address] - begin.arrays["qpos"][address]
            return scale(unit) * abs(moved) / max(end.time_s - begin.time_s, 1e-9)

        rate = creep(run) / scale(unit)
        force = max(abs(data.efc_force[row]), mujoco.mjMINVAL)
        # At a steady speed the row balances b v = R f, as in law.py.
        predicted = data.efc_R[row] * force / data.efc_KBIP[row, 1]
        loads = [abs(data.qfrc_smooth[dof]), abs(data.qfrc_constraint[dof])]
        # Only creep that the law predicts is reported, under a load that is constant:
        # both the applied and the constraint force are close to the force of the row.
        ratios = [rate / max(predicted, 1e-12), *(load / force for load in loads)]
        if (
            rate < SAGS
            or dof in driven
            or force > HELD * model.dof_frictionloss[dof]
            or not AGREES < min(ratios) <= max(ratios) < 1.0 / AGREES
        ):
            continue
        loss = model.dof_frictionloss[dof]
        ways = [of_element(scene, "joint", joint, solimpfriction=HARD)]
        ways += noslip(scene)
        yield Symptom(
            Finding(
                "sag",
                scene.name("joint", joint),
                "speed",
                scale(unit) * rate,
                f"$shape creeps at $value{origin(run)} under a load of"
                f" {number(force)}, which is {force / loss:.0%} of its frictionloss,"
                " because MuJoCo's dry friction yields like a damper",
                unit=unit,
                severity="note" if dof in undriven else "warning",
            ),
            creep,
            ways,
        )


def passing(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield geoms that pass through a plate and would not if it were thicker."""
    model = scene.model
    contacts = scene.contacts
    pairs = np.concatenate([contacts.geoms, contacts.geoms[:, ::-1]])
    # Only plates that stand still count; moving bodies pass others without contact.
    still = model.body_weldid[model.geom_bodyid] == 0
    walls = np.isin(model.geom_type, PLATES) & still
    pairs = pairs[walls[pairs[:, 1]]]
    for geom, wall in pairs[_crossing(model, pairs, run)][:1].tolist():
        pair = np.array([[geom, wall]])

        def crosses(run: Run, pair=pair) -> float:
            # A geom that stops within a plate has not been stopped by it.
            return float(_crossing(model, pair, run, inside=0.5).any())

        # The thinnest direction of the bounding box is the normal of a plate.
        axis = model.geom_aabb[wall, 3:].argmin()
        thick = 2.0 * M * model.geom_aabb[wall, 3 + axis]
        column = axis // 2 if model.geom_type[wall] == CYLINDER else axis
        contact = scene.pair_index((geom, wall))
        mu = 0.0 if contact is None else contacts.friction[contact, 0]
        is_steep = scene.option.cone == "pyramidal" and mu > STEEP
        ways = [elliptic(scene)] if is_steep else []
        for times in THICKER if model.geom_type[wall] != MESH else ():
            size = model.geom_size[wall].copy()
            size[column] *= times
            count = 2 if model.geom_type[wall] == CYLINDER else 3
            ways.append(of_geom(scene, wall, {"size": text_of(size[:count])}))
        ways += shorter_steps(scene)
        finding = Finding(
            "tunnel",
            scene.names[geom],
            "wall",
            thick,
            f"$shape passes through $against{origin(run)}, which is only $value thick,"
            " because a body that is more than halfway in is pushed out on the far side",
            against=(scene.names[wall],),
            unit="mm",
            severity="error",
            hint="Use a thicker plate or a softer drive.",
        )
        # The thickness of a mesh, or of a model without a file, cannot be tried.
        needs = scene.source.root is not None and model.geom_type[wall] != MESH
        yield Symptom(finding, crosses, ways, needs_cure=needs, effect="stops it")


def _crossing(
    model: MjModel, pairs: np.ndarray, run: Run, inside: float = 0.0
) -> np.ndarray:
    """Return whether each geom passed through its plate, for pairs of a geom and a plate.

    Args:
        inside: Share of a geom's half extent that has to stay on its side of the plate.
    """
    rows = np.arange(len(pairs))
    geoms, walls = pairs.T
    centres, sizes = np.split(model.geom_aabb[walls], 2, axis=1)
    axis = sizes.argmin(axis=1)
    crossing = np.zeros(len(pairs), dtype=bool)
    last = None
    for sample in run.samples:
        positions = sample.arrays["geom_xpos"]
        frames = sample.arrays["geom_xmat"].reshape(-1, 3, 3)
        axes = frames[walls]
        way = np.einsum("nji,nj->ni", axes, positions[geoms] - positions[walls])
        way -= centres
        normals = axes[rows, :, axis]
        along = np.abs(np.einsum("ni,nij->nj", normals, frames[geoms]))
        # Half the width of the rotated bounding box along the normal of the plate.
        extent = (along * model.geom_aabb[geoms, 3:]).sum(axis=1)
        if last is None:
            # The geom starts on one side, and has passed if it leaves on the other side.
            side = np.sign(way[rows, axis])
        else:
            edge = side * inside * extent
            before = last[rows, axis] - edge
            after = way[rows, axis] - edge
            is_through = (side * before > 0.0) & (side * after < 0.0)
            span = np.where(is_through, before - after, 1.0)
            share = np.where(is_through, before / span, 0.0)
            # Interpolate to the moment of passage, because samples are far apart.
            across = np.abs(last + (way - last) * share[:, None])
            across[rows, axis] = 0.0
            crossing |= is_through & (across <= sizes).all(axis=1)
        last = way
    return crossing


def crowded(scene: Scene, run: Run) -> Iterator[Symptom]:
    """Yield height fields with more cells under a geom than a pair has contacts."""
    model = scene.model
    if not model.nhfield:
        return
    for sample in run.samples[1:]:
        pairs, counts = np.unique(sample.touches.geoms, axis=0, return_counts=True)
        for pair in pairs[counts >= MOST_CONTACTS].tolist():
            field, geom = sorted(pair, key=lambda geom: model.geom_type[geom] != HFIELD)
            if run.still[model.geom_bodyid[geom]]:
                continue
            asset = model.geom_dataid[field]
            wide = model.hfield_size[asset][:2].tolist()
            # With cells of 0.7 radii, a geom touches too few of them to reach the limit.
            ncol, nrow = (
                max(2, round(2.0 * side / (0.7 * model.geom_rbound[geom])))
                for side in wide
            )

            def fall(run: Run, geom=geom) -> float:
                places = [sample.arrays["geom_xpos"][geom] for sample in run.samples]
                return M * np.linalg.norm(places[-1] - places[0])

            finding = Finding(
                "hfield",
                scene.names[geom],
                "cells",
                MOST_CONTACTS,
                "$shape sinks through $against because it touches more cells than"
                " MuJoCo's limit of $value contacts for a pair",
                against=(scene.names[field],),
                hint=f'Use larger cells, such as nrow="{nrow}" ncol="{ncol}".',
            )
            way = of_element(scene, "hfield", asset, nrow=str(nrow), ncol=str(ncol))
            yield Symptom(finding, fall, [way], effect="makes the cells large enough")
            return


def _thin(model: MjModel) -> np.ndarray:
    """Return half the least thickness of each geom, infinite for one-sided ones [m]."""
    sizes = np.where(model.geom_size > 0.0, model.geom_size, np.inf).min(axis=1)
    sizes[np.isin(model.geom_type, (PLANE, HFIELD))] = np.inf
    return sizes
