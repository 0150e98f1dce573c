"""Run the files of the fix as a reader would, in separate processes."""

import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from experiments.facts.case import AS_SHIPPED
from experiments.facts.fix_files import fix_files
from experiments.simulation.measurement import Conditions, Measurement

SCRIPTS = {"as-shipped": "scene_as_shipped.py", "fixed": "fixed_scene.py"}
NUMBERS = ("slip_mm", "drift_mm_s", "cube_height_m")


def measure(conditions: Conditions) -> Measurement:
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count)
    runs = [
        {"case": case, "backend": "warp", "script": script}
        for case, script in SCRIPTS.items()
    ]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return Measurement(
            list(
                pool.map(
                    lambda row: try_script(row, conditions.device, frame_count), runs
                )
            )
        )


def try_script(
    row: dict[str, object], device: str, frame_count: int
) -> dict[str, object]:
    """Return a row with the numbers and the test result of a script.

    The script runs in an empty folder.
    """
    with tempfile.TemporaryDirectory() as folder:
        script, summary = (
            Path(folder) / str(row["script"]),
            Path(folder) / "summary.json",
        )
        script.write_text(fix_files()[script.name], encoding="utf-8")
        options = [
            "--viewer",
            "null",
            "--num-frames",
            str(frame_count),
            "--test",
            "--quiet",
        ]
        options += [
            "--backend",
            str(row["backend"]),
            "--device",
            device,
            "--json",
            str(summary),
        ]
        run = subprocess.run(
            [sys.executable, str(script), *options],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        results = (
            json.loads(summary.read_text(encoding="utf-8")) if summary.exists() else {}
        )
    message = run.stderr.strip().splitlines()[-1:]
    for name in NUMBERS:
        value = results.get(name)
        row[name] = value if value is not None and math.isfinite(value) else None
        if row[name] is None:
            row[f"{name}_reason"] = (
                message[0]
                if run.returncode and message
                else "the script does not say it"
            )
    test = {
        "exit_status": run.returncode,
        "test_message": message[0] if run.returncode and message else None,
    }
    return row | {"dropped": results.get("dropped"), **test, "frame_count": frame_count}
