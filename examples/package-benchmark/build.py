"""Run a command of make; ``make help`` lists all commands."""

import signal
import sys

signal.signal(
    signal.SIGINT, signal.SIG_DFL
)  # During this import, Ctrl-C ends the program without a message.

from measured_report.commands.command_line import main

if __name__ == "__main__":
    sys.exit(main())
