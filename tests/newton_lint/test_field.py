"""Scenes from public questions: the finding, its number and the advice for each."""

import mujoco
import numpy as np
import pytest

from newton_lint.command import main

BOX = '<geom name="floor" type="plane" size="2 2 .1"/>'
LINK = '<body pos="0 0 {z}"><joint name="j" {joint}/><geom name="link" type="capsule" {geom}/></body>'
SERVO = "</worldbody><actuator><position joint='j' {}/></actuator><keyframe><key {}/></keyframe><worldbody>"
KNEE = LINK.format(
    z=0.6,
    joint='axis="0 1 0" damping=".05"',
    geom='size=".02" fromto="0 0 0 .2 0 0" mass=".4"',
)
SCENES = {  # bodies, options, expected parts of the message, parts that must be absent
    "a servo too stiff for the step": (
        KNEE + SERVO.format('kp="4000"', 'qpos="0"'),
        'timestep=".005" integrator="implicitfast"',
        (
            "error unstable",
            'kv="20"` on actuator_0 prevents it',
            "servo actuator_0 has a kp·h²/m of 17.4, and only values below 4 are",
        ),
        "timestep=",
    ),
    "an arm that sags": (
        LINK.format(
            z=1,
            joint='axis="0 1 0" damping="5"',
            geom='size=".02" fromto="0 0 0 .4 0 0" mass="3"',
        )
        + SERVO.format('kp="40"', 'qpos="0"'),
        "",
        (
            "warning servo: actuator_0 is 8.",
            '`gravcomp="1"` on body_1 reduces it to',
            "(measured, 2 s)",
        ),
        "unstable",
    ),
    "a joint driven past its limit": (
        LINK.format(
            z=1,
            joint='axis="0 1 0" range="0 90" damping=".1" armature=".001"',
            geom='size=".008 .02"',
        )
        + SERVO.format('kp="100" ctrlrange="-1 12.2"', 'qpos="1.5" ctrl="12"'),
        "",
        (
            "note limit: j is",
            "pulls it to a target of 12",
            '`ctrlrange="0 1.571"` on actuator',
            "error degrees",
        ),
        "servo",
    ),
    "a rope that gives": (
        '<site name="a" pos="0 0 1"/><body pos="0 0 .5"><joint type="slide" axis="0 0 1"/><geom size=".05" mass="5"/>'
        '<site name="b"/></body></worldbody><tendon><spatial name="rope" limited="true" range="0 .5" '
        'solreflimit=".1 1"><site site="a"/><site site="b"/></spatial><spatial name="other"><site site="a"/>'
        '<site site="b"/></spatial></tendon><actuator><motor tendon="other"/></actuator><worldbody>',
        "",
        (
            "warning limit: rope is 4.",
            'solreflimit="0.005 1"` on tendon rope reduces it to 0.0',
        ),
        "error",
    ),
    "a mimic joint that stays open": (
        LINK.format(
            z=1, joint='type="slide" axis="1 0 0"', geom='size=".01 .02" mass=".02"'
        )
        + '<body><joint name="k" type="slide" axis="-1 0 0" damping="50"/><geom size=".01" mass=".02"/></body>'
        '</worldbody><equality><joint name="mirror" joint1="k" joint2="j"'
        ' solref=".05 1" solimp=".5 .6 .001"/></equality><worldbody>'
        + SERVO.format('kp="1000" kv="10"', 'qpos="0 0" ctrl=".03"'),
        'gravity="-3 0 0"',
        (
            "warning equality: mirror is",
            'solref="0.004 1"` on equality mirror reduces it to 0.0',
        ),
        "error",
    ),
    "a keyframe without ctrl": (
        KNEE + SERVO.format('kp="300" kv="10"', 'name="home" qpos="-.8"'),
        'integrator="implicitfast"',
        (
            "warning keyframe: keyframe home sets the scene in motion",
            '`ctrl="-0.8"` on key home reduces it to 0.0',
        ),
        "unstable",
    ),
    "a tool through a plate": (
        '<geom name="plate" type="box" size=".2 .2 .002" pos="0 0 .2"/>'
        + LINK.format(
            z=0.5,
            joint='type="slide" axis="0 0 1" damping="30"',
            geom='size=".01 .03" mass="1"',
        )
        + SERVO.format('kp="6000" kv="100"', 'qpos="-.2" ctrl="-.4"'),
        'timestep=".004"',
        (
            "error tunnel: body_1/link passes through plate",
            "only 4 mm thick",
            "stops it (measured, 2 s)",
        ),
        "unstable",
    ),
    "a bullet through a disc": (
        '<geom name="disc" type="cylinder" size=".2 .002" pos="0 0 .2"/><geom size=".01" pos="9 0 0"/>'
        '<body pos="0 0 3"><freejoint/><geom name="ball" size=".01"/></body>',
        'timestep=".004"',
        (
            "error tunnel: body_1/ball passes through disc, which is only 4 mm",
            "stops it (m",
        ),
        "unstable",
    ),
    "a bullet through a mesh": (
        '<geom name="slab" type="mesh" mesh="m" pos="0 0 .2"/><geom size=".01" pos="9 0 0"/>'
        '<body pos="0 0 3"><freejoint/><geom name="ball" size=".01"/></body></worldbody><asset><mesh name="m" '
        'scale=".2 .2 .002" vertex="-1 -1 -1 -1 -1 1 -1 1 -1 -1 1 1 1 -1 -1 1 -1 1 1 1 -1 1 1 1"/></asset><worldbody>',
        'timestep=".004"',
        (
            "error tunnel: body_1/ball passes through slab, which is only 4 mm thick",
            "Use a thicker plate",
        ),
        "unstable",
    ),
    "a wheel that is soft on its own side": (
        BOX
        + '<body pos="0 0 .2"><freejoint/><geom name="wheel" size=".1" solref=".1 1"/></body>',
        "",
        (
            "warning depth: body_1/wheel sinks 1.77 mm",
            'solref="0.032 1"` on body_1/wheel reduces it to 0.344 mm',
        ),
        "error",
    ),
    "masks that leave no pairs": (
        (BOX + '<body name="ball" pos="0 0 1"><freejoint/><geom size=".1"/></body>')
        .replace("geom n", 'geom contype="0" n')
        .replace("geom s", 'geom contype="0" conaffinity="0" s')
        .replace('"plane"', '"plane" conaffinity="0"'),
        "",
        (
            "warning lost: ball falls through every other body",
            'contype="1" conaffinity="1"` on floor lets it collide',
        ),
        "error",
    ),
    "more cells than contacts": (
        '<geom name="terrain" type="hfield" hfield="g"/><body pos="0 0 .031"><freejoint/>'
        '<geom name="sole" type="box" size=".12 .06 .03" mass="20"/></body></worldbody>'
        '<asset><hfield name="g" nrow="400" ncol="400" size="1 1 .02 .1"/></asset><worldbody>',
        "",
        (
            "warning hfield: body_1/sole sinks through terrain",
            'nrow="21" ncol="21"` on hfield g',
        ),
        "unstable",
    ),
    "as many cells under a body that rests": (
        '<geom name="terrain" type="hfield" hfield="g"/><body pos="0 0 .1"><freejoint/>'
        '<geom name="sole" type="ellipsoid" size=".3 .3 .05" mass=".1"/></body></worldbody>'
        '<asset><hfield name="g" nrow="100" ncol="100" size="1 1 .02 .1"/></asset><worldbody>',
        "",
        ("nothing found",),
        "hfield",
    ),
    "two crates that one change holds": (
        '<geom name="slope" type="plane" size="2 2 .1" euler="0 12 0"/>'
        '<body name="one" pos="0 0 .052"><freejoint/><geom type="box" size=".05 .05 .05" mass="8"/></body>'
        '<body name="two" pos="0 .3 .052"><freejoint/><geom type="box" size=".05 .05 .05" mass="4"/></body>',
        "",
        ("1 warning, 2 notes", "warning slip: one", "note slip: two"),
        "error",
    ),
    "a dampratio that softens": (
        BOX
        + '<body name="box" pos="0 0 .05"><freejoint/>'
        + '<geom type="box" size=".05 .05 .05" solref=".02 10" priority="1"/></body>',
        "",
        ("warning depth: box", "(0.02 10) is too soft", 'solref="0.004 1"'),
        "lighter",
    ),
    "a jerk past a limit": (
        '<body name="target" mocap="true" pos=".5 0 1"/><body name="hand" pos="0 0 1">'
        '<joint name="j" type="slide" axis="1 0 0" range="0 .1"/><geom size=".05"/></body></worldbody>'
        '<equality><weld body1="target" body2="hand" relpose="0 0 0 1 0 0 0"/></equality><worldbody>',
        "",
        ("1 warning", "warning apart", "note limit: j is 200 mm"),
        "error",
    ),
    "a load that swings on its rope": (
        '<site name="a" pos="0 0 2"/><body pos=".5 0 1.9"><joint type="slide" axis="1 0 0"/>'
        '<joint type="slide" axis="0 0 1"/><geom size=".05" mass="5"/><site name="b"/></body></worldbody>'
        '<tendon><spatial name="rope" limited="true" range="0 .5" solreflimit=".1 1">'
        '<site site="a"/><site site="b"/></spatial></tendon><worldbody>',
        "",
        ("limit: rope is", "beyond its range after 2 s"),
        "at rest",
    ),
}


@pytest.mark.parametrize("scene", SCENES)
def test_what_people_ask_is_named_with_what_mends_it(scene, tmp_path, capsys):
    bodies, option, texts, absent = SCENES[scene]
    path = tmp_path / "scene.xml"
    path.write_text(
        f"<mujoco><option {option}/><worldbody>{bodies}</worldbody></mujoco>"
    )
    main([str(path), "--notes"])
    out = capsys.readouterr().out
    assert all(text in out for text in texts) and absent not in out, out


WELD = """<mujoco><worldbody><body name="a" pos="0 0 1"><geom size=".03"/></body>
<body name="ring" pos="0 0 .9"><freejoint/><geom size=".03" mass=".05"/></body>
<body name="weight" pos="0 0 .7"><freejoint/><geom size=".08" mass="50"/></body></worldbody>
<equality><weld name="top" body1="a" body2="ring"/><weld body1="ring" body2="weight"/></equality></mujoco>"""


def test_what_swings_is_read_where_it_comes_to_rest(tmp_path, capsys):
    """Test an upper weld that is 83 mm open after 0.2 s and 196 mm after 12 s.

    A weld that follows a mocap body is not reported.
    """
    model = mujoco.MjModel.from_xml_string(WELD)
    data = mujoco.MjData(model)
    for _ in range(6000):
        mujoco.mj_step(model, data)
    (tmp_path / "weld.xml").write_text(WELD)
    main([str(tmp_path / "weld.xml")])
    out = capsys.readouterr().out
    gap = float(out.partition("top is ")[2].split()[0])
    assert (
        gap == pytest.approx(1e3 * float(np.linalg.norm(data.efc_pos[:3])), rel=0.02)
        and "open after 2 s" in out
    )
    body = '<body name="hand"><freejoint/><geom size=".03"/></body>'
    mocap = f'<worldbody><body name="m" mocap="true" pos="0 0 .5"/>{body}</worldbody>'
    weld = '<equality><weld body1="m" body2="hand" relpose="0 0 0 1 0 0 0" solref=".2 1"/></equality>'
    (tmp_path / "mocap.xml").write_text(
        f'<mujoco><option gravity="0 0 0"/>{mocap}{weld}</mujoco>'
    )
    assert (
        main([str(tmp_path / "mocap.xml")]) == 0
        and "equality" not in capsys.readouterr().out
    )


BLOCK = """<mujoco><worldbody><geom name="board" type="box" size=".08 .05 .005"/><body pos="0 0 .026"><freejoint/>
<geom name="block" type="box" size=".02 .02 .02" mass=".05" friction="10 .005 .0001"/></body>
<geom type="plane" size="1 1 1" pos="0 0 -9"/></worldbody></mujoco>"""


def test_what_no_longer_falls_through_is_mended(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    path.write_text(BLOCK)
    main([str(path), "--fix"])
    assert 'cone="elliptic"' in path.read_text(), capsys.readouterr().err


OPTIONS = [
    (["--version"], 0, "newton-lint "),
    (["--explain", "limit"], 0, "limit (warning): A joint or tendon"),
    (["--explain", "limits"], 2, "limits: expected FILE.xml"),
    (["{}", "--ignore", "limits"], 2, "cannot ignore unknown rule limits"),
]


@pytest.mark.parametrize(("arguments", "status", "text"), OPTIONS)
def test_rules_are_explained_and_unknown_ones_refused(
    arguments, status, text, tmp_path, capsys
):
    (tmp_path / "scene.xml").write_text("<mujoco/>")
    try:
        result = main(
            [argument.format(tmp_path / "scene.xml") for argument in arguments]
        )
    except SystemExit as end:
        result = end.code
    assert result == status and text in "".join(capsys.readouterr())


@pytest.mark.parametrize(
    "geoms",
    [
        '<geom name="a" size="1"/><geom name="b" size="1" pos="0 0 1.5"/><body pos="0 0 9"><freejoint/>'
        '<geom size="1"/></body>'
        '</worldbody><contact><pair geom1="a" geom2="b"/></contact><worldbody>',
        '<body><freejoint/><geom size=".1" solref="1e200 1"/></body>' + BOX,
        '<body><freejoint/><geom size=".1" friction="1e180"/></body>' + BOX,
    ],
)
def test_what_mujoco_stops_at_and_numbers_without_squares_are_one_line(
    geoms, tmp_path, capsys
):
    path = tmp_path / "scene.xml"
    path.write_text(f"<mujoco><worldbody>{geoms}</worldbody></mujoco>")
    assert main([str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and len(err.splitlines()) == 1, err


def test_a_timeconst_without_refsafe_is_as_stiff_as_it_says(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    box = (
        f'{BOX}<body pos="0 0 .1"><freejoint/><geom type="box" size=".1 .1 .1"/></body>'
    )
    text = '<mujoco><option><flag refsafe="disable"/></option><default><geom solref="{} 1"/></default><worldbody>'
    for timeconst, status in (("0.0005", 1), ("0.003", 0)):
        path.write_text(f"{text.format(timeconst)}{box}</worldbody></mujoco>")
        assert main([str(path), "--load", "1"]) == status
        assert ("error stiff" in (out := capsys.readouterr().out)) == bool(status)
        assert not status or ('solref="0.004 1"' in out and "predicted" not in out)


FINGER = """<body name="{name}" pos="{x} 0 -.5" gravcomp="1"><joint name="{name}" type="slide" axis="{axis} 0 0" range="0 .05"/>
<geom type="box" size=".01 .02 .02" mass=".1"/></body>"""
SHAKEN = """<mujoco><option cone="elliptic"/><worldbody>
<body name="arm" pos="0 0 1"><joint type="hinge" axis="0 1 0" stiffness="200"/>
<geom type="capsule" size=".02" fromto="0 0 0 0 0 -.4" mass="1" contype="0" conaffinity="0"/>{fingers}</body>
<body name="cube" pos="{x} 0 {z}"><freejoint/><geom type="box" size=".05 .03 .03" mass=".2"/></body></worldbody>
<contact><exclude body1="left" body2="right"/></contact>
<actuator><position joint="left" kp="2000" kv="50"/><position joint="right" kp="2000" kv="50"/></actuator>
<keyframe><key qpos="{angle} .01 .01 {x} 0 {z} {w} 0 {y} 0" ctrl=".03 .03"/></keyframe></mujoco>"""


@pytest.mark.parametrize(("angle", "falls"), [(0.1, False), (0.2, True)])
def test_creep_in_a_shaken_grip_is_reported_even_if_no_change_helps(
    angle, falls, tmp_path, capsys
):
    """Test an arm on a spring, which shakes a cube with 3 % to 14 % of the friction."""
    fingers = FINGER.format(name="left", x=-0.07, axis=1)
    fingers += FINGER.format(name="right", x=0.07, axis=-1)
    text = SHAKEN.format(
        fingers=fingers,
        angle=angle,
        x=-0.5 * np.sin(angle),
        z=1.0 - 0.5 * np.cos(angle),
        w=np.cos(angle / 2.0),
        y=np.sin(angle / 2.0),
    )
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    for _ in range(1000):
        mujoco.mj_step(model, data)
    arm, cube = model.body("arm").id, model.body("cube").id
    distance_m = np.linalg.norm(data.xpos[cube] - data.xpos[arm])
    assert distance_m > 0.504 and (distance_m > 0.6) == falls
    (tmp_path / "shaken.xml").write_text(text)
    assert main([str(tmp_path / "shaken.xml")]) == 1
    [line] = [
        line for line in capsys.readouterr().out.splitlines() if " slip: " in line
    ]
    assert "warning slip: cube creeps at " in line and "because" not in line
    assert line.endswith("None of the tried changes helps.")
