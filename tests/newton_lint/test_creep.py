"""The predicted creep, held against MuJoCo's C engine."""

import math

import mujoco
import pytest

from newton_lint.creep import impedance_at, predicted_creep

TIMESTEP_S, MU = 1e-3, 0.7
SCENE = """
<mujoco>
  <option timestep="{timestep}" cone="{cone}" impratio="{impratio}" tolerance="1e-14" iterations="500"/>
  <default><geom friction="{mu}" solref="{solref}" solimp="{solimp}"/></default>
  <worldbody>
    <body><joint type="hinge" axis="0 0 1" armature="1e6"/><geom type="box" size="2 2 1" pos="0 0 -1" mass="1"/></body>
    <body pos="{radius} 0 0.1">
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
      <geom type="sphere" size="0.1" mass="2"/>
    </body>
  </worldbody>
</mujoco>
"""


def scene(solref, solimp, cone="elliptic", impratio=1.0, radius=0.0) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """A ball that cannot turn, on a table that can."""
    text = SCENE.format(
        timestep=TIMESTEP_S, cone=cone, impratio=impratio, mu=MU, radius=radius,
        solref=" ".join(map(str, solref)), solimp=" ".join(map(str, solimp)),
    )  # fmt: skip
    model = mujoco.MjModel.from_xml_string(text)
    return model, mujoco.MjData(model)


def mm_s_along_x(model: mujoco.MjModel, data: mujoco.MjData) -> float:
    """What the ball slides in the second that follows once it slides steadily."""
    for _ in range(1500):
        mujoco.mj_step(model, data)
    start = data.qpos[1]
    for _ in range(1000):
        mujoco.mj_step(model, data)
    return 1e3 * (data.qpos[1] - start)


def predicted_at(model: mujoco.MjModel, data: mujoco.MjData, solref, solimp, **known):
    """What is predicted of the ball where it is now."""
    impedance = impedance_at(solimp, data.contact[0].dist)
    weight = model.body_invweight0[:, 0].sum()
    return predicted_creep(solref, solimp[1], inverse_mass_1_kg=weight, impedance=impedance, **known)


@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
@pytest.mark.parametrize("impratio", [1.0, 10.0])
@pytest.mark.parametrize("solref", [(0.02, 1.0), (0.001, 1.0), (-2500.0, -50.0)])
def test_the_creep_under_a_load_is_the_engines(solref, impratio, cone):
    solimp, load_n = (0.9, 0.95, 0.001, 0.4, 3.0), 5.0
    model, data = scene(solref, solimp, cone, impratio)
    data.qfrc_applied[1] = load_n
    found = mm_s_along_x(model, data)
    of_cone = {"impratio": impratio, "cone": cone, "mu": MU}
    predicted = predicted_at(model, data, solref, solimp, timestep_s=TIMESTEP_S, load_n=load_n, **of_cone)
    assert predicted.acceleration_mm_s == 0.0
    assert predicted.load_mm_s == pytest.approx(found, rel=1e-4)


@pytest.mark.parametrize("timeconst_s", [0.01, 0.05])
def test_the_creep_under_an_acceleration_that_the_rows_leave_out_is_the_engines(timeconst_s):
    """On a table that turns J̇·q̇ is the centripetal acceleration, whose force is a load besides.

    The step is short, for it has a part of its own.
    """
    solref, solimp, radius_m, rate_1_s = (timeconst_s, 1.0), (0.9, 0.95, 0.001, 0.5, 2.0), 1.0, 0.5
    model, data = scene(solref, solimp, radius=radius_m)
    model.opt.timestep = 1e-4
    data.qvel[[0, 2]] = rate_1_s, rate_1_s * radius_m
    radii = []
    for _ in range(4000):
        mujoco.mj_step(model, data)
        radii.append(math.hypot(radius_m + data.qpos[1], data.qpos[2]))
    found_mm_s = 1e3 * (radii[-1] - radii[1999]) / 0.2
    acceleration = rate_1_s**2 * radius_m
    known = {"acceleration_m_s2": acceleration, "load_n": model.body_mass[2] * acceleration}
    predicted = predicted_at(model, data, solref, solimp, timestep_s=1e-4, **known)
    assert predicted.acceleration_mm_s > 9.0 * predicted.load_mm_s > 0.0
    assert predicted.acceleration_mm_s + predicted.load_mm_s == pytest.approx(found_mm_s, rel=0.02)


@pytest.mark.parametrize("depth_m", [0.0, 2e-4, 4e-4, 8e-4, 2e-3])
@pytest.mark.parametrize("solimp", [(0.8, 0.95, 0.001, 0.4, 3.0), (0.0, 1.0, 0.001, 1.0, 0.5)])
def test_the_impedance_is_the_engines(solimp, depth_m):
    model, data = scene((0.02, 1.0), solimp)
    data.qpos[3] = -depth_m - 1e-9  # so that there is a contact at all
    mujoco.mj_forward(model, data)
    assert data.efc_KBIP[0, 2] == pytest.approx(impedance_at(solimp, depth_m), abs=1e-5)


@pytest.mark.parametrize("dmax", [0.0, 1.0])
def test_the_creep_with_a_dmax_that_the_engine_does_not_take_is_the_engines(dmax):
    solref, solimp = (0.02, 1.0), (dmax, dmax, 0.001, 0.5, 2.0)
    model, data = scene(solref, solimp)
    data.qpos[3] = -1e-4
    mujoco.mj_forward(model, data)
    weight = model.body_invweight0[:, 0].sum()
    predicted = predicted_creep(solref, dmax, inverse_mass_1_kg=weight)
    assert predicted.response_s == pytest.approx(1.0 / data.efc_KBIP[0, 1])
    assert predicted.yield_m_s_n == pytest.approx(1.0 / data.efc_D[1] / data.efc_KBIP[0, 1])
