"""The survey: what the lint says of the examples that Newton ships, release by release."""

from collections import Counter
from collections.abc import Mapping, Sequence

import pandas as pd

from report.chapters import Releases
from report.claims import Claim, Outcome, all_of, at_least, decided
from report.parts import Section, Table
from report.quantities import Quantity, Value
from report.results import Results, Row

order = 131
page = "fix"

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
    return Section(
        tables={
            "rules": _rule_table(results, releases),
            "scenes": _scene_table(found),
            "others": _scene_table([row for row in linted if row.solver != MUJOCO and row.finding_count.value]),
            "unbuilt": _unbuilt_table(unbuilt),
        },
        claims=[
            _many_are_linted(results, linted, unbuilt),
            _mujoco_scenes_say_what_is_not_done(results, solved, found),
            _names_the_undamped(results),
            _releases_differ(results, releases),
        ],
    )


def _examples(results: Results) -> list[Row]:
    return [row for row in results.rows if "unbuilt" in row]


def _linted(results: Results) -> list[Row]:
    return [row for row in _examples(results) if not row.unbuilt]


def _counted(results: Results, name: str, formula: str, rows: Sequence[Row]) -> Value:
    """How many rows there are, which the numbers of their findings say."""
    return results.value(name, formula, lambda *found: len(found), *[row.finding_count for row in rows])


def _many_are_linted(results: Results, linted: Sequence[Row], unbuilt: Sequence[Row]) -> Claim:
    count = _counted(results, "linted", "examples that were linted", linted)
    bound = results.chosen("enough", "examples that a survey takes", 40)
    left_out = results.chosen("unbuilt", "examples that cannot be built here", len(unbuilt))
    return Claim("many_are_linted", at_least(count, bound), {"count": count, "bound": bound, "left_out": left_out})


def _mujoco_scenes_say_what_is_not_done(results: Results, solved: Sequence[Row], found: Sequence[Row]) -> Claim:
    every = _counted(results, "solved", "examples that MuJoCo solves", solved)
    some = results.value(
        "found",
        "of those, how many have a finding",
        lambda *counts: sum(count > 0 for count in counts),
        *[row.finding_count for row in solved],
    )
    outcome = decided(bool(found), every, some)
    return Claim("shipped_scenes_have_findings", outcome, {"count": some, "all": every})


def _names_the_undamped(results: Results) -> Claim:
    counts = [results.row[case].ke_without_kd_count for case in UNDAMPED]
    outcomes = [decided(bool(count.value), count) for count in counts]
    return Claim("names_the_undamped", all_of(*outcomes))


def _releases_differ(results: Results, releases: Releases) -> Claim:
    """Whether an example that two releases have has other findings in the newer of them."""
    surveys = {name: chapters["survey"].results for name, chapters in releases.items() if "survey" in chapters}
    if len(surveys) < 2:
        return Claim("releases_differ", Outcome("unknown", "only one release was surveyed"))
    old, new = (surveys[name] for name in (next(iter(surveys)), next(reversed(list(surveys)))))
    both = [row.case for row in _linted(old) if row.case in {row.case for row in _linted(new)}]
    cells = [
        (old.row[case][column], new.row[case][column]) for case in both for column in ("finding_count", *RULES.values())
    ]
    shared = results.value(
        "shared",
        "examples that were linted in the oldest and in the newest release",
        lambda *found: len(found),
        *[old.row[case].finding_count for case in both],
        across=True,
    )
    columns = 1 + len(RULES)
    differing = results.value(
        "differing",
        "of those, how many have another number of findings of some rule",
        lambda *found: sum(
            any(found[2 * (index + each)] != found[2 * (index + each) + 1] for each in range(columns))
            for index in range(0, len(found) // 2, columns)
        ),
        *[cell for pair in cells for cell in pair],
        across=True,
    )
    outcome = decided(bool(differing.value), shared, differing)
    return Claim("releases_differ", outcome, {"count": differing, "all": shared})


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
    return Table(pd.DataFrame(columns, index=pd.Index(list(RULES), name="rule"), dtype=object))


def _scene_table(rows: Sequence[Row]) -> Table:
    columns: Mapping[str, list] = {
        "solver": [row.solver.removeprefix("Solver") for row in rows],
        "pairs": [row.pair_count for row in rows],
        **{name: [row[column] if row[column].value else "" for row in rows] for name, column in RULES.items()},
    }
    return Table(pd.DataFrame(columns, index=pd.Index([row.case for row in rows], name="example"), dtype=object))


def _unbuilt_table(rows: Sequence[Row]) -> Table:
    reasons = Counter(row.unbuilt for row in rows)
    names = {reason: [row.case for row in rows if row.unbuilt == reason] for reason in reasons}
    columns = {"examples": [", ".join(found) for found in names.values()]}
    return Table(pd.DataFrame(columns, index=pd.Index(list(names), name="reason"), dtype=object))
