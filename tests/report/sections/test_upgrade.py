"""Test the changes between releases, and their cause."""

import shutil
from dataclasses import replace

import pytest
from deriving import chapters_with, found_in, near, only, results_with
from toys import ROWS, TEMPLATE, Toy

from measured_report.editions.project import Project
from measured_report.files.root import ROOT
from measured_report.findings.editions import editions_of
from measured_report.pages.prose import Templates
from measured_report.records.record import write_record
from measured_report.site.check import check_site
from report.sections import upgrade

SOFT, STIFF = ROWS


UPGRADE_ROWS = {
    "1.4.0": {
        "as-shipped": (6.36, 0.0),
        "as-shipped-friction-timeconst-on": (0.32, 0.002),
    },
    "1.8.0": {
        "as-shipped": (0.32, 6e-5),
        "as-shipped-friction-timeconst-off": (6.35, 0.0),
    },
    "neither": {
        "as-shipped": (0.32, 6e-5),
        "as-shipped-friction-timeconst-off": (0.9, 0.0),
    },
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
    """Return the section as the oldest or the newest of these releases derives it."""
    for release, end in ends.items():
        rows = [
            {
                "case": case,
                "kind": "run",
                "slip_mm": slip,
                "timeconst_s": 0.02,
                "friction_timeconst_s": friction,
            }
            for case, (slip, friction) in UPGRADE_ROWS[end].items()
        ]
        rows.append(
            {
                "case": "option-cone",
                "kind": "option",
                "name": "cone",
                "value": "elliptic",
            }
        )
        side = toy.of(release)
        write_record(
            side.project.record_path("upgrade"), side.record(rows, section="upgrade")
        )


@pytest.fixture
def upgraded(toy) -> Toy:
    """Return the real section on releases, and one that provides the noise."""
    shutil.copytree(
        ROOT / "report/sections/upgrade", toy.project.root / "report/sections/upgrade"
    )
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
    assert (
        found["taking_it_away_brings_it_back"]
        == found["giving_it_does_the_same"]
        == found["cause"]
        == "holds"
    )
    assert found["release_has_a_switch"] == found["in_one_step"] == "unknown"
    upgraded.build()
    assert check_site(upgraded.project.site) == []
    measure_upgrade(upgraded, {"1.8.0": "neither"})
    assert outcomes(upgraded.project)["cause"] == "fails"


def test_claims_that_turned_are_said_as_other_releases_say_them(upgraded):
    measure_upgrade(upgraded, ENDS)
    upgraded.write(
        "templates/sections/toy.md.j2",
        TEMPLATE.replace("It does not.", "It does not, {{ gain }} times."),
    )
    for release, slip in (("1.6.0", 0.4), ("1.7.0", 0.4), ("1.8.0", 0.5)):
        upgraded.of(release).measure([{**SOFT, "slip_mm": slip}, STIFF])
    upgraded.build()
    assert check_site(upgraded.project.site) == []
    said = (
        (upgraded.project.site / "releases.html")
        .read_text(encoding="utf-8")
        .partition('class="turns"')[2]
    )
    assert ">toy</a></dt>" in said and "It helps" not in said
    assert "<b>1.8.0:</b> It does not" in said and "The same for 1.6.0, 1.7.0." in said
    assert 'data-src="newton-1.8.0/values.json#/toy/gain"' in said


OLD = {
    "noise": {},
    "speed": {
        "*": {
            "frame_ms": 10,
            "frame_ms_p5": 9.9,
            "frame_ms_p95": 10.1,
            "repeat_count": 1,
        }
    },
    "upgrade": {
        "as-shipped": {"slip_mm": 6, "friction_timeconst_s": 0},
        "as-shipped-mujoco-contacts": {"slip_mm": 6},
        "as-shipped-friction-timeconst-on": {"slip_mm": 0.35},
    },
    "solver": {"cone-pyramidal": {"slip_mm": 6}},
    "reproduction": {"as-shipped-mujoco-c": {"slip_mm": 6}},
}
"""Rows of a release in which the cube slips 6 mm."""
CHANGES = {
    "upgrade": {
        "as-shipped": {"slip_mm": 0.3, "friction_timeconst_s": 0.002},
        "as-shipped-mujoco-contacts": {"slip_mm": 6.2},
        "as-shipped-friction-timeconst-off": {"slip_mm": 5.9},
        "as-shipped-kf-off": {"slip_mm": 5.8},
    },
    "solver": {"cone-pyramidal": {"slip_mm": 5.75}},
    "reproduction": {"as-shipped-mujoco-c": {"slip_mm": 6.28}},
}
"""Cells that differ in a newer release."""


def found_between(**releases) -> dict:
    results = results_with("upgrade", release="1.8.0")
    chapters = {
        name: chapters_with(*changes, release=name)
        for name, changes in releases.items()
    }
    return found_in(upgrade.derive(results, chapters), results)


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {},
            {
                "slip_change": -95,
                "slip_step_1.5.0": 0,
                "slip_step_1.8.0": -95,
                "slip_is_the_same": "the opposite",
                "slip_is_the_same/grows": False,
                "taken_share": 98.24561,
                "taken_share_miss": 1.754386,
                "given_share": 99.12281,
                "off_share": 96.49123,
                "friction_timeconst_is_new": "holds",
                "cause": "holds",
                "taking_it_away_brings_it_back": "holds",
                "giving_it_does_the_same": "holds",
                "release_has_a_switch": "holds",
                "elsewhere_change": 4.666667,
                "mujoco_contacts_as_before": "holds",
                "pyramid_change": 4.166667,
                "pyramid_as_before": "holds",
                "frame_ratio_least": 1,
                "frame_ratio_most": 1,
                "frame_change": 0,
                "same_speed": "holds",
                "same_speed/device": "GPU",
                "in_one_step": "holds",
                "claims_stand": "holds",
            },
        ),
        (
            {
                "upgrade": {
                    "as-shipped-friction-timeconst-off": {"slip_mm": 5.6},
                    "as-shipped-kf-off": {"slip_mm": 7},
                },
                "reproduction": {"as-shipped-mujoco-c": {"slip_mm": 6.4}},
                "solver": {"cone-pyramidal": {"slip_mm": 5.6}},
                "speed": {"*": {"frame_ms": 12}},
            },
            {
                "taken_share_miss": 7.017544,
                "taking_it_away_brings_it_back": "fails",
                "cause": "fails",
                "mujoco_contacts_as_before": "fails",
                "pyramid_as_before": "fails",
                "same_speed": "the opposite",
                "release_has_a_switch": "fails",
            },
        ),
        (
            {
                "speed": {"*": {"frame_ms": 8}},
                "upgrade": {"as-shipped": {"friction_timeconst_s": 0}},
            },
            {"same_speed": "the opposite", "friction_timeconst_is_new": "fails"},
        ),
        (
            {"speed": {"*": {"frame_ms": 8}, "fixed": {"frame_ms": 12}}},
            {
                "frame_ratio_least": 0.8,
                "frame_ratio_most": 1.2,
                "frame_change": 20,
                "same_speed": "the opposite",
            },
        ),
        (
            {"upgrade": {"as-shipped": {"slip_mm": 6.03}}},
            {
                "slip_change": 0.5,
                "slip_is_the_same": "holds",
                "cause": "cannot tell",
                "in_one_step": "cannot tell",
            },
        ),
        (
            {"upgrade": {"as-shipped": {"slip_mm": 7}}},
            {"slip_is_the_same": "the opposite", "slip_is_the_same/grows": True},
        ),
        (
            {"upgrade": {"as-shipped": {"slip_mm": 6.06}}},
            {"slip_change": 1, "slip_is_the_same": "cannot tell"},
        ),
    ],
)
def test_what_changed_follows_from_the_cells_of_two_releases(changes, expected):
    releases = {"1.4.0": [OLD], "1.5.0": [OLD], "1.8.0": [OLD, CHANGES, changes]}
    assert only(found_between(**releases), expected) == near(expected)


def test_a_release_that_changes_nothing_is_said_to_be_the_same_and_within_what():
    """Test that no number is more precise than 0.05 %, and no difference of two numbers
    more precise than √2 times that. The time of a frame that was measured once differs
    between hosts by more than the bound.
    """
    same = [OLD, {"upgrade": {"as-shipped": {"slip_mm": 6.0}}}]
    same.append({"speed": {"*": {"frame_ms": 10.0}}})
    found = found_between(**{"1.4.0": same, "1.8.0": same})
    assert only(found, ["slip_is_the_same", "slip_change", "same_speed"]) == {
        "slip_is_the_same": "holds",
        "slip_change": 0,
        "same_speed": "cannot tell",
    }
    assert found["slip_within"] == pytest.approx(0.05 * 2**0.5, rel=0.01)
    assert 5 < found["frame_within"] < 20
    chapters = {name: chapters_with(*same, release=name) for name in ("1.4.0", "1.8.0")}
    section = upgrade.derive(results_with("upgrade", release="1.8.0"), chapters)
    words = Templates(ROOT / "templates").words("sections/upgrade.md.j2")
    said = {
        claim.name: replace(claim, wording=words["claim", claim.name]).text
        for claim in section.claims
        if ("claim", claim.name) in words
    }
    assert said["slip_is_the_same"].startswith(
        "With shipped pads the cube slips as far in Newton 1.8.0 as in Newton 1.4.0, within 0."
    )
    assert "the bound of 5 % lies within the interval 0" in said["same_speed"]
    assert not [text for text in said.values() if "it would compare" in text]


@pytest.mark.parametrize(
    ("between", "outcome"),
    [
        ({"1.5.0": [OLD]}, "holds"),
        ({"1.5.0": [OLD, {"upgrade": {"as-shipped": {"slip_mm": 3}}}]}, "fails"),
        ({}, "cannot tell"),
    ],
    ids=["one step", "two steps", "no release between"],
)
def test_a_slip_falls_in_one_step_or_in_two(between, outcome):
    releases = {"1.4.0": [OLD], **between, "1.8.0": [OLD, CHANGES]}
    assert found_between(**releases)["in_one_step"] == outcome
