"""Check that the numbers in texts still agree with your result files.

A number is checked if it has a mark, such as 12.3 ms<!-- = bench.json#/mean -->. The
exit status is 1 if a number is stale, a word is false, or a mark or a source cannot be
read.
"""

import argparse
import glob
import io
import json
import os
import subprocess
import sys
import unicodedata
from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path

from number_audit.audit import PROBLEMS, Audit, Finding, message_of
from number_audit.files import AuditError, read_file, replace_file
from number_audit.sources import NoiseOfRecord, Repeats, Source
from number_audit.suggestions import suggestions

COMMIT_LIMIT = 20
"""The largest number of earlier commits that are searched."""

UNPRINTABLE = "Cc Cf Cs Co Cn Zl Zp".split()
"""Unicode categories of characters that can disturb a terminal or a log."""


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
        help="correct stale numbers and false words",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="print only findings that are not fresh",
    )
    parser.add_argument(
        "--suggest",
        metavar="RESULTS",
        help="add a mark to each number that is in these results",
    )
    parser.add_argument(
        "--allow",
        metavar="FOLDER",
        type=Path,
        action="append",
        default=[],
        help="also read results from this folder outside the repository",
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
    """Return the findings in one file, and fix or mark the file if requested."""

    @cache
    def loaded(name: str) -> Repeats | AuditError:
        project = _project_of(path)
        sources = []
        try:
            for file in _files(path.parent / name):
                content = _read_source(file, project, options.allow)
                sources.append(Source(file, content, noise_of_record))
        except AuditError as error:
            return error
        except Exception as error:  # Each library raises errors of its own.
            return AuditError(f"{name} cannot be read: {message_of(error)}")
        return Repeats(name, sources)

    def source_of(name: str) -> Repeats:
        source = loaded(name)
        if isinstance(source, AuditError):
            raise source
        return source

    try:
        content = read_file(path)
        # Bytes that are not UTF-8 are restored when the text is encoded.
        text = content.decode("utf-8", "surrogateescape")
        if "\0" in text:
            raise AuditError("the file is not UTF-8 text")
        if options.suggest:
            name = Path(os.path.relpath(options.suggest, path.parent)).as_posix()
            source = source_of(name)
            earlier = _earlier_sources(path.parent, name)
            findings = suggestions(text, path.suffix, [("", source), *earlier])
        else:
            findings = list(Audit(text, path.suffix, source_of).findings())
        is_changed = options.fix or options.suggest
        fixed = _fixed(text, findings) if is_changed else text
        if fixed == text:
            return findings
        replace_file(path, content, fixed.encode("utf-8", "surrogateescape"))
        if options.suggest:
            return findings
        return list(Audit(fixed, path.suffix, source_of).findings())
    except (*PROBLEMS, RecursionError) as error:
        return [Finding(1, "missing", message_of(error))]


def _files(path: Path) -> list[Path]:
    """Return the files that match a path, which may contain * in its last part."""
    if "*" not in path.name:
        return [path.absolute()]
    # Only * is special, because names of files can contain brackets.
    pattern = glob.escape(path.name).replace("[*]", "*")
    files = sorted(path.absolute().parent.glob(pattern))
    if not files:
        raise AuditError(f"no file matches {path.name}")
    return files


def _earlier_sources(folder: Path, name: str) -> Iterator[tuple[str, Repeats]]:
    """Yield the last commits of a result file and its content at that time."""
    log = _git(folder, "log", f"-{COMMIT_LIMIT}", "--format=%h", "--", name)
    for commit in log.decode().split():
        # Without ./ the name would be relative to the root of the repository.
        content = _git(folder, "show", f"{commit}:./{name}")
        with suppress(Exception):  # The file may have been damaged at that time.
            yield commit, Repeats(name, [Source(Path(name), content)])


def _git(folder: Path, *command: str) -> bytes:
    """Return the output of a git command, which is empty if git fails."""
    try:
        return subprocess.run(
            ["git", *command], cwd=folder, capture_output=True, check=False
        ).stdout
    except OSError:
        return b""


def _project_of(path: Path) -> Path:
    """Return the repository of a file, or the current folder if there is none."""
    # A worktree or a submodule has a file .git instead of a folder.
    folders = path.absolute().parents
    return next(
        (folder for folder in folders if (folder / ".git").exists()), Path.cwd()
    )


def _read_source(file: Path, project: Path, allowed: Sequence[Path]) -> bytes:
    """Read a result file in the project or in an allowed folder."""
    resolved = file.resolve()
    folders = (project, *allowed)
    if not any(resolved.is_relative_to(folder.resolve()) for folder in folders):
        raise AuditError(
            f"{file.name} is outside {project.name}/: use --allow FOLDER to read it"
        )
    return read_file(resolved)


def _fixed(text: str, findings: Sequence[Finding]) -> str:
    """Return the text after all replacements."""
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
