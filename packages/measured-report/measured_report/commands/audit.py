"""Audit texts: say which of their numbers and words are no longer what the results say that their marks name."""

import argparse
import json
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from measured_report.files.atomic import read_own_file
from measured_report.files.errors import UNPRINTABLE, ReportError
from measured_report.site.audit import Audit, Finding
from measured_report.site.sources import Source

BYTE_LIMIT = 256 << 20
OPTIONS: Mapping[str, Mapping[str, Any]] = {
    "files": {"nargs": "+", "metavar": "FILE", "help": "Markdown, HTML, LaTeX or reStructuredText"},
    "--fix": {"action": "store_true", "help": "write what is right in place of stale numbers and false words"},
    "--check": {"action": "store_true", "help": "print nothing of what is fresh"},
    "--suggest": {"metavar": "RESULTS", "help": "mark the numbers that are each one number of these results"},
    "--allow": {"action": "append", "default": [], "help": "read results from this folder outside the project, too"},
    "--format": {"choices": ("text", "github", "json"), "default": "text", "help": "github: annotations"},
}


def audit(arguments: argparse.Namespace) -> int:
    """Print what came of each mark of the files; 1 where a number is stale, a word false or a source missing."""
    findings = [finding for name in arguments.files for finding in _findings(Path(name), arguments)]
    shown = [finding for finding in findings if not (arguments.check and finding.kind == "fresh")]
    if arguments.format == "json":
        names = ("file", "line", "kind", "text", "value", "unit", "noise")
        print(json.dumps([{name: getattr(finding, name) for name in names} for finding in shown], indent=1))
        return int(any(finding.is_wrong for finding in findings))
    for finding in shown:
        text = UNPRINTABLE.sub("?", f"{finding.kind}: {finding.text}")
        place = f"file={finding.file},line={finding.line}::{text.replace('%', '%25')}"
        is_annotated = arguments.format == "github" and finding.kind != "fresh"
        print(
            f"::{'error' if finding.is_wrong else 'notice'} {place}"
            if is_annotated
            else f"{finding.file}:{finding.line}: {text}"
        )
    return int(any(finding.is_wrong for finding in findings))


def _findings(path: Path, arguments: argparse.Namespace) -> Sequence[Finding]:
    folders = [folder for folder in path.absolute().parents if (folder / ".git").exists()] or [Path.cwd()]
    allowed = [folder.resolve() for folder in (folders[0], *map(Path, arguments.allow))]

    def read(file: Path) -> bytes:
        if not any(file.resolve().is_relative_to(folder) for folder in allowed):
            raise ReportError(f"{file.name} is outside {allowed[0].name}/, where --allow FOLDER lets it be read")
        return read_own_file(file.resolve(), BYTE_LIMIT)

    @cache
    def source(name: str) -> Source:
        return Source((path.parent / name).absolute(), read)

    try:
        audit = Audit(path, source)
        findings = list(audit.suggestions(arguments.suggest) if arguments.suggest else audit.findings())
        if arguments.suggest or arguments.fix:
            audit.write(findings)
        return findings if not arguments.fix else list(Audit(path, source).findings())
    except (OSError, ReportError) as error:
        return [Finding(str(path), 1, "missing", str(error))]
