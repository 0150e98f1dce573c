"""Parts of a frame left out while it is captured, to see what they cost. What is left out stays as it was before."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from typing import Any
from unittest import mock

from experiments.simulation.simulation import Simulation

Ablation = Callable[[Simulation], AbstractContextManager]


def nothing(*_: Any, **__: Any) -> None:
    """Queue nothing."""


def no_recording(simulation: Simulation) -> AbstractContextManager:
    return mock.patch.multiple(simulation.recorder, begin_frame=nothing, watch_substep=nothing, end_frame=nothing)


@contextmanager
def no_inverse_kinematics(simulation: Simulation) -> Iterator[None]:
    simulation.part_beside = None
    yield


@contextmanager
def no_targets(simulation: Simulation) -> Iterator[None]:
    simulation.parts[0] = nothing
    simulation.part_beside = None
    yield


def no_collision(simulation: Simulation) -> AbstractContextManager:
    return mock.patch.object(simulation.pipeline, "collide", nothing)


ABLATIONS: Mapping[str, Ablation] = {
    "recording": no_recording,
    "inverse-kinematics": no_inverse_kinematics,
    "control": no_targets,
    "collision": no_collision,
}
