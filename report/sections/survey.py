"""The survey: what the lint says of the examples that Newton ships, release by release."""

from collections.abc import Mapping, Sequence

from measured_report.deriving.chapters import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, all_of, at_least, decided
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, table_of

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
    both = _of_both(*ends) if ends else []
    linted = _linted(results)
    solved = [row for row in linted if row.solver == MUJOCO]
    undamped = [row for case in UNDAMPED if (row := results.row[case])]
    has_all = len(undamped) == len(UNDAMPED)
    return Section(
        tables={"rules": _rule_table(results, surveys)},
        claims=[
            _mujoco_scenes_say_what_is_not_done(results, linted, solved),
            *([_names_the_undamped(undamped)] if has_all else []),
            _releases_differ(results, ends, both),
        ],
        unmeasured=() if has_all else ("names_the_undamped",),
    )


def _linted(results: Results) -> list[Row]:
    return [row for row in results.rows if "unbuilt" in row and not row.unbuilt]


def _mujoco_scenes_say_what_is_not_done(results: Results, linted: Sequence[Row], solved: Sequence[Row]) -> Claim:
    counts, shapes = [row.finding_count for row in solved], [row.shape_count for row in linted]
    every = cell_count(results, "solved", "examples that MuJoCo solves", counts)
    some = results.value("found", "of those, how many have a finding", _positive_count, *counts)
    formula = "examples of which the shapes were counted"
    read = results.value("linted", formula, lambda *found: sum(each >= 0 for each in found), *shapes)
    lost = sum("unbuilt" in row and bool(row.unbuilt) for row in results.rows)
    results.value("unbuilt", "examples of the record without a model", lambda *_: lost, *shapes)
    outcome = all_of(decided(bool(some.value), every, some), at_least(read, 40, why="a survey"))
    return Claim("shipped_scenes_have_findings", outcome, {"count": some, "all": every, "linted": read})


def _positive_count(*counts: float) -> int:
    return sum(count > 0 for count in counts)


def _names_the_undamped(undamped: Sequence[Row]) -> Claim:
    counts = [row.ke_without_kd_count for row in undamped]
    return Claim("names_the_undamped", all_of(*(decided(bool(count.value), count) for count in counts)))


def _findings(results: Results, case: str) -> list[Row]:
    return [row for row in results.rows if "rule" in row and row.scene == case]


def _authored(row: Row) -> Quantity:
    return next((row[column] for column in ("authored_s", "authored_m") if column in row), row.authored)


def _of_both(old: Results, new: Results) -> list[bool]:
    """Tell of each example of both surveys whether another thing is found in it, or the same with another value."""

    def told(results: Results, case: str) -> list[tuple[str, str, float | None]]:
        return [(row.rule, row.parameter, _authored(row).value) for row in _findings(results, case)]

    cases = {row.case for row in _linted(new)}
    return [told(old, row.case) != told(new, row.case) for row in _linted(old) if row.case in cases]


def _releases_differ(results: Results, ends: Sequence[Results], are_changed: Sequence[bool]) -> Claim:
    """Tell whether an example that the oldest and the newest survey have has other findings in the newer of them."""
    if not ends:
        alone = "only one release was surveyed"
        return Claim("releases_differ", Outcome("unknown", alone), dict.fromkeys(("count", "both"), absent("1", alone)))
    cells = [_authored(row) for side in ends for row in side.rows if "rule" in row]
    formula = "examples of both releases of which another rule, parameter or value is found"
    count = results.value("changed", formula, lambda *_: sum(are_changed), *cells, across=True)
    both = results.value("both", "examples of both releases", lambda *_: len(are_changed), *cells, across=True)
    outcome = Outcome("unknown", count.reason) if count.value is None else HOLDS if any(are_changed) else FAILS
    return Claim("releases_differ", outcome.having_read(count, both), {"count": count, "both": both})


def _rule_table(results: Results, surveys: Mapping[str, Results]) -> Table:
    """Count the examples in which each rule finds something, by release."""

    def count(release: str, rule: str) -> Quantity:
        cells = [row[RULES[rule]] for row in _linted(surveys[release])]
        formula = "examples in which the rule finds something"
        return results.value(f"{rule}_in_{release}", formula, _positive_count, *cells, across=True)

    def read(release: str) -> Quantity:
        cells = [row.finding_count for row in _linted(surveys[release])]
        return results.value(f"read_in_{release}", "examples read", lambda *each: len(each), *cells, across=True)

    columns = {release: [read(release), *(count(release, rule) for rule in RULES)] for release in surveys}
    return table_of("rule", ("examples read", *RULES), columns)
