"""Lets ``python -m number_audit`` run the audit."""

import sys

from number_audit.command import main

sys.exit(main())
