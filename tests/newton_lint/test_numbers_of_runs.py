"""Compare numbers of runs, and thresholds of findings and of harm, with numbers
computed by hand.
"""

import math
from dataclasses import dataclass, replace

import mujoco
import numpy as np
import pytest

from newton_lint.findings import Finding, rounded
from newton_lint.grips import _firmer
from newton_lint.ledger import Run, Start, run_of, starts
from newton_lint.motion import motions, symptoms
from newton_lint.report import scene_of
from newton_lint.target import Target
from newton_lint.trials import Trials, harm
from newton_lint.yielding import _centre

BALL = """
<mujoco>
  <option gravity="0 0 {g}" {option}>{flag}</option>
  <worldbody><geom name="floor" type="plane" size="9 9 1" {floor}/>
    <body name="ball" pos="0 0 {z}"><freejoint name="free"/>
      <geom name="ball" type="{type}" size="0.1 0.1 0.1" mass="2"/></body>{more}
  </worldbody>
  {rest}
</mujoco>
"""
USUAL = {
    "g": 0,
    "option": "",
    "flag": "",
    "floor": "",
    "z": 1,
    "type": "sphere",
    "more": "",
    "rest": "",
}


def of(**changes) -> Target:
    return Target(
        "scene", mujoco.MjModel.from_xml_string(BALL.format(**USUAL | changes))
    )


@dataclass(frozen=True)
class Pushed(Start):
    """Return a start at which the ball has a speed and a force acts on it."""

    force: tuple = (0.0, 0.0, 0.0)
    torque: tuple = (0.0, 0.0, 0.0)
    speed: tuple = (0.0, 0.0, 0.0)

    def data(self, model: mujoco.MjModel) -> mujoco.MjData:
        data = super().data(model)
        data.xfrc_applied[1] = (*self.force, *self.torque)
        data.qvel[:3] = self.speed
        return data


def ran(
    target: Target, time_s: float = 0.2, force: float = 0.0, speed: tuple = (0, 0, 0)
) -> Run:
    return run_of(
        target.model, Pushed("the start", force=(force, 0.0, 0.0), speed=speed), time_s
    )


def found_in(target: Target) -> dict[str, Finding]:
    """Return the findings on all starts of a scene by their rules."""
    runs = [run_of(target.model, start) for start in starts(target.model, None)]
    scene = scene_of(target)
    findings = motions(Trials(scene, runs, lambda *given: ([], symptoms(*given))))
    return {each.rule: each for each in findings}


@pytest.mark.parametrize("speed", [0.0, 1.5])
def test_what_a_force_gives_a_body_is_energy_that_it_gained(speed):
    """Test a force of 6 N that acts on 2 kg for 0.2 s.

    It adds 0.6 m/s, so the energy grows by (v + 0.6)²/2 - v²/2. A falling body gains
    no energy.
    """
    seen = ran(of(), force=6.0, speed=(speed, 0, 0))
    assert seen.rise_m2_s2[0] == pytest.approx(
        0.5 * (speed + 0.6) ** 2 - 0.5 * speed**2
    )
    assert seen.thrown_m_s[0] == pytest.approx(math.sqrt(0.36 + 1.2 * speed))
    assert (seen.speeds_m_s[0], seen.time_s, seen.effort, seen.bad) == (
        pytest.approx(speed + 0.6),
        pytest.approx(0.2),
        500.0,
        False,
    )
    turned = run_of(of().model, Pushed("the start", torque=(1.0, 1.0, 1.0)), 0.2)
    assert turned.rise_m2_s2[0] == 0.0  # a rotating body does not count as thrown
    falls = ran(of(g=-9.81))
    assert (falls.thrown_m_s[0], falls.speeds_m_s[0]) == (0.0, pytest.approx(1.962))
    assert ran(
        of(g=-9.81, flag='<flag gravity="disable"/>'), speed=(0, 0, 2.0)
    ).thrown_m_s[0] == pytest.approx(0.0)


def test_overlaps_count_from_the_margin_on_and_depths_do_not():
    """Test a ball of 0.1 m at a height of 0.095 m, which is 5 mm deep, or 15 mm with
    its margin.
    """
    seen = ran(of(z=0.095, floor='margin="0.01"'), 0.002)
    assert (seen.first, seen.deepest_m) == (
        {(0, 1): pytest.approx(0.015)},
        pytest.approx(0.005),
    )
    assert ran(of(z=0.105, floor='margin="0.01"'), 0.002).deepest_m == 0.0


@pytest.mark.parametrize(("time_s", "late"), [(0.024, True), (0.045, False)])
def test_late_is_after_the_first_third(time_s, late):
    """Test that 1 m/s upward from a depth of 10 mm ends the contact within 8 to 15 ms."""
    seen = ran(of(z=0.09, floor='solref="1 1"'), time_s, speed=(0, 0, 1.0))
    assert seen.deepest_m == pytest.approx(0.01) and (seen.late_m > 0.0) == late


@pytest.mark.parametrize(("iterations", "share"), [(1, 1.0), (100, 0.0)])
def test_effort_is_steps_and_half_the_iterations(iterations, share):
    target = of(g=-9.81, z=0.1, type="box", option=f'iterations="{iterations}"')
    seen = ran(target)
    data = mujoco.MjData(target.model)
    count = 0
    for _ in range(100):
        mujoco.mj_step(target.model, data)
        count += int(data.solver_niter.sum())
    assert (seen.effort, seen.at_limit) == (
        pytest.approx(500.0 + 0.5 * count / 0.2, rel=0.01),
        pytest.approx(share, abs=0.05),
    )
    assert 0.0 < seen.spent_s < 10.0


@pytest.mark.parametrize(
    ("depth", "severity"),
    [
        (0.0049, None),  # 5 % of 0.1 m
        (0.0051, "note"),
        (0.09, "warning"),  # this throws the ball up at more than 0.5 m/s
    ],
)
def test_an_overlap_is_a_warning_if_it_throws(depth, severity):
    target = of(g=-9.81, z=0.1 - depth)
    found = found_in(target).get("overlap")
    assert (found.severity if found else None) == severity
    assert not found or (found.shape, found.against) == ("ball", ("floor",))
    assert not found or found.value == pytest.approx(1e3 * depth)
    # The ball is raised by the depth and a tenth of a millimetre.
    # Nothing is tried for a note.
    raised = '`pos="0 0 0.1001"` on body ball'
    assert (raised in found.advice) == (severity == "warning") if found else True


@pytest.mark.parametrize(("depth_mm", "said"), [(0.9, False), (1.1, True), (5, True)])
def test_what_lies_is_pressed_in_from_a_millimetre_on(depth_mm, said):
    """Test a box of 0.1 m that sinks by g (1 - d) timeconst² / 4.

    The recommended timeconst reduces this to a tenth, or to 0.3 mm.
    """
    timeconst = math.sqrt(1e-3 * depth_mm / (9.81 * 0.1 / 4.0))
    floor = f'priority="1" solref="{timeconst} 1" solimp="0.9 0.9 0.001" friction="1"'
    found = found_in(of(g=-9.81, z=0.1, floor=floor, type="box")).get("depth")
    assert bool(found) == said
    assert not found or found.value == pytest.approx(depth_mm, rel=0.04)
    after = found.cures[0].after if found else None
    # Attributes have two digits.
    assert not found or after == pytest.approx(min(0.3, 0.1 * depth_mm), rel=0.12)


@pytest.mark.parametrize(
    ("y", "joint", "said"),
    [(0, "", True), (1.5, "", False), (0, '<joint damping="1e9"/>', False)],
)
def test_what_flies_through_a_wall_is_followed_and_what_flies_past_is_not(
    y, joint, said
):
    """At 20 m/s the ball passes 20 mm in half a step."""
    wall = f'<body pos="-1 0 1">{joint}<geom name="wall" type="box" size="0.01 1 1"/></body>'
    more = " 0" if joint else ""
    key = f'<keyframe><key qpos="-2 {y} 1 1 0 0 0{more}" qvel="20 0 0 0 0 0{more}"/></keyframe>'
    target = of(more=wall, rest=key)
    found = found_in(target).get("tunnel")
    assert bool(found) == said
    assert not found or found.value == pytest.approx(20.0)


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.0, "mm", "0 mm"),
        (0.0004, "mm", "below 0.001 mm"),
        (2.0004, "°/s", "2°/s"),
        (999.4, "mm", "999 mm"),
        (999.6, "mm", "1,000 mm"),
        (2004.2, "mm", "2,004 mm"),
        (1.6e5, "1", "160,000"),
        (-1.2e4, "%", "-12,000%"),
    ],
)
def test_large_numbers_are_printed_in_full(value, unit, text):
    assert rounded(value, unit) == text


@pytest.mark.parametrize(("timeconst", "said"), [(0.043, False), (0.047, True)])
def test_a_weld_is_open_from_a_millimetre_on(timeconst, said):
    """Test the gap (1 - d) g timeconst², which has the same form as a contact's depth."""
    weld = f'<equality><weld body1="ball" solref="{timeconst} 1" solimp="0.95 0.95 0.001"/></equality>'
    target = of(g=-9.81, rest=weld)
    found = found_in(target).get("equality")
    assert bool(found) == said
    assert not found or found.value == pytest.approx(
        50.0 * 9.81 * timeconst**2, rel=0.02
    )


ARM = """
<body pos="2 0 1"><joint {} frictionloss="{}" solreffriction="{} 1"/><geom size="0.05" pos="{} 0 0" mass="1"/></body>
"""


@pytest.mark.parametrize(
    ("timeconst", "share", "kind", "said"),
    [
        (0.02, 0.5, "slide", True),
        (0.01, 0.5, "slide", True),
        (0.009, 0.5, "slide", False),  # 4.66 mm/s
        (0.02, 0.983, "slide", True),
        (0.02, 0.995, "slide", False),
        (0.02, 0.5, "hinge", True),
    ],
)
def test_a_joint_sags_by_its_row_as_a_contact_creeps(timeconst, share, kind, said):
    """Test the speed R f / b = (1 - d)/d g dmax timeconst / 2, with d 0.9 and dmax
    0.95. A hinge turns at this speed over its arm of 0.3 m.
    """
    arm, axis = (0.3, "0 1 0") if kind == "hinge" else (0, "0 0 1")
    joint = f'type="{kind}" axis="{axis}"'
    target = of(
        g=-9.81,
        more=ARM.format(joint, 9.81 * (arm or 1.0) / share, timeconst, arm),
        z=0.1,
    )
    found = found_in(target).get("sag")
    assert bool(found) == said
    speed = 0.1 / 0.9 * 9.81 * 0.95 * 0.5 * timeconst
    turned = (
        math.degrees(speed / 0.3) * 0.09 / (0.09 + 0.4 * 0.05**2)
    )  # and the ball's own inertia
    assert not found or found.value == pytest.approx(
        1e3 * speed if kind == "slide" else turned, rel=0.01
    )
    # With solimpfriction 0.999, R is 111 times as small.
    assert not found or found.cures[0].after == pytest.approx(
        found.value / 111.0, rel=0.2
    )


HARM = [
    ({}, {"deepest_m": 0.01104}, ""),  # 1.1 times 10 mm and 0.05 mm
    ({}, {"deepest_m": 0.01106}, "deepest contact goes from 10 to 11.1 mm"),
    ({}, {"late_m": 0.00554}, ""),
    ({}, {"late_m": 0.00556}, "deepest contact at the end goes from 5 to 5.56 mm"),
    ({}, {"speed": 1.204}, ""),  # 1.2 times 1 m/s and 5 mm/s
    ({}, {"speed": -1.206}, "the fastest speed"),
    ({}, {"effort": 1790.0}, ""),
    ({}, {"effort": 1810.0}, "1.8 times as much"),
    ({}, {"bad": True}, "blows up after 0.2 s"),
    ({"bad": True}, {"deepest_m": 1.0}, ""),
    ({}, {"thrown": 0.49}, ""),
    ({"thrown": 0.1}, {"thrown": 0.51}, "contacts throw a body at 0.51 m/s"),
    ({"thrown": 2.0}, {"thrown": 2.39}, ""),
    ({"thrown": 2.0}, {"thrown": 2.41}, "contacts throw a body at 2.41 m/s"),
    (
        {"thrown": 0.51},
        {"thrown": 0.24, "late_m": 0.009},
        "",
    ),  # the position in which it lies now
    ({"thrown": 0.51}, {"thrown": 0.26, "late_m": 0.009}, "at the end"),
    ({"thrown": 0.49}, {"thrown": 0.24, "late_m": 0.009}, "at the end"),
    (
        {"thrown": 0.51},
        {"thrown": 0.24, "late_m": 0.009, "deepest_m": 0.0101},
        "at the end",
    ),
    ({"rule": "lost"}, {"late_m": 0.009, "deepest_m": 0.0019, "effort": 9e9}, ""),
    ({"rule": "lost"}, {"late_m": 0.009, "deepest_m": 0.0021}, "at the end"),
]


@pytest.mark.parametrize(("old", "new", "said"), HARM)
def test_a_change_does_harm_from_its_thresholds_on(old, new, said):
    runs = []
    seen = ran(of())
    for given in (old, new):
        given = {
            "deepest_m": 0.01,
            "late_m": 0.005,
            "effort": 1000.0,
            "speed": 1.0,
            "thrown": 0.0,
            **given,
        }
        moving = {"qvel": np.array([0.0, given.pop("speed"), 0.0, 0.0, 0.0, 0.5])}
        samples = [replace(each, arrays=each.arrays | moving) for each in seen.samples]
        rise = np.array([0.5 * given.pop("thrown") ** 2])
        rule = given.pop("rule", "depth")
        runs.append((rule, replace(seen, samples=samples, rise_m2_s2=rise, **given)))
    (rule, before), (_, after) = runs
    found = harm([before], [after], [rule])
    assert said in found and bool(found) == bool(said)


@pytest.mark.parametrize(
    ("impratio", "tried"),
    [(1, {"10", "100"}), (10, {"100", "1000"}), (100, {"1000"}), (1000, set())],
)
def test_no_impratio_above_1000_is_tried(impratio, tried):
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option impratio="{impratio}"/><worldbody><geom type="plane" size="1 1 1"/>'
        '<body pos="0 0 .1"><freejoint/><geom size=".1"/></body></worldbody></mujoco>'
    )
    ways = _firmer(scene_of(Target("scene", model)), 1, [0])
    attributes = {item for way in ways for change in way for item in change.attributes}
    assert {value for name, value in attributes if name == "impratio"} == tried


def test_a_swing_that_ended_has_no_centre():
    swing = 10.0 + 3.0 * np.cos(np.linspace(0.0, 6.0 * math.pi, 50))
    slow = np.linspace(0.0, 0.5, 50)
    assert _centre(np.append(slow, swing), 25) == pytest.approx(10.0, abs=0.1)
    assert _centre(np.append(swing, slow), 25) == pytest.approx(slow[-25:].mean())
