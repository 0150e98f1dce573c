"""Other scenes: does one law tell the creep of all of them, and do grasps that others published fail by it?"""

from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.sections.scenes import capsule, creep, hand, pick

order = 184  # after the sections that creep reads
page = "scenes"
reads = ("contacts", "cure")
label = "other scenes"

PARTS = (creep, capsule, pick, hand)


def derive(results: Results) -> Section:
    parts = [part.derive(results) for part in PARTS]
    return Section(
        figures={name: figure for part in parts for name, figure in part.figures.items()},
        claims=[claim for part in parts for claim in part.claims],
        unmeasured=[name for part in parts for name in part.unmeasured],
    )
