"""Tests of the rules on a Newton model of two boxes, and on the shake test."""

import newton
import numpy as np
import pytest
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.simulation import Simulation
from newton_lint.law import DEFAULT_SOLREF
from newton_lint.newton_models import rules as module
from newton_lint.newton_models.compat import kf_is_read
from newton_lint.newton_models.report import report_of
from newton_lint.newton_models.rules import CONVERTED, Shapes
from newton_lint.report import Request
from newton_lint.scene import Engine
from newton_lint.target import Target

DT = 1.0 / 960.0
ENGINE = Engine(timestep_s=DT)
FORCE_SPACE, RAW = range(CONVERTED)
ShapeConfig = newton.ModelBuilder.ShapeConfig
PAIR = ("body_0/box_0", "body_1/box_1")


def builder_of_the_solver() -> newton.ModelBuilder:
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    return builder


def two_boxes(first: dict, second: dict, **attributes: tuple) -> newton.Model:
    """Return two boxes that can touch, with custom attributes of the solver for each."""
    builder = builder_of_the_solver()
    for index, config in enumerate((first, second)):
        body = builder.add_body(label=f"body_{index}")
        custom = {
            f"mujoco:{name}": values[index] for name, values in attributes.items()
        }
        config = ShapeConfig(**{"gap": 0.001, **config})
        builder.add_shape_box(
            body, cfg=config, label=f"box_{index}", custom_attributes=custom
        )
    return builder.finalize(device="cpu")


def read_mjcf(xml: str) -> newton.Model:
    builder = builder_of_the_solver()
    builder.add_mjcf(xml)
    return builder.finalize(device="cpu")


def findings_in(model: newton.Model, engine: Engine = ENGINE):
    return report_of(Target("", None, model), Request(engine, step=False)).findings


def found(model: newton.Model, **options) -> list[tuple]:
    return [
        (
            *(
                finding.rule,
                (finding.shape, *finding.against),
                finding.parameter,
                pytest.approx(finding.value),
            ),
            finding.used if finding.used is None else pytest.approx(finding.used),
        )
        for finding in findings_in(model, Engine(timestep_s=DT, **options))
    ]


STIFF = {"ke": 2.5e5, "kd": 1e3}
FOUND = {
    "a timeconst below two substeps": (
        STIFF,
        STIFF,
        {},
        [("timeconst", PAIR, "timeconst", 2e-3, 2 * DT)],
    ),
    "a pair's is the mean of 2 ms and 20 ms": (
        STIFF,
        {},
        {},
        [("one-sided", PAIR[:1], "solref", 2e-3, 11e-3)],
    ),
    "a solref of its own takes the place of ke and kd": (
        *(
            {"ke": 8e4},
            {},
            {
                "solref": ((1e-3, 1.0),) * 2,
                "solref_mode": (RAW, RAW),
                "geom_priority": (0, 1),
            },
        ),
        [("timeconst", PAIR[::-1], "timeconst", 1e-3, 2 * DT)],
    ),
    "0.5 is not far from 1": (*[{"ke": 1e4, "kd": 100.0}] * 2, {}, []),
    "nor is that of a stiffness and a damping": (
        *({}, {}, {"solref": ((-2500.0, -100.0),) * 2, "solref_mode": (RAW, RAW)}, []),
    ),
}


@pytest.mark.parametrize("name", FOUND)
def test_what_is_found_and_what_is_not(name):
    first, second, attributes, expected = FOUND[name]
    assert found(two_boxes(first, second, **attributes)) == expected


@pytest.mark.parametrize(
    ("material", "parameter"),
    [({"ke": 1e5, "kd": 0.0}, "ke"), ({"ke": 0.0, "kd": 5.0}, "kd")],
)
def test_a_ke_without_kd_is_not_read(material, parameter):
    model = two_boxes(material, {})
    used = {"ke": ShapeConfig().ke, "kd": ShapeConfig().kd}[parameter]
    assert found(model) == [
        ("ke-without-kd", PAIR[:1], parameter, material[parameter], used)
    ]
    # No parameter is lost if no parameter is given, if a solref is given, or if both act as
    # forces.
    assert found(two_boxes({"ke": 0.0, "kd": 0.0}, {})) == []
    for mode in (RAW, FORCE_SPACE):
        assert (
            found(
                two_boxes(
                    material,
                    material,
                    solref=[DEFAULT_SOLREF] * 2,
                    solref_mode=(mode, mode),
                )
            )
            == []
        )


def test_kf_is_read_by_some_releases_and_cones_and_contacts_and_clamped():
    model = two_boxes({"kf": 50.0}, {})
    unread = [("kf", PAIR[:1], "kf", 50.0, None)]
    assert found(model, name="newton", cone="pyramidal") == unread
    assert found(model, name="mujoco", cone="elliptic") == unread
    assert found(model, name="newton", cone="elliptic") == (
        [] if kf_is_read() else unread
    )
    assert found(two_boxes({}, {}), name="newton", cone="elliptic") == []
    high = two_boxes({"kf": 1e7}, {}, geom_priority=(1, 0))
    shapes = [each[1] for each in found(high, name="newton", cone="elliptic")]
    assert shapes == ([PAIR] if kf_is_read() else [PAIR[:1]])


@pytest.mark.parametrize("impratio", [1.0, 4.0])
def test_kf_is_clamped_where_its_timeconst_is_two_substeps(monkeypatch, impratio):
    """The timeconst is 2 / (kf w ((1 - dmax) / impratio + dmax)), with dmax of 0.95."""
    monkeypatch.setattr(module, "kf_is_read", lambda: True)

    def of(first: float, second: float, **attributes: tuple) -> list[tuple]:
        model = two_boxes({"kf": first}, {"kf": second}, **attributes)
        return found(model, name="newton", cone="elliptic", impratio=impratio)

    weight = 2.0 / float(two_boxes({}, {}).body_mass.numpy()[0])
    most = 1.0 / (DT * weight * (0.05 / impratio + 0.95))
    own = {"geom_priority": (1, 0)}
    mixed = {"geom_solmix": (1.0, 3.0)}
    assert (
        of(0.99 * most, 9.0 * most, **own)
        == of(0.39 * most, 1.19 * most, **mixed)
        == []
    )
    assert of(1.01 * most, 9.0 * most, **own) == [("kf", PAIR, "kf", 1.01 * most, most)]
    assert of(0.4 * most, 1.21 * most, **mixed) == [
        ("kf", PAIR, "kf", 1.0075 * most, most)
    ]


def test_a_kf_of_zero_takes_the_friction_away(monkeypatch):
    monkeypatch.setattr(module, "kf_is_read", lambda: True)
    model = two_boxes({"kf": 0.0}, {"kf": 1e5}, geom_priority=(1, 0))
    assert found(model, name="newton", cone="elliptic") == [
        ("kf", PAIR, "mu", ShapeConfig().mu, None)
    ]


MJCF = """
<mujoco>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1" solref="{geom} 1"/>
    <body name="ball"><freejoint/><geom name="skin" size="0.1" solref="{geom} 1"/></body>
  </worldbody>
  <contact><pair geom1="floor" geom2="skin" solref="{pair}"/></contact>
</mujoco>
"""


@pytest.mark.parametrize(
    ("pair", "rules"),
    [
        ("0.02 1", []),
        ("0.001 1", ["timeconst"]),
        ("-100 -20", []),
    ],
)
def test_an_explicit_pair_has_parameters_of_its_own(pair, rules):
    model = read_mjcf(MJCF.format(geom=0.001, pair=pair))
    assert [rule for rule, *_ in found(model)] == rules


def test_models_without_shapes_or_the_solvers_attributes():
    builder = newton.ModelBuilder()
    assert findings_in(builder.finalize(device="cpu")) == []
    body = builder.add_body()
    assert findings_in(builder.finalize(device="cpu")) == []
    builder.add_shape_box(body, cfg=ShapeConfig(ke=2.5e7, kd=1e4))
    builder.add_ground_plane(cfg=ShapeConfig(ke=2.5e7, kd=1e4))
    assert [
        finding.rule for finding in findings_in(builder.finalize(device="cpu"))
    ] == ["timeconst"]


def test_the_contacts_are_those_that_the_solver_has():
    """Test a cube and a ground with the same priority, whose parameters are mixed."""
    simulation = Simulation([AS_SHIPPED], wp.get_device("cpu"))
    simulation.frame()
    scene = Shapes.of(simulation.model, Engine())
    contacts = scene.contacts
    shapes = scene.index
    pairs = zip(
        shapes[contacts.first].tolist(), shapes[contacts.second].tolist(), strict=True
    )
    places = {frozenset(pair): index for index, pair in enumerate(pairs)}
    data = simulation.solver.mjw_data
    geom_shapes = simulation.solver.mjc_geom_to_newton_shape.numpy()[0]
    count = int(data.nacon.numpy()[0])
    geoms = geom_shapes[data.contact.geom.numpy()[:count]]
    assert count
    where = [places[frozenset(pair)] for pair in geoms.tolist()]
    np.testing.assert_allclose(
        contacts.solref[where], data.contact.solref.numpy()[:count], rtol=1e-5
    )
    np.testing.assert_allclose(
        contacts.solimp[where], data.contact.solimp.numpy()[:count], rtol=1e-5
    )
    np.testing.assert_allclose(
        contacts.friction[where, 0], data.contact.friction.numpy()[:count, 0], rtol=1e-5
    )
    np.testing.assert_array_equal(
        contacts.condim[where], data.contact.dim.numpy()[:count]
    )
