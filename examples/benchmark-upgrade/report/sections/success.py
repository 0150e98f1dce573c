"""Find the releases that run the benchmark, and count the episodes that they change."""

from collections.abc import Sequence

import pandas as pd

from measured_report.findings.chapters import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, decided
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results
from report.paired import Step, changes, counted, steps_of

order = 10
page = "releases"
label = "all tasks"


def derive(results: Results, releases: Releases) -> Section:
    rows = results.rows
    trials = [row.seed_count for row in rows]
    tasks = results.value("task_count", "tasks", lambda *found: len(found), *trials)
    ran = [row for row in rows if row.success_count.value is not None]
    runs = results.value("run_count", "tasks that run", lambda *_: len(ran), *trials)
    reason = next(
        (row.success_count.reason.partition(": ")[2] for row in rows if row not in ran),
        "",
    )
    results.value(
        "seen",
        "chance that one in ten shows",
        lambda n: 100 * (1 - 0.9**n),
        rows[0].seed_count,
        unit="%",
    )
    numbers = {
        "release": results.edition,
        "count": runs,
        "all": tasks,
        "reason": reason,
    }
    claims = [
        Claim("runs", decided(len(ran) == len(rows), runs, tasks), numbers),
        _stops(releases),
    ]
    if ran:
        repeated = sum(row.repeats for row in ran)
        same = results.value(
            "repeat_count",
            "tasks whose first episode repeats",
            lambda *_: repeated,
            *trials,
        )
        claims.append(
            Claim("repeats", decided(repeated == len(ran), same), {"count": same})
        )
    steps = list(steps_of(releases, "success", [row.case for row in rows]))
    tables = {
        "releases": _release_table(results, releases, steps),
        "changes": changes(results, steps, 2 * len(rows)),
    }
    return Section(tables=tables, claims=claims, unmeasured=() if ran else ("repeats",))


def _stops(releases: Releases) -> Claim:
    """Return a claim about the first release in which no task runs, with the reason."""
    for release, chapters in releases.items():
        cells = (
            [row.success_count for row in chapters["success"].results.rows]
            if "success" in chapters
            else []
        )
        if cells and all(cell.value is None for cell in cells):
            reason = cells[0].reason.partition(": ")[2]
            return Claim(
                "stops",
                HOLDS.having_read(*cells),
                {"release": release, "reason": reason},
            )
    return Claim("stops", FAILS, {"release": "", "reason": ""})


def _release_table(
    results: Results, releases: Releases, steps: Sequence[Step]
) -> Table:
    lines = {}
    for release, chapters in releases.items():
        if "success" in chapters:
            counts = [row.success_count for row in chapters["success"].results.rows]
            total = results.value(
                f"total_{release}",
                "sum of successes",
                lambda *n: sum(n),
                *counts,
                across=True,
            )
            lines[release] = {"successes": total}
            if found := [step for step in steps if step.releases[1] == release]:
                whats = ("other_motion", "lost", "gained")
                lines[release] |= {
                    what.replace("_", " "): counted(results, release, what, found)
                    for what in whats
                }
    frame = pd.DataFrame(lines).T.rename_axis("MuJoCo")
    return Table(frame, {"all": results.rows[0].seed_count})
