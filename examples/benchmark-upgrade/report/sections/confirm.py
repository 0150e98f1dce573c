"""Test the tasks that seemed to change with new seeds, release by release."""

from collections.abc import Mapping, Sequence

import pandas as pd

from measured_report.findings.chapters import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, at_least, at_most
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.paired import Step, changes, rows_of, steps_of

order = 20
page = "releases"
label = "tasks that changed"

DIAL, LOCK, PEG, PUSH = (
    "dial-turn-v3",
    "door-lock-v3",
    "peg-insert-side-v3",
    "stick-push-v3",
)
PANELS = {
    DIAL: ("success_count", "dial-turn: successes"),
    PEG: ("success_count", "peg-insert-side: successes"),
    LOCK: ("step_median", "door-lock: steps to success"),
    PUSH: ("untouched_mm", "stick-push: thermos, untouched [mm]"),
}
TOLD = ("success_count", "step_median", "grasp_count", "untouched_mm")
ENOUGH = "at least 80 %, as Meta-World's own tests ask of its experts"
REST_MM, LOCK_STEPS = 10.0, 100.0


def derive(results: Results, releases: Releases) -> Section:
    tasks = [row.case for row in results.rows]
    rows_by_task = {task: rows_of(releases, "confirm", task) for task in tasks}
    steps = list(steps_of(releases, "confirm", tasks))
    row, seeds = results.row, {"all": results.row[DIAL].seed_count}
    turns, moved, slow = (
        row[DIAL].success_count,
        row[PUSH].untouched_mm,
        row[LOCK].step_median,
    )
    claims = [
        Claim(
            "dial_turns",
            at_least(turns, 0.8 * (seeds["all"].value or 0), ENOUGH),
            {"count": turns, **seeds},
        ),
        Claim(
            "thermos_rests",
            at_most(moved, REST_MM, "an object that is not touched rests"),
            {"moved": moved},
        ),
        Claim(
            "lock_in_time",
            at_most(slow, LOCK_STEPS, "half as long again as with MuJoCo 3.3"),
            {"steps": slow},
        ),
        _lost(
            "dial_lost",
            row[DIAL],
            [step for step in steps if step.task == DIAL],
            2 * len(tasks),
        ),
        _lost(
            "peg_lost",
            row[PEG],
            [step for step in steps if step.task == PEG],
            2 * len(tasks),
        ),
        _since("lock_slower", row[LOCK], "step_median", LOCK_STEPS, rows_by_task[LOCK]),
        _since(
            "thermos_leaves", row[PUSH], "untouched_mm", REST_MM, rows_by_task[PUSH]
        ),
    ]
    tables = {
        column.partition("_")[0]: Table(
            pd.DataFrame(
                {
                    task: {release: row[column] for release, row in rows.items()}
                    for task, rows in rows_by_task.items()
                }
            ).T,
            seeds,
        )
        for column in TOLD
    }
    drawn = [
        row[column]
        for task, (column, _) in PANELS.items()
        for row in rows_by_task[task].values()
    ]
    figure = Figure(lambda: _draw(rows_by_task), drawn, seeds)
    tables["changes"] = changes(results, steps, 2 * len(tasks))
    return Section(tables=tables, figures={"course": figure}, claims=claims)


def _lost(name: str, own: Row, steps: Sequence[Step], tests: int) -> Claim:
    """Return a claim that a release lost successes, and the later release that restored them."""
    lost = next((step for step in steps if "lost" in step.beyond_chance(tests)), None)
    before, after = lost.rows if lost else (own, own)
    later = steps[steps.index(lost) :] if lost else []
    back = [step.releases[1] for step in later if "gained" in step.beyond_chance(tests)]
    cells = {
        "before": before.success_count,
        "after": after.success_count,
        "all": after.seed_count,
    }
    outcome = (HOLDS if lost else FAILS).having_read(*cells.values())
    return Claim(
        name,
        outcome,
        {
            **cells,
            "release": lost.releases[1] if lost else "",
            "back": "".join(back[:1]),
        },
    )


def _since(
    name: str, own: Row, column: str, bound: float, rows: Mapping[str, Row]
) -> Claim:
    """Return a claim about the first release in which a number exceeds a bound."""
    since = next(
        (
            release
            for release, row in rows.items()
            if (row[column].value or 0.0) > bound
        ),
        "",
    )
    ends = {"before": next(iter(rows.values()), own), "after": rows.get(since, own)}
    cells = {
        f"{each}_{when}": row[each]
        for when, row in ends.items()
        for each in (*TOLD, "seed_count")
    }
    return Claim(
        name,
        (HOLDS if since else FAILS).having_read(*cells.values()),
        {"release": since, **cells},
    )


def _draw(rows_by_task: Mapping[str, Mapping[str, Row]]):
    drawing, panels = new_figure(7.2, 4.6, nrows=2, ncols=2)
    for axes, (task, (column, title)), colour in zip(
        panels.flat, PANELS.items(), SERIES, strict=False
    ):
        course = pd.Series(
            {release: row[column].value for release, row in rows_by_task[task].items()},
            dtype=float,
        )
        axes.plot(range(len(course)), course, color=colour, marker="o", markevery=1)
        axes.set_xticks(range(len(course)), course.index, rotation=60)
        axes.set(title=title, ylim=(0, 1.12 * course.max()))
    return drawing
