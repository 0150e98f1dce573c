"""Parts of a frame left out while it is captured, to see what they cost. What is left out stays as it was before."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from typing import Any
from unittest import mock

from experiments.simulation.simulation import Simulation

Switch = Callable[[Simulation], AbstractContextManager]


def nothing(*_: Any, **__: Any) -> None:
    """Queue nothing."""


def once_a_frame(call: Callable, substeps: int, at: int) -> Callable:
    """Make a call that is done in substep ``at`` of each frame only."""
    count = 0

    def counted(*arguments: Any, **options: Any) -> None:
        nonlocal count
        if count % substeps == at:
            call(*arguments, **options)
        count += 1

    return counted


@contextmanager
def no_recording(simulation: Simulation) -> Iterator[None]:
    with mock.patch.multiple(simulation.recorder, begin_frame=nothing, watch_substep=nothing, end_frame=nothing):
        yield


@contextmanager
def no_watching(simulation: Simulation) -> Iterator[None]:
    with mock.patch.object(simulation.recorder, "watch_substep", nothing):
        yield


@contextmanager
def no_inverse_kinematics(simulation: Simulation) -> Iterator[None]:
    simulation.part_beside = None
    yield


@contextmanager
def no_targets(simulation: Simulation) -> Iterator[None]:
    simulation.parts[0] = nothing
    simulation.part_beside = None
    yield


@contextmanager
def no_collision(simulation: Simulation) -> Iterator[None]:
    with mock.patch.object(simulation.pipeline, "collide", nothing):
        yield


@contextmanager
def contacts_once(simulation: Simulation) -> Iterator[None]:
    solver = simulation.solver
    convert = once_a_frame(solver._convert_contacts_to_mjwarp, simulation.case.substeps, 0)
    with mock.patch.object(solver, "_convert_contacts_to_mjwarp", convert):
        yield


@contextmanager
def state_once(simulation: Simulation) -> Iterator[None]:
    solver, substeps = simulation.solver, simulation.case.substeps
    with mock.patch.object(
        solver, "_update_newton_state", once_a_frame(solver._update_newton_state, substeps, substeps - 1)
    ):
        yield


SWITCHES: Mapping[str, Switch] = {
    "recording": no_recording,
    "watching": no_watching,
    "inverse-kinematics": no_inverse_kinematics,
    "control": no_targets,
    "collision": no_collision,
    "contacts-once": contacts_once,
    "state-once": state_once,
}
"""By name. ``contacts-once`` and ``state-once`` hand contacts to the engine, and its state to Newton, once a frame."""
