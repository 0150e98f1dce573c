"""Run scenes in MJCF in this process."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from experiments.drivers.mujoco_c import InC
from experiments.drivers.mujoco_warp import InWarp
from experiments.drivers.newton_mujoco import ThroughNewton
from experiments.drivers.scene import Scene, Trace
from experiments.simulation.c_warnings import RunFailed
from measured_report.measuring.measurement import absent

ENGINES = {"c": InC, "warp": InWarp, "newton": ThroughNewton}  # type: dict[str, type]
"""Engines by their names in cases."""
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)  # MuJoCo's default


def numbers(values: Sequence[float]) -> str:
    """Return numbers as text in the format of MJCF."""
    return " ".join(map(str, values))


def run(scene: Scene, engine: str, device: str = "cpu") -> Trace:
    """Return the trace of a scene; raise RunFailed if the run fails.

    The time between samples must be ``STEPS`` steps.
    """
    world = ENGINES[engine](scene.mjcf, 1, device)
    shown = [world.body()]
    for target in scene.targets:
        world.command(np.array([target]))
        world.advance()
        shown.append(world.body())
    position_m, velocity_m_s = map(np.array, zip(*shown, strict=True))
    return Trace(
        position_m,
        velocity_m_s=velocity_m_s,
        contacts=world.contacts(),
        model=world.model,
    )


def columns_of(
    measure: Callable[[], Mapping[str, object]], names: Sequence[str]
) -> dict[str, object]:
    """Return the measured columns, or the reason if the run fails."""
    try:
        return dict(measure())
    except RunFailed as failed:
        return absent(names, str(failed))
