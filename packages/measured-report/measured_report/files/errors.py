"""Errors: what a command says in one line, in place of a traceback."""

import os
import re
import sys
from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from traceback import extract_tb
from types import TracebackType

UNPRINTABLE = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ud800-\udfff\ue000-\uf8ff"
    "\ufdd0-\ufdef\ufeff\ufff9-\ufffb\ufffe\uffff\U000e0000-\U000e007f\U000f0000-\U0010ffff"
    "\xad\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\uffa0]"
    "|[\u0300-\u036f\u0483-\u0489\u1ab0-\u1aff\u1dc0-\u1dff\u20d0-\u20ff\ufe20-\ufe2f]{4,}"
)  # what no text needs: control, turned round, unseen, halves, of no meaning, not in XML, blanks that are letters, and
# more marks on a letter than any language has


class ReportError(Exception):
    """Tells the reader of its message, which is one line, what to mend."""

    def __str__(self) -> str:
        return without_secrets(super().__str__())


class UsageError(ReportError):
    """Tells that what was asked for does not exist or makes no sense; nothing was changed."""


def without_secrets(text: str) -> str:
    """Return a text without what opens the addresses in it, and without where its reader's home lies."""
    home = os.path.expanduser("~").rstrip("/")  # noqa: PTH111 # Path.home would raise where there is none
    text = re.sub(r"(?<=//)[^/\s]*@", "", text)
    return re.sub(rf"(?<![\w.~-]){re.escape(home)}(?=/)", "~", text) if home else text


def suggestion(name: str, names: Iterable[str]) -> str:
    """Say ``; similar: `` and the names that are like a mistyped one; nothing where none is."""
    matches = get_close_matches(name, list(names), n=4, cutoff=0.5)
    return f"; similar: {', '.join(matches)}" if matches else ""


def bug_of(error: BaseException) -> str:
    """Write an error of a report's own code in one line: file and line of what raised it there, kind and text."""
    frames = [
        (Path(frame.filename), frame.lineno)
        for frame in extract_tb(error.__traceback__)
    ]
    installed = (Path(__file__).parents[1], Path(sys.base_prefix), Path(sys.prefix))
    files = [
        (file, line) for file, line in frames if file.suffix == ".py"
    ]  # a dataclass is made in a <string>
    own_frames = [
        (file, line)
        for file, line in files
        if not any(map(file.is_relative_to, installed))
    ]
    kind = "" if isinstance(error, ReportError) else f"{type(error).__name__}: "
    text = f"{kind}{' '.join(str(error).split())}"
    for file, line in own_frames[-1:]:
        rooms = [
            index
            for index, folder in enumerate(file.parts)
            if folder in ("report", "experiments")
        ]
        return f"{'/'.join(file.parts[max(rooms, default=-1) :])}:{line}: {text}"
    return text


def _say(
    kind: type[BaseException], error: BaseException, trace: TracebackType | None
) -> None:
    if issubclass(kind, ReportError):
        print(" ".join(str(error).split()), file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


sys.excepthook = _say  # report.toml is read as modules are imported, where no command has begun that could say it
