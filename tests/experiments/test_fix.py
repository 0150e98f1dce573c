"""The fix as it is offered: the very files, run in a process of their own, and against the scene of this report."""

import ast
import html
import json
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from textwrap import indent

import mujoco
import newton
import numpy as np
import pandas as pd
import pytest
import warp as wp
from conftest import needs_boxes_in_c

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, FIXED, STIFF_PADS
from experiments.facts.fix_files import fix_files, without_patch
from experiments.facts.trace import Trace
from experiments.simulation.measurement import SETUP_FRAME_COUNT
from experiments.simulation.simulation import Simulation, run, simulate
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT

OPTIONS = "--viewer null --test --quiet --backend mujoco --json summary.json".split()
FRAME_COUNT = 420
CASES = {
    "fixed_scene.py": replace(STIFF_PADS, backend="mujoco", state_sync=True, frame_count=FRAME_COUNT),
    "scene_as_shipped.py": replace(AS_SHIPPED, backend="mujoco", state_sync=True, frame_count=FRAME_COUNT),
}
"""What each script must repeat. As shipped it slips enough to fail its test in half the frames."""
RUN = (
    "import runpy, sys, warp; warp.config.enable_backward = False; runpy.run_path(sys.argv.pop(1), run_name='__main__')"
)
"""Runs a script with the kernels of all other tests, which would be compiled once more with those of gradients."""


@pytest.fixture(scope="module")
def runs(tmp_path_factory, kernels) -> dict[str, tuple[subprocess.CompletedProcess, dict, Trace]]:
    """Both scripts through MuJoCo's C engine, each alone in a folder, and beside them what they must repeat."""

    def run(name: str) -> tuple[subprocess.CompletedProcess, dict]:
        return run_script(fix_files()[name], tmp_path_factory.mktemp("fix"))

    traces = simulate(list(CASES.values()))
    return {name: (*run(name), trace) for name, trace in zip(CASES, traces, strict=True)}


def run_script(text: str, folder: Path) -> tuple[subprocess.CompletedProcess, dict]:
    """How a scene ends that is run alone in a folder, and the summary that it writes."""
    (folder / "scene.py").write_text(text, encoding="utf-8")
    command = [sys.executable, "-c", RUN, "scene.py", *OPTIONS, "--num-frames", str(FRAME_COUNT)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done, json.loads((folder / "summary.json").read_text())


@pytest.mark.slow
@needs_boxes_in_c
def test_the_fixed_scene_passes_its_own_test_and_the_shipped_one_fails(runs):
    fixed, shipped = runs["fixed_scene.py"][0], runs["scene_as_shipped.py"][0]
    assert fixed.returncode == 0, fixed.stderr
    assert shipped.returncode == 1
    assert "the cube slipped" in shipped.stderr.splitlines()[-1]


@pytest.mark.slow
@needs_boxes_in_c
@pytest.mark.parametrize("name", CASES)
def test_a_script_is_the_scene_of_this_report(runs, name):
    _, summary, trace = runs[name]
    moved = metrics.displacement(trace)
    assert summary["slip_mm"] == pytest.approx(metrics.slip_mm(moved), abs=0.02)
    assert summary["drift_mm_s"] == pytest.approx(metrics.drift_mm_s(moved), abs=0.002)
    assert summary["dropped"] is metrics.is_dropped(trace) is False
    assert summary["cube_height_m"] == pytest.approx(metrics.cube_height_m(trace), abs=1e-4)


@pytest.mark.parametrize("tool", [["patch", "-p1", "--input=fix.patch"], ["git", "apply", "fix.patch"]])
def test_the_patch_makes_the_shipped_scene_the_fixed_one(tool, tmp_path):
    for name, text in fix_files().items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    try:
        subprocess.run(tool, cwd=tmp_path, check=True, capture_output=True)
    except FileNotFoundError:
        pytest.skip(f"there is no {tool[0]} here")
    assert (tmp_path / "scene_as_shipped.py").read_text() == fix_files()["fixed_scene.py"]


def test_the_patch_changes_the_pads_material_and_nothing_else_and_must_fit():
    lines = fix_files()["fix.patch"].splitlines()[2:]
    changed = [line[1:].strip() for line in lines if line[0] in "+-"]
    assert [line for line in changed if not line.startswith("#")] == [
        f"robot.shape_material_ke[pad] = {STIFF_PADS.pad_ke:.1e}".replace("e+0", "e"),
        f"robot.shape_material_kd[pad] = {STIFF_PADS.pad_kd:.1e}".replace("e+0", "e"),
    ]
    files = fix_files()
    with pytest.raises(ReportError, match="does not lead to"):
        without_patch(files["scene_as_shipped.py"], files["fix.patch"])


def test_the_script_needs_newton_alone_and_holds_the_robot_of_this_report():
    tree = ast.parse(fix_files()["fixed_scene.py"])
    imported = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    imported |= {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    outside = {name.partition(".")[0] for name in imported} - sys.stdlib_module_names
    assert outside == {"newton", "numpy", "warp"}
    strings = [ast.literal_eval(node.value) for node in tree.body if ast.unparse(node).startswith("URDF = ")]
    assert strings == [(ROOT / AS_SHIPPED.asset).read_text(encoding="utf-8")]


CODE = re.compile(r"<pre[^>]*><code[^>]*>(.*?)</code></pre>", re.DOTALL)
BEFORE = "    return robot\n"
"""Where the robot of the scene is whole."""


def block_with(page: Path, word: str) -> str:
    """The first lines to paste that have a word in them, as a page has them."""
    blocks = (html.unescape(re.sub("<[^>]+>", "", code)) for code in CODE.findall(page.read_text(encoding="utf-8")))
    return next(block for block in blocks if word in block)


def fix_block(page: Path) -> str:
    return block_with(page, "shape_material_ke")


@pytest.mark.slow
@needs_boxes_in_c
def test_the_lines_of_the_front_page_hold_the_cube_as_it_says(site, tmp_path):
    scene = (site / "download/scene_as_shipped.py").read_text(encoding="utf-8")
    block = fix_block(site / "index.html")
    assert scene.count(BEFORE) == 1
    pasted = scene.replace(BEFORE, f"    builder = robot\n{indent(block, '    ')}{BEFORE}")
    done, summary = run_script(pasted, tmp_path)
    assert done.returncode == 0, done.stderr
    assert_as_said(site, summary["slip_mm"])


def assert_as_said(site: Path, slip_mm: float) -> None:
    """The run with stiff pads whose slip the page says had come as far by then."""
    noise = json.loads((site / "data/values.json").read_text(encoding="utf-8"))["noise"]["slip_floor"]["value"]
    moved = pd.read_csv(site / "data/newton-1.4.0/reproduction.stiff-pads.csv.gz")
    then = moved.loc[FRAME_COUNT - SETUP_FRAME_COUNT - 1, ["x_mm", "y_mm", "z_mm"]]
    assert slip_mm == pytest.approx(np.linalg.norm(then), abs=noise)


def test_every_release_has_the_same_lines_to_paste(site):
    pages = [*site.glob("**/index.html"), site / "fix.html"]
    assert len({fix_block(page) for page in pages}) == 1


class InMjcf(Simulation):
    """The scene through MuJoCo's C engine, its pads as lines of MJCF have them."""

    lines = ""

    def _build_solver(self):
        solver = super()._build_solver()
        geoms = self.lines.replace("<geom", '<geom type="box" size="0.01 0.01 0.01"')
        pads = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{geoms}</worldbody></mujoco>")
        assert [pads.geom(name).priority[0] for name in ("left_pad", "right_pad")] == [1, 1]
        model = solver.mj_model
        fingers = [geom for geom in range(model.ngeom) if "finger" in model.body(model.geom_bodyid[geom]).name]
        assert model.geom_solref[fingers] == pytest.approx(np.tile([0.02, 1.0], (8, 1)))
        model.geom_solref[fingers] = pads.geom_solref[0]
        return solver


@pytest.mark.slow
@needs_boxes_in_c
def test_the_lines_of_mjcf_hold_the_cube_as_the_other_block_does(site, monkeypatch):
    monkeypatch.setattr(InMjcf, "lines", block_with(site / "index.html", "left_pad"))
    [[trace]] = run([InMjcf([CASES["scene_as_shipped.py"]], wp.get_device("cpu"))])
    assert_as_said(site, metrics.slip_mm(metrics.displacement(trace)))


class Pasted(Simulation):
    """The scene with the solver that a block makes, beside the scene's own options."""

    block = ""

    def _build_solver(self):
        options = "nconmax=64, njmax=96, use_mujoco_contacts=False, iterations=15, ls_iterations=100, cone='elliptic'"
        assert self.block.count("model, ...,") == 1
        names = {"newton": newton, "model": self.model}
        exec(self.block.replace("...,", f"{options}, update_data_interval=0,"), names)
        names["solver"].reset(self.state)
        return names["solver"]


@pytest.mark.slow
def test_the_block_of_the_cure_does_what_was_measured(site, monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "assets/fix")
    monkeypatch.setattr(Pasted, "block", block_with(site / "cure.html", "compensated_positions"))
    case = replace(FIXED, frame_count=330)
    cured = replace(case, impratio=400.0, compensated=True, contact_bias=True, bias_centred=True)
    [[pasted]] = run([Pasted([case], wp.get_device("cpu"))])
    [own] = simulate([cured], device="cpu")
    moved = [1e3 * metrics.displacement(trace).vector_m[-1] for trace in (pasted, own)]
    assert moved[0] == pytest.approx(moved[1], abs=1e-4)
    assert abs(moved[0]).max() < 0.1
