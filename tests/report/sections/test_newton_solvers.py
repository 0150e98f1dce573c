"""Newton's own solvers: what a second measurement says of them."""

from dataclasses import replace

from measured_report.values.cells import evidence_of
from measured_report.values.results import Results
from report.sections.newton_solvers import derive
from tests.by_hand import with_cells


def test_whose_slip_does_not_repeat_is_named_with_each_that_keeps_the_cube(editions):
    tracked = editions["1.8.0"].chapters["newton_solvers"].results
    record = with_cells(
        tracked.record, ["kamino-3cm.slip_mm=0.2", "steel-points-held.slip_mm=1", "xpbd-10cm.slip_mm=4"]
    )

    def repeat(*cells: str) -> tuple[str, str]:
        again = [replace(with_cells(record, list(cells)), machine=record.machine | {"gpu_uuid": "another"})] * bool(
            cells
        )
        evidence = evidence_of({"again": [record, *again]}, {}, tracked.columns)["again"]
        section = derive(Results(record, tracked.path, tracked.others, evidence=evidence))
        [claim] = [claim for claim in section.claims if claim.name == "slips_repeat"]
        return claim.outcome.answer, claim.numbers["solvers"]

    assert repeat() == ("cannot tell", "")
    assert repeat("xpbd-10cm.slip_mm=4.09") == ("holds", "")
    both = "kamino-3cm.slip_mm=0.31", "steel-points-held.slip_mm=0.8"
    assert repeat(*both) == ("the opposite", "Kamino and in Steel without anchors")
    assert repeat("vbd-3cm.slip_mm=100") == ("holds", ""), "it loses the cube"
