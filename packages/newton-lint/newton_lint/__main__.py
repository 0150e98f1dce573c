"""Lints a scene: ``python -m newton_lint TARGET``."""

import sys

from newton_lint.command import main

sys.exit(main())
