"""The command line that make calls; ``make help`` says what there is."""

import sys

from measured_report.commands.command_line import main

if __name__ == "__main__":
    sys.exit(main())
