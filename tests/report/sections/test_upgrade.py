"""The section on releases: what changed between them, and its cause."""

import shutil

import pytest
from toys import ROWS, TEMPLATE, Toy

from measured_report.editions.project import Project
from measured_report.files.root import ROOT
from measured_report.findings.editions import editions_of
from measured_report.records.record import write_record
from measured_report.site.check import check_site

SOFT, STIFF = ROWS


UPGRADE_ROWS = {
    "1.4.0": {"as-shipped": (6.36, 0.0), "as-shipped-friction-timeconst-on": (0.32, 0.002)},
    "1.8.0": {"as-shipped": (0.32, 6e-5), "as-shipped-friction-timeconst-off": (6.35, 0.0)},
    "neither": {"as-shipped": (0.32, 6e-5), "as-shipped-friction-timeconst-off": (0.9, 0.0)},
}
ENDS = {"1.4.0": "1.4.0", "1.8.0": "1.8.0"}
NOISE = """from measured_report.parts.section import Section

order = 0


def derive(results):
    for name, unit in (("slip", "mm"), ("drift", "mm/s")):
        results.value(f"{name}_floor", "chosen", lambda: 0.01, unit=unit)
    return Section()
"""


def measure_upgrade(toy: Toy, ends: dict[str, str]) -> None:
    """Measure the section on these releases, as one of the two ends gave it."""
    for release, end in ends.items():
        rows = [
            {"case": case, "kind": "run", "slip_mm": slip, "timeconst_s": 0.02, "friction_timeconst_s": friction}
            for case, (slip, friction) in UPGRADE_ROWS[end].items()
        ]
        rows.append({"case": "option-cone", "kind": "option", "name": "cone", "value": "elliptic"})
        side = toy.of(release)
        write_record(side.project.record_path("upgrade"), side.record(rows, section="upgrade"))


@pytest.fixture
def upgraded(toy) -> Toy:
    """The real section on releases, beside one that stands for the noise."""
    shutil.copytree(ROOT / "report/sections/upgrade", toy.project.root / "report/sections/upgrade")
    for name in ("templates/sections/upgrade.md.j2", "templates/sources.toml"):
        toy.write(name, (ROOT / name).read_text(encoding="utf-8"))
    toy.write("report/sections/noise.py", NOISE)
    toy.write("templates/sections/noise.md.j2", "# Noise\n")
    for name in ("upgrade", "noise"):
        toy.write(f"experiments/{name}.py", "from experiments.scene import slip\n")
    rows = [{"case": "a", "of": "as-shipped", "slip_mm": 1.0}]
    write_record(toy.project.record_path("noise"), toy.record(rows, section="noise"))
    return toy


def outcomes(project: Project) -> dict[str, str]:
    chapter = editions_of(project)[project.release].chapters["upgrade"]
    return {claim.name: claim.outcome.name for claim in chapter.section.claims}


def test_the_cause_is_what_brings_the_old_number_back(upgraded):
    upgraded.of("1.8.0").measure()
    measure_upgrade(upgraded, ENDS)
    found = outcomes(upgraded.project)
    assert found["slip_is_the_same"] == "fails"
    assert found["friction_timeconst_is_new"] == "holds"
    assert found["taking_it_away_brings_it_back"] == found["giving_it_does_the_same"] == found["cause"] == "holds"
    assert found["release_has_a_switch"] == found["in_one_step"] == "unknown"
    upgraded.build()
    assert check_site(upgraded.project.site) == []
    measure_upgrade(upgraded, {"1.8.0": "neither"})
    assert outcomes(upgraded.project)["cause"] == "fails"


def test_claims_that_turned_are_said_as_other_releases_say_them(upgraded):
    measure_upgrade(upgraded, ENDS)
    upgraded.write("templates/sections/toy.md.j2", TEMPLATE.replace("It does not.", "It does not, {{ gain }} times."))
    for release, slip in (("1.6.0", 0.4), ("1.7.0", 0.4), ("1.8.0", 0.5)):
        upgraded.of(release).measure([{**SOFT, "slip_mm": slip}, STIFF])
    upgraded.build()
    assert check_site(upgraded.project.site) == []
    said = (upgraded.project.site / "releases.html").read_text(encoding="utf-8").partition('class="turns"')[2]
    assert ">toy</a></dt>" in said and "It helps" not in said
    assert "<b>1.8.0:</b> It does not" in said and "So too: 1.6.0, 1.7.0." in said
    assert 'data-src="newton-1.8.0/values.json#/toy/gain"' in said
