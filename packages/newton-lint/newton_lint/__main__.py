"""Lets ``python -m newton_lint TARGET`` run the lint."""

import sys

from newton_lint.command import main

sys.exit(main())
