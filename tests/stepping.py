"""Steps of MuJoCo Warp on the CPU, without launching each of their kernels from Python."""

from functools import partial

import mujoco_warp as mjw

from experiments.simulation.simulation import captured


def take_steps(m: mjw.Model, d: mjw.Data, count: int) -> None:
    """Take ``count`` steps, the first as it is and the others as a graph, as simulations do."""
    mjw.step(m, d)
    step = captured(partial(mjw.step, m, d))
    for _ in range(count - 1):
        step()
