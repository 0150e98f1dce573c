"""Run scenes in an engine that has a Python of its own: ``apart.py SCRIPT QUESTION ANSWER``.

A script defines a ``World`` of a scene and the engine's options. Scenes are those of
``experiments/drivers/scenes.py``, with attributes of the same names.
"""

import json
import runpy
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np


class World:
    """A scene in an engine that goes from sample to sample."""

    def __init__(self, scene):
        self.scene = scene

    def command(self, target):
        """Set the joints' targets until the next sample."""
        self.target = target

    def advance(self):
        """Go on to the next sample."""
        for _ in range(round(self.scene.sample_s / self.scene.step_s)):
            self.step()

    def step(self):
        """Take one time step."""
        raise NotImplementedError

    def poses(self):
        """Return position [m] and quaternion (x, y, z, w) of the body, and of the tool."""
        raise NotImplementedError

    def forces(self):
        """Return normal and tangential force [N] and depth [m] of each contact.

        NaN stands for what the engine does not tell.
        """
        return []

    def joints(self):
        """Return the positions of all joints [rad, m]."""
        return []

    def drive(self, positions, velocities):
        """Return the forces of the joints' drives [N m, N], for engines without drives."""
        robot = self.scene.robot
        errors = np.subtract(self.target, positions)
        forces = robot.ke * errors - robot.kd * np.array(velocities)
        return np.clip(forces, -np.array(robot.effort), robot.effort)


def run(scene, world):
    """Return poses at the start and after each sample, sums of forces, and joints."""
    poses = [floats(world.poses())]
    forces = []
    for target in scene.targets:
        world.command(target)
        world.advance()
        poses.append(floats(world.poses()))
        touched = np.array([[0.0, 0.0, 0.0], *world.forces()])
        forces.append(
            [*touched[:, :2].sum(axis=0).tolist(), float(touched[:, 2].max())]
        )
    return {"poses": poses, "forces": forces, "joints": floats(world.joints())}


def floats(values):
    """Return numbers of any kind as plain lists."""
    return np.array(list(values), dtype=float).tolist()


def main(script, question, answer):
    """Run what a file asks for; write what each run shows, or why it shows nothing."""
    make_world = runpy.run_path(script)["World"]
    text = Path(question).read_text(encoding="utf-8")
    asked = json.loads(text, object_hook=lambda items: SimpleNamespace(**items))
    results = []
    for scene in asked.scenes:
        try:
            results.append(run(scene, make_world(scene, **vars(asked.options))))
        except Exception as error:  # engines have errors of their own; all are data
            reason = " ".join(str(error).split())[:120] or type(error).__name__
            results.append({"reason": reason})
    Path(answer).write_text(json.dumps(results), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
