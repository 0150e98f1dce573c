"""Measure the headline again and write it into a file, without changing the results.

Usage: ``python -m experiments.simulation.headline --device cpu --json FILE``.
"""

import argparse
import json
import sys
import time
from pathlib import Path

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.simulation.host import compile_first, warp_device
from experiments.simulation.measurement import Conditions
from measured_report.files.config import report
from measured_report.measuring.batch import reason_of
from measured_report.measuring.machine import machine


def main() -> int:
    program, purpose = (
        "python -m experiments.simulation.headline",
        __doc__.split(":")[0],
    )
    parser = argparse.ArgumentParser(prog=program, description=purpose)
    parser.add_argument("--device", choices=("cuda", "cpu"), required=True)
    parser.add_argument("--json", type=Path, required=True, metavar="FILE")
    arguments = parser.parse_args()
    try:
        start = time.perf_counter()
        compile_first(arguments.device)
        compiled = time.perf_counter()
        device = warp_device(arguments.device)
        rows = (
            Conditions(device.alias, quick=False)
            .measure([AS_SHIPPED, STIFF_PADS], "headline")
            .rows
        )
        seconds = {
            "compile_s": compiled - start,
            "measure_s": time.perf_counter() - compiled,
        }
        headline = {"machine": machine(arguments.device), "rows": rows, **seconds}
        arguments.json.write_text(json.dumps(headline), encoding="utf-8")
    except Exception as error:
        print(f"measuring failed: {reason_of(error, report())}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
