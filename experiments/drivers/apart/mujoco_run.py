"""MuJoCo C with its integrator ``discrete``, or MJX, its engine in JAX, in single precision."""

import mujoco
import numpy as np
from apart import World


def load(scene, discrete=False, timeconst_s=0.02):
    """Load MJCF, of which the last body is watched; its controls never change."""
    model = mujoco.MjModel.from_xml_string(scene.mjcf)
    model.opt.timestep = scene.step_s
    model.geom_solref[:, 0] = timeconst_s
    data = mujoco.MjData(model)
    data.qvel[:] = scene.qvel
    data.ctrl[:] = scene.targets[0]
    mujoco.mj_forward(model, data)
    start = model.jnt_qposadr[model.body_jntadr[-1]]
    place = slice(start, start + 3)
    if not discrete:
        return in_mjx(scene, model, data, place)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_DISCRETE
    return World(lambda _: mujoco.mj_step(model, data), lambda: [data.qpos[place]])


def in_mjx(scene, model, data, place):
    import jax  # takes long, and C does without
    from mujoco import mjx

    engine = mjx.put_model(model)
    state = mjx.put_data(model, data)
    count = round(scene.sample_s / scene.step_s)

    @jax.jit
    def sample(state):
        return jax.lax.fori_loop(
            0, count, lambda _, each: mjx.step(engine, each), state
        )

    def step(_):
        nonlocal state
        state = sample(state)

    def poses():
        yield np.asarray(state.qpos, dtype=float)[place]

    return World(step, poses, step_count=1)
