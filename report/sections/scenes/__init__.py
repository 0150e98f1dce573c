"""Compare the creep of other scenes with one law, and with published grasps that fail."""

from report.sections.scenes import capsule, creep, pick
from report.shared import Results, Section, joined

order = 184  # after the sections whose values creep reads
page = "scenes"
reads = ("contacts", "cure")
label = "other scenes"


def derive(results: Results) -> Section:
    return joined([part.derive(results) for part in (creep, capsule, pick)])
