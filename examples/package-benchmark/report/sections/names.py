"""Derive whether idna refuses long names at once."""

import pandas as pd

from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results

label = "names"  # the name of the section in figures and tables
CASES = ("host", "long-1000", "long-2000")


def derive(results: Results) -> Section:
    host, short, long = (results.row[case].run_ms for case in CASES)
    claim = Claim(
        "is_refused_at_once",
        at_most(long, host, why="a name that is too long needs no more work"),
        {"long": long, "host": host},
    )
    table = pd.DataFrame({"time": [host, short, long]}, index=list(CASES))
    return Section(tables={"times": Table(table)}, claims=[claim])
