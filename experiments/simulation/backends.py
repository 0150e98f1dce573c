"""The backends of a case: the one place that chooses by ``case.backend``."""

from collections.abc import Sequence

from experiments.facts.case import Case, batch_key
from experiments.simulation.scene import Scene
from experiments.simulation.stepper import Stepper
from experiments.simulation.stepper_c import CStepper
from experiments.simulation.stepper_warp import WarpStepper
from newton_lint.newton_models.compat import warp_has_noslip


def is_in_c(case: Case) -> bool:
    """Tell whether the case runs in MuJoCo's C engine rather than in MuJoCo Warp."""
    return case.backend == "mujoco"


def stepper_of(scene: Scene, cases: Sequence[Case]) -> Stepper:
    """Return the stepper of a batch of cases."""
    return CStepper(scene, cases) if is_in_c(cases[0]) else WarpStepper(scene, cases)


def batches(cases: Sequence[Case]) -> list[list[int]]:
    """Return the indices of the cases that run as worlds of one simulation; the C engine has one world each."""
    groups: dict[object, list[int]] = {}
    for index, case in enumerate(cases):
        groups.setdefault(index if is_in_c(case) else batch_key(case), []).append(index)
    return list(groups.values())


def device_of(case: Case, device: str | None) -> str | None:
    """Return the device that the case runs on where ``device`` was asked for."""
    return "cpu" if is_in_c(case) else case.device or device


def has_noslip(case: Case) -> bool:
    """Tell whether the case's engine has the noslip pass."""
    return is_in_c(case) or warp_has_noslip()
