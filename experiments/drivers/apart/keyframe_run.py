"""MuJoCo C of any release, from the first keyframe of the scene; the last body is watched."""

import mujoco
from apart import World


def load(scene):
    model = mujoco.MjModel.from_xml_string(scene.mjcf)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    return World(lambda _: mujoco.mj_step(model, data), lambda: [data.xpos[-1]])
