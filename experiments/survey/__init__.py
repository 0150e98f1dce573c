"""What does the lint say of the examples that Newton ships?"""

import json
import os
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator

from tqdm import tqdm

from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.survey import examples
from measured_report.files.root import ROOT

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: what it finds is the same on any machine."""
RULES = ("priority", "default-gap", "timeconst", "ke-without-kd", "dampratio", "kf", "unused")
COUNTS = {rule: f"{rule.replace('-', '_')}_count" for rule in RULES}


def measure(conditions: Conditions) -> Measurement:
    """A row for each example, and one for each thing that is found in it."""
    return Measurement([row for found in linted() for row in _rows(found)])


def linted() -> Iterator[dict]:
    """What ``experiments.survey.examples`` prints: a GPU would not be used, and its context can't be forked."""
    command = [sys.executable, "-m", examples.__name__]
    blind = {**os.environ, "CUDA_VISIBLE_DEVICES": ""}
    process = subprocess.Popen(command, cwd=ROOT, env=blind, stdout=subprocess.PIPE, text=True)
    with process:
        yield from map(json.loads, tqdm(process.stdout, desc="examples", unit="example", delay=3.0))
    if process.returncode:
        raise RuntimeError(f"{' '.join(command)} ended with status {process.returncode}")


def _rows(found: dict) -> Iterator[dict[str, object]]:
    place = {"case": found["case"], "folder": found["folder"], "unbuilt": found["unbuilt"]}
    if found["unbuilt"]:
        names = ("shape_count", "pair_count", "finding_count", *COUNTS.values())
        yield place | {"solver": ""} | absent(names, f"it is not linted: {found['unbuilt']}")
        return
    findings = found["findings"]
    counts = Counter(finding["rule"] for finding in findings)
    numbers = {name: found[name] for name in ("shape_count", "pair_count")} | {"finding_count": len(findings)}
    yield place | {"solver": found["solver"], **numbers} | {name: counts[rule] for rule, name in COUNTS.items()}
    for number, finding in enumerate(findings, start=1):
        unit = "" if finding["unit"] == "1" else f"_{finding['unit']}"
        used = {f"used{unit}": finding["used"]}
        if finding["used"] is None:
            used = absent(used, "the solver does not read it")
        yield {
            "case": f"{found['case']}-{number}",
            "scene": found["case"],
            "rule": finding["rule"],
            "parameter": finding["parameter"],
            f"authored{unit}": finding["value"],
            **used,
            "place_count": finding["count"],
        }
