"""Test that the page's own engine agrees with the tracked runs in Node, and that every
run ends.
"""

import json
import os
import random
import shutil
import subprocess

import numpy as np
import pytest

from experiments.facts.classes import CLASSES
from measured_report.files.root import ROOT
from measured_report.records.record import trace_path
from measured_report.records.traces import load_trace

pytestmark = pytest.mark.skipif(
    not shutil.which("node"), reason="there is no node to run the page's engine with"
)
RECORD = ROOT / "results/newton-1.4.0/lab.json"
QUERIES = {
    "as-shipped": "",
    "stiff-pads": "ke=250000&kd=1000",
    "term": "term=on",
    "whole-cure": "term=centred&integrator=Euler&impratio=1000",
    "stiff-pads-10cm": "ke=250000&kd=1000&amplitude_mm=100",
    "cone-pyramidal": "cone=pyramidal",
}
"""Text after the page's address for each tracked case."""
WHOLE = "stiff-pads-10cm"
"""Cases that run to the end. ``test_lab_page.py`` runs the case as shipped on the page.
"""
RANDOM_COUNT = int(os.environ.get("LAB_RANDOM", "3"))
"""Number of settings to try; 1000 take some minutes."""
NUMBERS = {
    "ke": (1e2, 1e7),
    "kd": (5, 1e5),
    "mu": (0.05, 5),
    "impratio": (1, 1e3),
    "substeps": (2, 64),
    "grip_n": (1, 60),
    "mass_g": (5, 1e3),
    "edge_mm": (15, 60),
    "amplitude_mm": (1e-3, 150),
    "frequency_hz": (0.2, 3),
    "gravity_m_s2": (1e-3, 20),
}
NAMES = {
    "cone": ("elliptic", "pyramidal"),
    "integrator": ("implicitfast", "Euler", "implicit", "RK4", "discrete"),
    "term": ("off", "on", "centred"),
}


def rows_in_node(queries, shake_frame_count, **env):
    command = ["node", ROOT / "assets/lab/run.mjs", RECORD, str(shake_frame_count)]
    done = subprocess.run(
        command,
        input=json.dumps(queries),
        capture_output=True,
        text=True,
        env=os.environ | env,
    )
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


@pytest.mark.slow
def test_it_slips_as_the_tracked_runs_and_ends_in_their_class():
    """Test two cycles of each setting, and the results of two settings."""
    for case, row in zip(QUERIES, rows_in_node([*QUERIES.values()], 121), strict=True):
        moved = load_trace(trace_path(RECORD, case))[["x_mm", "y_mm", "z_mm"]].iloc[120]
        assert row["slip_mm"] == pytest.approx(
            np.linalg.norm(moved), rel=1e-3, abs=1e-4
        ), case
    tracked = {row["case"]: row for row in json.loads(RECORD.read_text())["rows"]}
    [row] = rows_in_node([QUERIES[WHOLE]], 688)
    assert row["class"] == tracked[WHOLE]["class"]
    assert row["slip_mm"] == pytest.approx(
        tracked[WHOLE]["slip_mm"], rel=0.01, abs=0.02
    )
    assert row["predicted_drift_mm_s"] == pytest.approx(row["drift_mm_s"], rel=0.02)


@pytest.mark.slow
def test_it_ends_whatever_it_is_asked():
    chance = random.Random(4)
    queries = []
    for _ in range(RANDOM_COUNT):
        said = {
            name: low * (high / low) ** chance.random()
            for name, (low, high) in NUMBERS.items()
        }
        said |= {name: chance.choice(choices) for name, choices in NAMES.items()}
        queries.append("&".join(f"{name}={value}" for name, value in said.items()))
    rows = rows_in_node(queries, 60)
    assert len(rows) == RANDOM_COUNT and {row["class"] for row in rows} <= set(CLASSES)
    assert all(row["reason"] or row["slip_mm"] is not None for row in rows)


def test_what_an_address_says_badly_is_as_shipped_or_in_range():
    queries = [
        "kd=nonsense&cone=round&substeps=2.4",
        "kd=1e99&substeps=2",
        "kd=100&substeps=2",
    ]
    badly, far, plain = rows_in_node(queries, 10)
    assert (
        badly["pad_kd"] == 100
        and badly["cone"] == "elliptic"
        and badly["slip_mm"] == plain["slip_mm"]
    )
    assert far["pad_kd"] == 1e5
