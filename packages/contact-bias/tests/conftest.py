"""Disables gradients, which the tests do not need, to halve the compile time of Warp."""

import warp as wp

wp.config.enable_backward = False  # This must precede the import of kernels.
