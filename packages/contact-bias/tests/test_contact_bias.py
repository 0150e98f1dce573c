"""Compares both kernels with numerical differences of the contact velocity."""

from copy import copy
from itertools import product
from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import pytest
import warp as wp

import contact_bias
import contact_bias_c

STATE_COUNT = 8
DIFFERENCE_S = 1e-5
"""Half of the time between the two states of a difference."""
TUMBLE = """
<mujoco>
  <option cone="{cone}" timestep="0.001"/>
  <worldbody>
    <geom type="plane" size="5 5 1" condim="3"/>
    <body pos="0 0 0.3">
      <joint axis="0 0 1"/> <joint axis="0 1 0"/>
      <geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.08" condim="3"/>
      <body pos="0.3 0 0">
        <joint axis="1 0 0"/> <joint type="slide" axis="0 1 0"/>
        <geom type="box" size="0.15 0.1 0.2" condim="3"/>
        <body pos="0.2 0 0"> <joint type="ball"/> <geom type="capsule" size="0.1 0.2" condim="4"/> </body>
      </body>
    </body>
    <body pos="0.2 0.2 0.2">
      <freejoint/> <geom type="box" size="0.2 0.15 0.1" condim="6" friction="0.8 0.1 0.05"/>
    </body>
    <body pos="0.1 -0.2 0.2"> <freejoint/> <geom type="sphere" size="0.2" condim="1" priority="1"/> </body>
    <body pos="0.5 -0.1 0.2"> <freejoint/> <geom type="box" size="0.1 0.2 0.15" condim="3" friction="0.5"/> </body>
  </worldbody>
</mujoco>
"""


@pytest.fixture(scope="module", params=["elliptic", "pyramidal"])
def tumble(request) -> mujoco.MjModel:
    """Return bodies on joints of all types, with contacts of all dimensions."""
    return mujoco.MjModel.from_xml_string(TUMBLE.format(cone=request.param))


def states(model: mujoco.MjModel):
    """Yield random states near the default one, with speeds of a few rad/s and m/s."""
    random = np.random.default_rng(0)
    for _ in range(STATE_COUNT):
        data = mujoco.MjData(model)
        mujoco.mj_integratePos(model, data.qpos, random.normal(0.0, 0.2, model.nv), 1.0)
        data.qvel[:] = random.normal(0.0, 2.0, model.nv)
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        yield data


def differenced(model: mujoco.MjModel, data: mujoco.MjData, contact) -> np.ndarray:
    """Return d(J q̇)/dt of the second body relative to the first, linear then angular.

    The shape is [2, 3], and the point is the contact.
    """
    bodies = model.geom_bodyid[np.asarray(contact.geom)]
    points = [
        data.xmat[body].reshape(3, 3).T @ (contact.pos - data.xpos[body])
        for body in bodies
    ]
    rates = []
    for sign in (1.0, -1.0):
        moved = mujoco.MjData(model)
        moved.qpos[:] = data.qpos
        mujoco.mj_integratePos(model, moved.qpos, data.qvel, sign * DIFFERENCE_S)
        mujoco.mj_kinematics(model, moved)
        mujoco.mj_comPos(model, moved)
        of_body = np.zeros((2, 2, 3, model.nv))
        for jacobian, body, point in zip(of_body, bodies, points, strict=True):
            at = moved.xpos[body] + moved.xmat[body].reshape(3, 3) @ point
            mujoco.mj_jac(model, moved, jacobian[0], jacobian[1], at, body)
        rates.append((of_body[1] - of_body[0]) @ data.qvel)
    return (rates[0] - rates[1]) / (2.0 * DIFFERENCE_S)


def expected_rows(
    model: mujoco.MjModel, data: mujoco.MjData, contact, normal: bool
) -> np.ndarray:
    """Return the expected value for each row of a contact, in the engine's order."""
    axes = np.asarray(contact.frame).reshape(3, 3)
    linear, angular = differenced(model, data, contact)
    missing = np.concatenate([axes @ linear, axes @ angular])[: contact.dim]
    missing[0] *= normal
    if contact.dim == 1 or model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC:
        return -missing
    leaning = np.asarray(contact.friction)[: contact.dim - 1] * missing[1:]
    return -missing[0] + np.stack([-leaning, leaning], axis=1).ravel()


def test_the_twin_in_c_is_the_rate_of_the_contact_velocity(tumble):
    dims = set()
    for data, normal in product(states(tumble), (False, True)):
        data.efc_aref[:] = 0.0
        contact_bias_c.subtract_bias(tumble, data, normal=normal)
        for contact in data.contact:
            rows = expected_rows(tumble, data, contact, normal)
            found = data.efc_aref[contact.efc_address :][: len(rows)]
            assert np.linalg.norm(found - rows) <= 1e-6 * np.linalg.norm(rows)
            dims.add(int(contact.dim))
    assert dims == {1, 3, 4, 6}


def test_the_kernel_is_the_rate_of_the_contact_velocity(tumble):
    dims = set()
    with wp.ScopedDevice("cpu"):
        m = mjw.put_model(tumble)
        for data in states(tumble):
            d = mjw.put_data(tumble, data)
            mjw.com_vel(m, d)
            mjw.rne(m, d)
            columns = "pos frame geom dim friction efc_address".split()
            host = {name: getattr(d.contact, name).numpy() for name in columns}
            for normal in (False, True):
                d.efc.aref.zero_()
                contact_bias.apply(
                    m, d, wp.array([True], dtype=bool), centred=False, normal=normal
                )
                reference = d.efc.aref.numpy()[0]
                for index in range(int(d.nacon.numpy()[0])):
                    contact = SimpleNamespace(
                        **{name: values[index] for name, values in host.items()}
                    )
                    rows = expected_rows(tumble, data, contact, normal)
                    found = reference[contact.efc_address[: len(rows)]]
                    assert np.linalg.norm(found - rows) <= 1e-4 * np.linalg.norm(rows)
                    dims.add(int(contact.dim))
    assert dims == {1, 3, 4, 6}


@pytest.mark.parametrize(
    ("solver", "options", "words"),
    [
        (SimpleNamespace(), {}, "needs a solver with a mjw_model"),
        (SimpleNamespace(mjw_model=None), {}, "needs a solver with a mjw_model"),
        (
            {"disableflags": contact_bias.NO_ACTUATION, "integrator": 0},
            {},
            "while actuation is disabled",
        ),
        (
            {"disableflags": 0, "integrator": contact_bias.RUNGE_KUTTA},
            {"centred": True},
            "leave centred off",
        ),
    ],
)
def test_a_solver_that_cannot_have_it_is_refused_in_a_line(solver, options, words):
    if isinstance(solver, dict):
        solver = SimpleNamespace(
            mjw_model=SimpleNamespace(opt=SimpleNamespace(**solver))
        )
    with pytest.raises(ValueError, match=words) as error:
        contact_bias.install(solver, **options)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("solref", "dmax", "refsafe", "expected"),
    [
        ((0.02, 1.0), 0.95, True, 2.0 / 0.019),
        ((0.001, 0.3), 0.5, True, 2.0 / (0.5 * 0.004)),
        ((0.001, 0.3), 0.5, False, 4e3),
    ]
    + [
        ((-500.0, -20.0), 0.8, True, 25.0),
        ((0.02, 1.0), 1.5, True, 2.0 / (0.9999 * 0.02)),
        ((0.02, 1.0), 0.0, True, 1e6),
    ],
)
def test_damping_is_as_the_engine_documents_it(solref, dmax, refsafe, expected):
    """b is 2 / (dmax timeconst) or damping / dmax, with clamped timeconst and dmax."""
    solimp = (0.1, dmax, 0.001, 0.5, 2.0)
    engine = SimpleNamespace(
        opt=SimpleNamespace(
            timestep=0.002, disableflags=0 if refsafe else contact_bias.NO_REFSAFE
        )
    )
    assert contact_bias_c.damping(engine, solref, solimp) == pytest.approx(expected)


@pytest.mark.parametrize("own", [(0.0, 0.0), (0.01, 1.0)])
def test_centred_the_term_is_less_by_what_a_step_damps(own):
    """The share is 1 − h b / 2, with b = 2 / (0.95 · 20 ms), or 10 ms for friction rows."""
    engine = SimpleNamespace(
        opt=SimpleNamespace(timestep=0.002, disableflags=0, cone=contact_bias.ELLIPTIC)
    )
    contact = SimpleNamespace(
        efc_address=1, dim=4, solref=np.array([0.02, 1.0]), solreffriction=np.array(own)
    )
    contact.solimp = np.array([0.9, 0.95, 0.001, 0.5, 2.0])
    data = SimpleNamespace(efc_aref=np.zeros(6))
    contact_bias_c.subtract(
        engine, data, contact, np.arange(1.0, 7.0), centred=True, normal=True
    )
    normal = 1.0 - 0.002 / 0.019
    friction = 1.0 - 0.002 / (0.0095 if any(own) else 0.019)
    assert data.efc_aref == pytest.approx(
        [0.0, -normal, -2.0 * friction, -3.0 * friction, -4.0 * friction, 0.0]
    )


@pytest.mark.parametrize("refsafe", [True, False])
def test_centred_the_kernel_is_its_twin_in_c(tumble, refsafe):
    """Timeconsts are near two steps of 1 ms, one solref is direct, impedances reach 1."""
    tumble = copy(tumble)
    tumble.geom_solref[:, 0] = np.geomspace(0.001, 0.01, tumble.ngeom)
    tumble.geom_solimp[:, 1] = 1.0
    tumble.geom_solref[-1] = (-500.0, -20.0)
    tumble.geom_solimp[::2, 1] = 0.8
    tumble.opt.disableflags |= 0 if refsafe else contact_bias.NO_REFSAFE
    with wp.ScopedDevice("cpu"):
        m = mjw.put_model(tumble)
        for data in states(tumble):
            own = np.random.default_rng(1).uniform(0.001, 0.01, (data.ncon, 2))
            for contact, solref in zip(data.contact, own, strict=True):
                contact.solreffriction[:] = solref * (contact.dim == 3)
            d = mjw.put_data(tumble, data)
            mjw.com_vel(m, d)
            mjw.rne(m, d)
            d.efc.aref.zero_()
            data.efc_aref[:] = 0.0
            contact_bias.apply(
                m, d, wp.array([True], dtype=bool), centred=True, normal=True
            )
            contact_bias_c.subtract_bias(tumble, data, centred=True, normal=True)
            found = d.efc.aref.numpy()[0, : data.nefc]
            assert np.linalg.norm(found - data.efc_aref) <= 1e-4 * np.linalg.norm(
                data.efc_aref
            )
