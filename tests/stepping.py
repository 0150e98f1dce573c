"""Step MuJoCo Warp on the CPU without launching each kernel from Python."""

from functools import partial

import mujoco
import mujoco_warp as mjw

from experiments.simulation.simulation import captured

BALL = """<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast"/><worldbody>
  <geom type="plane" size="5 5 1"/><body pos="0 0 0.03"><freejoint/><geom type="sphere" size="0.03" mass="0.2"/></body>
  <body><joint type="slide" axis="1 0 0"/><geom size="0.03" contype="0" conaffinity="0"/></body>
</worldbody></mujoco>"""
"""Scene with a ball on the ground and another on a slide without contact.

Kernels are compiled for its sizes.
"""


def in_two_worlds(
    model: mujoco.MjModel, data: mujoco.MjData
) -> tuple[mjw.Model, mjw.Data]:
    return mjw.put_model(model), mjw.put_data(
        model, data, nworld=2, nconmax=4, njmax=16
    )


def take_steps(m: mjw.Model, d: mjw.Data, count: int) -> None:
    """Take ``count`` steps.

    The first step is launched directly and the others as a graph, as in simulations.
    """
    mjw.step(m, d)
    step = captured(partial(mjw.step, m, d))
    for _ in range(count - 1):
        step()
