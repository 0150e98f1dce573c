"""An arm that holds an object, in MJCF, in MotrixSim, which has one integrator, whatever the file asks for."""

import numpy as np
from motrixsim import SceneData, load_mjcf_str, step


def run(scene, step_s):
    """Run it; returns what ``in_c`` of ``experiments/engines/published.py`` does."""
    model = load_mjcf_str(scene["mjcf"])
    model.options.timestep = step_s
    data = SceneData(model)
    state = np.array(data.low.dof_positions)
    state[: len(scene["state"])] = scene["state"]
    data.low.set_dof_positions_unchecked(state)
    model.forward_kinematic(data)
    shown = []
    for control in scene["controls"]:
        data.actuator_ctrls = np.array(control, dtype=np.float32)
        step(model, data)
        # A sensor tells how many contacts there are, and the force of up to four, along the normal first.
        felt = [np.array(model.get_sensor_value(finger, data)) for finger in ("finger1", "finger2")]
        force = sum(each[1:].reshape(4, -1)[: int(each[0]), 0].sum() for each in felt)
        shown.append((float(model.get_body("object").get_pose(data)[2]), float(force)))
    return shown, np.array(data.low.dof_positions).tolist()
