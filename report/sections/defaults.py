"""What a release sets where nobody does, and the slip with that: the scene writes what 1.4.0 had."""

from measured_report.claims.claim import Claim, decided
from measured_report.parts.section import Section
from measured_report.records.columns import changed_parameters
from measured_report.values.results import Results

order = 205
page = "releases"
label = "own defaults"

CASE, RUN = "own-defaults", ("frame_count", "device")
"""The case, and what it has otherwise than the scene for being a run of its own."""


def derive(results: Results) -> Section:
    row = results.row[CASE]
    changed = [name for name in changed_parameters(row.plain) if name not in RUN]
    numbers = {"release": results.edition, "changed": ", ".join(changed)}
    return Section(claims=[Claim("as_the_scene", decided(not changed, row.slip_mm), numbers)])
