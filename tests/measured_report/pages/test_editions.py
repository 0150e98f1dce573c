"""Short runs: a claim that full runs answer otherwise is marked on their page."""

from dataclasses import replace

from conftest import ROWS

from measured_report.site.check import check_site

SOFT, STIFF = ROWS
NO_HELP = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""With these rows the toy's claim fails."""
OTHERWISE = "otherwise in full runs</span> <span"


def test_a_claim_that_full_runs_answer_otherwise_is_marked(toy):
    quick = replace(toy, project=replace(toy.project, profile="quick"))
    quick.measure(NO_HELP)
    quick.build()
    mark = 'title="Full runs: It helps 20 times.">'
    assert f'{mark}{OTHERWISE} class="claim" data-claim="toy.helps"' in quick.page
    assert check_site(toy.project.site) == []
    quick.measure(ROWS)
    quick.build()
    assert OTHERWISE not in quick.page
    toy.build()
    assert OTHERWISE not in toy.page
