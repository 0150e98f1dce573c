"""MotrixSim, which has one integrator, whatever the MJCF asks for."""

import apart
import numpy as np
from motrixsim import SceneData, load_mjcf_str, step


class World(apart.World):
    """An arm that holds a body named object, in MJCF; a sample is a step."""

    def __init__(self, scene):
        super().__init__(scene)
        self.model = load_mjcf_str(scene.mjcf)
        self.model.options.timestep = scene.step_s
        self.data = SceneData(self.model)
        state = np.array(self.joints())
        state[: len(scene.qpos)] = scene.qpos
        self.data.low.set_dof_positions_unchecked(state)
        self.model.forward_kinematic(self.data)

    def step(self):
        self.data.actuator_ctrls = np.array(self.target, dtype=np.float32)
        step(self.model, self.data)

    def poses(self):
        yield self.model.get_body("object").get_pose(self.data)

    def forces(self):
        """Return the normal forces of both fingers as those of one contact."""
        total = 0
        for finger in ("finger1", "finger2"):
            # How many contacts there are, and of up to four the force, normal first.
            felt = np.array(self.model.get_sensor_value(finger, self.data))
            total += felt[1:].reshape(4, -1)[: int(felt[0]), 0].sum()
        yield float(total), 0.0, 0.0

    def joints(self):
        return self.data.low.dof_positions
