"""The suites: what the lint says of robot scenes that pip brings."""

from measured_report.parts.claim import Claim, all_of, at_least, decided
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, table_of

order = 186
page = "scenes"
label = "robot suites, linted"

RULES = (
    "slip lost timeconst one-sided pyramid dampratio solimp condim pair unused untouched "
    "priority solref-format override refsafe"
).split()


def derive(results: Results) -> Section:
    suites = [row for row in results.rows if "scene_count" in row]
    warned = [row for row in results.rows if "rule" in row]
    columns: dict[str, Column] = {
        **{"release": "release", "MuJoCo": "mujoco", "scenes": "scene_count", "refused": "refused_count"},
        **{"pairs": "pair_count", "with a warning": "warned_count", "worst creep": "creep_mm_s"},
    }
    found: dict[str, Column] = {"scene": "scene", "rule": "rule", "places": "place_count"}
    return Section(
        tables={
            "suites": table_of("suite", [row.case for row in suites], columns, suites),
            "rules": _rules(results, suites),
            "warned": table_of("suite", [row.suite for row in warned], found, warned),
        },
        claims=[_many_are_read(results, suites), _most_have_no_warning(results, suites), _grips_creep(results, suites)],
    )


def _rules(results: Results, suites: list[Row]) -> Table:
    """Count the scenes in which each rule finds something."""

    def count(rule: str):
        cells = [row[f"{rule.replace('-', '_')}_scene_count"] for row in suites]
        return results.value(f"{rule}_scenes", "scenes in which the rule finds something", _sum, *cells)

    return table_of("rule", RULES, {"scenes": [count(rule) for rule in RULES]})


def _sum(*counts: float) -> float:
    return sum(counts)


def _quiet_share(*found: float) -> float:
    """In percent, of the scenes with a warning and all scenes of each suite in turn."""
    return 100.0 * (1.0 - sum(found[::2]) / sum(found[1::2]))


def _many_are_read(results: Results, suites: list[Row]) -> Claim:
    scenes = results.value("scenes", "scenes that MuJoCo compiles", _sum, *(row.scene_count for row in suites))
    pairs = results.value("pairs", "pairs of their geoms that may touch", _sum, *(row.pair_count for row in suites))
    bound = results.chosen("enough", "scenes that a survey takes", 100)
    return Claim("many_are_read", at_least(scenes, bound), {"scenes": scenes, "pairs": pairs, "bound": bound})


def _most_have_no_warning(results: Results, suites: list[Row]) -> Claim:
    cells = [cell for row in suites for cell in (row.warned_count, row.scene_count)]
    formula = "of the scenes, those in which there is no warning"
    share = results.value("quiet", formula, _quiet_share, *cells, unit="%")
    bound = results.chosen("quiet_bound", "share from which a lint is quiet enough to be used", 90.0, unit="%")
    return Claim("most_have_no_warning", at_least(share, bound), {"share": share, "bound": bound})


def _grips_creep(results: Results, suites: list[Row]) -> Claim:
    """Tell whether a gripped body creeps by what the lint warns of, in any scene."""
    there = [row.creep_mm_s for row in suites if row.creep_mm_s.value is not None]
    count = results.value("slips", "scenes in which a body slips", _sum, *(row.slip_scene_count for row in suites))
    bound = results.chosen("slip_bound", "creep that the lint warns of", 1.0)
    if not there:
        return Claim("grips_creep", decided(False, count), {"count": count, "worst": count})
    worst = results.value("worst", "largest creep of a gripped body", max, *there, unit="mm/s")
    outcome = all_of(decided(bool(count.value), count), at_least(worst, bound))
    return Claim("grips_creep", outcome, {"count": count, "worst": worst})
