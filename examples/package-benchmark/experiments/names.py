"""Time how long idna takes to encode names, and to refuse names that are too long."""

import time
from contextlib import suppress
from itertools import product

import idna

NAMES = {
    "host": "www.bücher.example",
    "long-1000": "\u30fb" * 1000 + "\u6f22",
    "long-2000": "\u30fb" * 2000 + "\u6f22",
}
RUN_COUNT = 11  # the first run of each name is its row, and the others repeat it
CALL_COUNT = {"host": 200}  # calls in one run; the clock cannot resolve a single one


def run_ms(case: str) -> float:
    """Return the CPU time of one call [ms]."""
    count = CALL_COUNT.get(case, 1)
    began = time.process_time()
    for _ in range(count):
        with suppress(idna.IDNAError):  # a label may have 63 characters
            idna.encode(NAMES[case])
    return 1e3 * (time.process_time() - began) / count


def measure(conditions) -> list[dict]:
    rows = []
    run_ms("host")  # the first call is slower than all others
    for run, case in product(range(3 if conditions.quick else RUN_COUNT), NAMES):
        row = {"case": case, "character_count": len(NAMES[case])}
        if run:
            row |= {"case": f"{case}-run-{run}", "of": case}
        rows.append({**row, "run_ms": run_ms(case)})
    return rows
