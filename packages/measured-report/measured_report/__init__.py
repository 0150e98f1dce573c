"""A report that measures itself: from measured records to values, claims, figures and a site.

It knows no subject: what is measured, derived and said is a report's own, in the folder that has a ``report.toml``.
"""

import sys
from pathlib import Path


class ReportError(Exception):
    """Something that the reader of the message can mend; the message is one line."""


class UsageError(ReportError):
    """What was asked for does not exist or makes no sense; nothing was changed."""


def _root() -> Path:
    """The report's folder: the first with a ``report.toml`` above the program, or else above where it was started."""
    starts = [Path(sys.path[0] or ".").resolve(), Path.cwd()]
    folders = (folder for start in starts for folder in (start, *start.parents))
    return next((folder for folder in folders if (folder / "report.toml").is_file()), Path.cwd())


ROOT = _root()
"""Every path in a record is relative to it."""
