"""Compare loads and creep of held bodies, and thresholds of grips, with numbers
computed by hand. With a solimp of 0.9 at each depth, a box of mass m on four points
creeps at g sin θ / 4 · (1 - d) timeconst / 2, because w is 1/m.
"""

import copy
import math
from dataclasses import replace

import mujoco
import pytest

from newton_lint.law import DISCRETE
from newton_lint.report import scene_of
from newton_lint.target import Target
from tests.newton_lint.cases import Case
from tests.newton_lint.settle import Work, _reading, predicted_hold, settled_hold

FLAT = "0.9 0.9 0.001 0.5 2"
SOFT = "0.1 0.1 0.001 0.5 2"
SIN = 0.2 / math.hypot(1.0, 0.2)
COS = 1.0 / math.hypot(1.0, 0.2)
CREEP = 1e3 * 9.81 * SIN / 4.0 * 0.1 * 0.01
"""Creep on a slope of 0.2 with a timeconst of 20 ms [mm/s]."""


def hold_of(kind: str = "incline", work: Work | None = None, **changes) -> tuple:
    target = Case(kind, tuple({"solimp": FLAT, **changes}.items())).target
    scene = scene_of(target)
    return scene, target, settled_hold(scene, target, work or Work("held"))


@pytest.mark.parametrize(
    ("changes", "lift", "creep"),
    [
        ({}, 0.0, CREEP),
        ({"impratio": 4, "mass": 2}, 0.0, CREEP / 4.0),
        ({"cone": "pyramidal", "mu": 0.5}, 0.0, CREEP * 1.25),  # 1 + μ²
        ({"cone": "pyramidal", "mu": 0.5, "impratio": 4}, 0.0, CREEP * 1.25 / 4.0),
        ({}, 9.81, 2.0 * CREEP),
        ({"option": 'noslip_iterations="20"'}, 0.0, 0.0),
    ],
)
def test_a_slope_is_borne_by_four_points(changes, lift, creep):
    _, _, hold = hold_of(work=Work("held", lift_m_s2=lift), **changes)
    mass = changes.get("mass", 0.5)
    assert hold.load_n == pytest.approx(mass * (9.81 + lift) * SIN, rel=1e-3)
    assert (
        hold.mm_s == pytest.approx(creep, rel=2e-3, abs=1e-9)
        and hold.rests
        and not hold.slides
    )
    assert (hold.point_count, hold.data.time, hold.acceleration_mm_s) == pytest.approx(
        (4, 0.5, 0.0)
    )
    assert sum(touch.normal_n for touch in hold.touches) == pytest.approx(
        mass * 9.81 * COS, rel=1e-3
    )
    for touch in hold.touches:
        assert touch.weight_1_kg == pytest.approx(1.0 / mass, rel=1e-4)
        assert touch.normal[2] == pytest.approx(1.0) and touch.softer == pytest.approx(
            1.0, rel=1e-3
        )


@pytest.mark.parametrize(
    ("cone", "used"), [("elliptic", 0.2 * math.sqrt(2.0)), ("pyramidal", 0.4)]
)
def test_a_cone_is_used_by_the_length_of_friction_and_a_pyramid_by_the_sum_of_its_axes(
    cone, used
):
    target = Case("incline", (("cone", cone), ("solimp", FLAT))).target
    target.model.opt.gravity[:] = 2.0, 2.0, -10.0
    touches = settled_hold(scene_of(target), target, Work("held")).touches
    normals = sum(touch.normal_n for touch in touches)
    assert sum(
        touch.used * touch.normal_n for touch in touches
    ) / normals == pytest.approx(used, rel=1e-3)


def test_of_two_frictions_the_lower_gives_way_by_the_square():
    """Test that R along the second axis is (0.8 / 0.4)² times as large as along the
    first one.
    """
    rest = '<contact><pair geom1="floor" geom2="box" friction="0.8 0.4" {}/></contact>'.format(
        f'solimp="{FLAT}"'
    )
    target = Case("incline", (("rest", rest),)).target
    target.model.opt.gravity[:] = 1.0, 1.0, -10.0
    scene = scene_of(target)
    hold = settled_hold(scene, target, Work("held"))
    assert [touch.softer for touch in hold.touches] == pytest.approx(
        [2.5] * 4, rel=1e-2
    )
    # The ellipse has a radius of 0.8 / √2.5 there, so √2 N per kilogram need a force of
    # 2.8 N.
    for share, slides in ((0.27, True), (0.29, False)):
        touches = [
            replace(touch, normal_n=share * touch.normal_n) for touch in hold.touches
        ]
        assert (
            predicted_hold(scene, hold.body, touches, Work("held"), hold.data).slides
            == slides
        )


def test_what_turns_leaves_its_centripetal_acceleration_out():
    _, _, hold = hold_of("turn", Work("held", turn_rad_s=0.5))
    assert hold.acceleration_mm_s == pytest.approx(
        (0.9 * 10.0 - 1.0) * 0.25, rel=1e-3
    )  # (1/b - h/2) ω² r
    # For the load m ω² r on one point, R/b is (1 - d) timeconst / 2 / m; the table with
    # 1e6 kg m² adds nothing.
    assert hold.mm_s == pytest.approx(8.0 * 0.25 + 0.1 * 10.0 * 0.25, rel=2e-3)


def test_what_turns_is_as_far_out_as_from_the_root_of_what_holds_it():
    """Test an axis at 0.4 m, which leaves a radius of 0.6 m."""
    text = Case("turn", (("solimp", FLAT),)).text.replace(
        '<body name="table">', '<body name="table" pos="0.4 0 0">'
    )
    target = Target("scene", mujoco.MjModel.from_xml_string(text))
    hold = settled_hold(scene_of(target), target, Work("held", turn_rad_s=0.5))
    assert hold.acceleration_mm_s == pytest.approx(8.0 * 0.25 * 0.6, rel=1e-3)
    assert hold.mm_s == pytest.approx((8.0 + 1.0) * 0.25 * 0.6, rel=2e-3)


def test_friction_is_what_acts_on_what_is_held_whichever_of_both_geoms_comes_first():
    """Test a box that precedes its support in the file and is lifted with 2 g: 3 m g
    sin θ.
    """
    text = Case("incline", (("solimp", FLAT),)).text
    floor = next(line for line in text.splitlines() if 'name="floor"' in line)
    below = f"<body>{floor.replace('plane', 'box')}</body>".replace(
        "<geom", '<geom pos="0 0 -1"'
    )
    text = text.replace(floor, "").replace("</worldbody>", f"{below}</worldbody>")
    target = Target("scene", mujoco.MjModel.from_xml_string(text))
    hold = settled_hold(scene_of(target), target, Work("held", lift_m_s2=2.0 * 9.81))
    assert hold.touches[0].geoms == (0, 1) and hold.load_n == pytest.approx(
        3.0 * 0.5 * 9.81 * SIN, rel=1e-3
    )


def test_a_touch_counts_by_its_share_of_the_last_fifth():
    """Test a body that falls for 0.45 s and touches in the second half of 0.4 to 0.5 s."""
    fall = 0.5 * 9.81 * 0.45**2
    changes = {"slope": 0.0, "shape": "sphere", "solref": "0.02 3"}
    target = Case("incline", tuple(changes.items())).target
    target.model.qpos0[2] = 0.05 + fall
    hold = settled_hold(scene_of(target), target, Work("held"))
    assert hold.point_count == pytest.approx(0.5, abs=0.03)
    [touch] = hold.touches
    assert touch.normal_n * 0.1 == pytest.approx(
        0.5 * 9.81 * 0.45, rel=0.2
    )  # a mean over all steps, because the body was stopped


@pytest.mark.parametrize(
    ("above", "speed", "is_held"),
    [(0.035, -1.0, True), (-0.0055, 0.0, True), (0.1, 0.0, False)],
)
def test_what_was_touched_within_a_tenth_or_a_hundredth_of_the_time_is_lost(
    above, speed, is_held
):
    """Test a body in contact from 40 to 50 ms, from 4 to 5 ms, or never."""
    target = Case(
        "incline", (("slope", 0.0), ("shape", "sphere"), ("solref", "0.02 0.25"))
    ).target
    target.model.opt.gravity[:] = 0.0
    data = mujoco.MjData(target.model)
    data.qpos[2] = 0.05 + above
    data.qvel[2] = speed
    hold = settled_hold(scene_of(target), replace(target, data=data), Work("held"))
    assert (hold is not None and hold.slides) == is_held


def test_what_is_at_the_edge_of_its_cone_or_moves_much_faster_slides():
    scene, _, hold = hold_of()
    for used, slides in ((0.9985, False), (0.9995, True)):
        touches = [replace(touch, used=used) for touch in hold.touches]
        assert (
            predicted_hold(scene, hold.body, touches, Work("held"), hold.data).slides
            == slides
        )
    softer = [
        replace(touch, weight_1_kg=1e6 * touch.weight_1_kg) for touch in hold.touches
    ]
    assert predicted_hold(
        scene, hold.body, softer, Work("held"), hold.data
    ).slides  # faster than 1 m/s
    for speed, slides in ((0.14, False), (0.16, True)):  # 3 · (0.5 mm/s + 50 mm/s)
        hold.data.qvel[:] = speed, 0.0, 0.0, 0.0, 0.0, 0.0
        mujoco.mj_forward(scene.model, hold.data)
        found = predicted_hold(scene, hold.body, hold.touches, Work("held"), hold.data)
        assert (found.slides, found.moves_mm_s) == (
            slides,
            pytest.approx(1e3 * speed, rel=1e-3),
        )


def test_discrete_weighs_what_a_row_says_of_itself():
    """Test the factor 1 + b h + h² k d, with b = 2 / 18 ms and k = 1 / 18² ms²."""
    scene, _, hold = hold_of()
    model = copy.copy(scene.model)
    model.opt.integrator = DISCRETE
    discrete = replace(scene, model=model)
    one, other = (
        _reading(variant, hold.data, 0, 1.0)["weight_1_kg"]
        for variant in (scene, discrete)
    )
    assert other / one == pytest.approx(1.0 + 2.0 / 9.0 + 0.9 / 81.0)
