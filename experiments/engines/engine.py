"""Engines that are in environments of their own, and how they are asked to run scenes."""

import json
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from measured_report.editions.environment import python_with
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT

APART = "experiments/engines/apart/apart.py"


@dataclass(frozen=True)
class Engine:
    """An engine, the script that runs scenes in it, and what is installed for it."""

    name: str
    release: str
    script: str
    requirements: tuple[str, ...]


def run_apart(engine: Engine, asked: Sequence[dict]) -> list[dict]:
    """Run an engine in its environment; each run returns what it shows, or a ``reason`` where it shows nothing."""
    try:
        python = python_with(f"engine-{engine.name.lower()}", engine.requirements)
    except UsageError as error:
        return [{"reason": str(error)}] * len(asked)
    with tempfile.TemporaryDirectory() as folder:
        question, answer = Path(folder) / "asked.json", Path(folder) / "answer.json"
        question.write_text(json.dumps(asked), encoding="utf-8")
        call = [python, ROOT / APART, ROOT / engine.script, question, answer]
        process = subprocess.run(call, cwd=folder, capture_output=True, text=True, check=False)
        if process.returncode:
            last = process.stderr.strip().splitlines()[-1:] or [f"it ended with status {process.returncode}"]
            return [{"reason": last[0][:120]}] * len(asked)
        return json.loads(answer.read_text(encoding="utf-8"))
