"""The survey: what the lint says of the examples that Newton ships, release by release."""

from collections.abc import Mapping, Sequence
from itertools import zip_longest

from measured_report.claims.claim import FAILS, HOLDS, Claim, Outcome, all_of, at_least, decided
from measured_report.deriving.chapters import Releases
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, cell_count, table_of

order = 185
page = "scenes"
label = "Newton's examples, linted"

RULES = {
    rule: f"{rule.replace('-', '_')}_count"
    for rule in ("priority", "default-gap", "timeconst", "ke-without-kd", "dampratio", "kf", "unused")
}
"""Columns that count what a rule finds, by the rule."""
MUJOCO = "SolverMuJoCo"
UNDAMPED = ("newton_cradle-mujoco", "domino_spiral-mujoco", "balance_bird-mujoco")
"""Examples that author a ke with a kd of 0 and can be solved by MuJoCo."""


def derive(results: Results, releases: Releases) -> Section:
    surveys = {release: chapters["survey"].results for release, chapters in releases.items() if "survey" in chapters}
    ends = list(surveys.values())[:: len(surveys) - 1] if len(surveys) > 1 else []
    changed = _changed(*ends) if ends else []
    linted = _linted(results)
    solved = [row for row in linted if row.solver == MUJOCO]
    lost = (row for row in results.rows if "unbuilt" in row and row.unbuilt)
    unbuilt = sorted(lost, key=lambda row: (row.unbuilt, row.case))
    return Section(
        tables={
            "rules": _rule_table(results, surveys),
            "scenes": _scene_table(results, [row for row in solved if row.finding_count.value]),
            "others": _scene_table(results, [row for row in linted if row.solver != MUJOCO]),
            "changed": _changed_table(ends, changed),
            "unbuilt": table_of("example", [row.case for row in unbuilt], {"why": "unbuilt"}, unbuilt),
        },
        claims=[
            _many_are_linted(results, linted),
            _mujoco_scenes_say_what_is_not_done(results, solved),
            _names_the_undamped(results),
            _releases_differ(results, ends, changed),
        ],
    )


def _linted(results: Results) -> list[Row]:
    return [row for row in results.rows if "unbuilt" in row and not row.unbuilt]


def _many_are_linted(results: Results, linted: Sequence[Row]) -> Claim:
    shapes, formula = [row.shape_count for row in linted], "examples of which the shapes were counted"
    count = results.value("linted", formula, lambda *found: sum(each >= 0 for each in found), *shapes)
    bound = results.chosen("enough", "examples that a survey takes", 40)
    return Claim("many_are_linted", at_least(count, bound), {"count": count, "bound": bound})


def _mujoco_scenes_say_what_is_not_done(results: Results, solved: Sequence[Row]) -> Claim:
    counts = [row.finding_count for row in solved]
    every = cell_count(results, "solved", "examples that MuJoCo solves", counts)
    some = results.value("found", "of those, how many have a finding", _positive_count, *counts)
    outcome = decided(bool(some.value), every, some)
    return Claim("shipped_scenes_have_findings", outcome, {"count": some, "all": every})


def _positive_count(*counts: float) -> int:
    return sum(count > 0 for count in counts)


def _names_the_undamped(results: Results) -> Claim:
    if any(case not in results.row for case in UNDAMPED):
        return Claim("names_the_undamped", Outcome("unknown", "this release does not have all three, or not linted"))
    counts = [results.row[case].ke_without_kd_count for case in UNDAMPED]
    return Claim("names_the_undamped", all_of(*(decided(bool(count.value), count) for count in counts)))


def _findings(results: Results, case: str) -> list[Row]:
    return [row for row in results.rows if "rule" in row and row.scene == case]


def _authored(row: Row) -> Quantity:
    return next((row[column] for column in ("authored_s", "authored_m") if column in row), row.authored)


def _changed(old: Results, new: Results) -> list[str]:
    """List the examples of two surveys in which another thing is found, or the same with another value."""

    def told(results: Results, case: str) -> list[tuple[str, str, float | None]]:
        return [(row.rule, row.parameter, _authored(row).value) for row in _findings(results, case)]

    both = {row.case for row in _linted(new)}
    return [row.case for row in _linted(old) if row.case in both and told(old, row.case) != told(new, row.case)]


def _releases_differ(results: Results, ends: Sequence[Results], changed: Sequence[str]) -> Claim:
    """Tell whether an example that the oldest and the newest survey have has other findings in the newer of them."""
    if not ends:
        alone = "only one release was surveyed"
        return Claim("releases_differ", Outcome("unknown", alone), {"count": absent("1", alone)})
    cells = [_authored(row) for side in ends for row in side.rows if "rule" in row]
    formula = "examples of both releases of which another rule, parameter or value is found"
    count = results.value("changed", formula, lambda *_: len(changed), *cells, across=True)
    outcome = Outcome("unknown", count.reason) if count.value is None else HOLDS if changed else FAILS
    return Claim("releases_differ", outcome.having_read(count), {"count": count})


def _changed_table(ends: Sequence[Results], changed: Sequence[str]) -> Table:
    """Show what is authored in the examples that changed, or words where it is not found, release beside release."""
    lines: list[tuple] = []
    for case in changed:
        found: list[dict[tuple[str, str], list[Quantity]]] = [{}, {}]
        for side, at in zip(ends, found, strict=True):
            for row in _findings(side, case):
                at.setdefault((row.rule, row.parameter), []).append(_authored(row))
        for said in found[0] | found[1]:
            values = zip_longest(*(at.get(said, []) for at in found), fillvalue="nothing")
            lines += [(case, *said, *cells) for cells in values]
    names = ["rule", "parameter", *(side.edition for side in ends)]
    columns = {name: [line[place] for line in lines] for place, name in enumerate(names, start=1)}
    return table_of("example", [line[0] for line in lines], columns)


def _rule_table(results: Results, surveys: Mapping[str, Results]) -> Table:
    """Count the examples in which each rule finds something, by release."""

    def count(release: str, rule: str) -> Quantity:
        cells = [row[RULES[rule]] for row in _linted(surveys[release])]
        formula = "examples in which the rule finds something"
        return results.value(f"{rule}_in_{release}", formula, _positive_count, *cells, across=True)

    return table_of("rule", RULES, {release: [count(release, rule) for rule in RULES] for release in surveys})


def _scene_table(results: Results, rows: Sequence[Row]) -> Table:
    """Show a line for each thing that is found in these examples."""
    found = [finding for row in rows for finding in _findings(results, row.case)]
    columns: dict[str, Column] = {
        "solver": lambda row: results.row[row.scene].solver.removeprefix("Solver"),
        **{"rule": "rule", "parameter": "parameter", "authored": _authored, "places": "place_count"},
    }
    return table_of("example", [row.scene for row in found], columns, found)
