"""Tests of ``--hold``, prescribe and page on a pinch and an incline."""

import json
import re
from pathlib import Path

import pytest

from newton_lint.command import main
from newton_lint.findings import Change
from newton_lint.fix import Unwritable, edited
from newton_lint.source import Source, parse
from tests.newton_lint.cases import Case


@pytest.fixture
def written(tmp_path):
    def write(kind: str, **changes) -> str:
        path = tmp_path / f"{kind}.xml"
        path.write_text(Case(kind, tuple(changes.items())).text)
        return str(path)

    return write


def test_a_hold_is_said_and_is_a_finding_above_its_bound(written, capsys):
    pinch = written("pinch")
    assert main([pinch, "--hold", "held", "--json"]) == 1  # from 1 mm/s on
    hold = json.loads(capsys.readouterr().out)["hold"]
    assert (
        hold["load_n"] == pytest.approx(0.5 * 9.81, rel=1e-3)
        and hold["point_count"] == 8
    )
    assert hold["mm_s"] == pytest.approx(3.68, rel=0.01) and not hold["slides"]
    assert main([pinch, "--hold", "held", "--below", "5"]) == 0
    assert main([pinch, "--hold", "held", "--below", "1"]) == 1
    assert (
        "held creeps at 3.68 mm/s under 4.9 N on 8 contact points"
        in capsys.readouterr().out
    )
    assert main([pinch, "--hold", "held", "--lift", "9.81", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["hold"]["mm_s"] == pytest.approx(
        2.0 * hold["mm_s"], rel=1e-3
    )
    assert main([written("incline", slope=1.3), "--hold", "held"]) == 1
    assert "error slides" in capsys.readouterr().out
    assert (
        main([written("pinch", grip=0.5), "--hold", "held", "--settle", "3"]) == 1
    )  # and is far away by then
    assert "slides: held slides because its load" in capsys.readouterr().out
    assert (
        main([pinch, "--hold", "cube"]) == 2
        and "has no body cube" in capsys.readouterr().err
    )


@pytest.mark.parametrize(
    ("kind", "changes"), [("pinch", {}), ("incline", {"cone": "pyramidal", "mu": 1.5})]
)
def test_a_prescription_reaches_its_bound_and_is_written(
    kind, changes, written, capsys
):
    scene = written(kind, **changes)
    assert main(["prescribe", scene, "--hold", "held", "--below", "0.05", "--fix"]) == 0
    out = capsys.readouterr().out
    assert re.search(r"impratio=\"\d+\" on option \(\w+\.xml:3\): written", out)
    assert Path(f"{scene}.orig").read_text() != Path(scene).read_text()
    assert main([scene, "--hold", "held", "--below", "0.05"]) == 0
    assert main(["prescribe", scene, "--hold", "held", "--below", "0.05"]) == 0
    assert "as it is" in capsys.readouterr().out


def test_what_is_asked_for_is_simulated_too(written, capsys):
    """``--impratio`` replaces that of the scene."""
    assert (
        main(["prescribe", written("pinch"), "--hold", "held", "--impratio", "10"]) == 0
    )
    predicted, measured = re.search(
        r"([\d.]+) mm/s +([\d.]+) mm/s.* as it is", capsys.readouterr().out
    ).groups()
    assert float(predicted) == pytest.approx(0.368, rel=0.01) == float(measured)


def test_what_slips_by_its_own_weight_is_a_finding(written, capsys):
    """The creep agrees with the simulation, between fingers and on a slope."""
    for kind, changes in (
        ("pinch", {"grip": 60}),
        ("incline", {"cone": "pyramidal", "solref": "0.05 1"}),
    ):
        assert main([written(kind, **changes), "--json"]) == 1
        [slip] = [
            each
            for each in json.loads(capsys.readouterr().out)["findings"]
            if each["rule"] == "slip"
        ]
        measured = Case(kind, tuple(changes.items())).measured_mm_s()
        assert slip["value"] == pytest.approx(measured, rel=0.1)
        assert slip["changes"][0]["attributes"] == {
            "cone": "elliptic",
            "impratio": "10",
        }
    assert (
        main([written("incline", mu=0.1)])
        == main([written("pinch", impratio=100)])
        == 0
    )


def test_what_nothing_holds_is_said(written, capsys):
    assert main(["prescribe", written("incline", slope=1.3), "--hold", "held"]) == 1
    assert "increase μ or the grip force" in capsys.readouterr().out
    with pytest.raises(SystemExit):
        main(["prescribe", written("pinch")])


def test_an_edit_changes_what_it_has_to(tmp_path):
    path = tmp_path / "scene.xml"
    path.write_bytes(
        b"<mujoco  model='a>b'>\r\n <geom\n  name = \"x solref='9'\" solref = '1 1'/><geom name='y'/></mujoco>"
    )
    root = parse(path)
    changes = [
        Change("x", (("solref", "2 1"),), root.children[0]),
        Change("y", (("priority", "1"),), root.children[1]),
        Change("option", (("cone", "elliptic"),)),
    ]
    assert edited(changes, Source(root, None), {})[path] == (
        b'<mujoco  model=\'a>b\'>\r\n  <option cone="elliptic"/>\r\n <geom\n  name = "x solref=\'9\'" solref = "2 1"/>'
        b"<geom name='y' priority=\"1\"/></mujoco>"
    )
    with pytest.raises(Unwritable):  # its text is elsewhere by now
        edited(changes[:1], Source(root, None), {path: b" " + path.read_bytes()})


def test_a_page_has_every_scene_of_a_folder(written, tmp_path, capsys):
    written("pinch"), written("incline")
    (tmp_path / "bad.xml").write_text("<mujoco><nothing/></mujoco>")
    assert main(["page", str(tmp_path), "-o", str(tmp_path / "page")]) == 0
    text = (tmp_path / "page" / "index.html").read_text(encoding="utf-8")
    assert (
        text.count("<details") == 3
        and "2 scenes, " in text
        and "MuJoCo refuses it" in text
    )
