"""Implements ``--fix``: tries changes in MuJoCo C and writes those that do no harm."""

import difflib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from xml.parsers import expat

import mujoco

from newton_lint.findings import Cure, Finding
from newton_lint.fix import Unwritable, edited, write
from newton_lint.ledger import runs_of
from newton_lint.report import Report, Request, report_of
from newton_lint.source import Texts, parse
from newton_lint.target import Target, TargetError, compiled, read_target, tried
from newton_lint.trials import harm

# At most this many changes are tried in one pass.
MOST_TRIES = 40
# Scenes that share files are mended in at most this many passes.
PASSES = 4


class Mending:
    """Tries changes for the findings of a scene, each one on top of those before it."""

    def __init__(self, target: Target, request: Request, paths: Sequence[Path]):
        self.target = target
        self.request = replace(request, step=True)
        self.paths = paths
        self.first = report_of(target, self.request)
        self.report = self.first
        self.texts: dict[Path, bytes] = {}
        self.outcomes: dict[str, str] = {}
        """For each tried change, the reason why it is not written; empty if it is."""
        rules: list[str] = []
        # An accepted change alters the findings, so list the candidates again.
        while candidate := self._next():
            line, finding, cure = candidate
            self.outcomes[line] = self._outcome(finding, cure)
            if not self.outcomes[line]:
                rules.append(finding.rule)
                # A change that did harm before may be harmless now.
                self.outcomes = {
                    line: "" for line, reason in self.outcomes.items() if not reason
                }
        # Each change alone does little harm, but many of them may add up.
        if reason := harm(self.first.runs, self.report.runs, rules):
            self.texts = {}
            self.report = self.first
            reason = f"together with the other changes, {reason}"
            self.outcomes = {line: why or reason for line, why in self.outcomes.items()}

    def _next(self) -> tuple[str, Finding, Cure] | None:
        """Return the next cure with the text of its changes and the finding that it mends."""
        for finding in self.report.findings:
            for cure in finding.cures if finding.severity != "note" else ():
                line = ", ".join(map(str, cure.changes))
                if line not in self.outcomes and len(self.outcomes) < MOST_TRIES:
                    return line, finding, cure
        return None

    def _outcome(self, finding: Finding, cure: Cure) -> str:
        """Apply a cure of a finding, or return why it is not written."""
        if cure.drawback:
            return cure.drawback
        try:
            texts = self.texts | edited(cure.changes, self.report.source, self.texts)
            report = report_of(tried(self.target, texts), self.request)
        except Unwritable as error:
            return str(error)
        except (ValueError, OSError, expat.ExpatError, mujoco.FatalError) as error:
            return f"MuJoCo refuses it: {' '.join(str(error).split())[:200]}"
        # The changes were tried on the compiled model, and these are the files.
        reason = harm(self.report.runs, report.runs, [finding.rule])
        if reason := reason or self._harm_elsewhere(texts, finding.rule):
            return reason
        self.texts = texts
        self.report = report
        return ""

    def _harm_elsewhere(self, texts: Texts, rule: str) -> str:
        """Return how a change of an included file harms the other scenes."""
        included = texts.keys() - {self.target.path}
        for path in self.paths if included else ():
            files = {element.file for element in parse(path).walk()}
            if path == self.target.path or not included & files:
                continue
            engine = self.request.engine
            before, after = (
                runs_of(engine.configured(compiled(path, contents)), None)
                for contents in ({}, texts)
            )
            if reason := harm(before, after, [rule]):
                return f"in {path.name}, {reason}"
        return ""

    def lines(self, is_written: bool) -> Iterator[str]:
        """Yield a line for each change that was tried."""
        outcome = "written" if is_written else "can be written"
        for line, why in self.outcomes.items():
            yield f"{line}: {f'not written because {why}' if why else outcome}"

    def patch(self) -> Iterator[str]:
        """Yield the lines of a patch from the old files to the new ones."""
        for file, text in self.texts.items():
            old = file.read_bytes().decode(errors="replace").splitlines()
            new = text.decode(errors="replace").splitlines()
            yield from difflib.unified_diff(
                old, new, f"a/{file}", f"b/{file}", lineterm=""
            )


def fixed(
    target: Target, request: Request, paths: Sequence[Path], dry: bool
) -> tuple[Report, list[str]]:
    """Mend the files of a scene.

    Args:
        dry: Whether to print a patch instead of writing the files.

    Returns:
        The report before the changes, and lines on each change.

    Raises:
        TargetError: A file cannot be written.
    """
    mending = Mending(target, request, paths)
    before = list(mending.patch()) if dry else _written(target, mending.texts)
    return mending.first, [*before, *mending.lines(not dry)]


def fixed_again(
    targets: Sequence[str], request: Request, paths: Sequence[Path]
) -> list[str]:
    """Mend scenes that may share files until no scene changes any more."""
    lines: list[str] = []
    for _ in range(PASSES):
        new_lines = []
        for scene in map(read_target, targets):
            if scene.path and scene.model is not None:
                _, changes = fixed(scene, request, paths, dry=False)
                new_lines += [line for line in changes if line.endswith(": written")]
        if not new_lines:
            break
        lines += new_lines
    return lines


def _written(target: Target, texts: Texts) -> list[str]:
    try:
        replaced = write(texts)
    except OSError as error:
        raise TargetError(f"{target.name}: not written: {error}") from error
    return [
        f"{file}: the old file is kept as {backup.name}"
        for file, (_, backup) in zip(texts, replaced, strict=True)
    ]
