"""Several releases: judged, shown and compared without any of them being installed."""

from argparse import Namespace
from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import pytest
from toys import MODULE, ROWS, Toy, compared, derived

from measured_report.changes.alarm import rate_of, settings_text
from measured_report.changes.compare import flips_between
from measured_report.changes.moves import Move, judged
from measured_report.commands import diff, page
from measured_report.editions.release import release_of
from measured_report.files.config import report
from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, at_most, greater
from measured_report.parts.section import Section
from measured_report.records.record import load_record
from measured_report.site.check import check_site
from measured_report.values.noise import Estimate
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results

SOFT, STIFF = ROWS
BETTER = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""A release in which the stiff case gains nothing."""


@pytest.fixture
def newer(toy) -> Toy:
    newer = toy.of("1.8.0")
    newer.measure(BETTER)
    return newer


def test_every_release_has_a_page_that_leads_to_the_others_and_the_one_asked_for_is_first(
    toy, newer
):
    toy.build()
    site = toy.project.site
    other = (site / "newton-1.8.0/cause.html").read_text()
    assert (
        'href="newton-1.8.0/cause.html#toy"' in toy.page
        and 'href="newton-1.8.0/index.html"' in toy.front
    )
    assert 'href="../cause.html#toy"' in other
    assert 'data-claim="toy.helps" data-outcome="holds"' in toy.page
    assert 'data-claim="toy.helps" data-outcome="fails"' in other
    assert 'data-src="newton-1.8.0/toy.json#/rows/1/slip_mm"' in other
    assert "NEWTON" not in toy.page
    assert (site / "data/newton-1.8.0/toy.json").is_file()
    assert check_site(site) == []
    newer.build()
    assert "<b>Newton 1.8.0</b>" in newer.page.replace(' aria-current="true"', "")
    assert 'href="newton-1.4.0/cause.html"' in newer.page
    assert check_site(site) == []
    path = site / "newton-1.4.0/cause.html"
    path.write_text(
        path.read_text()
        .replace('id="toy"', 'id="other"')
        .replace('href="#toy"', 'href="#other"')
    )
    assert "cause.html: newton-1.4.0/cause.html#toy leads nowhere" in check_site(site)


@pytest.mark.parametrize(
    ("bug", "said"),
    [
        ("results.rows[5:]; rows[0]", "IndexError: list index"),
        ("results.row['stiff'].slap_mm", "toy: stiff has no column"),
        (
            "results.chosen('x', 'so', 1.0, 'furlong')",
            "the value x has the unit furlong, not known here; units",
        ),
    ],
)
def test_a_bug_of_derive_is_no_damage_and_has_its_line_and_no_advice_to_measure(
    toy, bug, said, capsys
):
    toy.write(
        "report/sections/toy.py", MODULE.replace("rows = results.rows", f"rows = {bug}")
    )
    assert (
        page.run(toy.project, Namespace(release=release_of("1.4.0"), address="")) == 1
    )
    found = capsys.readouterr()
    assert found.err.startswith(
        f"not shown: newton-1.4.0/toy.json: report/sections/toy.py:20: {said}"
    )
    assert (
        "report/sections/toy.py:20" in toy.page and "rerun" not in toy.page + found.out
    )
    toy.write("experiments/scene.py", "def slip():\n    return 2\n")
    toy.build()
    assert "<b>toy</b> is left out" in toy.page and said in toy.page


def test_a_diff_names_what_moved_and_flipped_and_a_dropped_cube_as_dropped(
    toy, newer, capsys
):
    arguments = Namespace(a=release_of("1.4.0"), b=release_of("1.8.0"), format="text")
    assert diff.run(toy.project, arguments) == 1
    said = capsys.readouterr().out
    flips = said.partition("toy: 1 moved, 1 better")[0]
    assert "toy.helps: holds → fails\n  It helps 20 times.\n  It does not." in flips
    assert (
        "slip 6.36 mm → 0.4 mm, -94 % better (toy soft)" in flips
        and "(toy stiff)" not in said
    )
    newer.measure(ROWS)
    assert diff.run(toy.project, arguments) == 0
    newer.measure([SOFT, {**STIFF, "slip_mm": 900.0, "dropped": True}])
    moves = compared(toy.project, newer.project).moves
    assert [(move.column.name, move.direction) for move in moves] == [
        ("dropped", "worse")
    ]


def test_what_is_near_the_noise_has_not_flipped(toy):
    (chapter,) = derived(toy.project).chapters.values()

    def flip_count(*outcomes: Outcome) -> int:
        sections = [Section(claims=[Claim("same", outcome)]) for outcome in outcomes]
        return len(
            flips_between(
                *({"toy": replace(chapter, section=section)} for section in sections)
            )
        )

    near, unknown = Outcome("unknown", "near", is_inconclusive=True), Outcome("unknown")
    assert (
        flip_count(HOLDS, near)
        == flip_count(near, FAILS)
        == flip_count(HOLDS, HOLDS)
        == 0
    )
    assert flip_count(HOLDS, unknown) == flip_count(HOLDS, FAILS) == 1


@pytest.mark.parametrize(
    ("before", "after", "moved"),
    [
        (
            {"classes": "creeping, creeping", "drift_mm_s": 1.0},
            {"classes": "creeping, creeping", "drift_mm_s": 2.0},
            1,
        ),
        (
            {"classes": "creeping, creeping", "drift_mm_s": 1.0},
            {"classes": "dropped, creeping", "drift_mm_s": 2.0},
            0,
        ),
        ({"failure": "overflow in frame 3"}, {"failure": "overflow in frame 4"}, 0),
        ({"failure": None}, {"failure": "overflow in frame 4"}, 1),
        ({"peak_contact_count": 7}, {"peak_contact_count": 8}, 0),
        ({"peak_contact_count": 7}, {"peak_contact_count": 9}, 1),
        (
            {"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0},
            {"ms_per_s": 109.0},
            0,
        ),
        (
            {"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0},
            {"ms_per_s": 116.0},
            1,
        ),
        ({"drift_mm_s": 1.0}, {"drift_mm_s": 1.03}, 0),
        (
            {"drift_mm_s": 1.0, "case": "c"},
            {"drift_mm_s": 1.03},
            1,
        ),  # which repeats to the last bit
        ({"substeps": 4, "drift_mm_s": 1.0}, {"substeps": 6, "drift_mm_s": 2.0}, 0),
    ],
)
def test_what_may_be_chance_has_not_moved(toy, newer, before, after, moved):
    toy.measure([SOFT, {**STIFF, **before}])
    newer.measure([SOFT, {**STIFF, **before, **after}])
    assert len(compared(toy.project, newer.project).moves) == moved


AGAIN, ONCE = (
    Estimate(1.0, 0.01, 4.0, 4.0, is_again=True),
    Estimate(2.0, 100.0, 7.0, least=0.5),
)
KNOWN = [(AGAIN, ONCE, 0.0125, 5.882353, 2e-6), (ONCE, AGAIN, 0.0125, 5.882353, 2e-6)]
KNOWN += [
    (AGAIN, AGAIN._replace(value=2.0), 0.005, 8.0, 2e-6),
    (AGAIN, None, 0.0125, 5.882353, 3e-6),
]
KNOWN += [(ONCE, None, 200.0, 14.0, 0.5)]


@pytest.mark.parametrize(("before", "after", "square", "freedom", "least"), KNOWN)
def test_what_was_measured_again_tells_of_what_was_measured_once(
    before, after, square, freedom, least
):
    """By Welch: a mean of four and one, of a variance of 0.01, have (1/400 + 1/100)² / (1/400² + 1/100²) · 4."""
    ends = tuple(each.value if each else 3.0 for each in (before, after))
    [move] = judged([(Move(report().columns["load"], *ends), (before, after), 0.0)])
    assert (move.error**2, move.freedom, move.least) == pytest.approx(
        (square, freedom, least)
    )
    stats = pytest.importorskip("scipy.stats")
    assert move.chance == pytest.approx(
        2 * stats.t.sf((abs(ends[1] - ends[0]) - least) / square**0.5, freedom),
        rel=0.01,
    )
    [seldom] = judged([(Move(report().columns["load"], *ends), (before, after), 0.99)])
    assert seldom.chance == 0.99


def test_a_share_is_sure_beyond_its_noise_whichever_way_it_moves_and_two_of_three_comparisons_tell_a_change():
    """2.5758 deviations are 99 % of a normal distribution: of a fall by 1, 0.05 and 0.25758 are none."""
    load, value = (report().columns[name] for name in ("load", "value"))
    falls, grows = (
        Move(load, *ends, chance=0.0, error=0.1, least=0.05)
        for ends in ((2.0, 1.0), (-2.0, -1.0))
    )
    assert (falls.share, grows.share, falls.noise) == pytest.approx(
        (-0.5, 0.5, 0.30758), rel=1e-4
    )
    assert (
        falls.sure_share
        == grows.sure_share
        == pytest.approx(0.5 * (1 - 0.30758), rel=1e-4)
    )
    assert replace(falls, error=1.0).sure_share == 0.0
    setting = partial(Move, value, 1.0, chance=0.0, rules=report().settings.changes)
    some = [
        setting(after=after, place={"case": f"by {after}", "kind": "option"})
        for after in (1.0001, 0.8)
    ]
    assert [each.exceeds_threshold for each in some] == [False, True] and settings_text(
        some
    ).startswith("by 0.8 ")
    evidence = {
        "a": SimpleNamespace(changed=[(40, 0), (40, 1), (0, 0)]),
        "b": SimpleNamespace(changed=[(20, 3)]),
    }
    found = rate_of(SimpleNamespace(evidence=evidence))
    assert found == {"comparisons": 3, "told": 2, "numbers": 100, "moves": 4}


def test_rows_of_different_releases_or_machines_are_not_compared_by_accident(
    toy, newer
):
    results, other = (
        Results(load_record(each.record_path), each.record_path)
        for each in (toy, newer)
    )
    slips = results.row["soft"].slip_mm, other.row["soft"].slip_mm
    refused = results.value("gain", "one over the other", lambda a, b: a / b, *slips)
    assert refused.value is None
    assert (
        refused.reason
        == "it would compare Newton 1.4.0 on A processor with Newton 1.8.0 on A processor"
    )
    asked = results.value(
        "change",
        "one less the other",
        lambda a, b: b - a,
        *slips,
        unit="mm",
        across=True,
    )
    assert asked.value == pytest.approx(0.4 - 6.3617)
    bound = results.value("bound", "chosen", lambda: 0.1, unit="mm")
    assert greater(*slips).reason == refused.reason
    assert at_most(asked, bound).name == "holds"
    assert Quantity(1.0, "mm", "").bare.striptags() == "n/a", (
        "a number without a place is not shown"
    )
