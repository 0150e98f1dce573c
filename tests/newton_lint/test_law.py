"""Compares the law with MuJoCo's C engine on every sixth case of ``cases.py``."""

import math

import mujoco
import pytest

from newton_lint.law import Contact, Option, impedance_at, response_of, shared_slide_m_s
from tests.newton_lint.cases import Case, cases

CONTACT = Contact((0.02, 1.0), (0.9, 0.95, 0.001, 0.5, 2.0), 0.8, 2.0)


@pytest.mark.parametrize("case", list(cases())[::6], ids=str)
def test_a_prediction_is_the_engines(case):
    predicted = case.predicted_mm_s()
    measured = case.measured_mm_s()
    if math.isinf(predicted):
        assert measured > 50.0
    else:
        assert predicted == pytest.approx(measured, rel=0.1, abs=1e-3)


@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
def test_points_share_a_load_up_to_their_cones(cone):
    response = response_of(CONTACT, Option(0.002, cone=cone))
    points = [(response, 10.0), (response, 1.0)]
    slide = shared_slide_m_s(points, 0.4)
    assert slide == pytest.approx(0.2 * response.load_m_s_n)
    assert shared_slide_m_s(points, 8.7) > 1.9 * 4.0 * response.load_m_s_n
    assert math.isinf(shared_slide_m_s(points, 8.8001))


SOLIMPS = [
    (0.8, 0.95, 0.001, 0.4, 3.0),
    (0.0, 1.0, 0.001, 1.0, 0.5),
    (0.0, 0.0, 0.001, 0.5, 2.0),
]


@pytest.mark.parametrize("depth_m", [0.0, 2e-4, 4e-4, 8e-4, 2e-3])
@pytest.mark.parametrize("solimp", [*SOLIMPS, (1.0, 1.0, 0.001, 0.5, 2.0)])
def test_impedance_and_rows_are_the_engines_also_where_it_does_not_take_a_solimp(
    solimp, depth_m
):
    changes = {"solimp": " ".join(map(str, solimp)), "shape": "sphere", "slope": 0.0}
    model = Case("incline", tuple(changes.items())).target.model
    data = mujoco.MjData(model)
    data.qpos[2] = 0.05 - depth_m - 1e-9  # so that there is a contact at all
    mujoco.mj_forward(model, data)
    d = impedance_at(solimp, depth_m)
    assert data.efc_KBIP[0, 2] == pytest.approx(d, abs=1e-5)
    weight = model.body_invweight0[:, 0].sum()
    response = response_of(
        Contact((0.02, 1.0), solimp, 1.0, weight), Option(0.002, cone="elliptic"), d
    )
    assert response.load_m_s_n == pytest.approx(
        1.0 / data.efc_D[1] / data.efc_KBIP[0, 1], rel=0.02
    )
