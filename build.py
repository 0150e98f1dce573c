"""Run the command line that make calls; ``make help`` lists the commands."""

import signal
import sys
from pathlib import Path

signal.signal(
    signal.SIGINT, signal.SIG_DFL
)  # During this import, Ctrl-C ends the program without a message.
HERE = Path(__file__).resolve().parent
PACKAGES = [str(folder) for folder in sorted((HERE / "packages").glob("*"))]
sys.path[:0] = [
    str(HERE),
    *PACKAGES,
]  # PYTHONSAFEPATH leaves out the first of these folders.

import os

from measured_report.commands.command_line import main

if __name__ == "__main__":
    # Programs that are started from here are modules of this folder, and find the
    # packages.
    os.environ.pop("PYTHONSAFEPATH", None)
    os.environ["PYTHONPATH"] = os.pathsep.join(
        [*PACKAGES, *filter(None, [os.environ.get("PYTHONPATH")])]
    )
    sys.exit(main())
