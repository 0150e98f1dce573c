"""Gradients are half of what Warp compiles, and nothing here takes one."""

import warp as wp

wp.config.enable_backward = False  # before kernels are imported
