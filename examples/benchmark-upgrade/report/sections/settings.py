"""Which setting brings back what a release changed."""

import pandas as pd

from measured_report.pages.editions import Releases
from measured_report.parts.claim import Claim, at_least, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.paired import FAILED
from report.sections.confirm import DIAL, LOCK, LOCK_STEPS, PUSH

order = 30
page = "settings"
label = "settings"

BACK, PLANTED, SHIPPED = "push-back-v3", "impratio-10", "as shipped"
SHOWN = {  # the release that began it, and the number that shows it; the last is planted in a release that is well
    DIAL: ("3.5.0", "success_count"),
    LOCK: ("3.4.0", "step_median"),
    PUSH: ("3.7.0", "untouched_mm"),
    BACK: ("3.3.0", "success_count"),
}


def derive(results: Results, releases: Releases) -> Section:
    columns = {task: _column(results, releases, task, *SHOWN[task]) for task in SHOWN}
    dial, push = columns[DIAL].get("own-invweight"), columns[PUSH].get("no-nativeccd")
    lock, planted = columns[LOCK].get(PLANTED), columns[BACK].get(PLANTED)
    tested = {
        "own_invweight_turns_the_dial": dial and at_least(dial, 5, "most of ten"),
        "old_collider_keeps_the_thermos": push and at_most(push, 30.0, "far less than it slides"),
        "impratio_speeds_the_lock": lock and at_most(lock, LOCK_STEPS, "half as long again as with MuJoCo 3.3"),
        "planted_is_seen": planted and at_most(planted, 8, "80 %, as Meta-World's own tests ask"),
    }
    found = zip(tested.items(), (dial, push, lock, planted), strict=True)
    claims = [Claim(name, outcome, {"found": cell}) for (name, outcome), cell in found if outcome]
    frame = pd.DataFrame({f"{task} {SHOWN[task][0]}": cells for task, cells in columns.items()}, dtype=object)
    lacking = [name for name, outcome in tested.items() if not outcome]
    return Section(tables={"settings": Table(frame.rename_axis("setting"))}, claims=claims, unmeasured=lacking)


def _column(results: Results, releases: Releases, task: str, release: str, column: str) -> dict[str, Quantity]:
    """A number of a task by setting, as shipped first: successes of the same seeds, or the median of all of them."""
    chapters = releases.get(release, {})
    if not {"settings", "confirm"} <= set(chapters):
        return {}
    rows = [row for row in chapters["settings"].results.rows if row.task == task]
    shipped = chapters["confirm"].results.row[task]
    before = shipped[column]
    if column == "success_count":
        count = sum(word != FAILED for word in shipped.steps.split()[: rows[0].seed_count.value])
        before = results.value(f"{task}_shipped", "successes of the same seeds", lambda *_: count, before, across=True)
    return {SHIPPED: before, **{row.setting: row[column] for row in rows}}
