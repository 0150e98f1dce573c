"""MuJoCo C with its integrator ``discrete``, or MJX, its engine in JAX, in single precision."""

import apart
import mujoco
import numpy as np


class World(apart.World):
    """A scene in MJCF, of which the last body is watched; its controls never change."""

    def __init__(self, scene, discrete=False, timeconst_s=0.02):
        super().__init__(scene)
        self.model = mujoco.MjModel.from_xml_string(scene.mjcf)
        self.model.opt.timestep = scene.step_s
        self.model.geom_solref[:, 0] = timeconst_s
        self.data = mujoco.MjData(self.model)
        self.data.qvel[:] = scene.qvel
        self.data.ctrl[:] = scene.targets[0]
        mujoco.mj_forward(self.model, self.data)
        if discrete:
            self.model.opt.integrator = mujoco.mjtIntegrator.mjINT_DISCRETE
        else:
            self.use_mjx()

    def use_mjx(self):
        import jax  # takes long, and C does without
        from mujoco import mjx

        engine = mjx.put_model(self.model)
        count = round(self.scene.sample_s / self.scene.step_s)

        @jax.jit
        def sample(state):
            return jax.lax.fori_loop(
                0, count, lambda _, each: mjx.step(engine, each), state
            )

        def advance():
            self.data = sample(self.data)

        self.data = mjx.put_data(self.model, self.data)
        self.advance = advance

    def step(self):
        mujoco.mj_step(self.model, self.data)

    def poses(self):
        address = self.model.jnt_qposadr[self.model.body_jntadr[-1]]
        yield np.asarray(self.data.qpos, dtype=float)[address : address + 7]
