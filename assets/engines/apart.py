"""What the scripts here share: each runs scenes in an engine that has a Python of its own."""

import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path


def answer(run: Callable[..., dict]) -> None:
    """Do the runs that the file ``argv[1]`` asks for, and write into ``argv[2]`` what each shows, or why nothing.

    Args:
        run: Takes a scene, a time step [s] and the engine's options.
    """
    asked_for, answered = map(Path, sys.argv[1:])
    results = []
    for asked in json.loads(asked_for.read_text(encoding="utf-8")):
        try:
            results.append(run(asked["scene"], asked["step_s"], **asked["options"]))
        except Exception as error:  # each engine has errors of its own, and all of them are data
            results.append({"reason": " ".join(str(error).split())[:120] or type(error).__name__})
    answered.write_text(json.dumps(results), encoding="utf-8")


def sampled(scene: dict, step_s: float, place: Callable[[], list], step: Callable[[], None]) -> list[list[float]]:
    """Step through a scene, and return the body's place [m] at every sample."""
    path = [[float(value) for value in place()]]
    for _ in samples(scene):
        for _ in range(round(scene["sample_s"] / step_s)):
            step()
        path.append([float(value) for value in place()])
    return path


def samples(scene: dict) -> Iterator[float]:
    """The times [s] of the samples after the first."""
    return (scene["sample_s"] * (index + 1) for index in range(round(scene["seconds"] / scene["sample_s"])))
