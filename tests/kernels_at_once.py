"""Compile a kernel as a study does, and print what it makes; for processes that do so at once."""

import sys
from functools import partial

import numpy as np
import warp as wp

from experiments.simulation.compiling import load_all

wp.config.enable_backward = False  # as where sections are measured


@wp.kernel(module="unique")
def double(values: wp.array(dtype=float)):
    i = wp.tid()
    values[i] = 2.0 * values[i]


@wp.kernel(module="unique")
def factorize(matrix: wp.array2d(dtype=float)):
    tile = wp.tile_load(matrix, shape=(2, 2))
    wp.tile_store(matrix, wp.tile_cholesky(tile))  # compiled apart, and linked


if __name__ == "__main__":
    wp.config.log_level = wp.LOG_ERROR
    wp.init()
    here = partial(double.module.load, "cpu", 1)
    for_a_gpu = partial(wp.compile_aot_module, factorize.module, arch=90, module_dir=sys.argv[1])  # which takes none
    load_all([here, for_a_gpu])
    numbers = wp.array(np.arange(3.0, dtype=np.float32), device="cpu")
    wp.launch(double, dim=3, inputs=[numbers], device="cpu")
    print(numbers.numpy().tolist())
