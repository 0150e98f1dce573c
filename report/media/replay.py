"""Write replay.html, which shows stored runs in 3D."""

import json
from collections.abc import Mapping
from typing import Any

from markupsafe import Markup

from measured_report.editions.project import Project
from measured_report.files.root import ROOT
from measured_report.findings.chapters import Chapter
from measured_report.pages.prose import Templates
from measured_report.values.format import format_number
from report.media.clips import Clips

REPLAY = "replay.html"
SHAKES = {  # the choices of the page, and for each the cases and names of its runs
    "3 cm": {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"},
    "10 cm": {"as-shipped-10cm": "shipped pads", "stiff-pads-10cm": "stiff pads"},
    "held still": {"hold-60s": "shipped pads, held still"},
}
SCRIPT = ROOT / "assets/replay/replay.js"  # the pages of all editions share it


def replay_page(
    project: Project,
    chapter: Chapter,
    runs: Mapping[str, Any],
    clips: Clips | None,
    templates: Templates,
    root: str,
) -> str:
    """Return the page of one release.

    Args:
        chapter: The section poses.
        runs: Packed by ``packed_runs``.
        clips: The clips of the release. A page without a script shows their still.
        root: Leads from the page to the root of the site.
    """
    names = {
        "root": root,
        "results": chapter.results,
        "section": chapter.section,
        "still": clips
        and clips.still(
            "#runs-in-numbers",
            Markup("The picture shows the cube in the hand at every second cycle."),
        ),
        "shakes": list(SHAKES),
        "speeds": {
            speed: format_number(speed, noise=0.0) for speed in (0.25, 1.0, 4.0)
        },  # relative to the simulated time
        "speed": 1.0,
        "magnifications": (1, 5, 20),
        "runs": json.dumps(runs, separators=(",", ":")),
        "style": Markup(
            (project.root / "assets/replay/replay.css").read_text(encoding="utf-8")
        ),
        "script": SCRIPT.name,
    }
    return templates.layout(f"{REPLAY}.j2", names)
