"""A scene in MJCF in MJX, MuJoCo's engine in JAX, on the CPU and in single precision."""

import jax
import mujoco
import numpy as np
from apart import answer, samples
from mujoco import mjx


def run(scene, step_s):
    """The last body is what is looked at."""
    model = mujoco.MjModel.from_xml_string(scene["mjcf"])
    model.opt.timestep = step_s
    data = mujoco.MjData(model)
    data.qvel[:], data.ctrl[:] = scene["qvel"], scene["ctrl"]
    mujoco.mj_forward(model, data)
    engine, state = mjx.put_model(model), mjx.put_data(model, data)
    count = round(scene["sample_s"] / step_s)

    @jax.jit
    def sample(state):
        return jax.lax.fori_loop(0, count, lambda _, each: mjx.step(engine, each), state)

    address = model.jnt_qposadr[model.body_jntadr[-1]]
    path = [state.qpos]
    for _ in samples(scene):
        state = sample(state)
        path.append(state.qpos)
    return {"path": [np.asarray(qpos, dtype=float)[address : address + 3].tolist() for qpos in path]}


answer(run)
