"""Short runs: a claim that full runs answer otherwise is marked on their page."""

from dataclasses import replace

from conftest import ROWS, Toy

from measured_report.site.check import check_site

SOFT, STIFF = ROWS
NO_HELP = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""With these rows the toy's claim fails."""
OTHERWISE = "otherwise in full runs</span> <span"


def of_profile(toy: Toy, profile: str, release: str = "1.4.0") -> Toy:
    return replace(toy, project=replace(toy.project, profile=profile).of(release))


def test_a_claim_that_full_runs_answer_otherwise_even_in_another_edition_is_marked(toy):
    quick = of_profile(toy, "quick")
    quick.measure(NO_HELP)
    quick.build()
    mark = 'title="Newton 1.4.0 in full runs: It helps 20 times.">'
    assert f'{mark}{OTHERWISE} class="claim" data-claim="toy.helps"' in quick.page
    assert check_site(toy.project.site) == []
    quick.measure(ROWS)
    quick.build()
    assert OTHERWISE not in quick.page
    toy.build()
    assert OTHERWISE not in toy.page
    of_profile(toy, "quick").measure(NO_HELP)
    newer = of_profile(toy, "quick", "1.9.0")
    newer.measure(NO_HELP)
    newer.build()
    assert f">perhaps {OTHERWISE}" in newer.page and f">{OTHERWISE}" not in newer.page
    of_profile(toy, "full", "1.9.0").measure(NO_HELP)  # whose full runs answer as its short ones do
    newer.build()
    assert OTHERWISE not in newer.page
