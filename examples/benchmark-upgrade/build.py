"""The command line that make calls."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PACKAGES = [str(folder) for folder in sorted((HERE.parents[1] / "packages").glob("*"))]
sys.path[:0] = [str(HERE), *PACKAGES]  # as they lie beside this example

from measured_report.commands.command_line import main

if __name__ == "__main__":
    os.environ["PYTHONPATH"] = os.pathsep.join(PACKAGES)  # of programs that are started from here
    sys.exit(main())
