"""What the lint finds in the scenes, and how fast it predicts that what is held creeps."""

import pandas as pd

from measured_report.parts.claim import Claim, at_least, decided
from measured_report.parts.section import Section, Table
from measured_report.values.results import Results

order = 40
page = "grasps"
label = "grasps"


def derive(results: Results) -> Section:
    rows = results.rows
    warned = [row for row in rows if row.warning_count.value]
    counts = [row.warning_count for row in rows]
    scenes = results.value("scene_count", "scenes", lambda *found: len(found), *counts)
    warnings = results.value("warned_count", "scenes with a warning", lambda *n: sum(map(bool, n)), *counts)
    noted = [row.note_count for row in rows]
    notes = results.value("noted_count", "scenes with a note", lambda *n: sum(map(bool, n)), *noted)
    held = [row for row in rows if (row.load_n.value or 0.0) > 0.1]
    worst = max(held, key=lambda row: row.creep_mm_s.value, default=None)
    creep = results.value("worst_creep", "largest predicted creep", max, *(row.creep_mm_s for row in held), unit="mm/s")
    found = {"count": warnings, "all": scenes, "notes": notes}
    claims = [
        Claim("lint_is_clean", decided(not warned, *found.values()), found),
        Claim(
            "grasps_creep",
            at_least(creep, 1.0, "the lint warns from there on"),
            {"creep": creep, "task": worst.case if worst else ""},
        ),
    ]
    columns = {"held": "body", "load": "load_n", "predicted creep": "creep_mm_s", "speed": "speed_mm_s"}
    frame = pd.DataFrame(
        {name: {row.case: row[column] for row in held} for name, column in columns.items()}, dtype=object
    )
    return Section(tables={"creep": Table(frame.rename_axis("task"))}, claims=claims)
