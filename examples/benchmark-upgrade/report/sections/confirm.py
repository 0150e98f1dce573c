"""What the tasks that seemed to change do from fresh seeds, release by release."""

from collections.abc import Mapping

import pandas as pd

from measured_report.pages.editions import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, at_least, at_most
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.paired import Step, changes, rows_of, steps_of

order = 20
page = "releases"
label = "tasks that changed"

DIAL, LOCK, PEG, PUSH = "dial-turn-v3", "door-lock-v3", "peg-insert-side-v3", "stick-push-v3"
PANELS = {
    DIAL: ("success_count", "dial-turn: successes"),
    PEG: ("success_count", "peg-insert-side: successes"),
    LOCK: ("step_median", "door-lock: steps to success"),
    PUSH: ("untouched_mm", "stick-push: thermos, untouched [mm]"),
}
ENOUGH = "at least 80 %, as Meta-World's own tests ask of its experts"
REST_MM, LOCK_STEPS = 10.0, 100.0


def derive(results: Results, releases: Releases) -> Section:
    tasks = [row.case for row in results.rows]
    found = {task: rows_of(releases, "confirm", task) for task in tasks}
    steps = list(steps_of(releases, "confirm", tasks))
    row, seeds = results.row, results.row[DIAL].seed_count
    turns, moved, slow = row[DIAL].success_count, row[PUSH].untouched_mm, row[LOCK].step_median
    claims = [
        Claim("dial_turns", at_least(turns, 0.8 * (seeds.value or 0), ENOUGH), {"count": turns, "all": seeds}),
        Claim("thermos_rests", at_most(moved, REST_MM, "what nobody touches rests"), {"moved": moved}),
        Claim("lock_in_time", at_most(slow, LOCK_STEPS, "half as long again as with MuJoCo 3.3"), {"steps": slow}),
        _lost("dial_lost", DIAL, steps, 2 * len(tasks)),
        _lost("peg_lost", PEG, steps, 2 * len(tasks)),
        _since("lock_slower", "step_median", LOCK_STEPS, found[LOCK]),
        _since("thermos_leaves", "untouched_mm", REST_MM, found[PUSH]),
    ]
    tables = {
        "success": _by_release(found, "success_count", {"all": seeds}),
        "steps": _by_release(found, "step_median", {}),
        "grasps": _by_release(found, "grasp_count", {"all": seeds}),
        "changes": changes(results, steps, 2 * len(tasks)),
    }
    drawn = [each[column] for task, (column, _) in PANELS.items() for each in found[task].values()]
    figure = Figure(lambda: _draw(found), drawn, {"all": seeds})
    return Section(tables=tables, figures={"course": figure}, claims=claims)


def _lost(name: str, task: str, steps: list[Step], tests: int) -> Claim:
    """That a release lost successes of a task beyond chance, and whether a later one brought them back."""
    own = [step for step in steps if step.task == task and step.is_beyond_chance("success", tests)]
    worse = [step for step in own if step.lost > step.gained]
    if not worse:
        return Claim(name, FAILS, dict.fromkeys(("release", "before", "after", "all", "back"), ""))
    back = [step.releases[1] for step in own[own.index(worse[0]) :] if step.gained > step.lost]
    before, after = worse[0].rows
    cells = {"before": before.success_count, "after": after.success_count, "all": after.seed_count}
    numbers = {"release": worse[0].releases[1], "back": "".join(back[:1]), **cells}
    return Claim(name, HOLDS.having_read(*cells.values()), numbers)


def _since(name: str, column: str, bound: float, rows: Mapping[str, Row]) -> Claim:
    """From which release on a number is beyond a bound, and what else is otherwise in the task than in the first."""
    columns = {"grasped": "grasp_count", "steps": "step_median", "successes": "success_count", "all": "seed_count"}
    since = [release for release, row in rows.items() if (row[column].value or 0.0) > bound]
    if not since:
        names = ("release", "moved", *columns, *(f"{each}_before" for each in columns))
        return Claim(name, FAILS, dict.fromkeys(names, ""))
    first, new = next(iter(rows.values())), rows[since[0]]
    cells = {"moved": new.untouched_mm, **{each: new[column] for each, column in columns.items()}}
    cells |= {f"{each}_before": first[column] for each, column in columns.items()}
    return Claim(name, HOLDS.having_read(*cells.values()), {"release": since[0], **cells})


def _by_release(found: Mapping[str, Mapping[str, Row]], column: str, names: Mapping[str, Quantity]) -> Table:
    cells = {task: {release: row[column] for release, row in rows.items()} for task, rows in found.items()}
    return Table(pd.DataFrame(cells).T, names)


def _draw(found: Mapping[str, Mapping[str, Row]]):
    drawing, panels = new_figure(7.2, 4.6, nrows=2, ncols=2)
    for axes, (task, (column, title)), colour in zip(panels.flat, PANELS.items(), SERIES, strict=False):
        cells = [(release, row[column].value) for release, row in found[task].items()]
        places = [place for place, (_, value) in enumerate(cells) if value is not None]
        axes.plot(places, [cells[place][1] for place in places], color=colour, marker="o", markevery=1)
        axes.set_xticks(range(len(cells)), [release for release, _ in cells], rotation=60)
        axes.set(title=title, ylim=(0, 1.12 * max((value or 0) for _, value in cells)))
    return drawing
