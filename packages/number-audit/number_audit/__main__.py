"""Run the audit as ``python -m number_audit``."""

import sys

from number_audit.command import main

sys.exit(main())
