"""Errors: what a command says in one line, in place of a traceback."""


class ReportError(Exception):
    """Something that the reader of the message can mend; the message is one line."""


class UsageError(ReportError):
    """What was asked for does not exist or makes no sense; nothing was changed."""
