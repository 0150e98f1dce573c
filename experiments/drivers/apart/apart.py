"""Run scenes in an engine that has a Python of its own: ``apart.py SCRIPT QUESTION ANSWER``.

A script has ``load``, which makes a ``World`` of a scene and the engine's options. Scenes
are those of ``experiments/drivers/scene.py``, with attributes of the same names.
"""

import json
import runpy
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import numpy as np


@dataclass
class World:
    """A scene in an engine.

    Attributes:
        step: Takes a step with these targets of the joints.
        poses: Returns position [m] and quaternion (x, y, z, w) of the body and the tool.
        forces: Returns normal and tangential force [N] and depth [m] of each contact;
            NaN where the engine does not tell it.
        joints: Returns the positions of all joints [rad, m].
        step_count: How many steps a sample takes, where they are not the scene's.
    """

    step: Callable
    poses: Callable
    forces: Callable = list
    joints: Callable = list
    step_count: int = 0


def run(scene, world):
    """Return poses at the start and after each sample, sums of forces, and joints."""
    count = world.step_count or round(scene.sample_s / scene.step_s)
    poses = [floats(world.poses())]
    forces = []
    for target in scene.targets:
        for _ in range(count):
            world.step(target)
        poses.append(floats(world.poses()))
        touched = np.array([[0.0, 0.0, 0.0], *world.forces()])
        sums = touched[:, :2].sum(axis=0).tolist()
        forces.append([*sums, float(touched[:, 2].max())])
    return {"poses": poses, "forces": forces, "joints": floats(world.joints())}


def floats(values):
    """Return numbers of any kind as plain lists."""
    return np.array(list(values), dtype=float).tolist()


def drive(robot, target, positions, velocities):
    """Return the forces of the joints' drives [N m, N], for engines without drives."""
    errors = np.subtract(target, positions)
    forces = robot.ke * errors - robot.kd * np.array(velocities)
    return np.clip(forces, -np.array(robot.effort), robot.effort)


def main(script, question, answer):
    """Run what a file asks for; write what each run shows, or why it shows nothing."""
    load = runpy.run_path(script)["load"]
    text = Path(question).read_text(encoding="utf-8")
    asked = json.loads(text, object_hook=lambda items: SimpleNamespace(**items))
    results = []
    for scene in asked.scenes:
        try:
            results.append(run(scene, load(scene, **vars(asked.options))))
        except Exception as error:  # engines have errors of their own; all are data
            reason = " ".join(str(error).split())[:120] or type(error).__name__
            results.append({"reason": reason})
    Path(answer).write_text(json.dumps(results), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
