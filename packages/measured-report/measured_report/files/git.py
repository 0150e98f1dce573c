"""Run git without its hooks, and without the environment of a hook.

This program may itself have been started by a hook.
"""

import os
import re
import subprocess
from pathlib import Path

from measured_report.files.errors import UsageError

KEPT_VARIABLES = (
    "GIT_SSH",
    "GIT_SSH_COMMAND",
    "GIT_ASKPASS",
    "GIT_CONFIG_GLOBAL",
    "GIT_CONFIG_NOSYSTEM",
)
"""Variables for access to other hosts, which git keeps.

All other variables that begin with GIT_ may name a repository or its index.
"""
WITHOUT_HOOKS = ("core.hooksPath=/dev/null", "core.fsmonitor=false")
QUIET = {"GIT_OPTIONAL_LOCKS": "0", "GIT_TERMINAL_PROMPT": "0", "LC_ALL": "C"}


ORIGIN = re.compile(
    r"""
    (?: (?:https?|ssh)://(?:[^@/]*@)? | [\w.-]+@ )  # scheme and user
    ([\w.-]+)  # host
    (?: :\d+(?=/) )?  # port
    [:/]
    ([^?#]+?)  # path
    (?:\.git)?/?
    """,
    re.VERBOSE,
)
"""Matches an address of git's origin that is also a web address: host and path."""


def environment(**settings: str) -> dict[str, str]:
    """Return the environment for git and for programs that call it."""
    variables = {
        name: value
        for name, value in os.environ.items()
        if name in KEPT_VARIABLES or not name.startswith("GIT_")
    }
    return variables | QUIET | settings


def run_git(folder: Path, *command: str, **settings: str) -> str:
    """Return the output of git in a folder.

    Raise UsageError with the first line of its message if it fails.
    """
    options = [option for setting in WITHOUT_HOOKS for option in ("-c", setting)]
    try:
        process = subprocess.run(
            ["git", "-C", folder, *options, *command],
            input="",
            capture_output=True,
            text=True,
            errors="replace",
            env=environment(**settings),
            check=False,
        )
    except FileNotFoundError:
        raise UsageError("git is not installed: install it") from None
    if process.returncode:
        lines = filter(None, map(str.strip, process.stderr.splitlines()))
        message = next(lines, f"exit status {process.returncode}")
        raise UsageError(f"git: {message}")
    return process.stdout.strip()


def git(folder: Path, *command: str) -> str:
    """Return the output of git in a folder, or an empty string if it fails, for example
    because the folder is outside of a repository.
    """
    try:
        return run_git(folder, *command)
    except UsageError:
        return ""


def web_address(folder: Path) -> str:
    """Return the web address of a repository's origin without credentials, if any."""
    origin = ORIGIN.fullmatch(git(folder, "remote", "get-url", "origin"))
    return f"https://{origin[1]}/{origin[2]}" if origin else ""
