"""Tests of ``--fix``: it damages no file and writes no harmful change."""

import os

import mujoco
import pytest

from newton_lint.command import main

BODY = '<body name="b" pos="0 0 0.1"><freejoint/><geom name="g" size="0.1" mass="1" solref="0.001 1"/></body>'
SCENE = '<mujoco>\n<include file="common.xml"/><worldbody><geom type="plane" size="1 1 1"/>{}</worldbody></mujoco>'
COMMON = '<mujoco>\r\n<!-- <geom solref="9 9"/> --><default><geom solref="1e-7 1"/></default></mujoco>'
LEGS = """
<mujoco>
  <option timestep=".004" impratio="100" iterations="1" ls_iterations="4"><flag eulerdamp="disable"/></option>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 .1"/>
    <body name="trunk" pos="0 0 .3"><freejoint/>
      <geom name="trunk" type="box" size=".2 .1 .05" mass="6"/>
      <geom name="fl" size=".02" pos=".18 .12 -.28" mass=".1"/>
      <geom name="fr" size=".02" pos=".18 -.12 -.28" mass=".1"/>
      <geom name="rl" size=".02" pos="-.18 .12 -.28" mass=".1"/>
      <geom name="rr" size=".02" pos="-.18 -.12 -.28" mass=".1"/>
    </body>
  </worldbody>
</mujoco>
"""
STIFF = """
<mujoco>
  <option timestep="0.01"/><default><geom solref="{solref}"/></default>
  <worldbody><geom type="plane" size="1 1 1"/>
    <body name="part" pos="0 0 0.03"><freejoint/><geom type="box" size="0.04 0.03 0.03" mass="0.2"/></body></worldbody>
</mujoco>
"""


@pytest.fixture
def scenes(tmp_path):
    """Return a folder with two scenes that include the same file."""
    (tmp_path / "common.xml").write_bytes(COMMON.encode())
    for name, body in (
        ("one.xml", BODY),
        ("two.xml", BODY.replace('0.001 1"', '0.0008 1" priority="1"')),
    ):
        (tmp_path / name).write_text(SCENE.format(body))
    return tmp_path


def test_scenes_that_share_a_file_or_are_named_twice_are_written_whole(scenes, capsys):
    targets = [str(scenes / name) for name in ("one.xml", "two.xml", "one.xml")]
    (scenes / "common.xml.orig").symlink_to("nowhere")
    assert main([*targets, "--fix"]) == 1
    assert (scenes / "common.xml").read_bytes() == COMMON.replace(
        "1e-7 1", "0.004 1"
    ).encode()
    assert (scenes / "common.xml.orig2").read_bytes() == COMMON.encode() and not (
        scenes / "nowhere"
    ).exists()
    held = {path: path.read_bytes() for path in scenes.iterdir() if path.exists()}
    assert main([*targets, "--fix"]) == 0
    assert {
        path: path.read_bytes() for path in scenes.iterdir() if path.exists()
    } == held


def test_a_dry_run_prints_the_patch_and_writes_nothing(scenes, capsys):
    assert main([str(scenes / "one.xml"), "--dry-run"]) == 1
    err = capsys.readouterr().err
    assert (
        '+<!-- <geom solref="9 9"/> --><default><geom solref="0.004 1"/></default></mujoco>'
        in err
    )
    assert not list(scenes.glob("*.orig"))


def test_links_and_modes_are_kept_and_what_is_read_only_is_said(scenes, capsys):
    (scenes / "link.xml").symlink_to("one.xml")
    (scenes / "one.xml").chmod(0o640)
    assert main([str(scenes / "link.xml"), "--fix"]) == 1
    assert (scenes / "link.xml").is_symlink() and (
        scenes / "one.xml"
    ).stat().st_mode & 0o777 == 0o640
    (scenes / "two.xml").chmod(0o444)
    assert (
        main([str(scenes / "two.xml"), "--fix"]) == 2
        and "is read-only" in capsys.readouterr().err
    )


def test_an_elliptic_cone_gets_the_iterations_that_it_needs(tmp_path, capsys):
    """With one iteration, the elliptic cone throws the robot off at 6 m/s."""
    path = tmp_path / "legs.xml"
    path.write_text(LEGS)
    assert main([str(path), "--fix"]) == 1
    assert (
        'iterations="10"' in path.read_text() and 'cone="elliptic"' in path.read_text()
    )
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for _ in range(500):
        mujoco.mj_step(model, data)
    assert abs(data.qvel).max() < 1e-3


@pytest.mark.parametrize(("solref", "status"), [("-2500 -100", 0), ("-40000 -400", 1)])
def test_a_direct_solref_that_is_too_stiff_for_the_step_is_an_error(
    solref, status, tmp_path, capsys
):
    path = tmp_path / "stiff.xml"
    path.write_text(STIFF.format(solref=solref))
    assert main([str(path), "--fix"]) == status
    out = capsys.readouterr().out
    assert ("error stiff" in out) == bool(status) and "-" not in out.partition(
        "predicted creep"
    )[2].split("mm/s")[0]
    assert main([str(path)]) == 0


def test_a_default_of_many_is_changed_once_and_by_no_tiny_time_step(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    more = '<body pos="1 0 0.05"><freejoint/><geom size="0.05"/></body></worldbody>'
    path.write_text(STIFF.format(solref="1e-7 1").replace("</worldbody>", more))
    assert main([str(path), "--dry-run"]) == 1
    out, err = capsys.readouterr()
    [line] = [line for line in err.splitlines() if line.endswith(": can be written")]
    assert line.count('solref="0.02 1"') == 1 and "timestep=" not in out


def test_what_moves_in_too_many_ways_is_said(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("newton_lint.report.MOST_DOFS", 5)
    (tmp_path / "many.xml").write_text(STIFF.format(solref="0.02 1"))
    assert (
        main([str(tmp_path / "many.xml"), "--notes"]) == 0
        and "note unstepped" in capsys.readouterr().out
    )


def test_bad_input_is_one_line(scenes, tmp_path, monkeypatch, capsys):
    (tmp_path / "folder.xml").mkdir()
    os.mkfifo(tmp_path / "pipe.xml")
    (tmp_path / "dangling.xml").symlink_to("nowhere.xml")
    (tmp_path / "ends.py").write_text("def model():\n    raise SystemExit(0)\n")
    (tmp_path / "huge.xml").write_text(
        SCENE.format("").replace("<mujoco>", '<mujoco><option timestep="1e308"/>')
    )
    (tmp_path / "\udcff.xml").write_text("<mujoco/>")
    for name in (
        "huge.xml",
        "\udcff.xml",
        "folder.xml",
        "pipe.xml",
        "dangling.xml",
        "ends.py:model",
        "a\nb.xml",
    ):
        assert main([str(tmp_path / name), "--json"]) == 2
        out, err = capsys.readouterr()
        assert out == "[]\n" and len(err.splitlines()) == 1
    (tmp_path / "fragment.xml").write_text("<mujocoinclude/>")
    assert main([str(tmp_path), "--exclude", "*.xml"]) == 2
    (tmp_path / "pyproject.toml").write_text("[tool")
    monkeypatch.chdir(tmp_path)
    capsys.readouterr()
    assert (
        main([str(scenes / "one.xml")]) == 2
        and len(capsys.readouterr().err.splitlines()) == 1
    )


GEOM = '<geom size="0.01" pos="{} 0 1"{}/>'
PLANE = '<geom type="plane" size="1 1 1"/>'


def test_of_too_many_geoms_one_that_differs_is_read(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("newton_lint.pairs.MOST_PAIRS", 5000)
    odd = ' solref="0.02 -3"'
    geoms = "".join(GEOM.format(index, odd * (index == 101)) for index in range(200))
    text = f"<mujoco><worldbody>{PLANE}{geoms}<body><freejoint/>{geoms}</body></worldbody></mujoco>"
    (tmp_path / "many.xml").write_text(text)
    assert main([str(tmp_path / "many.xml"), "--no-step", "--notes"]) == 1
    out = capsys.readouterr().out
    assert "error solref-format: each of geom_102 and body_1/geom_302 has" in out
    assert "note unread: Only 84 of the shapes" in out


def test_many_alike_bodies_have_one_warning_with_one_change(tmp_path, capsys):
    bodies = "".join(
        f'<body pos="{index} 0 .1"><freejoint/><geom size=".1" solref="0.001 1"'
        f' priority="1"/></body>'
        for index in range(1500)
    )
    text = f"<mujoco><worldbody>{PLANE}{bodies}</worldbody></mujoco>"
    path = tmp_path / "many.xml"
    path.write_text(text.replace('"0.001 1"', '"0.02 -3"', 1))
    assert main([str(path), "--no-step"]) == 1
    lines = capsys.readouterr().out.splitlines()
    assert "1125750 pairs" in lines[0] and len(lines) == 3
    assert "error solref-format: body_1/geom_1 has" in lines[1]
    assert "warning timeconst: each of body_2/geom_2, " in lines[2]
    assert 'solref="0.004 1"` on body_2/geom_2, body_3/geom_3, ' in lines[2]
    assert "and 1496 more only states the" in lines[2]
