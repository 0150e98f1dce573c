"""Test the downloads of the fix: the published files run in separate processes and
agree with the scene of this report.
"""

import html
import json
import os
import re
import runpy
import subprocess
import sys
from dataclasses import replace
from multiprocessing import get_context
from pathlib import Path
from textwrap import indent
from types import SimpleNamespace

import mujoco
import newton
import pytest
import warp as wp
from conftest import needs_boxes_in_c, tracked_mm

from experiments.facts import metrics
from experiments.facts.case import FIXED
from experiments.facts.fix_files import fix_files
from experiments.simulation.simulation import Simulation, run, simulate
from experiments.simulation.stepper_c import MuJoCoStepper
from measured_report.files.root import ROOT

OPTIONS = "--viewer null --test --quiet --backend mujoco --json summary.json".split()
FRAME_COUNT, FEW = 360, 272
"""Number of frames that a script must repeat.

With shipped pads the cube has then slipped far enough to fail the test; with stiff pads
one second of shake shows that it creeps a tenth as fast.
"""


def run_script(text: str, folder: Path, frame_count: int = FEW) -> tuple[int, str]:
    """Run a script in a folder of its own in a forked process, which has the engine and
    its kernels. Return its exit status and output. A scene runs in MuJoCo's C engine.
    """
    (folder / "scene.py").write_text(text, encoding="utf-8")
    process = get_context("fork").Process(
        target=_be_the_script, args=(folder, frame_count)
    )
    process.start()
    process.join()
    return process.exitcode, (folder / "said").read_text()


def _be_the_script(folder: Path, frame_count: int) -> None:
    os.chdir(folder)
    sys.argv = ["scene.py", *OPTIONS, "--num-frames", str(frame_count)]
    newton.use_coord_layout_targets = (
        False  # as in a process in which no other scene has run
    )
    sys.stdout = sys.stderr = Path("said").open("w", encoding="utf-8")  # noqa: SIM115 # the output is read after the script
    runpy.run_path("scene.py", run_name="__main__")


def assert_slip_is_tracked(
    folder: Path, case: str, within_mm: float, frame_count: int = FEW
) -> None:
    """Assert that the cube has slipped as far as in the tracked run of this case after
    as many frames.
    """
    summary = json.loads((folder / "summary.json").read_text())
    expected = tracked_mm(ROOT / "results/newton-1.4.0", case, frame_count)
    assert summary["slip_mm"] == pytest.approx(expected, abs=within_mm)
    assert summary["drift_mm_s"] > 0.0 and summary["dropped"] is False
    assert summary["cube_height_m"] == pytest.approx(0.22, abs=0.05)


@pytest.mark.slow
@needs_boxes_in_c
def test_the_scene_as_shipped_is_that_of_this_report_and_fails_its_own_test(tmp_path):
    status, said = run_script(fix_files()["scene_as_shipped.py"], tmp_path, FRAME_COUNT)
    assert status == 1 and "the cube slipped" in said.splitlines()[-1]
    assert_slip_is_tracked(tmp_path, "as-shipped", 0.03, FRAME_COUNT)


def test_the_patch_makes_the_shipped_scene_the_fixed_one(tmp_path):
    for name, text in fix_files().items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    subprocess.run(
        ["git", "apply", "fix.patch"], cwd=tmp_path, check=True, capture_output=True
    )
    assert (tmp_path / "scene_as_shipped.py").read_text() == fix_files()[
        "fixed_scene.py"
    ]


CODE = re.compile(r"<pre[^>]*><code[^>]*>(.*?)</code></pre>", re.DOTALL)
BEFORE = "    return robot\n"
"""Folder with the complete robot of the scene."""


def block_with(page: Path, word: str) -> str:
    """Return the first block of code on a page that contains a word."""
    blocks = (
        html.unescape(re.sub("<[^>]+>", "", code))
        for code in CODE.findall(page.read_text(encoding="utf-8"))
    )
    return next(block for block in blocks if word in block)


def fix_block(page: Path) -> str:
    return block_with(page, "shape_material_ke")


@pytest.mark.slow
@needs_boxes_in_c
def test_the_lines_of_the_front_page_hold_the_cube_as_it_says(site, tmp_path):
    """Test the lines of the front page, which the fixed scene contains as well."""
    scene = (site / "download/scene_as_shipped.py").read_text(encoding="utf-8")
    block = fix_block(site / "index.html")
    assert scene.count(BEFORE) == 1
    status, said = run_script(
        scene.replace(BEFORE, f"    builder = robot\n{indent(block, '    ')}{BEFORE}"),
        tmp_path,
    )
    assert status == 0, said
    noise = json.loads((site / "data/values.json").read_text(encoding="utf-8"))[
        "reproduction"
    ]["engine_bound"]["value"]
    assert_slip_is_tracked(tmp_path, "stiff-pads", noise)


MJCF = """<mujoco><worldbody><body name="finger"><freejoint/><geom name="pad" type="box" size=".1 .1 .1" {}/></body>
</worldbody></mujoco>"""
URDF = """<robot name="hand"><link name="finger">
<collision><geometry><box size=".1 .1 .1"/></geometry></collision></link></robot>"""


@pytest.mark.parametrize(
    "solref", ["", 'solref="0.02 1"', 'solref="-2500 -100"', "in URDF"]
)
def test_the_lines_of_the_front_page_reach_pads_that_were_imported(site, solref):
    """Test that a solref in MJCF overrides ke and kd unless the lines remove it."""
    builder = newton.ModelBuilder()
    newton.solvers.SolverMuJoCo.register_custom_attributes(builder)
    builder.add_urdf(URDF, floating=True) if solref == "in URDF" else builder.add_mjcf(
        MJCF.format(solref)
    )
    exec(fix_block(site / "index.html"), {"builder": builder})
    solver = newton.solvers.SolverMuJoCo(
        builder.finalize(device="cpu"), use_mujoco_cpu=True
    )
    assert solver.mj_model.geom_solref.tolist() == [pytest.approx([0.002, 1.0])]


def test_the_smallest_file_runs_as_it_is_shown(site, tmp_path):
    status, said = run_script(fix_block(site / "fix.html"), tmp_path)
    assert status == 0 and "[0.002" in said, said


def test_the_lines_of_mjcf_say_of_pads_what_the_other_block_does(site):
    geoms = block_with(site / "index.html", "left_pad").replace(
        "<geom", '<geom type="box" size="0.01 0.01 0.01"'
    )
    model = mujoco.MjModel.from_xml_string(
        f"<mujoco><worldbody>{geoms}</worldbody></mujoco>"
    )
    for pad in map(model.geom, ("left_pad", "right_pad")):
        assert pad.priority[0] == 1 and pad.solref == pytest.approx([0.002, 1.0])


class Pasted(MuJoCoStepper):
    """Return a stepper with the solver that a block of code creates, and the other
    options of the scene.
    """

    block = ""

    def _build_solver(self):
        options = "nconmax=64, njmax=96, iterations=15, ls_iterations=100, update_data_interval=0"
        assert self.block.count(" model, ") == 1
        names = {"builder": SimpleNamespace(finalize=lambda: self.model)}
        exec(self.block.replace(" model, ", f" model, {options}, "), names)
        names["solver"].reset(self.state)
        return names["solver"]


@pytest.mark.slow
def test_the_block_of_the_cure_does_what_was_measured(site, monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "experiments/simulation")
    monkeypatch.setattr(
        Pasted, "block", block_with(site / "cure.html", "compensated_positions")
    )
    case = replace(FIXED, cube_in_hand=True, frame_count=130)
    cured = replace(
        case, impratio=400.0, compensated=True, contact_bias=True, bias_centred=True
    )
    monkeypatch.setattr(Simulation, "stepper_of", Pasted)
    [[pasted]] = run([Simulation([case], wp.get_device("cpu"))])
    monkeypatch.undo()
    [own] = simulate([cured], device="cpu")
    moved = [1e3 * metrics.displacement(trace).vector_m[-1] for trace in (pasted, own)]
    assert moved[0] == pytest.approx(moved[1], abs=1e-4)
    assert abs(moved[0]).max() < 0.1
