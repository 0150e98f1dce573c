"""Test which of Newton's solvers are measured, a box that creeps, and the recorded
contacts of Steel.
"""

from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp
from newton import solvers

from experiments.facts.trace import FRAME_COLUMNS
from experiments.newton_solvers import box
from experiments.newton_solvers.steel import watch_overflow
from experiments.newton_solvers.stepper import colours_of, record_contacts


def array(values, dtype=int):
    return wp.array(values, dtype=dtype, device="cpu")


def recorded(*forces_n, body: int = -1) -> dict[str, float]:
    """Record one contact between the ground and a shape of world 0, which is 1 mm deep
    and has a margin.
    """
    contacts = wp.zeros((1, 1, len(FRAME_COLUMNS)), dtype=float, device="cpu")
    pose = array(
        [wp.transform(wp.vec3(0.0, 0.0, 0.5), wp.quat_identity())], wp.transform
    )
    points = (
        array([[0.0, 0.0, 0.0]], wp.vec3),
        array([[0.0, 0.0, -0.0005 - 0.5 * (body >= 0)]], wp.vec3),
    )
    margins = array([0.0005], float), array([0.0], float)
    inputs = [
        array([0]),
        array([1]),
        array([0]),
        array([1]),
        *points,
        *margins,
        array([[0.0, 0.0, 1.0]], wp.vec3),
    ]
    inputs += [
        array([[*each, 0.0, 0.0, 0.0] for each in forces_n], wp.spatial_vector),
        array([-1, 0]),
        array([-1, body]),
        pose,
    ]
    wp.launch(
        record_contacts,
        dim=1,
        inputs=[*inputs, array([1.0, 0.5], float)],
        outputs=[contacts],
        device="cpu",
    )
    return dict(zip(FRAME_COLUMNS, contacts.numpy()[0, 0], strict=True))


@pytest.mark.parametrize("body", [-1, 0], ids=["in the world", "on a body"])
def test_a_contact_is_taken_apart_along_its_normal_with_the_mean_of_two_frictions(body):
    found = recorded(
        [3.0, 0.0, -4.0], body=body
    )  # on the first shape, whose normal points away from it
    assert (found["normal_force_n"], found["tangential_force_n"]) == pytest.approx(
        (4.0, 3.0)
    )
    assert found["cone_use"] == pytest.approx(3.0 / (0.75 * 4.0))
    assert found["penetration_m"] == pytest.approx(0.001, rel=1e-3)
    assert (found["contact_count"], found["loaded_count"]) == (1, 1)


def test_friction_of_a_patch_counts_where_no_force_presses():
    found = recorded([3.0, 0.0, 0.0])
    assert (
        found["tangential_force_n"],
        found["loaded_count"],
        found["penetration_m"],
    ) == pytest.approx((3.0, 0, 0.0))


def test_a_contact_is_deep_where_its_solver_does_not_say_what_it_carries():
    found = recorded()
    assert (found["contact_count"], found["loaded_count"]) == (1, 0)
    assert found["penetration_m"] == pytest.approx(0.001, rel=1e-3)


def test_bodies_of_a_colour_are_not_joined():
    parents, children = [-1, 0, 1, 1, -1], [0, 1, 2, 3, 4]
    arm = SimpleNamespace(
        joint_parent=array(parents),
        joint_child=array(children),
        body_count=5,
        device="cpu",
    )
    colours = [set(group.numpy().tolist()) for group in colours_of(arm)]
    assert sorted(colours[0] | colours[1]) == [0, 1, 2, 3, 4]
    assert not any(
        {*pair} <= group
        for pair in zip(parents, children, strict=True)
        for group in colours
    )


def test_a_world_that_drops_rows_has_failed_from_the_first_frame_on_in_which_it_does():
    first = array([7, 7, 3])
    is_over = array(
        [True, False, True, True], wp.bool
    )  # the last contact belongs to no world
    wp.launch(
        watch_overflow,
        dim=3,
        inputs=[array([5, 5, 5]), is_over],
        outputs=[first],
        device="cpu",
    )
    assert np.array_equal(first.numpy(), [5, 7, 3])


def test_a_solver_that_a_release_adds_is_measured_unless_it_is_excused(monkeypatch):
    monkeypatch.setattr(
        solvers,
        "SolverNew",
        type("SolverNew", (solvers.SolverBase,), {}),
        raising=False,
    )
    monkeypatch.setattr(solvers, "__all__", [*solvers.__all__, "SolverNew"])
    names = {variant.solver: variant.name for variant in box.variants()}
    assert (names["SolverNew"], names["SolverMuJoCo"], names["SolverSemiImplicit"]) == (
        "new",
        "mujoco",
        "semi-implicit",
    )
    assert set(box.solver_classes()) == {*names, *box.EXCUSED}
    assert "SolverBase" not in names and "SolverNotifyFlags" not in names
