"""Return the files of the fix: the fixed scene, the patch and the scene as shipped.

The scene as shipped is the fixed scene without the patch.
"""

import re

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT

FIXED_SCENE = "assets/fix/fixed_scene.py"
PATCH = "assets/fix/fix.patch"
ROBOT = "assets/fr3.urdf"
HUNK = re.compile(r"^@@ .*\n", re.MULTILINE)
READING = (
    'URDF = (Path(__file__).parents[1] / "fr3.urdf").read_text(encoding="utf-8")\n'
)
"""The line with which the scene reads its robot.

The offered file contains the robot instead, because there are no other files in its
folder.
"""


def fix_files() -> dict[str, str]:
    """Return the text of each offered file by name."""
    scene, patch, robot = (
        (ROOT / path).read_text(encoding="utf-8")
        for path in (FIXED_SCENE, PATCH, ROBOT)
    )
    fixed = replaced(scene, READING, f'URDF = """\\\n{robot}"""  # noqa: E501\n')
    return {
        "fix.patch": patch,
        "fixed_scene.py": fixed,
        "scene_as_shipped.py": without_patch(fixed, patch),
    }


def without_patch(text: str, patch: str) -> str:
    """Return ``text`` without the changes of a unified diff.

    Raise ReportError if the diff does not lead to ``text``.
    """
    for hunk in HUNK.split(patch)[1:]:
        lines = hunk.splitlines(keepends=True)
        before, after = (
            "".join(line[1:] for line in lines if line[0] in marks)
            for marks in (" -", " +")
        )
        text = replaced(text, after, before)
    return text


def replaced(text: str, part: str, other: str) -> str:
    """Return the text with ``part`` replaced by ``other``.

    Raise ReportError unless the part occurs exactly once.
    """
    if text.count(part) != 1:
        raise ReportError(
            f"{FIXED_SCENE} is not what {PATCH} leads to, or does not read {ROBOT}"
        )
    return text.replace(part, other)
