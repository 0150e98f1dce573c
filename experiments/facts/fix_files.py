"""The files of the fix: the fixed scene, the patch, and the scene as shipped, which is the first without the second."""

import re

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT

FIXED_SCENE = "assets/fix/fixed_scene.py"
PATCH = "assets/fix/fix.patch"
HUNK = re.compile(r"^@@ .*\n", re.MULTILINE)


def fix_files() -> dict[str, str]:
    """Text of each file that is offered, by its name."""
    fixed, patch = ((ROOT / path).read_text(encoding="utf-8") for path in (FIXED_SCENE, PATCH))
    return {"fix.patch": patch, "fixed_scene.py": fixed, "scene_as_shipped.py": without_patch(fixed, patch)}


def without_patch(text: str, patch: str) -> str:
    """Take a unified diff of one file back out of ``text``; ReportError where ``text`` is not what it leads to."""
    for hunk in HUNK.split(patch)[1:]:
        lines = hunk.splitlines(keepends=True)
        before, after = ("".join(line[1:] for line in lines if line[0] in kept) for kept in (" -", " +"))
        if text.count(after) != 1:
            raise ReportError(f"{PATCH} does not lead to {FIXED_SCENE}")
        text = text.replace(after, before)
    return text
