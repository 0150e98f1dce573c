"""Tests of the command: its targets, its output and its exit status."""

import json
import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import mujoco
import newton
import pytest
import warp as wp

from measured_report.files.config import read_toml
from measured_report.files.root import ROOT
from newton_lint.check import check
from newton_lint.command import main

SCENE = """
<mujoco>
  {rest}
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body name="ball" pos="0 0 0.1"><freejoint/><geom name="skin" size="0.1" mass="2" {skin}/></body>
  </worldbody>
</mujoco>
"""
LOW = 'pos="0 0 -0.006"'  # This is a note: the ball overlaps the floor by 6 mm.
MESH = '<asset><mesh name="rock" file="rock.obj"/></asset><worldbody><geom type="mesh" mesh="rock"/></worldbody>'
SPHERE = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
URDF = f'<robot name="ball"><link name="skin">{SPHERE}</link></robot>'
KINDS = {
    "findings": {
        **{
            "rule": str,
            "shape": str,
            "against": list,
            "parameter": str,
            "value": float,
            "used": float | None,
        },
        **{"unit": str, "message": str},
    },
    "creep": {
        **{
            "acceleration_m_s2": float,
            "load_n": float,
            "pairs": list,
            "timeconst_s": float,
            "dmax": float,
        },
        **{
            "response_s": float,
            "acceleration_response_s": float,
            "load_deep_mm_s": float,
            "load_shallow_mm_s": float,
        },
    },
}


@pytest.fixture
def scene(tmp_path):
    def write(skin: str = "", rest: str = "") -> str:
        path = tmp_path / "scene.xml"
        path.write_text(SCENE.format(skin=skin, rest=rest))
        return str(path)

    return write


def spec() -> mujoco.MjSpec:
    """Return a target of the lint."""
    return mujoco.MjSpec.from_string(SCENE.format(skin="", rest=""))


def env() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Return a target of the lint."""
    model = spec().compile()
    return model, mujoco.MjData(model)


HIGH = wp.transform((0.0, 0.0, 1.1), wp.quat_identity())


def built() -> newton.Model:
    """Return a target of the lint."""
    builder = newton.ModelBuilder()
    builder.add_shape_sphere(builder.add_body(label="ball", xform=HIGH))
    builder.add_ground_plane()
    return builder.finalize(device="cpu")


def test_a_clean_scene(scene, capsys):
    assert main([scene(), "--acceleration", "1"]) == 0
    out = capsys.readouterr().out
    assert ": 2 shapes, 1 pair, dt 0.002 s: nothing found" in out.splitlines()[0]
    assert (
        "timeconst 0.02 s; 8.5 mm/s per m/s²" in out
    )  # 0.95 · 20 ms / 2, minus half a step
    texture = '<asset><texture name="a" type="2d" file="no.png"/><material name="b" texture="a"/></asset>'
    assert (
        main(
            [
                scene(
                    'material="b"', f'{texture}<sensor><touch site="nowhere"/></sensor>'
                )
            ]
        )
        == 0
    )


def test_warnings_end_with_one_and_notes_do_not(scene, capsys):
    short = 'solref="0.001 1" priority="1"'
    assert main([scene(short), "--dt", "0.01"]) == 1
    assert re.findall(r"(warning|note) ([\w-]+):", capsys.readouterr().out) == [
        ("warning", "timeconst")
    ]
    assert (
        main([scene('solref="0.001 0.1" priority="1"'), "--dt", "0.0001"]) == 0
    )  # which bounces, and may be meant to
    target = scene(LOW)
    fail_on = {"note": 1, "warning": 0, "error": 0, "never": 0}
    assert {least: main([target, "--fail-on", least]) for least in fail_on} == fail_on
    assert capsys.readouterr().out.count("nothing found, 1 note") == 4
    target = scene('solref="0.004 1" priority="1"', '<option timestep="0.009"/>')
    assert (
        main([target]),
        main([target, "--dt", "0.002"]),
        main([target, "--fail-on", "never"]),
    ) == (1, 0, 0)
    assert main([target, "--ignore", "timeconst,slip"]) == 0


@pytest.mark.parametrize(
    ("skin", "rest", "said"),
    [
        ("", "<bad/>", "'bad'"),
        ('solreff="0.05 1"', "", "'solreff'"),
        ("", '<contact><pair geom1="floor" geom2="skim"/></contact>', "'skim'"),
        ("", MESH, "rock.obj"),
    ],
)
def test_what_mujoco_refuses_is_refused_with_its_words(skin, rest, said, scene, capsys):
    assert main([scene(skin, rest)]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1) and "MuJoCo refuses" in err and said in err


def test_places_are_those_of_the_files(scene, tmp_path, capsys):
    """Test that findings are located in an included file, in a default, or at the geom
    itself.
    """
    (tmp_path / "pads.xml").write_text(
        '<mujoco>\n<default>\n<geom priority="1"\n solref="0.001 1"/></default></mujoco>'
    )
    target = scene('friction="0.05"', '<include file="pads.xml"/>')
    assert main([target, "--json"]) == 1
    found = {
        each["rule"]: each for each in json.loads(capsys.readouterr().out)["findings"]
    }
    assert (found["timeconst"]["file"], found["timeconst"]["line"]) == (
        str(tmp_path / "pads.xml"),
        3,
    )
    assert found["friction"]["file"] == target
    [change] = found["friction"]["changes"]
    # The default has a priority for all geoms, so it would not help to raise it there.
    assert change["attributes"] == {"priority": "2"} and change["line"] == 6


@pytest.mark.parametrize(
    ("comment", "line", "left"),
    [
        ("<!-- newton-lint: ignore=overlap -->", 0, 0),
        ("<!-- newton-lint: ignore -->", 0, 0),
        ("<!-- newton-lint: ignore=timeconst -->", 0, 1),
        ("<!-- newton-lint: ignore=slip, overlap -->", 4, 0),
        ("<!-- newton-lint: ignore=overlap -->", 2, 1),
    ],
)
def test_comments_ignore_rules(comment, line, left, scene, tmp_path, capsys):
    lines = (
        (tmp_path / "scene.xml" if scene(LOW) else None)
        .read_text()
        .strip()
        .splitlines()
    )
    (tmp_path / "scene.xml").write_text(
        "\n".join([*lines[:line], comment, *lines[line:]])
    )
    main([str(tmp_path / "scene.xml"), "--json"])
    assert len(json.loads(capsys.readouterr().out)["findings"]) == left


def test_a_comment_that_is_added_between_two_calls_counts(scene):
    path = Path(scene(LOW))
    [finding] = check(path, show=False)
    assert finding.rule == "overlap"
    ignoring = "<!-- newton-lint: ignore=overlap -->\n"
    path.write_text(ignoring + path.read_text().strip())
    assert not check(path, show=False)


def test_a_table_of_the_project_counts_below_options(
    scene, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    target = scene(LOW)
    (tmp_path / "pyproject.toml").write_text(
        '[tool.newton-lint]\nfail-on = "note"\nformat = "github"\n'
    )
    assert main([target]) == 1
    assert capsys.readouterr().out.startswith(
        f"::notice file={target},line=6,title=newton-lint overlap::"
    )
    assert main([target, "--fail-on", "error"]) == 0
    (tmp_path / "pyproject.toml").write_text(
        '[tool.newton-lint]\nignore = ["overlap"]\n'
    )
    assert main([target, "--fail-on", "note"]) == 0


def test_folders_and_several_files(scene, tmp_path, capsys):
    target = scene(LOW)
    (tmp_path / "notes.xml").write_text("<other/>")
    (tmp_path / "robot.urdf").write_text(URDF)
    notes = [str(tmp_path), target, "--format", "github", "--notes"]
    assert main(notes) == 0
    assert (
        capsys.readouterr().out.count(
            f"::notice file={target},line=6,title=newton-lint overlap"
        )
        == 2
    )
    assert (
        main([str(tmp_path), "--json"]) == 0
        and len(json.loads(capsys.readouterr().out)) == 2
    )
    assert main([target, "nowhere.xml"]) == 2


def test_the_documented_call_works_in_a_new_process(scene):
    document = (ROOT / "docs" / "lint.md").read_text(encoding="utf-8")
    example = re.search(
        r"(?:^    .*\n|^\n)*?^    from newton_lint.*\n(?:^    .*\n|^\n)+",
        document,
        re.MULTILINE,
    )
    path = scene('solref="0.001 1"')
    lines = [
        "import mujoco",
        f"model = mujoco.MjModel.from_xml_path({path!r})",
        *textwrap.dedent(example[0]).splitlines(),
    ]
    result = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True,
        text=True,
        check=True,
    )
    # check prints the finding, and so does the loop of the example.
    assert result.stdout.count("warning one-sided") == 2
    assert "$" not in result.stdout


def test_installed_by_itself_it_needs_no_checkout(scene, tmp_path):
    """Test that the files of the wheel suffice, without the rest of the project."""
    package = ROOT / "packages/newton-lint"
    project = read_toml(package / "pyproject.toml")
    for name in project["tool"]["hatch"]["build"]["targets"]["wheel"]["packages"]:
        shutil.copytree(package / name, tmp_path / "site" / name)
    module, _, function = project["project"]["scripts"]["newton-lint"].partition(":")
    program = tmp_path / "newton-lint"
    program.write_text(
        f"import sys\nfrom {module} import {function}\nsys.exit({function}())\n"
    )
    environment = os.environ | {"PYTHONPATH": str(tmp_path / "site")}
    call = [sys.executable, program, scene(), "--dt", "soon"]
    refused = subprocess.run(
        call, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert (refused.returncode, refused.stderr.count("\n")) == (
        2,
        1,
    ) and "newton-lint --help" in refused.stderr
    found = subprocess.run(
        call[:3],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (found.returncode, found.stderr) == (
        0,
        "",
    ) and "nothing found" in found.stdout


def test_a_function_and_a_robot_are_targets(tmp_path, capsys):
    (tmp_path / "robot.urdf").write_text(URDF)
    (tmp_path / "beside.py").write_text(f"from {__name__} import built\n")
    (tmp_path / "model.py").write_text(
        "from beside import built\n\ndef mine():\n    return built()\n"
    )
    assert [main([f"{__name__}:{name}"]) for name in ("built", "spec", "env")] == [
        0,
        0,
        0,
    ]
    assert main([f"{tmp_path / 'model.py'}:mine"]) == 0
    assert main([str(tmp_path / "robot.urdf")]) == 0  # one shape alone touches nothing
    assert "creep" not in capsys.readouterr().out.split("robot.urdf")[1]


@pytest.mark.parametrize(
    "arguments",
    "nowhere.xml,scene.txt,no.such.module:function,tests.newton_lint.test_command:nothing,nowhere.py:function,os:getcwd,"
    "broken,good --dt 0,good --dt nan,good --load -1,good --cone round,".split(","),
)
def test_what_cannot_be_linted_is_said_in_one_line(arguments, scene, tmp_path, capsys):
    (tmp_path / "broken.xml").write_text("<mujoco><worldbody>")
    places = {"good": scene(), "broken": str(tmp_path / "broken.xml")}
    try:
        status = main(
            [places.get(argument, argument) for argument in arguments.split()]
        )
    except SystemExit as end:
        status = end.code
    out, err = capsys.readouterr()
    assert (status, out, len(err.strip().splitlines())) == (2, "", 1)


def test_json_and_rules_are_as_documented(scene, capsys):
    target = scene('solref="0.001 1" friction="1 0.2 0.0001"')
    assert main([target, "--json", "--load", "3", "--acceleration", "0.5"]) == 1
    said = json.loads(capsys.readouterr().out)
    assert (said["schema"], said["target"], said["newton"], said["dt_s"]) == (
        2,
        target,
        None,
        0.002,
    )
    assert (said["shape_count"], said["pair_count"]) == (2, 1)
    of_old = [
        "schema",
        "target",
        "newton",
        "dt_s",
        "shape_count",
        "pair_count",
        "findings",
        "creep",
    ]
    assert list(said) == [*of_old, "hold"]
    for name, kinds in KINDS.items():
        assert said[name]
        for entry in said[name]:
            assert list(entry)[: len(kinds)] == list(kinds)
            assert all(isinstance(entry[key], kind) for key, kind in kinds.items())
    documented = (ROOT / "docs" / "lint.md").read_text(encoding="utf-8")
    for name in [*said, *said["findings"][0], *said["creep"][0]]:
        assert f"`{name}`" in documented
    [creep] = said["creep"]
    assert [sorted(pair) for pair in creep["pairs"]] == [["ball/skin", "floor"]]
    # The mean of 1 and 20 ms; the ball weighs 2 kg, and a pyramidal cone with μ 1 doubles R.
    response_s = 0.5 * 0.95 * 0.0105
    assert creep["response_s"] == pytest.approx(response_s)
    assert creep["acceleration_mm_s"] == pytest.approx(1e3 * (response_s - 0.001) * 0.5)
    assert creep["load_deep_mm_s"] == pytest.approx(
        1e3 * response_s * (0.05 / 0.95) * 0.5 * 2.0 * 3.0, rel=1e-4
    )
    assert creep["load_shallow_mm_s"] == pytest.approx(
        1e3 * response_s * (0.1 / 0.9) * 0.5 * 2.0 * 3.0, rel=1e-4
    )
    sources = [
        path.read_text(encoding="utf-8")
        for path in (ROOT / "packages/newton-lint/newton_lint").rglob("*.py")
    ]
    named = re.compile(r'(?i:wording|finding)\(\s*(?:scene,\s*)?"([a-z-]+)"')
    rules = {rule for source in sources for rule in named.findall(source)}
    table = (ROOT / "packages/newton-lint/newton_lint/rules.md").read_text(
        encoding="utf-8"
    )
    assert len(rules) > 20 and all(f"| `{rule}` |" in table for rule in rules), rules


def test_below_sets_the_speed_from_which_creep_is_reported(tmp_path, capsys):
    path = tmp_path / "scene.xml"
    path.write_text(
        '<mujoco><worldbody><geom type="plane" size="2 2 .1" euler="0 5 0"/><body name="box" pos="0 0 .0505">'
        '<freejoint/><geom type="box" size=".05 .05 .05"/></body></worldbody></mujoco>'
    )
    assert main([str(path)]) == 0
    assert main([str(path), "--below", "0.1"]) == 1
    assert "warning slip: box creeps at 0.4" in capsys.readouterr().out
