"""replay.html: kept runs in 3D, on a page that needs no other file and runs one script, known by its digest."""

import base64
import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report import ROOT
from measured_report.deriving.chapters import Chapter
from measured_report.editions.project import Project
from measured_report.pages.prose import Templates
from measured_report.values.format import format_number
from measured_report.values.quantities import local
from report.media.clips import Clips

REPLAY = "replay.html"
SHAKES = {
    "3 cm": {"as-shipped": "shipped pads", "stiff-pads": "stiff pads"},
    "10 cm": {"as-shipped-10cm": "shipped pads", "stiff-pads-10cm": "stiff pads"},
    "held still": {"hold-60s": "shipped pads, held still"},
}
"""What can be chosen on the page, and the runs that it shows, by case."""
SCRIPT = "assets/replay/replay.js"
STYLE = "assets/replay/replay.css"
SPEEDS, SPEED = (0.25, 1.0, 4.0), 1.0
"""How fast the replay can be played, and how fast it is at first; of the simulated time."""
MAGNIFICATIONS = (1, 5, 20)
"""How many times as large the displacement can be drawn; at first the first."""


def replay_page(
    project: Project, chapter: Chapter, runs: Mapping[str, Any], clips: Clips | None, templates: Templates
) -> str:
    """Write the page of one release.

    Args:
        project: The release.
        chapter: Its section poses.
        runs: What ``packed_runs`` makes of its results.
        clips: Where the still is, which is shown where nothing moves; None when there is none.
        templates: The templates of the project.
    """
    results = chapter.results
    names = {
        "results": results,
        "section": chapter.section,
        "claims": [claim.html(chapter.name) for claim in chapter.section.claims],
        "still": clips and clips.still("#runs-in-numbers", Markup("The cube in the hand, every second cycle.")),
        "shakes": list(SHAKES),
        "speeds": {speed: format_number(speed, noise=0.0) for speed in SPEEDS},
        "speed": SPEED,
        "magnifications": MAGNIFICATIONS,
        "runs": json.dumps(runs, separators=(",", ":")),
        "style": Markup((project.root / STYLE).read_text(encoding="utf-8")),
        "script": Markup(script(project.root)),
        "digest": base64.b64encode(hashlib.sha256(script(project.root).encode()).digest()).decode(),
    }
    return local(templates.layout(f"{REPLAY}.j2", names), project.release)


def script(root: Path = ROOT) -> str:
    """The one script that a page of this site may run."""
    return (root / SCRIPT).read_text(encoding="utf-8")
