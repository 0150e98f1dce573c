"""The page's side: from measured records to values, claims, figures and the site.

It knows nothing of the simulator.
"""

from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
"""The project's folder; every path in a record is relative to it."""


class ReportError(Exception):
    """Something that the reader of the message can mend; the message is one line."""


class UsageError(ReportError):
    """What was asked for does not exist or makes no sense; nothing was changed."""
