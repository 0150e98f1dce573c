"""Check that the numbers in texts still agree with your result files.

A number is checked if it has a mark, such as 12.3 ms<!-- = bench.json#/mean -->. The
exit status is 1 if a number is stale, a word is false, or a mark or a source cannot be
read.
"""

import argparse
import io
import json
import sys
import unicodedata
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from number_audit.audit import PROBLEMS, Audit, Finding, message_of
from number_audit.files import AuditError, read_file, replace_file
from number_audit.sources import NoiseOfRecord, Source
from number_audit.suggestions import suggestions

UNPRINTABLE = ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")
"""Categories of characters that disturb a terminal or a log."""


def main(
    arguments: Sequence[str] | None = None,
    *,
    prog: str = "number-audit",
    noise_of_record: NoiseOfRecord | None = None,
) -> int:
    """Audit files, print a line for each finding, and return 1 if one is an error."""
    options = _parser(prog).parse_args(arguments)
    # A terminal may not support all characters of a text.
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")
    is_wrong = False
    for path in options.files:
        for finding in _findings(path, options, noise_of_record):
            is_wrong = is_wrong or finding.is_error
            if finding.kind != "fresh" or not options.check:
                print(_line(path, finding, options.format))
    return int(is_wrong)


def _parser(prog: str) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog=prog,
        description=__doc__,
        allow_abbrev=False,
    )
    parser.add_argument(
        "files",
        nargs="+",
        type=Path,
        metavar="FILE",
        help="Markdown, HTML, LaTeX or reStructuredText",
    )
    parser.add_argument(
        "--fix",
        action="store_true",
        help="replace stale numbers and false words by those of the sources",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="print only findings that are not fresh",
    )
    parser.add_argument(
        "--suggest",
        metavar="RESULTS",
        help="mark each number that occurs exactly once in these results",
    )
    parser.add_argument(
        "--allow",
        metavar="FOLDER",
        type=Path,
        action="append",
        default=[],
        help="also read sources in this folder, outside the repository",
    )
    parser.add_argument(
        "--format",
        choices=("json", "text", "github"),
        default="text",
        help="output format; github prints annotations",
    )
    return parser


def _findings(
    path: Path, options: argparse.Namespace, noise_of_record: NoiseOfRecord | None
) -> list[Finding]:
    """Return the findings on one file, after fixing or marking it if requested."""

    @cache
    def source_of(name: str) -> Source:
        file = (path.parent / name).absolute()
        content = _read_source(file, _project_of(path), options.allow)
        return Source(file, content, noise_of_record)

    try:
        content = read_file(path)
        text = _decoded(content)
        if options.suggest:
            source = source_of(options.suggest)
            findings = list(suggestions(text, path.suffix, options.suggest, source))
        else:
            findings = list(Audit(text, path.suffix, source_of).findings())
        if not (options.fix or options.suggest):
            return findings
        fixed = _fixed(text, findings)
        if fixed == text:
            return findings
        replace_file(path, content, _encoded(fixed))
        if options.suggest:
            return findings
        return list(Audit(fixed, path.suffix, source_of).findings())
    except (*PROBLEMS, RecursionError) as error:
        return [Finding(1, "missing", message_of(error))]


def _project_of(path: Path) -> Path:
    """Return the repository of a file, or the current folder if there is none."""
    for folder in path.absolute().parents:
        if (folder / ".git").exists():
            return folder
    return Path.cwd()


def _read_source(file: Path, project: Path, allowed: Sequence[Path]) -> bytes:
    """Read a result file in the project or in an allowed folder."""
    resolved = file.resolve()
    folders = (project, *allowed)
    if not any(resolved.is_relative_to(folder.resolve()) for folder in folders):
        raise AuditError(
            f"{file.name} is outside {project.name}/: use --allow FOLDER to read it"
        )
    return read_file(resolved)


def _decoded(content: bytes) -> str:
    """Decode a text so that ``_encoded`` restores bytes that are not UTF-8."""
    if b"\0" in content:
        raise AuditError("the file is not UTF-8 text")
    return content.decode("utf-8", "surrogateescape")


def _encoded(text: str) -> bytes:
    return text.encode("utf-8", "surrogateescape")


def _fixed(text: str, findings: Sequence[Finding]) -> str:
    """Return a text with all replacements applied."""
    parts = []
    end = 0
    for finding in findings:
        if finding.replacement:
            parts += [text[end : finding.start], finding.replacement]
            end = finding.end
    return "".join([*parts, text[end:]])


def _line(path: Path, finding: Finding, form: str) -> str:
    """Return a finding as text, as JSON or as a GitHub annotation."""
    level = "error" if finding.is_error else "notice"
    text = _printable(finding.text)
    if form == "json":
        fields = vars(finding) | {"file": path.as_posix(), "text": text, "level": level}
        return json.dumps(fields)
    if form == "github":
        place = f"file={_escaped_property(path.as_posix())},line={finding.line}"
        return f"::{level} {place}::{finding.kind}: {_escaped(text)}"
    return f"{_printable(path.as_posix())}:{finding.line}: {finding.kind}: {text}"


def _printable(text: str) -> str:
    return "".join(
        "?" if unicodedata.category(character) in UNPRINTABLE else character
        for character in text
    )


def _escaped(text: str) -> str:
    """Escape the message of a workflow command, so that it cannot start another one."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _escaped_property(text: str) -> str:
    return _escaped(text).replace(":", "%3A").replace(",", "%2C")
