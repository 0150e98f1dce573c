"""How long a Python takes that imports the package, and one that imports nothing."""

import re
import resource
import subprocess
import sys
from importlib.metadata import packages_distributions

from measured_report.measuring.measurement import Conditions, Measurement

PACKAGE, REPEAT_COUNT, START_COUNT = "@PACKAGE@", 4, 9


def start(code: str) -> float:
    """Run a Python of its own; return how long processors took for that [ms]: what else a machine does costs none."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1e3 * (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)


def times(code: str) -> dict[str, float]:
    """Start Pythons with the code and with none in turn; return mean times, and a ratio that a busy machine leaves."""
    pairs = [(start(code), start("pass")) for _ in range(START_COUNT)]
    whole, nothing = (sum(column) / START_COUNT for column in zip(*pairs, strict=True))
    return {"import_ms": whole, "empty_ms": nothing, "import_ratio": whole / nothing}


def plain(name: str) -> str:
    """Write the name of a package as the index has it: its metadata may spell it otherwise."""
    return re.sub("[-_.]+", "-", name).lower()


def measure(conditions: Conditions) -> Measurement:
    """Return a row, and repeats of it, whose spread is the noise."""
    modules = [
        module
        for module, names in packages_distributions().items()
        if plain(PACKAGE) in map(plain, names)
    ]
    if not modules:
        raise ImportError(f"{PACKAGE} has no module that can be imported")
    code = f"import {min(modules, key=lambda module: (module.startswith('_'), len(module)))}"
    start(code)  # files are read, and compiled, for the first time
    rows = [
        {"case": "whole"},
        *({"case": f"repeat-{n}", "of": "whole"} for n in range(REPEAT_COUNT)),
    ]
    return Measurement([row | times(code) for row in rows])
