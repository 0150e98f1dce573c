"""Adds the documents that a new report begins with to the wheel and the sdist."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

DOCUMENTS = ("alarm.md", "cannot-tell.md", "section.md", "upgrade.md", "your-own.md")
PLACES = {"sdist": "docs", "wheel": "measured_report/skeleton/docs"}


class DocumentsHook(BuildHookInterface):
    """Adds files from docs/ of the repository, or from docs/ of the sdist."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        folder = Path(self.root, "docs")
        if not folder.exists():
            folder = Path(self.root).parents[1] / "docs"
        for name in DOCUMENTS:
            place = f"{PLACES[self.target_name]}/{name}"
            build_data["force_include"][str(folder / name)] = place
