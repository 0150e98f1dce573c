"""A scene in MJCF in MuJoCo C with its integrator ``discrete``, or in MJX, its engine in JAX, in single precision."""

import mujoco
import numpy as np
from apart import sampled, samples


def run(scene, step_s, discrete=False, timeconst_s=0.02):
    """Run it and look at the last body."""
    model = mujoco.MjModel.from_xml_string(scene["mjcf"])
    model.opt.timestep, model.geom_solref[:, 0] = step_s, timeconst_s
    data = mujoco.MjData(model)
    data.qvel[:], data.ctrl[:] = scene["qvel"], scene["ctrl"]
    mujoco.mj_forward(model, data)
    address = model.jnt_qposadr[model.body_jntadr[-1]]
    return (in_c if discrete else in_mjx)(model, data, scene, slice(address, address + 3))


def in_c(model, data, scene, place):
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_DISCRETE
    return {"path": sampled(scene, model.opt.timestep, lambda: data.qpos[place], lambda: mujoco.mj_step(model, data))}


def in_mjx(model, data, scene, place):
    import jax  # takes long, and C does without
    from mujoco import mjx

    engine, state = mjx.put_model(model), mjx.put_data(model, data)
    count = round(scene["sample_s"] / model.opt.timestep)

    @jax.jit
    def sample(state):
        return jax.lax.fori_loop(0, count, lambda _, each: mjx.step(engine, each), state)

    path = [state.qpos]
    for _ in samples(scene):
        state = sample(state)
        path.append(state.qpos)
    return {"path": [np.asarray(qpos, dtype=float)[place].tolist() for qpos in path]}
