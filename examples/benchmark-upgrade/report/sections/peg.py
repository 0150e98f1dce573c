"""What of the pads' contact parameters mends the peg."""

from measured_report.pages.editions import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim
from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.paired import Step
from report.sections.confirm import PEG

order = 31
page = "settings"
label = "the peg"
BEGAN = "3.4.0"


def derive(results: Results, releases: Releases) -> Section:
    there = releases.get(BEGAN, {})
    if "peg" not in there or "confirm" not in there:
        return Section(unmeasured=["margin_mends_the_peg"])
    shipped, pegs = there["confirm"].results.row[PEG], there["peg"].results
    step = Step(PEG, ("as shipped", "margin"), (shipped, pegs.row["margin"]))  # machines do not differ in an episode
    found = {row.case.replace("-", "_"): row.success_count for row in pegs.rows}
    found |= {"shipped": shipped.success_count, "count": shipped.seed_count}
    is_mended = step.gained > step.lost and step.is_beyond_chance("success", 1)
    outcome = (HOLDS if is_mended else FAILS).having_read(*found.values())
    return Section(claims=[Claim("margin_mends_the_peg", outcome, found)])
