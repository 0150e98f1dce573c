"""Other scenes: does one law give the creep of all, and do published grasps fail by it?"""

from report.sections.scenes import capsule, creep, pick
from report.shared import Results, Section, joined

order = 184  # after the sections that creep reads
page = "scenes"
reads = ("contacts", "cure")
label = "other scenes"


def derive(results: Results) -> Section:
    return joined([part.derive(results) for part in (creep, capsule, pick)])
