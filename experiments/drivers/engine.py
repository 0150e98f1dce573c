"""Run scenes in engines that need separate environments."""

import json
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np

from experiments.drivers.scene import Scene, Trace
from measured_report.editions.environment import python_with
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT

# Records depend on this file and on the scripts, because their paths appear in the
# code.
APART = "experiments/drivers/apart/apart.py"


@dataclass(frozen=True)
class Engine:
    """Describe an engine by the script that runs its scenes and by its requirements."""

    name: str
    release: str
    script: str
    requirements: Sequence[str]
    options: Mapping[str, object] = field(default_factory=dict)


def run(scenes: Sequence[Scene], engine: Engine) -> list[Trace | str]:
    """Return the trace of each scene, or the reason if it has none."""
    try:
        name = f"engine-{engine.name.lower()}"
        python = python_with(name, engine.requirements)
    except UsageError as error:
        return [str(error)] * len(scenes)
    with tempfile.TemporaryDirectory() as folder:
        question = Path(folder) / "question.json"
        answer = Path(folder) / "answer.json"
        asked = {"scenes": list(map(asdict, scenes)), "options": engine.options}
        question.write_text(json.dumps(asked), encoding="utf-8")
        process = subprocess.run(
            [python, ROOT / APART, ROOT / engine.script, question, answer],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        if process.returncode:
            status = f"it ended with status {process.returncode}"
            last = process.stderr.strip().splitlines()[-1:] or [status]
            return [last[0][:120]] * len(scenes)
        return [trace_of(shown) for shown in json.loads(answer.read_text("utf-8"))]


def trace_of(shown: Mapping) -> Trace | str:
    if "reason" in shown:
        return shown["reason"]
    return Trace(**{name: np.array(values) for name, values in shown.items()})
