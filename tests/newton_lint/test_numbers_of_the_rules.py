"""Checks each threshold of the rules from both sides, and each recommended number.

By default the step is 2 ms and dmax is 0.95. The formulas are from MuJoCo's
documentation, "Modeling", solver parameters: b = damping / dmax and
k = stiffness / dmax², or timeconst and dampratio, with at least two steps.
"""

import math

import mujoco
import pytest

from newton_lint.findings import Finding
from newton_lint.law import DISCRETE
from newton_lint.ledger import Start, run_of
from newton_lint.report import scene_of
from newton_lint.rules import lint
from newton_lint.scene import Engine
from newton_lint.target import Target
from newton_lint.trials import Trials

SCENE = """
<mujoco>
  <option timestep="{dt}" {option}>{flag}</option>
  <worldbody><geom name="floor" type="plane" size="1 1 1" {floor}/>
    <body name="part" pos="0 0 0.1"><freejoint/><geom name="part" type="{type}" size="0.1 0.1 0.1" {part}/></body>
  </worldbody>
  {rest}
</mujoco>
"""
PAIR = '<contact><pair geom1="floor" geom2="part" {}/></contact>'
USUAL = {
    "dt": 0.002,
    "option": "",
    "flag": "",
    "floor": "",
    "part": "",
    "type": "box",
    "rest": "",
    "integrator": None,
}


def found(rule: str, **changes) -> list[Finding]:
    given = USUAL | changes
    model = mujoco.MjModel.from_xml_string(SCENE.format(**given))
    if given["integrator"] is not None:
        model.opt.integrator = given["integrator"]
    scene = scene_of(Target("scene", model), Engine())
    # This release cannot step with the integrator discrete.
    steps = given["integrator"] is None
    runs = [run_of(scene.model, Start("the start"))] if steps else []
    trials = Trials(scene, runs)
    return [each for each in lint(trials) if each.rule == rule]


def alone(solref: str, **more) -> dict:
    """Return settings of a floor that give its solref the full weight."""
    return {"floor": f'priority="1" solref="{solref}"', **more}


FOUND = [
    ("solref-format", alone("0.03 -1"), -1.0, 1.0, "error", 'solref="0.02 1"'),
    ("solref-format", alone("-100 1"), 1.0, 1.0, "error", 'solref="0.02 1"'),
    ("solref-format", alone("0 1"), 1.0, 1.0, "error", 'solref="0.02 1"'),
    ("timeconst", alone("0.0039 1"), 0.0039, 0.004, "note", ""),
    ("timeconst", alone("0.00101 1"), 0.00101, 0.004, "note", ""),
    (
        "timeconst",
        alone("0.001 1"),
        0.001,
        0.004,
        "warning",
        'solref="0.004 1"',
    ),  # 4 times
    (
        "timeconst",
        alone("0.00025 2", integrator=DISCRETE),
        0.00025,
        0.001,
        "warning",
        "0.001 2",
    ),  # one step over 2
    (
        "stiff",
        alone("0 -191", dt=0.01),
        -191.0,
        None,
        "error",
        "",  # Without stiffness, the body sinks.
    ),  # dmax b h = 1.91; b h = 1
    (
        "stiff",
        alone("-38200 0", dt=0.01),
        0.0,
        None,
        "error",
        'solref="-2256 0"',
    ),  # 3.82 / 2 = 1.91; 95² / 4
    (
        "stiff",
        alone("-19100 -95", dt=0.01),
        -95.0,
        None,
        "error",
        'solref="-2256 -95"',
    ),  # 0.955 + 0.95
    (
        "one-sided",
        {"part": 'solref="0.004 1"'},
        0.004,
        0.012,
        "warning",
        'priority="1"` on part',
    ),
    (
        "one-sided",
        {"part": 'solref="0.004 1"'},
        0.004,
        0.012,
        "warning",
        'priority="1"',
    ),
    (
        "one-sided",
        {"part": 'solref="0.005 2"'},
        0.005,
        0.0125,
        "warning",
        'priority="1"',
    ),
    (
        "one-sided",
        {"part": 'solref="0.001 1"'},
        0.001,
        0.0105,
        "warning",
        'solref="0.004 1"',
    ),  # two steps
    (
        "one-sided",
        {"part": 'solref="0.001 1"'},
        0.001,
        0.0105,
        "warning",
        'priority="1"',
    ),  # 10.5 / 4
    (
        "one-sided",
        {"part": 'solref="0.001 1"', "flag": '<flag refsafe="disable"/>'},
        *(0.001, 0.0105, "warning", ""),
    ),
    (
        "one-sided",
        {"part": 'solref="0.004 1"', "floor": 'solref="0.0125 1"'},
        0.004,
        0.00825,
        "warning",
        'priority="1"',
    ),
    ("friction", {"part": 'friction="0.25"'}, 0.25, 1.0, "warning", 'priority="1"'),
    (
        "friction",
        {"part": 'friction="0.99"', "floor": 'friction="4"'},
        0.99,
        4.0,
        "warning",
        'priority="1"',
    ),
    (
        "pyramid",
        {"option": 'impratio="2"'},
        2.0,
        None,
        "warning",
        "by a factor of 2 (predicted)",
    ),
    (
        "pyramid",
        {"floor": 'friction="4"'},
        4.0,
        None,
        "warning",
        "by a factor of 17 (predicted)",
    ),  # 1 + μ²
    (
        "pyramid",
        {"floor": 'friction="4"'},
        4.0,
        None,
        "warning",
        "by a factor of 170 (predicted)",
    ),
    (
        "pyramid",
        {"floor": 'friction="4"', "option": 'impratio="0.5"'},
        4.0,
        None,
        "warning",
        "by a factor of 340 (predicted)",
    ),
    (
        "pyramid",
        {"floor": 'friction="4"', "option": 'impratio="0"'},
        4.0,
        None,
        "warning",
        "by a factor of",
    ),
    (
        "pyramid",
        {"floor": 'friction="3.1"', "option": 'iterations="9"'},
        3.1,
        None,
        "warning",
        'iterations="10"',
    ),
    (
        "lost",
        {"floor": 'conaffinity="4" contype="4"'},
        1.0,
        None,
        "warning",
        'contype="4" conaffinity="4"` on part',
    ),
]


@pytest.mark.parametrize(
    ("rule", "changes", "value", "used", "severity", "advice"), FOUND
)
def test_beyond_a_threshold_the_numbers_are_said(
    rule, changes, value, used, severity, advice
):
    [finding] = found(rule, **changes)
    assert (finding.value, finding.severity) == (pytest.approx(value), severity)
    assert finding.used == (None if used is None else pytest.approx(used))
    assert advice in str(finding.advice)


QUIET = [
    ("solref-format", alone("-100 -1")),
    (
        "solref-format",
        {"floor": 'solref="0.02 -1"', "rest": PAIR.format("")},
    ),  # its parameters do not count
    ("timeconst", alone("0.00399999 1")),
    ("timeconst", alone("0.003 1", flag='<flag refsafe="disable"/>')),
    ("timeconst", alone("0.0011 2", integrator=DISCRETE)),
    ("stiff", alone("0 -189", dt=0.01)),
    ("stiff", alone("-37800 0", dt=0.01)),
    ("stiff", alone("-18900 -95", dt=0.01)),
    (
        "stiff",
        alone('-37800 0" solimp="0 0.01 0.001', dt=0.01),
    ),  # as in MuJoCo's Newton's cradle
    ("stiff", alone("-19100 -95", dt=0.01, integrator=DISCRETE)),
    ("one-sided", {"part": 'solref="0.0051 1"'}),
    (
        "one-sided",
        {"part": 'solref="0.001 1"', "floor": 'solref="0.006 1"'},
    ),  # 3.5 ms, below four steps
    (
        "one-sided",
        {"part": 'solref="0.004 1"', "floor": 'solref="0.0119 1"'},
    ),  # 7.95 ms, not twice
    ("one-sided", {"part": 'solref="0.004 1"', "floor": 'priority="1"'}),
    ("friction", {"part": 'friction="0.26"'}),
    ("friction", {"floor": 'friction="4"'}),
    ("friction", {"part": 'friction="0.1" condim="1"', "floor": 'condim="1"'}),
    ("pyramid", {"floor": 'friction="3"'}),
    ("pyramid", {"floor": 'friction="3"', "option": 'cone="elliptic" impratio="10"'}),
    ("timeconst", {"dt": 0.015}),  # of the default value
    ("lost", {"floor": 'conaffinity="4"'}),
    (
        "lost",
        {"floor": 'conaffinity="4" contype="4"', "flag": '<flag gravity="disable"/>'},
    ),
]


@pytest.mark.parametrize(("rule", "changes"), QUIET)
def test_short_of_a_threshold_nothing_is_said(rule, changes):
    assert not found(rule, **changes)


def test_dmin_is_no_more_than_dmax_as_the_engine_clips_both():
    """2 and 1 are both clipped to 0.9999."""
    [finding] = found("solimp", floor='solimp="0.95 0.5 0.001 0.5 2"')
    assert (finding.value, finding.used) == (0.95, 0.5)
    assert 'solimp="0.95 0.95 0.001 0.5 2"' in str(finding.advice)
    assert not found("solimp", floor='solimp="2 1 0.001 0.5 2"') + found(
        "solimp", floor='solimp="0.9 0.9 0.001 0 1"'
    )


def test_a_pyramid_is_said_to_be_as_soft_as_it_is():
    """Test (1 + μ²) μ² / 2, which is 136 for a μ of 4."""
    [finding] = found("pyramid", floor='friction="4"')
    assert "contacts 136 times softer" in finding.message


def test_of_a_pair_whose_parameters_mix_the_stiffer_side_is_named():
    """Test a solmix of 3 to 1, which gives 0.75 · 2 ms + 0.25 · 8 ms."""
    floor = 'solref="0.008 1"'
    part = 'solref="0.002 1" solmix="3"'
    [finding] = found("timeconst", floor=floor, part=part)
    assert (finding.shape, finding.against) == ("part", ("floor",))
    assert finding.value == pytest.approx(0.0035) and math.isclose(finding.used, 0.004)


def test_a_pair_has_two_frictions_that_slide_then_one_that_spins_and_two_that_roll():
    own = 'friction="0.8 0.3 0.02 0.003 0.001" condim="6" solreffriction="0.004 1" solref="0.007 1"'
    off = 'contype="0" conaffinity="0"'
    model = mujoco.MjModel.from_xml_string(
        SCENE.format(**USUAL | {"rest": PAIR.format(own), "floor": off, "part": off})
    )
    scene = scene_of(Target("scene", model), Engine())
    contacts = scene.contacts
    assert scene.colliding == 2
    assert contacts.friction.tolist() == [
        [0.8, 0.02, 0.003]
    ] and contacts.condim.tolist() == [6]
    assert contacts.solref.tolist() == [
        [0.007, 1.0]
    ] and contacts.solreffriction.tolist() == [[0.004, 1.0]]
