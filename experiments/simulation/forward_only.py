"""Imported before kernels are, whose modules take it over: gradients are half of what there is to compile."""

import warp as wp

wp.config.enable_backward = False
