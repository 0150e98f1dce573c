"""Turn off gradients, which would double the code to compile.

This must be imported before kernels, because their modules copy the setting.
"""

import warp as wp

wp.config.enable_backward = False
