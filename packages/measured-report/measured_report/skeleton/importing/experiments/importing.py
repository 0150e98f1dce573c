"""How long a Python takes that imports the package, and one that imports nothing."""

import subprocess
import sys
import time
from importlib.metadata import packages_distributions

from measured_report.measuring.measurement import Conditions, Measurement

PACKAGE, REPEAT_COUNT = "@PACKAGE@", 7


def start(code: str) -> float:
    """Run a Python of its own; return how long that took [ms]."""
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", code], check=True)
    return 1e3 * (time.perf_counter() - began)


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each, and repeats of the first, whose spread is the noise."""
    modules = [module for module, packages in packages_distributions().items() if PACKAGE in packages]
    code = f"import {min(modules, key=lambda module: (module.startswith('_'), len(module)))}"
    start(code)  # files are read, and compiled, for the first time
    rows = [{"case": "whole", "import_ms": start(code)}, {"case": "nothing", "import_ms": start("pass")}]
    rows += [{"case": f"repeat-{n}", "of": "whole", "import_ms": start(code)} for n in range(REPEAT_COUNT)]
    return Measurement(rows)
