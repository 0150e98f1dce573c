"""MotrixSim, which has one integrator, whatever the MJCF asks for."""

import numpy as np
from apart import World
from motrixsim import SceneData, load_mjcf_str
from motrixsim import step as advance


def load(scene):
    """Load an arm that holds a body named object."""
    model = load_mjcf_str(scene.mjcf)
    model.options.timestep = scene.step_s
    data = SceneData(model)
    state = np.array(data.low.dof_positions)
    state[: len(scene.qpos)] = scene.qpos
    data.low.set_dof_positions_unchecked(state)
    model.forward_kinematic(data)

    def step(target):
        data.actuator_ctrls = np.array(target, dtype=np.float32)
        advance(model, data)

    def poses():
        yield model.get_body("object").get_pose(data)

    def forces():
        """Return the normal forces of both fingers as those of one contact."""
        total = 0
        for finger in ("finger1", "finger2"):
            # How many contacts there are, and of up to four the force, normal first.
            felt = np.array(model.get_sensor_value(finger, data))
            total += felt[1:].reshape(4, -1)[: int(felt[0]), 0].sum()
        yield float(total), 0.0, 0.0

    return World(step, poses, forces, lambda: data.low.dof_positions)
