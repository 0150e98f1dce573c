"""Other scenes: does one law tell the creep of all of them, and do grasps that others published fail by it?"""

from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.sections.scenes import capsule, creep, pick
from report.shared.arithmetic import joined

order = 184  # after the sections that creep reads
page = "scenes"
reads = ("contacts", "cure")
label = "other scenes"


def derive(results: Results) -> Section:
    return joined([part.derive(results) for part in (creep, capsule, pick)])
