"""Engines that run a scene in MJCF in this process."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from experiments.drivers.mujoco_c import InC
from experiments.drivers.mujoco_warp import InWarp
from experiments.drivers.newton_mujoco import ThroughNewton
from experiments.drivers.scene import Scene, Trace
from experiments.simulation.c_warnings import RunFailed
from measured_report.measuring.measurement import absent

ENGINES = {"c": InC, "warp": InWarp, "newton": ThroughNewton}  # type: dict[str, type]
"""Engines by the names that cases say."""
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)  # MuJoCo's own


def numbers(values: Sequence[float]) -> str:
    """Write numbers as MJCF has them."""
    return " ".join(map(str, values))


def run(scene: Scene, engine: str, device: str = "cpu") -> Trace:
    """Return what a scene shows, whose samples are ``STEPS`` steps; RunFailed if nothing."""
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
    """Return what is measured, or the reason why a run shows none of the columns."""
    try:
        return dict(measure())
    except RunFailed as failed:
        return absent(names, str(failed))
