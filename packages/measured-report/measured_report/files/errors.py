"""Define the errors that a command prints as one line instead of a traceback."""

import os
import re
import sys
from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from traceback import extract_tb
from types import TracebackType

UNPRINTABLE = re.compile(
    r"""
    (?: [\x00-\x08\x0b-\x1f\x7f-\x9f]  # control characters
      | [\xad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f]  # invisible
      | [\ufeff\ufff9-\ufffb]  # invisible
      | [\u034f\u17b4\u17b5\u180b-\u180f\U000e0000-\U000e007f]  # invisible marks
      | [\u115f\u1160\u2800\u3164\uffa0]  # letters that look blank
      | [\ud800-\udfff]  # halves of surrogate pairs
      | [\ue000-\uf8ff\U000f0000-\U0010ffff]  # private use
      | [\ufdd0-\ufdef\ufffe\uffff]  # forbidden in XML
    )
    # More marks on one letter than any language uses.
    | (?: [\u0300-\u036f\u0483-\u0489\u1ab0-\u1aff]
        | [\u1dc0-\u1dff\u20d0-\u20ff\ufe20-\ufe2f]
      ){4,}
    """,
    re.VERBOSE,
)
"""Characters that can hide or change the text around them and that no text needs."""


class ReportError(Exception):
    """Signal an error that the user can fix.

    The message is one line and states the remedy.
    """

    def __str__(self) -> str:
        return without_secrets(super().__str__())


class UsageError(ReportError):
    """Signal an invalid request; raised before anything was changed."""


def without_secrets(text: str) -> str:
    """Return a text without credentials in addresses and without the home folder."""
    # Path.home raises an error if there is no home folder.
    home = os.path.expanduser("~").rstrip("/")  # noqa: PTH111
    text = re.sub(r"(?<=//)[^/\s]*@", "", text)
    return re.sub(rf"(?<![\w.~-]){re.escape(home)}(?=/)", "~", text) if home else text


def suggestion(name: str, names: Iterable[str]) -> str:
    """Return `` (similar: …)`` with names that resemble a mistyped one, if there are
    any.
    """
    matches = get_close_matches(name, list(names), n=4, cutoff=0.5)
    return f" (similar: {', '.join(matches)})" if matches else ""


def bug_of(error: BaseException) -> str:
    """Return an error in a report's code as one line: file, line, type and message.

    Raise the error itself if memory was insufficient.
    """
    if isinstance(error, MemoryError):
        # The cache would keep this error, although the code is correct.
        raise error
    frames = [
        (Path(frame.filename), frame.lineno)
        for frame in extract_tb(error.__traceback__)
    ]
    installed = (Path(__file__).parents[1], Path(sys.base_prefix), Path(sys.prefix))
    # The methods of a dataclass have the file name <string>.
    files = [(file, line) for file, line in frames if file.suffix == ".py"]
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


def _print_error(
    kind: type[BaseException], error: BaseException, trace: TracebackType | None
) -> None:
    if issubclass(kind, ReportError):
        print_line(str(error))
    else:
        sys.__excepthook__(kind, error, trace)


def print_line(text: str) -> None:
    """Print an error as one line, without secrets and hidden characters."""
    line = UNPRINTABLE.sub("?", " ".join(without_secrets(text).split()))
    print(line, file=sys.stderr)


# An import reads report.toml before any command runs that could print an error.
sys.excepthook = _print_error
