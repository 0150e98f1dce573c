"""The cure: what each of its parts does, on which scenes, and what to use."""

from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.sections.cure import bodies, budget, hold, limits, turntable
from report.shared.arithmetic import joined

order = 141
page = "cure"
reads = ("noise",)
label = "the cure"
leads = True

PARTS = (turntable, hold, limits, bodies, budget)
"""The modules of its parts; the last one reads what the limits are."""


def derive(results: Results) -> Section:
    return joined([part.derive(results) for part in PARTS])
