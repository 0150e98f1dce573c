"""The page's own engine beside the tracked runs: the same settings in Node, and whether slip and class agree."""

import json
import os
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from typing import Any

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition

PROGRAM = ROOT / "assets/lab/run.mjs"
SHAKE_FRAME_COUNT = 688
QUERIES = {
    "as-shipped": "",
    "stiff-pads": "ke=250000&kd=1000",
    "term": "term=on",
    "whole-cure": "term=centred&integrator=Euler&impratio=1000",
    "as-shipped-10cm": "amplitude_mm=100",
    "stiff-pads-10cm": "ke=250000&kd=1000&amplitude_mm=100",
    "cone-pyramidal": "cone=pyramidal",
    "impratio-1": "impratio=1",
    "substeps-4": "substeps=4",
    "hold": "amplitude_mm=0",
}
"""What the page's address says for each tracked case."""
BOUND_MM, BOUND_SHARE = 0.02, 0.01
"""A slip agrees within the greater of the two."""
LINE = "{:18}{:>11}{:>11}  {:10} {:10} {}"


def rows_in_node(record: str, queries: Sequence[str], shake_frame_count: int, **env: str) -> list[Mapping[str, Any]]:
    """Return what the page's engine says of each query.

    Raises:
        ReportError: There is no Node, or it failed.
    """
    node = shutil.which("node")
    if not node:
        raise ReportError("there is no node to run the page's engine with; install Node.js 20 or later")
    command = [node, str(PROGRAM), record, str(shake_frame_count)]
    run = subprocess.run(
        command, input=json.dumps(queries), capture_output=True, text=True, check=False, env=os.environ | env
    )
    if run.returncode:
        raise ReportError(f"the page's engine failed in Node: {(run.stderr.strip().splitlines() or ['?'])[-1]}")
    return [json.loads(line) for line in run.stdout.splitlines()]


def verify_lab(edition: Edition) -> tuple[str, bool]:
    """Return what was found, in lines, and whether all agree with what is tracked."""
    if "lab" not in edition.chapters:
        raise ReportError(f"newton {edition.project.release} has no results of lab to compare with")
    tracked = edition.chapters["lab"].results.row
    record = edition.project.results / "lab.json"
    found = dict(zip(QUERIES, rows_in_node(str(record), [*QUERIES.values()], SHAKE_FRAME_COUNT), strict=True))
    verdicts = {case: agrees(row, tracked[case]) for case, row in found.items()}
    head = LINE.format("slip [mm]", "here", "tracked", "class", "tracked", "")
    lines = [f"{found['as-shipped']['engine']} in Node", head]
    for case, row in found.items():
        slips, own = (_mm(row["slip_mm"]), _mm(tracked[case].slip_mm.value)), str(tracked[case]["class"])
        lines.append(LINE.format(case, *slips, row["class"], own, "agrees" if verdicts[case] else "differs"))
    return "\n".join(lines), all(verdicts.values())


def agrees(row: Mapping[str, Any], tracked: Any) -> bool:
    """Tell whether the class is the same and, of a cube that is kept, the slip."""
    if row["class"] != str(tracked["class"]):
        return False
    slip = tracked.slip_mm.value
    return tracked.dropped or abs(row["slip_mm"] - slip) <= max(BOUND_MM, BOUND_SHARE * slip)


def _mm(value: float | None) -> str:
    return "-" if value is None else f"{value:.4f}"
