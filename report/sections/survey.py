"""The survey: what the lint says of the examples that Newton ships, release by release."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any

import pandas as pd

from measured_report.claims.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, decided
from measured_report.deriving.chapters import Releases
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count

order = 185
page = "scenes"
label = "Newton's examples, linted"

RULES = {
    "priority": "priority_count",
    "default-gap": "default_gap_count",
    "timeconst": "timeconst_count",
    "ke-without-kd": "ke_without_kd_count",
    "dampratio": "dampratio_count",
    "kf": "kf_count",
    "unused": "unused_count",
}
MUJOCO = "SolverMuJoCo"
UNDAMPED = ("newton_cradle-mujoco", "domino_spiral-mujoco", "balance_bird-mujoco")
"""Examples that author a ke with a kd of 0 and can be solved by MuJoCo."""


def derive(results: Results, releases: Releases) -> Section:
    linted, unbuilt = _linted(results), [row for row in _examples(results) if row.unbuilt]
    solved = [row for row in linted if row.solver == MUJOCO]
    found = [row for row in solved if row.finding_count.value]
    ends = _ends(releases)
    return Section(
        tables={
            "rules": _rule_table(results, releases),
            "scenes": _scene_table(results, found),
            "others": _scene_table(results, [row for row in linted if row.solver != MUJOCO]),
            "changed": _changed_table(ends),
            "unbuilt": _unbuilt_table(unbuilt),
        },
        claims=[
            _many_are_linted(results, linted),
            _mujoco_scenes_say_what_is_not_done(results, solved, found),
            _names_the_undamped(results),
            _releases_differ(results, ends),
        ],
    )


def _examples(results: Results) -> list[Row]:
    return [row for row in results.rows if "unbuilt" in row]


def _linted(results: Results) -> list[Row]:
    return [row for row in _examples(results) if not row.unbuilt]


def _many_are_linted(results: Results, linted: Sequence[Row]) -> Claim:
    shapes = [row.shape_count for row in linted]
    formula = "examples of which the shapes were counted"
    count = results.value("linted", formula, lambda *found: sum(each >= 0 for each in found), *shapes)
    bound = results.chosen("enough", "examples that a survey takes", 40)
    return Claim("many_are_linted", at_least(count, bound), {"count": count, "bound": bound})


def _mujoco_scenes_say_what_is_not_done(results: Results, solved: Sequence[Row], found: Sequence[Row]) -> Claim:
    counts = [row.finding_count for row in solved]
    every = cell_count(results, "solved", "examples that MuJoCo solves", counts)
    some = results.value(
        "found", "of those, how many have a finding", lambda *found: sum(each > 0 for each in found), *counts
    )
    outcome = decided(bool(found), every, some)
    return Claim("shipped_scenes_have_findings", outcome, {"count": some, "all": every})


def _names_the_undamped(results: Results) -> Claim:
    if any(case not in results.row for case in UNDAMPED):
        return Claim("names_the_undamped", Outcome("unknown", "this release does not have all three, or not linted"))
    counts = [results.row[case].ke_without_kd_count for case in UNDAMPED]
    outcomes = [decided(bool(count.value), count) for count in counts]
    return Claim("names_the_undamped", all_of(*outcomes))


@dataclass(frozen=True)
class Ends:
    """The oldest and the newest release that were surveyed, and the examples that both have."""

    old: Results
    new: Results

    @property
    def changed(self) -> list[str]:
        """Those in which another thing is found, or the same with another value."""
        both = [row.case for row in _linted(self.old) if row.case in {row.case for row in _linted(self.new)}]
        return [case for case in both if _told(self.old, case) != _told(self.new, case)]


def _ends(releases: Releases) -> Ends | None:
    """None where there is only one survey."""
    found = [chapters["survey"].results for chapters in releases.values() if "survey" in chapters]
    return Ends(found[0], found[-1]) if len(found) > 1 else None


def _findings(results: Results, case: str) -> list[Row]:
    return [row for row in results.rows if "rule" in row and row.scene == case]


def _authored(row: Row) -> Quantity:
    return next((row[column] for column in ("authored_s", "authored_m") if column in row), row.authored)


def _told(results: Results, case: str) -> list[tuple[str, str, float | None]]:
    return [(row.rule, row.parameter, _authored(row).value) for row in _findings(results, case)]


def _releases_differ(results: Results, ends: Ends | None) -> Claim:
    """Whether an example that two releases have has other findings in the newer of them."""
    if not ends:
        alone = "only one release was surveyed"
        return Claim("releases_differ", Outcome("unknown", alone), {"count": absent("1", alone)})
    changed = len(ends.changed)
    cells = [_authored(row) for side in (ends.old, ends.new) for row in side.rows if "rule" in row]
    count = results.value(
        "changed",
        "examples of both releases of which another rule, parameter or value is found",
        lambda *_: changed,
        *cells,
        across=True,
    )
    outcome = Outcome("unknown", count.reason) if count.value is None else HOLDS if changed else FAILS
    return Claim("releases_differ", outcome.having_read(count), {"count": count})


def _changed_table(ends: Ends | None) -> Table:
    """What is found in the examples that changed, the oldest and the newest release side by side."""
    changed = ends.changed if ends else []
    lines: list[tuple[str, ...]] = []
    cells: list[tuple[Any, ...]] = []
    """What is authored in either release, or words where it is not found there."""
    for case in changed:
        found = [_by_parameter(_findings(side, case)) for side in (ends.old, ends.new)]
        for said in dict.fromkeys([*found[0], *found[1]]):
            values = list(zip_longest(*(side.get(said, []) for side in found), fillvalue="nothing"))
            cells += values
            lines += [(case, *said)] * len(values)
    columns: dict[str, list] = {"rule": [line[1] for line in lines], "parameter": [line[2] for line in lines]}
    for index, side in enumerate((ends.old, ends.new) if ends else ()):
        columns[side.edition] = [cell[index] for cell in cells]
    return Table(_frame(columns, [line[0] for line in lines], "example"))


def _by_parameter(findings: Sequence[Row]) -> dict[tuple[str, str], list[Quantity]]:
    """What is authored, by rule and parameter."""
    found: dict[tuple[str, str], list[Quantity]] = {}
    for row in findings:
        found.setdefault((row.rule, row.parameter), []).append(_authored(row))
    return found


def _columns(findings: Sequence[Row]) -> dict[str, list]:
    return {
        "rule": [row.rule for row in findings],
        "parameter": [row.parameter for row in findings],
        "authored": [_authored(row) for row in findings],
    }


def _frame(columns: Mapping[str, Sequence], index: Sequence[str], name: str) -> pd.DataFrame:
    return pd.DataFrame(columns, index=pd.Index(index, name=name), dtype=object)


def _rule_table(results: Results, releases: Releases) -> Table:
    """In how many examples each rule finds something, by release."""
    columns: dict[str, list[Quantity]] = {}
    for release, chapters in releases.items():
        if "survey" not in chapters:
            continue
        found = chapters["survey"].results
        columns[release] = [
            results.value(
                f"{name}_in_{release}",
                "examples in which the rule finds something",
                lambda *counts: sum(count > 0 for count in counts),
                *[row[column] for row in _linted(found)],
                across=True,
            )
            for name, column in RULES.items()
        ]
    return Table(_frame(columns, list(RULES), "rule"))


def _scene_table(results: Results, rows: Sequence[Row]) -> Table:
    """A line for each thing that is found in these examples."""
    found = [(row, finding) for row in rows for finding in _findings(results, row.case)]
    columns = {
        "solver": [row.solver.removeprefix("Solver") for row, _ in found],
        **_columns([finding for _, finding in found]),
        "places": [finding.place_count for _, finding in found],
    }
    return Table(_frame(columns, [row.case for row, _ in found], "example"))


def _unbuilt_table(rows: Sequence[Row]) -> Table:
    ordered = sorted(rows, key=lambda row: (row.unbuilt, row.case))
    return Table(_frame({"why": [row.unbuilt for row in ordered]}, [row.case for row in ordered], "example"))
