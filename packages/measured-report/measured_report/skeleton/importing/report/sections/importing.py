"""Does importing the package take longer than one waits for?"""

import pandas as pd

from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results

order = 10  # place on the page


def derive(results: Results) -> Section:
    row = results.row["whole"]
    times = {"whole": row.import_ms, "nothing": row.empty_ms}
    limit = results.chosen("limit", "what one waits for without a word", 2000.0, "ms")
    claim = Claim(
        "is_quick",
        at_most(times["whole"], limit),
        {"whole": times["whole"], "limit": limit},
    )
    return Section(
        tables={"times": Table(pd.DataFrame({"time": times}))}, claims=[claim]
    )
