"""What does the lint say of the robot suites that pip brings?

Each is put into a folder of its own, with MuJoCo and without all else that it takes to run, and linted there.
"""

import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from experiments.simulation.measurement import Conditions, Measurement, absent
from measured_report.files.root import ROOT
from newton_lint import command

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: what it finds is the same on any machine."""
LINT = ROOT / "packages" / "newton-lint"
RULES = (
    *("solref-format", "solimp", "timeconst", "dampratio", "one-sided", "pyramid", "slip", "lost", "condim", "pair"),
    *("override", "refsafe", "priority", "unused", "untouched"),
)
COUNTS = {rule: f"{rule.replace('-', '_')}_scene_count" for rule in RULES}


@dataclass(frozen=True)
class Suite:
    """A suite, its release, and the folder that it installs."""

    name: str
    release: str
    folder: str
    mujoco: str = "4.0.0"
    """The newest release of MuJoCo that it takes."""


SUITES = (
    Suite("dm_control", "1.0.50", "dm_control"),
    Suite("gymnasium", "1.4.0", "gymnasium"),
    Suite("gymnasium-robotics", "1.4.2", "gymnasium_robotics"),
    Suite("metaworld", "3.1.1", "metaworld", "3.3.0"),
    Suite("robosuite", "1.5.2", "robosuite"),
    Suite("mani_skill", "3.0.1", "mani_skill"),
    Suite("playground", "0.2.0", "mujoco_playground"),
)


def measure(conditions: Conditions) -> Measurement:
    """A row for each suite, and one for each scene in which there is a warning."""
    suites = SUITES[:1] if conditions.quick else SUITES
    return Measurement([row for suite in tqdm(suites, desc="suites", delay=3.0) for row in _rows(suite)])


def _rows(suite: Suite) -> Iterator[dict[str, object]]:
    reports, refused = linted(suite)
    rules = [{finding["rule"] for finding in report["findings"]} for report in reports]
    worse = [[each for each in report["findings"] if each["severity"] != "note"] for report in reports]
    slips = [each["value"] for found in worse for each in found if each["rule"] == "slip"]
    creep = {"creep_mm_s": max(slips, default=None)}
    yield {
        **{"case": suite.name, "release": suite.release, "mujoco": suite.mujoco, "scene_count": len(reports)},
        **{"refused_count": refused, "warned_count": sum(map(bool, worse))},
        **{name: sum(report[name] for report in reports) for name in ("shape_count", "pair_count")},
        **{name: sum(rule in found for found in rules) for rule, name in COUNTS.items()},
        **(creep if slips else absent(creep, "no gripped body of it creeps by so much that the lint warns")),
    }
    places = [Path(report["target"]).name for report in reports]
    counts = [Counter(each["rule"] for each in found) for found in worse]
    told = [(scene, *each) for scene, found in zip(places, counts, strict=True) for each in found.items()]
    for number, (scene, rule, count) in enumerate(told, start=1):
        yield {
            "case": f"{suite.name}-{number}",
            "suite": suite.name,
            "scene": scene,
            "rule": rule,
            "place_count": count,
        }


def linted(suite: Suite) -> tuple[list[dict], int]:
    """A report of each scene that MuJoCo compiles, and how many files it refuses."""
    with tempfile.TemporaryDirectory() as folder:
        uv, python = Path(sys.executable).with_name("uv"), Path(folder) / "bin" / "python"
        install = (uv, "pip", "install", "--quiet", "--python", python)
        _run(uv, "venv", "--quiet", "--clear", "--python", sys.executable, folder)
        _run(*install, f"mujoco=={suite.mujoco}", "numpy")
        _run(*install, "--no-deps", f"{suite.name}=={suite.release}")
        site = _run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip()
        call = [python, "-c", f"from {command.__name__} import main; main()", Path(site) / suite.folder, "--json"]
        environment = {**os.environ, "PYTHONPATH": str(LINT)}
        found = subprocess.run(call, cwd=folder, env=environment, capture_output=True, text=True, check=False)
        reports = json.loads(found.stdout)
        return reports if isinstance(reports, list) else [reports], found.stderr.count("MuJoCo refuses it")


def _run(*call: object) -> str:
    return subprocess.run([str(each) for each in call], check=True, stdout=subprocess.PIPE, text=True).stdout
