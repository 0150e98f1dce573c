"""Run scenes in an engine that has a Python of its own: ``apart.py SCRIPT QUESTION ANSWER``.

A script has a function ``run`` of a scene, a time step [s] and the engine's options, which returns what the run shows.
"""

import json
import runpy
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np


def main(script: str, question: str, answer: str) -> None:
    """Do the runs that a file asks for, and write into another what each shows, or why nothing."""
    run, results = runpy.run_path(script)["run"], []
    for asked in json.loads(Path(question).read_text(encoding="utf-8")):
        try:
            results.append(run(asked["scene"], asked["step_s"], **asked["options"]))
        except Exception as error:  # each engine has errors of its own, and all of them are data
            results.append({"reason": " ".join(str(error).split())[:120] or type(error).__name__})
    Path(answer).write_text(json.dumps(results), encoding="utf-8")


def sampled(scene: dict, step_s: float, place: Callable[[], list], step: Callable[[], None]) -> list[list[float]]:
    """Step through a scene, and return the body's place [m] at every sample."""
    path = [[float(value) for value in place()]]
    for _ in samples(scene):
        for _ in range(round(scene["sample_s"] / step_s)):
            step()
        path.append([float(value) for value in place()])
    return path


def shaken(
    scene: dict, step_s: float, step: Callable[[list], None], poses: Callable[[], list], contacts: Callable[[], list]
) -> dict[str, list]:
    """Step through a shake, with a target for each joint in each frame.

    Args:
        step: Does a step with such targets.
        poses: Returns the poses of cube and tool, each a place [m] and a quaternion (x, y, z, w).
        contacts: Returns a normal and a tangential force [N] and a depth [m] of each contact; NaN where it is not said.
    """
    shown = {"poses": [], "forces": []}
    for target in scene["targets"]:
        for _ in range(round(scene["sample_s"] / step_s)):
            step(target)
        shown["poses"].append([[float(value) for value in pose] for pose in poses()])
        touched = np.array([[0.0, 0.0, 0.0], *contacts()])
        shown["forces"].append([*touched[:, :2].sum(axis=0).tolist(), float(touched[:, 2].max())])
    return shown


def drive(scene: dict, target: list, places: list, speeds: list) -> np.ndarray:
    """Return the forces of the joints' drives [N m, N], for an engine that has none of its own."""
    forces = scene["ke"] * np.subtract(target, places) - scene["kd"] * np.array(speeds)
    return np.clip(forces, -np.array(scene["effort"]), scene["effort"])


def samples(scene: dict) -> Iterator[float]:
    """Yield the times [s] of the samples after the first."""
    return (scene["sample_s"] * (index + 1) for index in range(round(scene["seconds"] / scene["sample_s"])))


if __name__ == "__main__":
    main(*sys.argv[1:])
