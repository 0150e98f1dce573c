"""Compare numbers of the law with numbers computed by hand from MuJoCo's documentation.

See "Modeling", solver parameters, and "Computation". A timeconst gives b = 2 / (dmax
timeconst) and k = 1 / (dmax timeconst dampratio)². A direct solref gives b = damping /
dmax and k = stiffness / dmax². R is (1 - d) / d · w / impratio. With ``refsafe`` a
timeconst is at least two steps.
"""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from scipy.optimize import brentq, minimize

from newton_lint import law
from newton_lint.law import Contact, Option, Response
from newton_lint.prediction import Load, predicted, predictions
from newton_lint.report import scene_of
from newton_lint.target import Target
from tests.newton_lint.cases import Case

CONTACT = Contact((0.02, 1.0), (0.9, 0.95, 0.001, 0.5, 2.0), 0.8, 2.0)
"""Test that 1/b = 0.95 · 20 ms / 2 = 9.5 ms and R = 0.05 / 0.95 · 2 = 2/19 per kg give
R/b = 1 mm/s/N.
"""
ELLIPTIC = Option(0.002, cone="elliptic")
STEEP = 1.0 + 0.8**2
"""Factor of w for an edge of the pyramid."""


@pytest.mark.parametrize(
    ("contact", "option", "acceleration_ms", "load_mm_s_n"),
    [
        ({}, {}, 8.5, 1.0),
        ({}, {"impratio": 10.0}, 8.5, 0.1),
        ({}, {"noslip": True}, 8.5, 0.0),
        ({}, {"cone": "pyramidal"}, 8.5, STEEP),
        ({}, {"cone": "pyramidal", "impratio": 10.0}, 8.5, 0.1 * STEEP),
        *(
            ({}, {"integrator": each}, 8.5, 1.0)
            for each in (law.EULER, law.IMPLICIT, law.IMPLICITFAST)
        ),
        ({}, {"integrator": law.RK4}, 9.5, 1.0),
        (
            {"solref": (0.003, 1.0)},
            {},
            0.9,
            0.2,
        ),  # two steps: 4 ms · 0.95 / 2, minus 1 ms
        (
            {"solref": (0.003, 1.0)},
            {"refsafe": False},
            0.425,
            0.15,
        ),  # 3 ms · 0.95 / 2, minus 1 ms
        ({"solref": (0.02, 3.0)}, {}, 8.5, 1.0),
        ({"solref": (-2500.0, -100.0)}, {}, 8.5, 1.0),  # 0.95 / 100 s
        ({"solref": (-2500.0, 1.0)}, {}, 8.5, 1.0),  # mixed: the default
        ({"solref": (-2500.0, 0.0)}, {"refsafe": False}, math.inf, math.inf),
        (
            {"solreffriction": (0.005, 1.0)},
            {},
            1.375,
            0.25,
        ),  # 0.95 · 5 ms / 2 = 2.375 ms
        ({"solreffriction": (-100.0, -200.0)}, {}, 3.75, 0.5),  # 0.95 / 200 s = 4.75 ms
        ({"solreffriction": (0.005, -1.0)}, {}, 8.5, 1.0),
        ({"solreffriction": (0.005, 1.0)}, {"cone": "pyramidal"}, 8.5, STEEP),
        (
            {"solimp": (0.9, 0.95, 0.0, 0.5, 2.0)},
            {},
            8.5,
            0.075 / 0.925 * 19.0,
        ),  # the mean of 0.9 and 0.95
        ({"solimp": (0.9, 0.95, 2.0, 0.5, 2.0)}, {}, 8.5, 1.0),  # at its full width
        (
            {"solimp": (0.9, 2.0, 0.001, 0.5, 2.0)},
            {},
            8.999,
            0.0001 * 20.0,
        ),  # dmax 0.9999
        (
            {"solimp": (0.9, -1.0, 0.001, 0.5, 2.0)},
            {},
            1e-3 - 1.0,
            0.9999 * 20.0,
        ),  # dmax 0.0001
    ],
)
def test_a_contact_gives_way_as_its_rows_say(
    contact, option, acceleration_ms, load_mm_s_n
):
    response = law.response_of(replace(CONTACT, **contact), replace(ELLIPTIC, **option))
    assert 1e3 * response.acceleration_s == pytest.approx(acceleration_ms)
    assert 1e3 * response.load_m_s_n == pytest.approx(load_mm_s_n)


def test_a_contact_that_hardly_touches_gives_way_more():
    assert 1e3 * law.response_of(CONTACT, ELLIPTIC, 0.9).load_m_s_n == pytest.approx(
        0.1 / 0.9 * 2.0 * 9.5
    )
    assert 1e3 * law.response_of(CONTACT, ELLIPTIC, 7.0).load_m_s_n == pytest.approx(
        0.0001 / 0.9999 * 2.0 * 9.5
    )


# ``discrete`` by hand; the creep of MuJoCo 3.13.0 agrees to seven digits: b h = 4/19, h² k d = 1/95, so that an
# elliptic row weighs (23/19) / (23/19 + 1/95) = 115/116; a pyramid's has b + h k d = 2000/19 + 100/19 1/s, and with
# 3 ms: b = 2/2.85 ms and h k d = 0.0019 / 2.85² ms². At 1 ms the row is the stiffest for the step: h² k d = 1.
@pytest.mark.parametrize(
    ("solref", "refsafe", "cone", "acceleration_ms", "load_mm_s_n"),
    [
        ((0.02, 1.0), True, "elliptic", 10.5, 115.0 / 116.0),
        (
            (0.02, 1.0),
            True,
            "pyramidal",
            1.0 + 19.0 / 2.1,
            2.0 / 19.0 * STEEP * 19.0 / 2.1,
        ),
        (
            (0.003, 1.0),
            False,
            "pyramidal",
            1.0 + 1.0 / (2 / 2.85 + 1.9 / 2.85**2),
            None,
        ),
        (
            (0.001, 1.0),
            True,
            "elliptic",
            1.475,
            0.05 * (1 + 4 / 0.95) / (2 + 2 / math.sqrt(0.95)),
        ),
        (
            (0.001, 1.0),
            False,
            "elliptic",
            1.475,
            0.05 * (1 + 4 / 0.95) / (1 + 4 / 0.95 + 4 / 0.95),
        ),
        (
            (0.001, 0.5),
            True,
            "elliptic",
            1.475,
            0.05 * (1 + 4 / 0.95) / (2 + 1 / math.sqrt(0.95)),
        ),
        ((-2500.0, -100.0), True, "elliptic", 10.5, (23 / 19) / (23 / 19 + 1 / 95)),
        ((-2500.0, 0.0), True, "pyramidal", 191.0, None),  # 0.95 / 5 s, and half a step
    ],
)
def test_discrete_weighs_its_rows_by_the_step(
    solref, refsafe, cone, acceleration_ms, load_mm_s_n
):
    option = Option(0.002, law.DISCRETE, cone, refsafe=refsafe)
    response = law.response_of(replace(CONTACT, solref=solref), option)
    assert 1e3 * response.acceleration_s == pytest.approx(acceleration_ms)
    assert load_mm_s_n is None or 1e3 * response.load_m_s_n == pytest.approx(
        load_mm_s_n
    )


ROWS = [
    *(
        (solref, refsafe)
        for solref in ("0.02 1", "0.003 0.5", "0.05 3")
        for refsafe in ("enable", "disable")
    ),
    *((solref, "enable") for solref in ("-900 -40", "-900 1", "0.02 -1", "0.02 0")),
]


@pytest.mark.parametrize(("solref", "refsafe"), ROWS)
@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
def test_stiffness_damping_and_r_are_the_engines(cone, solref, refsafe):
    flags = f'<flag refsafe="{refsafe}"/>'
    changes = {
        "solref": solref,
        "flags": flags,
        "cone": cone,
        "mu": 0.7,
        "impratio": 4,
        "slope": 0.0,
    }
    model = Case("incline", tuple(changes.items())).target.model
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    k, b, d = data.efc_KBIP[0, :3]
    weight = float(model.body_invweight0[:, 0].sum())
    contact = Contact(tuple(map(float, solref.split())), CONTACT.solimp, 0.7, weight)
    option = Option(0.002, law.RK4, cone, 4.0, refsafe == "enable")
    response = law.response_of(contact, option, d)
    assert law.stiffness(contact, option, d) == pytest.approx(k)
    assert 1.0 / response.acceleration_s == pytest.approx(b)
    # A friction force F moves the two edges of a pyramid apart, each by μ: F = 2 μ² b v
    # / R.
    r = data.efc_R[1] if cone == "elliptic" else data.efc_R[0] / (2.0 * 0.7**2)
    assert response.load_m_s_n == pytest.approx(r / b, rel=1e-4)


@pytest.mark.parametrize(
    ("condim", "cone", "edges"),
    [
        (3, "pyramidal", 4),
        (4, "pyramidal", 6),
        (6, "pyramidal", 10),
        (1, "pyramidal", 0),
        (6, "elliptic", 0),
    ],
)
def test_a_pyramid_has_two_edges_for_each_axis_of_friction(condim, cone, edges):
    assert (
        law.response_of(
            replace(CONTACT, condim=condim), Option(0.002, cone=cone)
        ).edge_count
        == edges
    )


@pytest.mark.parametrize("slide", [0.001, 0.0015, 0.003, 0.008, 0.02])
@pytest.mark.parametrize("edge_count", [4, 6])
def test_a_pyramids_edges_bear_what_minimizes_their_energy(slide, edge_count):
    """Compare with SciPy, which minimizes Σ R f²/2 - J f over non-negative forces, as
    in MuJoCo's dual.
    """
    mu = 0.5
    normal = 10.0
    compliance = 0.001
    pulls = np.zeros(edge_count)
    pulls[:2] = 1.0, -1.0
    r = 2.0 * mu**2 * compliance
    found = minimize(
        lambda f: 1e3 * (0.5 * r * f @ f - mu * slide * pulls @ f),
        np.full(edge_count, normal / edge_count),
        jac=lambda f: 1e3 * (r * f - mu * slide * pulls),
        bounds=[(0.0, None)] * edge_count,
        constraints={
            "type": "eq",
            "fun": lambda f: f.sum() - normal,
            "jac": np.ones_like,
        },
        options={"ftol": 1e-12},
    )
    response = Response(0.0, compliance, edge_count, mu)
    assert response.force_n(slide, normal) == pytest.approx(
        mu * pulls @ found.x, rel=1e-4
    )
    assert Response(0.0, compliance, 0, mu).force_n(slide, normal) == pytest.approx(
        min(slide / 0.001, 5.0)
    )


def test_points_share_a_load_as_scipy_shares_it():
    points = [(Response(0.0, 0.001, 4, 0.5), 10.0), (Response(0.0, 0.002, 0, 0.8), 4.0)]
    for load in (1.0, 5.0, 7.5, 8.1):
        root = brentq(
            lambda slide, load=load: (
                sum(each.force_n(slide, n) for each, n in points) - load
            ),
            0.0,
            1.0,
        )
        assert law.shared_slide_m_s(points, load) == pytest.approx(root)
    assert law.shared_slide_m_s(points, 8.2) == math.inf  # 0.5 · 10 + 0.8 · 4
    assert law.shared_slide_m_s([(Response(0.0, 0.0), 10.0)], 5.0) == pytest.approx(
        0.0, abs=1e-12
    )


@pytest.mark.parametrize(
    ("option", "contact", "depth_mm"),
    [
        (
            {},
            {},
            0.24,
        ),  # (1 - d) w N timeconst² = 0.1 · 2 · 3 · 0.02², as k d r = (1 - d)/d w N
        ({}, {"solref": (0.02, 2.0)}, 0.96),
        ({}, {"solref": (-10000.0, -100.0)}, 0.06),  # (1 - d) w N / stiffness
        ({}, {"solref": (0.001, 1.0)}, 0.0096),  # two steps of 2 ms
        ({"cone": "pyramidal"}, {}, 0.24 * 1.64 * 0.64 / 2.0),
        (
            {"cone": "pyramidal", "impratio": 4.0},
            {"condim": 4},
            0.24 * 1.64 * 0.64 / 3.0 / 4.0,
        ),
        ({"cone": "pyramidal"}, {"condim": 1}, 0.24),
        ({"impratio": 4.0}, {"condim": 6}, 0.24),
        (
            {},
            {"weight_1_kg": 20000.0},
            1e3 * min(2.4, 1.0),
        ),  # not deeper than the geometry shows
    ],
)
def test_a_force_presses_a_point_in_until_its_spring_bears_it(
    option, contact, depth_mm
):
    soft = replace(CONTACT, solimp=(0.9, 0.9, 0.001, 0.5, 2.0), **contact)
    assert 1e3 * law.settled_depth_m(
        soft, replace(ELLIPTIC, **option), 3.0
    ) == pytest.approx(depth_mm)


@pytest.mark.parametrize(
    ("cone", "condim"),
    [("elliptic", 3), ("pyramidal", 1), ("pyramidal", 3), ("pyramidal", 6)],
)
def test_what_lies_settles_as_deep_and_hard_as_the_law_says(cone, condim):
    changes = {
        "cone": cone,
        "condim": condim,
        "mu": 2,
        "slope": 0.0,
        "shape": "sphere",
        "solimp": "0.5 0.9 0.002 0.4 3",
    }
    model = Case("incline", tuple(changes.items())).target.model
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 1000)
    solimp = (0.5, 0.9, 0.002, 0.4, 3.0)
    contact = Contact(
        (0.02, 1.0),
        solimp,
        2.0,
        float(model.body_invweight0[:, 0].sum()),
        condim=condim,
    )
    option = Option(0.002, cone=cone)
    assert law.settled_depth_m(contact, option, 0.5 * 9.81) == pytest.approx(
        -data.contact.dist[0], rel=1e-3
    )
    assert law.settled_impedance(contact, option, 0.5 * 9.81) == pytest.approx(
        data.efc_KBIP[0, 2], rel=1e-3
    )


# Half way to a midpoint of 0.4, power 3: y = 0.2³ / 0.4² = 0.05; beyond it y = 1 - 0.4³ / 0.6² = 1 - 0.8 · 2/9.
@pytest.mark.parametrize(
    ("depth_mm", "d"),
    [
        (0.0, 0.5),
        (0.4, 0.52),
        (-0.4, 0.52),
        (1.2, 0.9 - 0.4 * 0.064 / 0.36),
        (2.0, 0.9),
        (9.0, 0.9),
    ],
)
def test_impedance_rises_by_its_power_to_both_sides_of_the_midpoint(depth_mm, d):
    assert law.impedance((0.5, 0.9, 0.002, 0.4, 3.0), 1e-3 * depth_mm) == pytest.approx(
        d
    )
    linear = 0.5 + 0.4 * min(abs(depth_mm) / 2.0, 1.0)
    for power in (0.3, 1.0):
        assert law.impedance(
            (0.5, 0.9, 0.002, 0.4, power), 1e-3 * depth_mm
        ) == pytest.approx(linear)
    assert law.impedance((0.5, 0.9, 1e-16, 0.4, 3.0), 1e-3 * depth_mm) == pytest.approx(
        0.7
    )
    assert law.impedance_at(
        (0.5, 0.9, 0.0, 0.4, 3.0), 1e-3 * depth_mm
    ) == pytest.approx(0.9)


def test_a_prediction_is_the_law_times_its_loads():
    found = predicted(CONTACT, ELLIPTIC, Load(0.5, 3.0), [("a", "b")], True)
    assert (found.timeconst_s, found.dmax, found.response_s) == pytest.approx(
        (0.02, 0.95, 0.0095)
    )
    assert (found.acceleration_response_s, found.acceleration_mm_s) == pytest.approx(
        (0.0085, 4.25)
    )
    assert (found.load_deep_mm_s, found.load_shallow_mm_s) == pytest.approx(
        (3.0, 0.1 / 0.9 * 2.0 * 9.5 * 3.0)
    )
    softer_when_deep = replace(CONTACT, solimp=(0.95, 0.9, 0.001, 0.5, 2.0))
    softer = predicted(softer_when_deep, ELLIPTIC, Load(0.0, 3.0), ())
    assert (softer.load_deep_mm_s, softer.load_shallow_mm_s) == pytest.approx(
        (2.842105, 6.0), 1e-6
    )
    rk4 = predicted(CONTACT, replace(ELLIPTIC, integrator=law.RK4), Load(), ())
    assert (rk4.timeconst_s, rk4.acceleration_response_s) == pytest.approx(
        (0.02, 0.0095)
    )
    assert (rk4.acceleration_mm_s, rk4.load_deep_mm_s, rk4.load_shallow_mm_s) == (
        0.0,
        0.0,
        0.0,
    )
    for solref in (
        (-2500.0, 0.0),
        (-4e4, -1000.0),
    ):  # undamped, and 0.95 ms, less than half a step of 1 ms
        assert predicted(replace(CONTACT, solref=solref), ELLIPTIC, Load(), ()) is None


FEW = """
<mujoco>
  <worldbody><geom name="floor" type="plane" size="1 1 1" condim="1" conaffinity="0"/>
    <body name="d"><joint/><geom name="d" {rest} mass="0.01"/></body>
    <body name="a"><freejoint/><geom name="a" {rest} mass="1"/></body>
    <body name="b"><freejoint/><geom name="b" {rest} mass="1"/></body>
    <body name="c"><freejoint/><geom name="c" {rest} mass="0.1"/></body>
    <body name="e"><freejoint/><geom name="e" {rest} mass="1" solref="0.03 1"/></body>
    <body name="f"><freejoint/><geom name="f" {rest} mass="1" condim="1"/></body>
  </worldbody>
</mujoco>
"""


@pytest.mark.parametrize(
    ("load", "order"),
    [
        (Load(0.0, 1.0), "c e ab d"),
        (Load(), "e ab c d"),
        (Load(9.0, 0.001), "e c ab d"),
    ],
)
def test_alike_pairs_are_predicted_together_the_free_and_the_fastest_first(load, order):
    """Test that a tenth of the mass creeps ten times as fast under a load.

    Under an acceleration only the timeconst matters.
    """
    model = mujoco.MjModel.from_xml_string(
        FEW.format(rest='size="0.1" contype="0" conaffinity="1"')
    )
    found = predictions(scene_of(Target("scene", model)), load)
    assert [
        "".join(other for _, other in each.pairs) for each in found
    ] == order.split()
