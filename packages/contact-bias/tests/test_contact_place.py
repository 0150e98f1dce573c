"""Compares the exact term with numerical differences of MuJoCo C's rows."""

from collections.abc import Iterator
from copy import copy
from functools import partial
from itertools import islice
from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import pytest
import warp as wp

import contact_bias
import contact_bias_c
import contact_place
from contact_tumbles import captured

STATES_OF_A_KIND = 1
"""States for each cone and dimension, which make 8 for each pair."""
DEPTH_M = 1e-4
GEOMS = {
    "plane": 'type="plane" size="5 5 1"',
    "sphere": 'type="sphere" size="0.1"',
    "capsule": 'type="capsule" size="0.07 0.15"',
    "ellipsoid": 'type="ellipsoid" size="0.1 0.15 0.2"',
    "cylinder": 'type="cylinder" size="0.1 0.12"',
    "box": 'type="box" size="0.1 0.13 0.16"',
    "mesh": 'type="mesh" mesh="block"',
}
CORNERS = " ".join(
    f"{x} {y} {z}" for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)
)
BY_FORMULA = [
    ("plane", other)
    for other in ("sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh")
]
BY_FORMULA += [("sphere", other) for other in ("sphere", "capsule", "cylinder", "box")]
BY_FORMULA += [("capsule", "capsule"), ("capsule", "box")]
BY_FORMULA += [("box", "box")]
STEP_S = 1e-5
NOTHING_M_S2 = 1e-6
"""A pair whose rate is zero."""
KINDS = [(cone, dim) for cone in ("elliptic", "pyramidal") for dim in (1, 3, 4, 6)]


def pair(first: str, second: str, cone: str, dim: int) -> mujoco.MjModel:
    """Return a model of two free bodies, or of one body and a tilted plane."""
    joint, tilt = ("", 'euler="20 30 10"') if first == "plane" else ("<freejoint/>", "")
    return mujoco.MjModel.from_xml_string(f"""<mujoco>
      <option timestep="1e-6" cone="{cone}" gravity="0 0 0" ccd_tolerance="1e-12" ccd_iterations="500">
        <flag multiccd="disable"/>
      </option>
      <default><geom margin="0.1" solref="2e-6 1"/></default>
      <asset>
        <mesh name="block" vertex="{CORNERS}"/>
      </asset>
      <worldbody>
        <body {tilt}>{joint}<geom {GEOMS[first]} condim="{dim}"/></body>
        <body><freejoint/><geom {GEOMS[second]} condim="{dim}"/></body>
      </worldbody>
    </mujoco>""")


def states(model: mujoco.MjModel, seed: int) -> Iterator[mujoco.MjData]:
    """Yield random states of two bodies that barely touch, with moderate velocities."""
    random = np.random.default_rng(seed)
    data = mujoco.MjData(model)
    for _ in range(200):
        for joint in range(model.njnt):
            quaternion = random.normal(size=4)
            data.qpos[7 * joint + 3 : 7 * joint + 7] = quaternion / np.linalg.norm(
                quaternion
            )
        way = random.normal(size=3)
        if model.njnt == 1:
            mujoco.mj_kinematics(model, data)
            way = data.geom_xmat[0].reshape(3, 3) @ (0.1 * way[0], 0.1 * way[1], 1.0)
        way /= np.linalg.norm(way)
        near = 0.0
        far = 3.0
        for _ in range(40):
            data.qpos[-7:-4] = 0.5 * (near + far) * way
            mujoco.mj_fwdPosition(model, data)
            inside = (
                min((contact.dist for contact in data.contact), default=1.0) < -DEPTH_M
            )
            near, far = (
                (0.5 * (near + far), far) if inside else (near, 0.5 * (near + far))
            )
        data.qvel[:] = random.normal(0.0, 2.0, model.nv)
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        if data.ncon and abs(data.contact.dist.min() + DEPTH_M) < DEPTH_M:
            yield data


def velocities(
    model: mujoco.MjModel, data: mujoco.MjData, time_s: float
) -> np.ndarray | None:
    """Return J q̇ of the first contact's rows after a time at constant velocity.

    The result is None if the contacts change.
    """
    moved = mujoco.MjData(model)
    moved.qpos[:] = data.qpos
    moved.qvel[:] = data.qvel
    mujoco.mj_integratePos(model, moved.qpos, data.qvel, time_s)
    mujoco.mj_fwdPosition(model, moved)
    if moved.ncon != data.ncon:
        return None
    found = np.zeros(moved.nefc)
    mujoco.mj_mulJacVec(model, moved, found, moved.qvel)
    return found[rows_of(model, moved.contact[0])]


def rows_of(model: mujoco.MjModel, contact) -> slice:
    is_pyramid = model.opt.cone != contact_bias_c.ELLIPTIC and contact.dim > 1
    return slice(
        contact.efc_address,
        contact.efc_address + (2 * contact.dim - 2 if is_pyramid else contact.dim),
    )


def rates(
    model: mujoco.MjModel, data: mujoco.MjData, step_s: float
) -> np.ndarray | None:
    """Return d(J q̇)/dt of the first contact's rows, by fourth-order differences."""
    found = [velocities(model, data, factor * step_s) for factor in (1, -1, 2, -2)]
    if any(each is None for each in found):
        return None
    return (8.0 * (found[0] - found[1]) - (found[2] - found[3])) / (12.0 * step_s)


def is_corner(kind: int, out: np.ndarray) -> bool:
    """Return whether a geom is touched at an edge or corner, by its local normal."""
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        return 1e-6 < abs(out[2]) < 1.0 - 1e-6
    return (
        kind in (mujoco.mjtGeom.mjGEOM_BOX, mujoco.mjtGeom.mjGEOM_MESH)
        and np.abs(out).max() < 1.0 - 1e-6
    )


def is_smooth(model: mujoco.MjModel, data: mujoco.MjData) -> bool:
    """Return whether the nearest contact involves at most one edge or corner.

    A mesh may only touch a plane.
    """
    contact = data.contact[0]
    normals = [
        data.geom_xmat[geom].reshape(3, 3).T @ contact.frame[:3]
        for geom in contact.geom
    ]
    kinds = model.geom_type[contact.geom]
    corners = [is_corner(*each) for each in zip(kinds, normals, strict=True)]
    if contact.dist > data.contact.dist.min():
        return False
    return not all(corners) and not (
        kinds[1] == mujoco.mjtGeom.mjGEOM_MESH and kinds[0] != 0 and corners[1]
    )


def smooth_states(
    model: mujoco.MjModel, seed: int
) -> Iterator[tuple[mujoco.MjData, np.ndarray]]:
    """Yield states with a rate on which differences over two steps agree, and the rate."""
    for data in states(model, seed):
        coarse = rates(model, data, STEP_S)
        fine = rates(model, data, 0.5 * STEP_S)
        if coarse is None or fine is None or not is_smooth(model, data):
            continue
        if np.linalg.norm(coarse - fine) <= 3e-4 * np.linalg.norm(fine) + NOTHING_M_S2:
            yield data, fine


def subtracted(model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
    """Return the values that MuJoCo Warp subtracts from the first contact's rows."""
    chosen = wp.array([True], dtype=bool)
    without_margin = copy(model)
    # MuJoCo Warp ignores the margin between boxes.
    without_margin.geom_margin[:] = 0.0
    m = mjw.put_model(without_margin)
    d = mjw.put_data(model, data, nconmax=20, njmax=100)
    mjw.rne(m, d)
    d.efc.aref.zero_()
    contact_bias.apply(m, d, chosen, centred=False, normal=True)
    contact_place.apply(m, d, chosen, centred=False, normal=True)
    return -d.efc.aref.numpy()[0][rows_of(model, data.contact[0])]


@pytest.mark.parametrize(("first", "second"), BY_FORMULA)
def test_what_is_subtracted_is_the_rate_of_the_row(first, second):
    with wp.ScopedDevice("cpu"):
        for number, (cone, dim) in enumerate(KINDS):
            model = pair(first, second, cone, dim)
            found = smooth_states(model, number)
            held = 0
            for data, wanted in islice(found, STATES_OF_A_KIND):
                missed = np.linalg.norm(subtracted(model, data) - wanted)
                assert missed <= 1e-3 * np.linalg.norm(wanted) + NOTHING_M_S2
                held += 1
            assert held == STATES_OF_A_KIND


def place_on_second(data: mujoco.MjData) -> np.ndarray:
    """Return the position of the first contact in the frame of the second geom [m]."""
    contact = data.contact[0]
    at = contact.pos + 0.5 * contact.dist * contact.frame[:3] - data.geom_xpos[1]
    return data.geom_xmat[1].reshape(3, 3).T @ at


@pytest.mark.parametrize(
    ("second", "length_m"), [("sphere", np.inf), ("ellipsoid", 0.2), ("cylinder", 0.1)]
)
def test_of_a_rate_that_turns_while_its_contact_settles_a_row_gets_what_is_left(
    second, length_m
):
    """The share decreases with the angle of the bodies and the contact, up to a radian."""
    model = pair("plane", second, "elliptic", 3)
    with wp.ScopedDevice("cpu"):
        data, rate = next(smooth_states(model, 0))
        ahead = copy(data)
        mujoco.mj_integratePos(model, ahead.qpos, data.qvel, 1e-5)
        mujoco.mj_fwdPosition(model, ahead)
        start, end = (place_on_second(state) for state in (data, ahead))
        turning = (
            np.linalg.norm(data.qvel[3:])
            + np.linalg.norm(end - start) / 1e-5 / length_m
        )
        for angle, left in ((0.3, 0.7), (0.8, 0.2), (1.1, 0.0)):
            model.opt.timestep = (
                angle / turning / 2.9
            )  # 2 / b is 0.95 (dmax) of the shortest timeconst, which is two steps.
            assert subtracted(model, data) == pytest.approx(
                left * rate, abs=5e-3 * np.linalg.norm(rate)
            )


def test_a_capsule_that_nearly_stands_whose_frame_runs_round_with_its_lean_gets_nothing():
    model = pair("plane", "capsule", "elliptic", 3)
    model.opt.timestep = 0.002
    data = mujoco.MjData(model)
    data.qpos[3:] = model.body_quat[1] + (0.0, 0.015, 0.0, 0.0)
    mujoco.mj_kinematics(model, data)
    data.qpos[:3] = data.geom_xmat[0].reshape(3, 3) @ (0.0, 0.0, 0.22)
    data.qvel[3:] = 3.0, 9.0, 0.0
    mujoco.mj_forward(model, data)
    with wp.ScopedDevice("cpu"):
        assert not subtracted(model, data).any()


def test_a_contact_without_a_normal_as_boxes_and_cylinders_have_in_the_engine_gets_nothing():
    model = pair("plane", "capsule", "elliptic", 3)
    data = next(states(model, 0))
    data.contact.frame[:] = 0.0
    data.contact.pos[:] = data.geom_xpos[1]
    with wp.ScopedDevice("cpu"):
        assert not subtracted(model, data).any()


def test_the_rim_of_a_cylinder_that_nearly_stands_is_no_side_where_the_engine_rounds_its_place():
    model = pair("plane", "cylinder", "elliptic", 3)
    data = mujoco.MjData(model)
    data.qpos[3:] = model.body_quat[1] + (0.0, 5e-4, 0.0, 0.0)
    mujoco.mj_kinematics(model, data)
    data.qpos[:3] = data.geom_xmat[0].reshape(3, 3) @ (0.0, 0.0, 0.12)
    data.qvel[3:] = 1.0, 2.0, 3.0
    mujoco.mj_forward(model, data)
    data.contact.pos[:] += 3e-4 * data.contact.frame[:, :3]
    with wp.ScopedDevice("cpu"):
        assert np.abs(subtracted(model, data)).max() < 10.0


STEP_COUNT = 500
BALL = """<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast"/>
  <worldbody>
    <geom type="plane" size="5 5 1"/>
    <body pos="0 0 0.03"><freejoint/><geom type="sphere" size="0.03" mass="0.2"/></body>
  </worldbody>
</mujoco>"""


def ball() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """The ball rolls at 1 m/s and spins at 20 rad/s."""
    model = mujoco.MjModel.from_xml_string(BALL)
    data = mujoco.MjData(model)
    data.qvel[:] = 1.0, 0.0, 0.0, 0.0, 1.0 / 0.03, 20.0
    mujoco.mj_forward(model, data)
    return model, data


def in_c(control) -> np.ndarray:
    model, data = ball()
    mujoco.set_mjcb_control(control)
    try:
        mujoco.mj_step(model, data, STEP_COUNT)
    finally:
        mujoco.set_mjcb_control(None)
    return data.qpos.copy()


def in_warp(*installed: bool, **options) -> np.ndarray:
    """Return the pose of the ball in two worlds with or without the term, shape [2, 7]."""
    model, data = ball()
    with wp.ScopedDevice("cpu"):
        m = mjw.put_model(model)
        d = mjw.put_data(model, data, nworld=2, nconmax=4, njmax=16)
        if installed:
            contact_place.install(
                SimpleNamespace(mjw_model=m, mjw_data=d), worlds=installed, **options
            )
        mjw.step(m, d)  # This compiles the kernels, which a capture does not permit.
        step = captured(partial(mjw.step, m, d))
        for _ in range(STEP_COUNT - 1):
            step()
        return d.qpos.numpy()


@pytest.mark.slow
def test_a_ball_that_rolls_and_spins_goes_straight_and_no_deeper():
    bare = in_warp()
    with_term = in_warp(True, False, normal=True)
    assert with_term[1].tobytes() == bare[1].tobytes()
    assert with_term[0].tobytes() != bare[0].tobytes()
    assert with_term[0][0] == pytest.approx(1.0, abs=2e-3)
    assert abs(with_term[0][1]) <= 0.5e-3
    assert abs(with_term[0][2] - bare[0][2]) <= 0.1e-3
    points = in_c(lambda model, data: contact_bias_c.subtract_bias(model, data))
    assert abs(points[1]) > 10e-3
