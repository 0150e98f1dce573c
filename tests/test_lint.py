"""The lint: each rule on a model of two boxes, and all of them on the shake test as the solver really has it."""

import newton
import numpy as np
import pytest
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.case import AS_SHIPPED
from experiments.lint import (
    CONDIM,
    CONVERTED,
    FORCE_SPACE,
    RAW,
    SCENES,
    SOLIMP,
    Buffer,
    _Shapes,
    columns,
    grouped,
    lint,
    measure,
)
from experiments.measurement import Conditions
from experiments.scene import build_scene
from experiments.simulation import Simulation

DT = 1.0 / 960.0
ShapeConfig = newton.ModelBuilder.ShapeConfig


def two_boxes(first: dict, second: dict, **attributes: tuple) -> newton.Model:
    """Two boxes that can touch; ``attributes`` are the solver's custom ones, a value for each box."""
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    for index, config in enumerate((first, second)):
        body = builder.add_body(label=f"body_{index}")
        custom = {f"mujoco:{name}": values[index] for name, values in attributes.items()}
        builder.add_shape_box(
            body, cfg=ShapeConfig(**{"gap": 0.001, **config}), label=f"box_{index}", custom_attributes=custom
        )
    return builder.finalize(device="cpu")


def found(model: newton.Model, **options) -> list[tuple]:
    return [
        (finding.rule, finding.shapes, finding.parameter, pytest.approx(finding.value), pytest.approx(finding.used))
        for finding in lint(model, DT, **options)
    ]


def test_what_a_higher_priority_overrules_is_named():
    model = two_boxes({"ke": 8e4, "mu": 0.3}, {"kd": 200.0}, geom_priority=(0, 2))
    pair = ("body_0/box_0", "body_1/box_1")
    assert found(model) == [("priority", pair, "ke", 8e4, 2.5e3), ("priority", pair, "mu", 0.3, 1.0)]


@pytest.mark.parametrize("priority", [(0, 0), (2, 0)])
def test_what_reaches_the_solver_is_not(priority):
    assert found(two_boxes({"ke": 8e4, "mu": 0.3}, {}, geom_priority=priority)) == []


def test_what_both_say_is_not_lost():
    assert found(two_boxes({"mu": 0.3}, {"mu": 0.3}, geom_priority=(0, 1))) == []


def test_solimp_is_compared_entry_by_entry():
    model = two_boxes({}, {}, geom_priority=(0, 1), geom_solimp=((0.7, 0.95, 0.001, 0.5, 2.0), SOLIMP))
    assert [(rule, name) for rule, _, name, *_ in found(model)] == [("priority", "solimp[0]")]


def test_a_gap_left_at_the_default_beside_one_that_was_set():
    default = newton.ModelBuilder().rigid_gap
    model = two_boxes({"gap": None}, {"gap": 0.004})
    assert found(model) == [("default-gap", ("body_0/box_0",), "gap", default, default + 0.004)]
    assert found(two_boxes({"gap": None}, {"gap": None})) == []
    assert found(two_boxes({"gap": 0.002}, {"gap": 0.004})) == []


def test_a_timeconst_below_two_substeps():
    pair = ("body_0/box_0", "body_1/box_1")
    stiff = {"ke": 2.5e5, "kd": 1e3}
    assert found(two_boxes(stiff, stiff)) == [("timeconst", pair, "timeconst", 2e-3, 2 * DT)]
    assert found(two_boxes(stiff, stiff), refsafe=False) == []
    assert found(two_boxes(stiff, {})) == []  # the pair's is the mean of 2 ms and 20 ms


def test_a_solref_of_its_own_takes_the_place_of_ke_and_kd():
    model = two_boxes({"ke": 8e4}, {}, solref=((1e-3, 1.0), (1e-3, 1.0)), solref_mode=(RAW, RAW), geom_priority=(0, 1))
    assert [(rule, name) for rule, _, name, *_ in found(model)] == [("timeconst", "timeconst")]


@pytest.mark.parametrize(("capacity", "says"), [(9, "smaller"), (10, None), (40, None), (41, "larger")])
def test_a_buffer_is_compared_with_the_measured_peak(capacity, says):
    findings = lint(two_boxes({}, {}), DT, buffers=[Buffer("contacts", capacity, 10)])
    assert [says in finding.message for finding in findings] == ([True] if says else [])


def test_shapes_that_cannot_touch_are_left_alone():
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    body = builder.add_body(label="body")
    for priority in (0, 1):
        builder.add_shape_box(
            body, cfg=ShapeConfig(ke=8e4 * (1 + priority)), custom_attributes={"mujoco:geom_priority": priority}
        )
    assert lint(builder.finalize(device="cpu"), DT) == []


def test_a_model_without_the_solvers_attributes():
    builder = newton.ModelBuilder()
    builder.add_shape_box(builder.add_body(), cfg=ShapeConfig(kd=1e4))
    builder.add_ground_plane(cfg=ShapeConfig(kd=1e4))
    assert {finding.rule for finding in lint(builder.finalize(device="cpu"), DT)} == {"timeconst"}


def test_the_constants_are_newtons():
    from newton._src.solvers.mujoco import constants

    modes = (constants.SOLREF_MODE_FORCE_SPACE, constants.SOLREF_MODE_RAW, constants.SOLREF_MODE_MJCF_DEFAULT)
    assert modes == (FORCE_SPACE, RAW, CONVERTED)
    builder = newton.ModelBuilder()
    SolverMuJoCo.register_custom_attributes(builder)
    assert builder.custom_attributes["mujoco:condim"].default == CONDIM
    np.testing.assert_allclose(builder.custom_attributes["mujoco:geom_solimp"].default, SOLIMP)


@pytest.mark.parametrize("scene", SCENES)
def test_the_real_scenes(scene):
    model = build_scene([SCENES[scene].case], wp.get_device("cpu")).model
    groups = {(group.first.rule, group.subject, group.first.parameter): group for group in grouped(lint(model, DT))}
    stiffness = groups["priority", "cube", "ke"]
    assert (stiffness.against, stiffness.count) == ("fr3_leftfinger, fr3_rightfinger", 8)
    assert columns(stiffness)["used"] == (2.5e3 if scene == "as-shipped" else 2.5e5)
    assert (("default-gap", "cube", "gap") in groups) == (scene == "as-shipped")
    assert (("timeconst", "fr3_leftfinger", "timeconst") in groups) == (scene == "fixed")


def test_the_timeconst_is_the_one_that_the_solver_has():
    """Contacts of the cube on the ground, where neither shape has priority, so that both sides mix."""
    simulation = Simulation([AS_SHIPPED], wp.get_device("cpu"))
    simulation.frame()
    shapes = _Shapes(simulation.model)
    contacts = _contact_pairs(simulation)
    assert contacts
    for pair, timeconst in contacts.items():
        assert shapes.timeconst(pair) == pytest.approx(timeconst, rel=1e-5)


def _contact_pairs(simulation: Simulation) -> dict[tuple[int, int], float]:
    data, geom_shapes = simulation.solver.mjw_data, simulation.solver.mjc_geom_to_newton_shape.numpy()[0]
    count = int(data.nacon.numpy()[0])
    geoms, solref = data.contact.geom.numpy()[:count], data.contact.solref.numpy()[:count]
    return {tuple(geom_shapes[pair].tolist()): float(row[0]) for pair, row in zip(geoms, solref, strict=True)}


def test_the_section_has_a_row_for_each_scene_and_each_finding():
    rows = measure(Conditions(device="cpu", quick=True)).rows
    for scene in SCENES:
        [summary] = [row for row in rows if row["case"] == scene]
        assert summary["finding_count"] == sum(row.get("scene") == scene for row in rows) > 0
    buffers = [row for row in rows if row.get("rule") == "buffer"]
    assert {row["scene"] for row in buffers} == {"as-shipped"}
    assert all(row["used_count"] < row["authored_count"] for row in buffers)
