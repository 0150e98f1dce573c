"""Other scenes: which runs a claim counts."""

from measured_report.editions.project import Project
from measured_report.records.reading import load_record
from measured_report.values.results import Results
from report.sections.scenes import hand


def test_runs_that_a_claim_leaves_out_are_counted():
    path = Project("1.4.0").record_path("scenes")
    told = next(claim for claim in hand.derive(Results(load_record(path), path)).claims if claim.name == "slip_by_law")
    count, others, kept = (told.numbers[name].value for name in ("count", "others", "kept"))
    assert (count, others, count + others) == (30, 7, kept)
