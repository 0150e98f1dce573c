"""List the runs with which the engine on the page is compared."""

from report.shared import Claim, Results, Section, at_least, by_case

order = 26
page = "lab"
label = "measure it"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-10cm": "shipped pads, 10 cm",
    "stiff-pads-10cm": "stiff pads, 10 cm",
    "term": "term restored",
    "whole-cure": "the root cure",
    "cone-pyramidal": "pyramidal cone",
    "hold": "arm held still",
}

COLUMNS = {
    "slip": "slip_mm",
    "drift": "drift_mm_s",
    "friction used": "cone_use",
    "class": "class",
}
# Cases that are not compared with the engine on the page.
CHECKS = ("impratio-1-midphase", "as-shipped-nearby")


def derive(results: Results) -> Section:
    runs = [row for row in results.rows if "slip_mm" in row and row.case not in CHECKS]
    with_midphase, without = (
        results.row[case] for case in ("impratio-1-midphase", "impratio-1")
    )
    farther = results.value(
        "midphase_farther",
        "displacement with the midphase divided by the displacement without it",
        with_midphase.wander_mm / without.wander_mm,
    )
    outcome = at_least(
        farther, 10.0, "the cube leaves the grasp instead of moving along it"
    )
    claim = Claim(
        "midphase_loses",
        outcome,
        {"way": with_midphase.wander_mm, "without": without.wander_mm},
    )
    return Section(tables={"runs": by_case(runs, COLUMNS)}, claims=[claim])
