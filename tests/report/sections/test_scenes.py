"""Test the creep of other scenes."""

import pytest
from deriving import assert_found

pytestmark = pytest.mark.usefixtures("unchanged")

CREEPS = {
    "*": {
        "creep_mm_s": 1,
        "forecast_creep_mm_s": 1,
        "steady_creep_mm_s": 1,
        "predicted_creep_mm_s": 1,
    },
    "slope-2ms-impratio-1": {"creep_mm_s": 1.4},
    "slope-20ms-impratio-1": {"creep_mm_s": 0.0005, "forecast_creep_mm_s": 0.0006},
    ("cure", "*"): {
        "growth_per_s": 0.01,
        "predicted_growth_per_s": -0.01,
        "start_radius_mm": 100,
    },
    ("contacts", "*"): {"slide_mm": 4, "predicted_slide_mm": 4},
    "recipe-c": {"creep_mm_s": 0.16},
    "impratio-1-c": {"creep_mm_s": 1.5},
    "pyramidal-c": {"creep_mm_s": 2.3},
    "stiff-c": {"creep_mm_s": 0.05},
    "noslip-c": {"creep_mm_s": 0.0014},
    "recipe-newton": {"steady_creep_mm_s": 1.009},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "largest_factor": 1.4,
                "fastest_creep": 1.4,
                "slowest_creep": 0.0005,
                "creep_range": 2800,
                "scene_count": 5,
                "predicted": "holds",
                "creep/predicted": True,
                "turntable_plain-c_measured": 1,
                "contacts_as-shipped-missing-term_measured": 1,
                "recipe_from_published": 3.232466,
                "published_off": 3.232466,
                "published_count": 5,
                "as_published": "holds",
                "law_off": 0.9,
                "law_count": 27,
                "follows_law": "holds",
            },
        ),
        (
            {
                "slope-2ms-impratio-1": {"creep_mm_s": 1.6},
                "recipe-c": {"creep_mm_s": 0.164},
                "recipe-newton": {"steady_creep_mm_s": 0.989},
            },
            {
                "predicted": "fails",
                "creep/predicted": False,
                "as_published": "fails",
                "law_off": 1.1,
                "follows_law": "fails",
            },
        ),
        (
            {
                "slope-2ms-impratio-1": {"forecast_creep_mm_s": 2.3},
                "noslip-*": {"predicted_creep_mm_s": 0},
            },
            {"largest_factor": 1.642857, "predicted": "fails", "law_count": 24},
        ),
        (
            {
                "slope-20ms-impratio-1": {
                    "creep_mm_s": 0.0015,
                    "forecast_creep_mm_s": 0.0015,
                }
            },
            {"predicted": "fails"},
        ),
        ({"slope-*": None}, {"predicted": "cannot tell", "creep/predicted": False}),
        (
            {
                ("cure", "resolution"): 0.5,
                ("cure", "plain-warp"): {"predicted_growth_per_s": 0.0049},
            },
            {"point_count": 71},
        ),
    ],
)
def test_whether_creeps_are_predicted(cells, expected):
    assert_found("scenes", CREEPS, cells, expected=expected)


GRASPS = {
    "*-published-*": {"held_count": 0, "seed_count": 8, "last_drop_s": 6},
    "*-elliptic-c": {"held_count": 8, "seed_count": 8},
    "ball-published-held": {"margin_mm": 4, "forecast_creep_mm_s": 4},
    "ball-2ms-published-c": {
        "median_drop_s": 6.1,
        "first_drop_s": 6.06,
        "last_drop_s": 6.1,
    },
    "cube-published-held": {"forecast_drop_s": 27},
    "cube-2ms-published-c": {"median_drop_s": 14},
}


@pytest.mark.parametrize(
    ("cells", "expected"),
    [
        (
            {},
            {
                "published_held": 0,
                "published_shakes": 64,
                "published_latest": 6.1,
                "fails_as_published": "holds",
                "elliptic_c_held": 16,
                "elliptic_c_count": 16,
                "elliptic_holds": "holds",
                "ball_passes": 5.5,
                "ball_drop_off": 10.90909,
                "ball_drop_spread": 0.04,
                "ball_off": 1.29525,
                "ball_creeps_out": "holds",
                "cube_drop_share": 51.85185,
                "cube_is_shaken_out": "holds",
                "drops/time of the drop, MuJoCo C/1": "never",
                "drops/time of the drop, MuJoCo C/0": 14,
                "drops/shakes survived, MuJoCo C/3": 0,
            },
        ),
        (
            {
                "cube-10ms-published-newton": {"held_count": 8},
                "ball-2ms-elliptic-c": {"held_count": 0},
                "ball-2ms-published-c": {"median_drop_s": 6.3},
            },
            {
                "fails_as_published": "fails",
                "elliptic_holds": "fails",
                "ball_off": 4.616407,
                "ball_creeps_out": "holds",
            },
        ),
        (
            {
                "cube-10ms-published-newton": {"last_drop_s": 21},
                "ball-2ms-published-c": {"median_drop_s": 6.32},
                "ball-published-held": {"margin_mm": 3},
            },
            {"fails_as_published": "fails", "ball_creeps_out": "fails"},
        ),
        (
            {
                "ball-published-held": {"margin_mm": 2},
                "cube-2ms-published-c": {"median_drop_s": 22},
            },
            {
                "ball_passes": 5,
                "ball_drop_off": 22,
                "ball_creeps_out": "fails",
                "cube_is_shaken_out": "fails",
            },
        ),
        (
            {
                "ball-2ms-published-c": {"last_drop_s": 6.17},
                "*-10ms-published-*": {"lifted_count": 0},
            },
            {"ball_creeps_out": "fails", "fails_as_published/is_lifted": False},
        ),
        (
            {"cube-10ms-published-c": {"lifted_count": 1}},
            {"fails_as_published/is_lifted": True},
        ),
    ],
)
def test_when_grasps_drop_their_object(cells, expected):
    assert_found("scenes", CREEPS, GRASPS, cells, expected=expected)
