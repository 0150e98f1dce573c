"""The command line that make calls; ``make help`` lists its commands."""

import signal
import sys

signal.signal(
    signal.SIGINT, signal.SIG_DFL
)  # while this is being imported there is nothing to say about a Ctrl-C

from measured_report.commands.command_line import main

if __name__ == "__main__":
    sys.exit(main())
