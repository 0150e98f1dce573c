"""Several releases: judged, shown and compared without any of them being installed."""

import json
import shutil
from argparse import Namespace
from dataclasses import replace

import pytest
from conftest import MODULE, ROWS, TEMPLATE, Toy

from measured_report import ROOT
from measured_report.changes.compare import Comparison, compare
from measured_report.changes.flips import flips_between
from measured_report.claims.claim import FAILS, HOLDS, Claim, Outcome, at_most, greater
from measured_report.commands import building, findings
from measured_report.deriving.editions import derive_edition, editions_of
from measured_report.editions.environment import requirements
from measured_report.editions.project import Project
from measured_report.editions.stack import stack_of
from measured_report.editions.status import status_matrix
from measured_report.pages.prose import Templates
from measured_report.parts.section import Section
from measured_report.records.provenance import MISSING
from measured_report.records.reading import load_record
from measured_report.records.record import Origin, write_record
from measured_report.site.check import check_site
from measured_report.values.noise import Floor, is_beyond, tolerance
from measured_report.values.quantities import Quantity, mixed
from measured_report.values.results import Results

SOFT, STIFF = ROWS
BETTER = ({**SOFT, "slip_mm": 0.4}, STIFF)
"""A release in which the stiff case gains nothing."""


@pytest.fixture
def newer(toy) -> Toy:
    newer = toy.of("1.8.0")
    newer.measure(BETTER)
    return newer


def compared(*sides: Toy) -> Comparison:
    return compare(*(derive_edition(side.project, Templates(side.project.templates)) for side in sides))


def test_a_release_is_judged_without_being_installed(toy, newer):
    assert newer.state().kind == "fresh"
    write_record(newer.record_path, newer.record(BETTER, identity=toy.record().identity))
    assert newer.state().notes == ("packages: newton 1.4.0 → 1.8.0",)


def test_the_newest_record_of_a_release_says_which_packages_belong_to_it(toy):
    newer = toy.of("99.0.0")  # one that is installed nowhere
    newer.measure()
    newer.write("report/sections/other.py", "order = 2\n")
    newer.write("experiments/other.py", "")
    shutil.copy(newer.record_path, newer.project.record_path("other"))
    identity = replace(newer.record().identity, packages={**newer.packages, "warp-lang": "9.9"})
    later = {**newer.record().measured, "date": "2026-06-07T00:00:00+00:00"}
    write_record(newer.project.record_path("other"), newer.record(identity=identity, section="other", measured=later))
    assert newer.state().summary == "stale: packages"
    assert newer.state().notes[0].endswith("→ 9.9")


def test_the_matrix_has_a_column_for_each_release(toy, newer):
    assert status_matrix(toy.project).splitlines()[1].split() == ["toy", "fresh", "fresh"]
    toy.of("1.5.0").project.results.mkdir()
    newer.write("assets/robot.urdf", "<robot name='other'/>")
    matrix = status_matrix(toy.project).splitlines()
    assert matrix[0].split() == ["section", "newton", "1.4.0", "newton", "1.8.0"]
    assert matrix[1].split() == ["toy", "stale:", "config", "stale:", "config"]


def test_every_release_has_a_page_and_every_section_leads_to_the_others(toy, newer):
    toy.build()
    site = toy.project.site
    other = (site / "newton-1.8.0/evidence.html").read_text()
    assert 'href="newton-1.8.0/evidence.html#toy"' in toy.page and 'href="newton-1.8.0/index.html"' in toy.front
    assert 'href="../evidence.html#toy"' in other
    assert 'data-claim="toy.helps" data-outcome="holds"' in toy.page
    assert 'data-claim="toy.helps" data-outcome="fails"' in other
    assert 'data-src="newton-1.8.0/toy.json#/rows/1/slip_mm"' in other
    assert "make rerun SECTION=toy NEWTON=1.8.0" in other and "NEWTON" not in toy.page
    assert (site / "data/newton-1.8.0/toy.json").is_file()
    assert check_site(site) == []


def test_the_release_asked_for_is_the_first_page(toy, newer):
    newer.build()
    assert "<b>Newton 1.8.0</b>" in newer.page.replace(' aria-current="true"', "")
    assert 'href="newton-1.4.0/evidence.html"' in newer.page
    assert check_site(toy.project.site) == []


def test_a_page_is_written_again_only_when_something_changed(toy, newer):
    toy.build()
    page = toy.project.site / "newton-1.8.0/evidence.html"
    before = page.stat()
    toy.build()
    assert (page.stat().st_mtime_ns, page.stat().st_ino) == (before.st_mtime_ns, before.st_ino)
    newer.measure(ROWS)
    toy.build()
    assert (page.stat().st_mtime_ns, page.stat().st_ino) != (before.st_mtime_ns, before.st_ino)


def test_the_check_follows_links_to_other_pages(toy, newer):
    toy.build()
    page = toy.project.site / "newton-1.8.0/evidence.html"
    page.write_text(page.read_text().replace('id="toy"', 'id="other"').replace('href="#toy"', 'href="#other"'))
    problems = check_site(toy.project.site)
    assert "evidence.html: newton-1.8.0/evidence.html#toy leads nowhere" in problems
    assert "newton-1.8.0/index.html: evidence.html#toy leads nowhere" in problems


def test_a_record_that_derive_breaks_on_is_left_out_with_the_line_that_does(toy):
    toy.write("report/sections/toy.py", MODULE.replace("rows = results.rows", "rows = results.rows[5:]; rows[0]"))
    assert building.page(toy.project, Namespace(stack=stack_of("1.4.0"), address="")) == 1
    assert "newton-1.4.0/toy.json: its record lacks what the section is about (IndexError: list index" in toy.page
    toy.write("experiments/scene.py", "def slip():\n    return 2\n")
    toy.build()
    assert "<b>toy</b> is left out" in toy.page and "IndexError" in toy.page


def test_a_diff_names_what_moved_and_what_flipped(toy, newer, capsys):
    arguments = Namespace(a=stack_of("1.4.0"), b=stack_of("1.8.0"), format="text", values="all")
    assert findings.diff(toy.project, arguments) == 1
    said = capsys.readouterr().out
    flips, _, moves = said.partition("toy: 1 values moved (1 better)")
    assert "toy.helps: holds → not shown\n  It helps 20 times.\n  It does not." in flips
    assert "soft  slip_mm: 6.4 mm → 0.40 mm" in moves and "stiff" not in said
    newer.measure(ROWS)
    assert findings.diff(toy.project, arguments) == 0


def test_a_dropped_cube_is_compared_as_dropped_and_not_by_how_far_it_fell(toy, newer):
    newer.measure([SOFT, {**STIFF, "slip_mm": 900.0, "dropped": True}])
    moves = compared(toy, newer).moves
    assert [(move.column, move.direction) for move in moves] == [("dropped", "worse")]


def test_what_is_near_the_noise_has_not_flipped(toy):
    (chapter,) = derive_edition(toy.project, Templates(toy.project.templates)).chapters.values()

    def flip_count(*outcomes: Outcome) -> int:
        sections = [Section(claims=[Claim("same", outcome)]) for outcome in outcomes]
        return len(flips_between(*({"toy": replace(chapter, section=section)} for section in sections)))

    near, unknown = Outcome("unknown", "near", is_near=True), Outcome("unknown")
    assert flip_count(HOLDS, near) == flip_count(near, FAILS) == flip_count(HOLDS, HOLDS) == 0
    assert flip_count(HOLDS, unknown) == flip_count(HOLDS, FAILS) == 1


@pytest.mark.parametrize(
    ("before", "after", "moved"),
    [
        ({"classes": "creeping, creeping", "drift_mm_s": 1.0}, {"classes": "creeping, creeping", "drift_mm_s": 2.0}, 1),
        ({"classes": "creeping, creeping", "drift_mm_s": 1.0}, {"classes": "dropped, creeping", "drift_mm_s": 2.0}, 0),
        ({"failure": "overflow in frame 3"}, {"failure": "overflow in frame 4"}, 0),
        ({"failure": None}, {"failure": "overflow in frame 4"}, 1),
        ({"peak_contact_count": 7}, {"peak_contact_count": 8}, 0),
        ({"peak_contact_count": 7}, {"peak_contact_count": 9}, 1),
        ({"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0}, {"ms_per_s": 109.0}, 0),
        ({"ms_per_s": 100.0, "ms_per_s_p5": 99.0, "ms_per_s_p95": 101.0}, {"ms_per_s": 112.0}, 1),
        ({"substeps": 4, "drift_mm_s": 1.0}, {"substeps": 6, "drift_mm_s": 2.0}, 0),
    ],
)
def test_what_may_be_chance_has_not_moved(toy, newer, before, after, moved):
    toy.measure([SOFT, {**STIFF, **before}])
    newer.measure([SOFT, {**STIFF, **before, **after}])
    assert len(compared(toy, newer).moves) == moved


def test_what_counts_as_moved():
    assert not is_beyond(0.01, 1.0, 1.009) and is_beyond(0.01, 1.0, 1.02)
    assert not is_beyond(0.0, 6.0, 6.005), "rounding"
    assert Floor(spread=0.01, magnitude=5.0).at(1.0) == 0.01
    assert Floor(spread=0.01, magnitude=5.0).at(10.0, -20.0) == pytest.approx(0.04)


def test_the_noise_is_what_nearly_all_pairs_stay_within():
    """χ² at 39 degrees of freedom and 0.05 is 25.695, and the normal distribution has 0.9995 of it below 3.2905."""
    runs = [6.36 + 0.001 * (-1) ** index for index in range(40)]
    deviation = 0.001 * (40 / 39) ** 0.5
    assert tolerance(runs) == pytest.approx(2**0.5 * 3.2905 * deviation * (39 / 25.695) ** 0.5, rel=1e-3)
    assert tolerance([*runs, 7.36]) == pytest.approx(1.001), "never less than what was seen"
    assert tolerance([6.36] * 40) == 0.0 and tolerance([1.0, 1.5]) == 0.5


def test_speed_is_compared_on_one_machine_only(toy, newer):
    rows = [{**SOFT, "frame_ms": 10.0}, {**STIFF, "frame_ms": 5.0}]
    toy.measure(rows)
    newer.measure([{**row, "frame_ms": row["frame_ms"] / 2} for row in rows])
    assert [move.column for move in compared(toy, newer).moves] == ["frame_ms"] * 2
    record = load_record(newer.record_path)
    write_record(newer.record_path, replace(record, machine={**record.machine, "cpu": "Another"}))
    found = compared(toy, newer)
    assert found.moves == []
    cores = "an unknown number of cores"
    assert found.notes == [f"speed and cost in toy: measured on A processor, {cores} and on Another, {cores}"]


def test_rows_of_different_releases_are_not_compared_by_accident(toy, newer):
    results, other = (Results(load_record(each.record_path), each.record_path) for each in (toy, newer))
    slips = results.row["soft"].slip_mm, other.row["soft"].slip_mm
    refused = results.value("gain", "one over the other", lambda a, b: a / b, *slips)
    assert refused.value is None
    assert refused.reason == "it would compare Newton 1.4.0 on A processor with Newton 1.8.0 on A processor"
    asked = results.value("change", "one less the other", lambda a, b: b - a, *slips, across=True)
    assert asked.value == pytest.approx(0.4 - 6.3617)
    noise = results.value("noise", "chosen", lambda: 0.1, unit="mm")
    assert greater(*slips, noise=noise).reason == refused.reason
    assert at_most(asked, noise).name == "holds"


def test_machines_mix_as_little_as_releases():
    here, there = (frozenset({Origin("1.4.0", processor)}) for processor in ("GPU", "CPU"))
    assert mixed(here, here, frozenset()) == ""
    assert "CPU" in mixed(here, there)
    assert Quantity(1.0, "mm", "").bare.striptags() == "n/a", "a number without a place is not shown"


def test_a_command_names_the_release_where_it_is_not_the_project_s_own():
    assert Project("1.4.0", own_release="1.4.0").rerun("gap") == "make rerun SECTION=gap"
    other = Project("99.0", "quick", own_release="1.4.0").rerun("gap", "cpu")
    assert other == "make rerun SECTION=gap DEVICE=cpu NEWTON=99.0 PROFILE=quick"


def test_an_environment_takes_the_project_s_requirements_and_the_release_s_packages():
    packages = {"newton": "1.8.0", "warp-lang": "1.19.0", "mujoco-warp": MISSING, "mujoco": MISSING}
    found = requirements(ROOT, packages)
    assert {"newton[sim]==1.8.0", "warp-lang==1.19.0"} <= set(found)
    assert any(name.startswith("pandas") for name in found)
    assert not any(name.startswith("mujoco") or "1.4.0" in name for name in found)


UPGRADE_ROWS = {
    "1.4.0": {"as-shipped": (6.36, 0.0), "as-shipped-friction-timeconst-on": (0.32, 0.002)},
    "1.8.0": {"as-shipped": (0.32, 6e-5), "as-shipped-friction-timeconst-off": (6.35, 0.0)},
}


def measure_upgrade(toy: Toy, release: str, slips: dict[str, tuple[float, float]]) -> Project:
    rows = [
        {"case": case, "kind": "run", "slip_mm": slip, "timeconst_s": 0.02, "friction_timeconst_s": friction}
        for case, (slip, friction) in slips.items()
    ]
    rows.append({"case": "option-cone", "kind": "option", "name": "cone", "value": "elliptic"})
    project = toy.of(release).project
    write_record(project.record_path("upgrade"), toy.of(release).record(rows, section="upgrade"))
    return project


@pytest.fixture
def upgraded(toy) -> Toy:
    """The real section on releases, beside one that stands for the noise."""
    shutil.copytree(ROOT / "report/sections/upgrade", toy.project.root / "report/sections/upgrade")
    toy.write(
        "templates/sections/upgrade.md.j2", (ROOT / "templates/sections/upgrade.md.j2").read_text(encoding="utf-8")
    )
    toy.write("templates/sources.toml", (ROOT / "templates/sources.toml").read_text(encoding="utf-8"))
    toy.write("experiments/upgrade.py", EXPERIMENT_OF_RELEASES)
    floor = 'results.value("{0}_floor", "chosen", lambda: 0.01, unit="{1}")'
    toy.write(
        "report/sections/noise.py",
        "from measured_report.parts.section import Section\n\norder = 0\n\n\ndef derive(results):\n"
        f"    {floor.format('slip', 'mm')}\n    {floor.format('drift', 'mm/s')}\n    return Section()\n",
    )
    toy.write("templates/sections/noise.md.j2", "# Noise\n")
    toy.write("experiments/noise.py", EXPERIMENT_OF_RELEASES)
    rows = [{"case": "a", "of": "as-shipped", "slip_mm": 1.0}]
    write_record(toy.project.record_path("noise"), toy.record(rows, section="noise"))
    return toy


EXPERIMENT_OF_RELEASES = "from experiments.scene import slip\n"


def outcomes(project: Project) -> dict[str, str]:
    chapter = editions_of(project, Templates(project.templates))[project.release].chapters["upgrade"]
    return {claim.name: claim.outcome.name for claim in chapter.section.claims}


def test_the_cause_is_what_brings_the_old_number_back(upgraded):
    upgraded.of("1.8.0").measure()
    for release, slips in UPGRADE_ROWS.items():
        measure_upgrade(upgraded, release, slips)
    found = outcomes(upgraded.project)
    assert found["slip_is_the_same"] == "fails"
    assert found["friction_timeconst_is_new"] == "holds"
    assert found["taking_it_away_brings_it_back"] == found["giving_it_does_the_same"] == found["cause"] == "holds"
    assert found["release_has_a_switch"] == found["in_one_step"] == "unknown"
    upgraded.build()
    assert check_site(upgraded.project.site) == []
    worse = {**UPGRADE_ROWS["1.8.0"], "as-shipped-friction-timeconst-off": (0.9, 0.0)}
    measure_upgrade(upgraded, "1.8.0", worse)
    assert outcomes(upgraded.project)["cause"] == "fails"


def test_claims_that_turned_are_said_in_both_ways(upgraded):
    for release, slips in UPGRADE_ROWS.items():
        measure_upgrade(upgraded, release, slips)
    upgraded.write("templates/sections/toy.md.j2", TEMPLATE.replace("It does not.", "It does not, {{ gain }} times."))
    upgraded.of("1.8.0").measure(BETTER)
    upgraded.build()
    turned = (upgraded.project.site / "releases.html").read_text(encoding="utf-8").partition('class="turns"')[2]
    assert "toy</a>: whether it helps" in turned
    assert "In 1.4.0:</b> It helps" in turned and "In 1.8.0:</b> It does not" in turned
    assert 'data-src="values.json#/toy/gain"' in turned
    assert 'data-src="newton-1.8.0/values.json#/toy/gain"' in turned
    assert check_site(upgraded.project.site) == []


def test_what_one_release_cannot_tell_is_listed_and_counted_by_itself(upgraded):
    for release, slips in UPGRADE_ROWS.items():
        measure_upgrade(upgraded, release, slips)
    newer = upgraded.of("1.8.0")
    newer.measure([SOFT, {**STIFF, "slip_mm": None, "slip_mm_reason": "as a test"}])
    rows = [{"case": "a", "of": "as-shipped", "slip_mm": 1.0}]  # without it a section is missing
    write_record(newer.project.record_path("noise"), newer.record(rows, section="noise"))
    upgraded.build()
    turned = (upgraded.project.site / "releases.html").read_text(encoding="utf-8").partition('class="turns"')[2]
    assert "toy</a>: whether it helps" in turned and "Cannot be told in 1.8.0:</b> as a test" in turned
    values = json.loads((upgraded.project.site / "data/values.json").read_text())["upgrade"]
    assert (values["turned_count"]["value"], values["undecided_count"]["value"]) == (0, 1)


def test_one_release_alone_tells_nothing(upgraded):
    measure_upgrade(upgraded, "1.4.0", UPGRADE_ROWS["1.4.0"])
    assert set(outcomes(upgraded.project).values()) == {"unknown"}
    upgraded.build()
    assert check_site(upgraded.project.site) == []


def test_the_page_of_an_edition_speaks_of_that_edition(upgraded):
    measure_upgrade(upgraded, "1.4.0", UPGRADE_ROWS["1.4.0"])
    for release in ("1.6.0", "1.8.0"):
        measure_upgrade(upgraded, release, UPGRADE_ROWS["1.8.0"])
    editions = editions_of(upgraded.project, Templates(upgraded.project.templates))
    ends = {}
    for release, edition in editions.items():
        claims = {claim.name: claim for claim in edition.chapters["upgrade"].section.claims}
        ends[release] = tuple(claims["slip_is_the_same"].numbers[side] for side in "ab")
    assert ends == {"1.4.0": ("1.4.0", "1.8.0"), "1.6.0": ("1.4.0", "1.6.0"), "1.8.0": ("1.4.0", "1.8.0")}
