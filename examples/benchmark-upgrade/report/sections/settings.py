"""Find the setting that restores the behaviour that a release changed."""

import pandas as pd

from measured_report.findings.chapters import Releases
from measured_report.parts.claim import FAILS, HOLDS, Claim, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results
from report.paired import Step
from report.sections.confirm import DIAL, LOCK, PEG, PUSH

order = 30
page = "settings"
label = "settings"

SHIPPED = "as shipped"
SHOWN = {  # task, release that changed it, setting and effect; the last one is a planted change
    "own_invweight_turns_the_dial": (DIAL, "3.5.0", "own-invweight", "gained"),
    "margin_mends_the_peg": (PEG, "3.4.0", "margin", "gained"),
    "impratio_speeds_the_lock": (LOCK, "3.4.0", "impratio-10", "faster"),
    "old_collider_keeps_the_thermos": (PUSH, "3.7.0", "no-nativeccd", "untouched"),
    "planted_is_seen": ("push-back-v3", "3.3.0", "impratio-10", "lost"),
}
COLUMNS = {"faster": "step_median", "untouched": "untouched_mm"}
"""The column that shows an effect, if it is not the number of successes."""


def derive(results: Results, releases: Releases) -> Section:
    claims, columns = [], {}
    for name, (task, release, setting, effect) in SHOWN.items():
        chapters = releases.get(release, {})
        if "settings" not in chapters or "confirm" not in chapters:
            continue
        rows = {SHIPPED: chapters["confirm"].results.row[task]}
        rows |= {
            row.setting: row
            for row in chapters["settings"].results.rows
            if row.task == task
        }
        cells = {
            setting_name: row[COLUMNS.get(effect, "success_count")]
            for setting_name, row in rows.items()
        }
        columns[f"{task} {release}"] = cells
        # An episode is the same on every machine, so rows of different machines can be compared.
        step = Step(task, (SHIPPED, setting), (rows[SHIPPED], rows[setting]))
        outcome = (
            HOLDS if effect in step.beyond_chance(len(SHOWN)) else FAILS
        ).having_read(*cells.values())
        if effect == "untouched":
            outcome = at_most(cells[setting], 30.0, "far less than it slides")
        numbers = {
            setting_name.replace("-", "_").replace(" ", "_"): cell
            for setting_name, cell in cells.items()
        }
        claims.append(
            Claim(
                name,
                outcome,
                {**numbers, "found": cells[setting], "all": rows[SHIPPED].seed_count},
            )
        )
    frame = pd.DataFrame(columns, dtype=object).rename_axis("setting")
    lacking = SHOWN.keys() - {claim.name for claim in claims}
    return Section(
        tables={"settings": Table(frame)}, claims=claims, unmeasured=sorted(lacking)
    )
