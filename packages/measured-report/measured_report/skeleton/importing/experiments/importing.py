"""How long a Python takes that imports the package, and one that imports nothing."""

import re
import resource
import subprocess
import sys
from importlib.metadata import packages_distributions

from measured_report.measuring.measurement import Conditions, Measurement

PACKAGE, REPEAT_COUNT, TRY_COUNT = "@PACKAGE@", 7, 3


def start(code: str) -> float:
    """Run a Python of its own; return how long processors took for that [ms]: what else a machine does costs none."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1e3 * (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)


def least(code: str) -> float:
    """Return the least time of some starts: what disturbs one only adds to it."""
    return min(start(code) for _ in range(TRY_COUNT))


def plain(name: str) -> str:
    """Write the name of a package as the index has it: its metadata may spell it otherwise."""
    return re.sub("[-_.]+", "-", name).lower()


def measure(conditions: Conditions) -> Measurement:
    """Return a row for each, and repeats of the first, whose spread is the noise."""
    modules = [module for module, names in packages_distributions().items() if plain(PACKAGE) in map(plain, names)]
    if not modules:
        raise ImportError(f"{PACKAGE} has no module that can be imported")
    code = f"import {min(modules, key=lambda module: (module.startswith('_'), len(module)))}"
    start(code)  # files are read, and compiled, for the first time
    rows = [{"case": "whole", "import_ms": least(code)}, {"case": "nothing", "import_ms": least("pass")}]
    rows += [{"case": f"repeat-{n}", "of": "whole", "import_ms": least(code)} for n in range(REPEAT_COUNT)]
    return Measurement(rows)
