"""Read the results of a benchmark as the rows of a section."""

import csv
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path
from statistics import fmean
from typing import Any

from measured_report.files.errors import ReportError

RUN_COUNT = 20  # chosen: more runs of one case are averaged in as many groups


def rows_of(file: str) -> list[dict[str, Any]]:
    """Return the runs in a JSON file of pytest-benchmark, hyperfine or asv, or in a CSV.

    The first column of a CSV names the cases. The first run of a case is its row, and
    the others repeat it. Times are in the column ``run_ms``.
    """
    try:
        runs = [*(_table(file) if file.endswith(".csv") else _times(file))]
    except (AttributeError, LookupError, TypeError, ValueError) as error:
        raise ReportError(
            f"{file} is not a result of pytest-benchmark, hyperfine or asv, or a CSV "
            f"with numbers ({type(error).__name__}: {error}): use one of them"
        ) from None
    counts: Counter[str] = Counter()
    rows = []
    for case, cells in runs:
        counts[case] += 1
        number = counts[case]
        name = {"case": f"{case} (run {number})", "of": case}
        rows.append({**(name if number > 1 else {"case": case}), **cells})
    return rows


def _table(file: str) -> Iterator[tuple[str, dict[str, Any]]]:
    with Path(file).open(newline="", encoding="utf-8") as lines:
        header, *rows = csv.reader(lines)
    for case, *cells in rows:
        yield case, dict(zip(header[1:], map(float, cells), strict=True))


def _times(file: str) -> Iterator[tuple[str, dict[str, Any]]]:
    for case, seconds in _timings(json.loads(Path(file).read_text(encoding="utf-8"))):
        # Rounded up, so that there are at most RUN_COUNT groups.
        size = -(-len(seconds) // RUN_COUNT)
        for start in range(0, len(seconds), size):
            yield case, {"run_ms": 1e3 * fmean(seconds[start : start + size])}


def _timings(data: Any) -> Iterator[tuple[str, Sequence[float]]]:
    """Yield the name and the times [s] of each benchmark."""
    if "benchmarks" in data:  # pytest-benchmark
        for benchmark in data["benchmarks"]:
            stats = benchmark["stats"]
            # The runs are in the file only with --benchmark-save-data.
            yield benchmark["name"], stats.get("data") or [stats["median"]]
    elif isinstance(data["results"], list):  # hyperfine
        for result in data["results"]:
            yield result["command"], result["times"]
    else:  # asv
        for name, fields in data["results"].items():
            result = dict(zip(data["result_columns"], fields, strict=False))
            samples = result.get("samples") or [None] * len(result["result"])
            # Without parameters this is one empty tuple, as there is one result.
            labels = product(*result["params"])
            for label, time, runs in zip(
                labels, result["result"], samples, strict=True
            ):
                if time is not None:
                    yield (
                        f"{name}({', '.join(label)})" if label else name,
                        runs or [time],
                    )
