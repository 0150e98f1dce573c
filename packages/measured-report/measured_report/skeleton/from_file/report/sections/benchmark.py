"""Derive which case is the best."""

import pandas as pd

from measured_report.parts.claim import Claim, greater
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "of" not in row]
    rows.sort(key=lambda row: row.run_ms.number)
    best, second = rows[:2]
    numbers = {"best": best.run_ms, "second": second.run_ms, "name": best.label}
    outcome = greater(second.run_ms, best.run_ms)
    cells = {row.label: row.run_ms for row in rows}
    table = pd.DataFrame({"result": pd.Series(cells)})
    return Section(
        tables={"cases": Table(table)}, claims=[Claim("is_best", outcome, numbers)]
    )
