"""Questions from issue trackers: the finding, and the effect of its first change."""

from pathlib import Path

import mujoco
import numpy as np
import pytest

from newton_lint.command import main
from tests.newton_lint.truth import CORPUS

PINCH = """
<mujoco>
  <option {option}/>
  <worldbody>
    <body name="left" pos="-0.0125 0 0"><joint name="l" type="slide" axis="1 0 0" damping="100"/>
      <geom name="left_pad" type="box" size="0.008 0.03 0.02" mass="0.2" {pads}/></body>
    <body name="right" pos="0.0125 0 0"><joint name="r" type="slide" axis="-1 0 0" damping="100"/>
      <geom name="right_pad" type="box" size="0.008 0.03 0.02" mass="0.2" {pads}/></body>
    <body name="body"><freejoint/>
      <geom type="capsule" size="0.004 0.05" euler="90 0 0" mass="{mass}" friction="0.7"/></body>
  </worldbody>
  <actuator><position joint="l" kp="4000"/><position joint="r" kp="4000"/></actuator>
  <keyframe><key ctrl="0.0025 0.0025"/></keyframe>
</mujoco>
"""
TIPS = """
<mujoco>
  <option cone="elliptic" impratio="100"/>
  <worldbody>
    <body name="hand">
      <body name="left" pos="-0.03 0 0"><joint name="l" type="slide" axis="1 0 0" damping="20"/>
        <geom name="left_tip" size="0.01" mass="0.1" friction="1 0.02"/></body>
      <body name="right" pos="0.03 0 0"><joint name="r" type="slide" axis="-1 0 0" damping="20"/>
        <geom name="right_tip" size="0.01" mass="0.1" friction="1 0.02"/></body>
    </body>
    <body name="body" pos="0 0.02 0"><freejoint/><geom type="box" size="0.0195 0.1 0.01" mass="0.05"/></body>
  </worldbody>
  <actuator><motor joint="l"/><motor joint="r"/></actuator>
  <keyframe><key ctrl="30 30"/></keyframe>
</mujoco>
"""
FLOOR = """
<mujoco>
  <option timestep="{dt}"/>
  <default><geom {default}/></default>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 1" euler="0 {slope} 0"/>
    <body name="body" pos="0 0 0.1"><freejoint/><geom type="box" size="0.1 0.1 0.1" {geom}/></body>
  </worldbody>
</mujoco>
"""
ARM = """
<mujoco>
  <option cone="elliptic" impratio="100"/>
  <worldbody><body name="body"><joint axis="0 1 0" frictionloss="20"/>
    <geom type="capsule" size="0.03" fromto="0 0 0 0.5 0 0" mass="3"/></body></worldbody>
</mujoco>
"""
BESIDE = {
    "option": "",
    "pads": 'friction="0.7"',
    "mass": 0.045,
    "dt": 0.002,
    "default": "",
    "geom": "",
    "slope": 0,
}
SETTLE_S = 1.0
MEASURED_S = 0.4
QUESTIONS = {
    "creeps-out-of-the-grip": (PINCH, {}, "slip", "creep", 0.1),
    "impratio-does-not-help": (
        PINCH,
        {"option": 'impratio="10"', "mass": 0.45},
        "pyramid",
        "creep",
        0.6,
    ),
    "stiff-pads-stay-soft": (
        PINCH,
        {
            "option": 'cone="elliptic" impratio="2"',
            "pads": 'friction="0.7" solref="0.004 1"',
        },
        "one-sided",
        "creep",
        0.6,
    ),
    "turns-in-the-fingertips": (TIPS, {}, "condim", "turn", 0.1),
    "falls-through-the-floor": (
        FLOOR,
        {"default": 'conaffinity="0"'},
        "lost",
        "sink",
        0.1,
    ),
    "solimp-in-the-wrong-order": (
        FLOOR,
        {"default": 'solimp="0.95 0.5 0.0001"', "slope": 8},
        "solimp",
        "creep",
        0.2,
    ),
    "sags-by-its-frictionloss": (ARM, {}, "sag", "turn", 0.01),
    "solref-below-the-time-step": (
        FLOOR,
        {"dt": 0.01, "default": 'solref="0.004 1"'},
        "timeconst",
        "sink",
        1.001,
    ),
}
"""Scene, its settings, the rule, the measured quantity, and the share that may remain."""


def measured(path: str, what: str) -> float:
    """Return the creep [mm/s], rotation [rad] or depth [mm] of the body."""
    model = mujoco.MjModel.from_xml_path(path)
    data = mujoco.MjData(model)
    body = model.body("body").id
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    places = []
    for time_s in (SETTLE_S, MEASURED_S):
        for _ in range(round(time_s / model.opt.timestep)):
            mujoco.mj_step(model, data)
        places.append((data.xpos[body].copy(), data.xmat[body].reshape(3, 3).copy()))
    (start, before), (end, after) = places
    if what == "creep":
        return 1e3 * float(np.linalg.norm(end - start)) / MEASURED_S
    if what == "turn":
        return float(
            np.arccos(np.clip(0.5 * (np.trace(before.T @ after) - 1.0), -1.0, 1.0))
        )
    return 1e3 * (0.1 - float(end[2]))


@pytest.mark.parametrize("question", QUESTIONS)
def test_the_change_that_is_named_cures_it(question, tmp_path, capsys):
    scene, changes, rule, what, share = QUESTIONS[question]
    path = tmp_path / "scene.xml"
    path.write_text(scene.format(**BESIDE | changes))
    before = measured(str(path), what)
    assert main([str(path), "--fix"]) == 1
    assert f"warning {rule}:" in capsys.readouterr().out
    assert measured(str(path), what) < share * before
    again = path.read_bytes()
    main([str(path), "--fix"])
    assert path.read_bytes() == again


SIDES = {
    "depth": (
        'solref="0.2 1" solimp="0.5 0.5 0.001" priority="1"',
        "",
        "part sinks 48.",
        "reduces it to 0.314 mm (measured, 2 s)",
    ),
    "friction": (
        "",
        'friction="0.05"',
        "part has a friction of 0.05, but its contacts use at least",
        'priority="1"',
    ),
    "pyramid": ("", 'friction="5"', "The friction of 5 makes", 'cone="elliptic"'),
}
"""Attributes of the floor and of the part, parts of the message, and of the advice."""


@pytest.mark.parametrize("rule", SIDES)
def test_what_only_one_side_says_is_answered(rule, tmp_path, capsys):
    floor, part, said, advice = SIDES[rule]
    path = tmp_path / "scene.xml"
    path.write_text(
        f'<mujoco><worldbody><geom name="mat" type="plane" size="1 1 1" {floor}/><body name="part" pos="0 0 0.1">'
        f'<freejoint/><geom name="part" type="box" size="0.1 0.1 0.1" {part}/></body></worldbody></mujoco>'
    )
    main([str(path), "--notes"])
    out = capsys.readouterr().out
    assert f" {rule}: " in out and said in out and advice in out
    assert ("but its contacts use" in out) == (rule == "friction")


PART = '<body name="part" pos="0 0 {z}"><freejoint/><geom name="part" type="box" size="0.1 0.1 0.1" {geom}/></body>'
TORSO = """
<body name="torso" pos="0 0 1"><geom type="box" size="0.2 0.2 0.2"/>
  <body name="thigh" pos="0 0 -0.2"><joint axis="0 1 0"/><geom type="capsule" size="0.07 0.2" pos="0 0 -0.2"/></body>
</body>
"""
SERVO = """
<body name="link"><joint name="a" axis="0 1 0"/><geom type="capsule" size="0.02" fromto="0 0 0 0.3 0 0" mass="0.2"/>
</body></worldbody><actuator><position joint="a" kp="5000" kv="100"/></actuator><keyframe><key qpos="0.3"/></keyframe>
<worldbody>
"""
WELDED = (
    PART.format(z=1, geom="")
    + '</worldbody><equality><weld body1="part" solref="1 1"/></equality><worldbody>'
)
STARTS = {
    "an exclude is of the bodies that overlap": (
        TORSO,
        "overlap: thigh/",
        'body1="torso" body2="thigh"',
    ),
    "a margin presses": (
        PART.format(z=0.12, geom='margin="0.1"'),
        "by 80 mm including their margin",
        '`pos="0 0 0.2001"` on body part',
    ),
    "of a direct solref": (
        PART.format(z=0.1, geom='solref="-25 -10" priority="1"'),
        "depth: part sinks",
        "reduces it to 0.485 mm (measured, 2 s)",
    ),
    "of the heavy on the light": (
        PART.format(z=0.1, geom='mass="0.01"')
        + PART.replace("part", "load").format(z=0.3, geom='mass="100"'),
        "with the mass of the lighter body",
        'solimp="0.999 0.999 0.001"',
    ),
    "a heap of loose bodies": (
        "".join(PART.replace("part", name).format(z=1, geom="") for name in "abc"),
        "(the fastest of 3 pairs), which throws them apart",
        '`pos="0.2001 0 1"` on body c',
    ),
    "a servo stiffer than the step": (
        SERVO,
        "error unstable",
        'integrator="implicitfast"',
    ),
    "a weld that is soft": (
        WELDED,
        "warning equality: equality_0 is",
        'solref="0.01 1"',
    ),
}
"""Bodies over a floor, part of the message, and part of the advice."""


@pytest.mark.parametrize("question", STARTS)
def test_what_stands_and_starts_wrong_is_said_with_what_mends_it(
    question, tmp_path, capsys, monkeypatch
):
    bodies, said, advice = STARTS[question]
    monkeypatch.chdir(tmp_path)
    floor = '<option timestep="0.005"/><worldbody><geom name="floor" type="plane" size="1 1 1"/>'
    (tmp_path / "scene.xml").write_text(f"<mujoco>{floor}{bodies}</worldbody></mujoco>")
    main(["scene.xml", "--notes"])
    out = capsys.readouterr().out
    assert said in out and advice in out, out
    assert [path.name for path in tmp_path.iterdir()] == [
        "scene.xml"
    ]  # MuJoCo writes a log of unstable runs


def test_the_thickness_that_is_named_stops_a_fall(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    thick_mm = 20.0
    for status in (1, 0):
        wall = f'<geom type="box" size="1 1 {thick_mm / 2e3}"/><body pos="0 0 6"><freejoint/><geom size="0.01"/>'
        path.write_text(f"<mujoco><worldbody>{wall}</body></worldbody></mujoco>")
        assert main([str(path)]) == status
        size = capsys.readouterr().out.partition('`size="1 1 ')[2].partition('"')[0]
        thick_mm = 2e3 * float(size or "nan")


LINK = '<body><joint name="j" axis="0 1 0" {}/><geom type="capsule" size="0.1" fromto="0 0 0 0.5 0 0" mass="3"/></body>'
FOOT = '<geom type="plane" size="1 1 1"/><body pos="0 0 0.02"><freejoint/><geom type="box" size="0.1 0.1 0.1"/></body>'
KEY = '</worldbody><keyframe><key qpos="0 0 0.1 1 0 0 0"/></keyframe><worldbody>'
MOTOR = '</worldbody><actuator><motor joint="j"/></actuator><worldbody>'
HOME = MOTOR.replace("motor", "position kp='999'").replace(
    "<w", "<keyframe><key qpos='-1' ctrl='0'/></keyframe><w"
)
NOTES = {
    "a piece by itself": (
        TORSO,
        "note overlap",
        "MuJoCo ignores this contact if the base can move",
    ),
    "a start beside a keyframe": (FOOT + KEY, "note overlap", "1 note"),
    "a start that is out of range": (
        LINK.format('range="60 90" damping="1e5"'),
        "note limit",
        "because it starts 60° beyond it",
    ),
    "a keyframe that says its ctrl": (LINK.format("") + HOME, "nothing found", ""),
    "a joint that a motor moves": (
        LINK.format('frictionloss="20"') + MOTOR,
        "nothing found",
        "note sag: j creeps at",
    ),
}


@pytest.mark.parametrize("question", NOTES)
def test_what_only_a_file_by_itself_shows_is_no_warning(question, tmp_path, capsys):
    bodies, *said = NOTES[question]
    (tmp_path / "scene.xml").write_text(
        f"<mujoco><worldbody>{bodies}</worldbody></mujoco>"
    )
    assert main([str(tmp_path / "scene.xml"), "--notes"]) == 0
    out = capsys.readouterr().out
    assert all(text in out for text in said), out


PUSHED = """
<mujoco>
  <worldbody>
    <geom type="plane" size="1 1 .1"/>
    <body pos="0 0 0.06"><freejoint/><geom type="cylinder" size="0.033 0.06" mass="1e-6"/></body>
    <body pos="-0.05 0 0.06"><joint name="x" type="slide" axis="1 0 0"/><geom size="0.02" mass="2"/></body>
  </worldbody>
  <actuator><position joint="x" kp="5000" kv="200"/></actuator>
  <keyframe><key ctrl="0.05"/></keyframe>
</mujoco>
"""


def test_what_is_pushed_lies_on_no_slope(tmp_path, capsys):
    (tmp_path / "scene.xml").write_text(PUSHED)
    main([str(tmp_path / "scene.xml")])
    assert "down a slope" not in capsys.readouterr().out


def test_what_mujoco_warp_refuses_is_said_in_its_words(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    path.write_text(FLOOR.format(**BESIDE).replace("<option", '<option solver="PGS"'))
    assert main([str(path), "--engine", "warp"]) == 1
    out = capsys.readouterr().out
    assert (
        "error engine" in out
        and "mjSOL_PGS is unsupported" in out
        and "predicted creep" not in out
    )


@pytest.mark.parametrize("solref", [".02 1", ".05 1"])
def test_a_change_that_tears_a_finger_through_a_wall_is_not_recommended(
    solref, tmp_path, capsys
):
    """A stiff mirror would drag the finger through the box that stops it."""
    text = (CORPUS / "mimic_blocked.xml").read_text()
    path = tmp_path / "scene.xml"
    path.write_text(text.replace(".02 1", solref))
    assert main([str(path), "--fix"]) == 1
    out, err = capsys.readouterr()
    assert "warning equality: mirror is 2" in out and err == ""
    assert "because" not in out and "None of the tried changes helps." in out


@pytest.mark.parametrize("name", ["bouncing_ball", "friction_ignored", "spin_hand"])
def test_fix_writes_the_change_that_the_line_recommends(name, tmp_path, capsys):
    path = tmp_path / "scene.xml"
    path.write_text((CORPUS / f"{name}.xml").read_text())
    assert main([str(path), "--fix"]) == 1
    out, err = capsys.readouterr()
    reasons = [line for line in err.splitlines() if "not written because" in line]
    assert ("--fix does not write this because" in out) == bool(reasons)
    assert bool(reasons) == (name != "spin_hand")


def test_a_rule_that_is_gone_is_named_in_one_line(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("pyproject.toml").write_text('[tool.newton-lint]\nignore = ["fixed"]\n')
    Path("scene.xml").write_text("<mujoco/>")
    assert main(["scene.xml"]) == 0
    out, err = capsys.readouterr()
    assert "nothing found" in out and len(err.splitlines()) == 1
    assert "rule fixed does not exist any more" in err


GROUND = '<geom name="floor" type="plane" size="2 2 .1"/>'


def test_pairs_that_are_given_twice_are_no_traceback(tmp_path):
    pair = '<pair geom1="floor" geom2="box"/>'
    box = '<body pos="0 0 .1"><freejoint/><geom name="box" type="box" size=".1 .1 .1"/></body>'
    ball = '<body pos="1 0 .1"><freejoint/><geom size=".1"/></body>'
    text = f"<mujoco><worldbody>{GROUND}{box}{ball}</worldbody><contact>{pair}{pair}</contact></mujoco>"
    (tmp_path / "scene.xml").write_text(text)
    assert main([str(tmp_path / "scene.xml")]) == 0
