"""Bodies that are dropped with a spin and tumble: does the exact term put energy into any of them?

Each world is run with nothing done, with nothing done from a start that is a hair's breadth aside, with the exact term
and with that of the material points alone. A tumble is chaos, and a step of a spinning body in the air has an error of
its own: what two sets of worlds without the term have differently is no effect of it.
"""

from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp
from tqdm import tqdm

from experiments.simulation import contact_bias, contact_place
from experiments.simulation.measurement import Conditions

VARIANTS = ("plain", "aside", "exact", "points")
ASIDE_RAD_S = 1e-3
STEPS_S = {"full": (0.0005, 0.001, 0.002, 0.005, 0.01), "quick": (0.005,)}
WORLD_COUNT = {"full": 300, "quick": 32}  # of each body, step and variant: 7 bodies at 5 steps are 10,500 worlds
SECONDS = 1.0
SAMPLE_S = 0.1
DROPS_M, SPINS_RAD_S = (0.05, 0.5), (0.0, 200.0)
RADIUS_M, FRICTION, GAIN = 0.03, 0.8, 1.01
CORNERS = " ".join(f"{x} {y} {z}" for x, y, z in np.random.default_rng(7).normal(scale=0.03, size=(14, 3)).round(4))
RIM = [(RADIUS_M * np.cos(angle), RADIUS_M * np.sin(angle), 0.0) for angle in np.linspace(0, 2 * np.pi, 24, False)]
CONE = " ".join(f"{x:.5f} {y:.5f} {z}" for x, y, z in [*RIM, (0.0, 0.0, 0.06)])
BODIES = {
    "box": f'type="box" size="{RADIUS_M} 0.02 0.045"',
    "cylinder": f'type="cylinder" size="{RADIUS_M} {RADIUS_M}"',
    "coin": f'type="cylinder" size="{RADIUS_M} 0.006"',
    "capsule": f'type="capsule" size="{RADIUS_M} {RADIUS_M}"',
    "ellipsoid": f'type="ellipsoid" size="{RADIUS_M} 0.02 0.045"',
    "mesh": 'type="mesh" mesh="convex"',
    "cone": 'type="mesh" mesh="cone"',
}


def measure(conditions: Conditions) -> list[dict]:
    """Make a row for each body and step: in how many worlds the energy rises."""
    chosen = [(body, step_s) for body in BODIES for step_s in STEPS_S[conditions.profile]]
    return [
        row_of(body, step_s, energies_left(body, step_s, WORLD_COUNT[conditions.profile], conditions.device))
        for body, step_s in tqdm(chosen, desc="cure, tumbles", unit="batch", delay=3.0)
    ]


def row_of(body: str, step_s: float, left: np.ndarray) -> dict[str, object]:
    """Count the worlds whose energy ends over 1 % above its start, or as no number, which is more than any.

    Args:
        left: Energy at the end by that at the start, shape [variants, worlds].
    """
    row = {"case": f"tumble-{body}-{1e3 * step_s:g}ms", "tumbling": body, "step_ms": 1e3 * step_s}
    row |= {"contact_bias": True, "world_count": left.shape[1]}
    gains = (np.nan_to_num(left, nan=np.inf) > GAIN).sum(axis=1).tolist()
    return row | {f"{name}_gain_count": count for name, count in zip(VARIANTS, gains, strict=True)}


def model_of(body: str, step_s: float) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(f"""<mujoco>
      <option timestep="{step_s}" cone="elliptic" integrator="implicitfast" impratio="10">
        <flag energy="enable"/>
      </option>
      <asset><mesh name="convex" vertex="{CORNERS}"/><mesh name="cone" vertex="{CONE}"/></asset>
      <worldbody>
        <geom type="plane" size="5 5 1" friction="{FRICTION}"/>
        <body><freejoint/><geom {BODIES[body]} mass="0.2" friction="{FRICTION}"/></body>
      </worldbody>
    </mujoco>""")


def starts_of(model: mujoco.MjModel, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Draw places and velocities, shapes [count, 7] and [count, 6]; all bodies and steps have the same."""
    random = np.random.default_rng(0)
    qpos, qvel = np.zeros((count, 7)), np.zeros((count, 6))
    qpos[:, 2] = model.geom_rbound[-1] + random.uniform(*DROPS_M, count)
    qpos[:, 3:] = random.normal(size=(count, 4))
    qpos[:, 3:] /= np.linalg.norm(qpos[:, 3:], axis=1, keepdims=True)
    axis = random.normal(size=(count, 3))
    qvel[:, 3:] = random.uniform(*SPINS_RAD_S, (count, 1)) * axis / np.linalg.norm(axis, axis=1, keepdims=True)
    return qpos, qvel


def energies_left(body: str, step_s: float, count: int, device: str) -> np.ndarray:
    """Return kinetic and potential energy after SECONDS, by that at the start, shape [variants, worlds]."""
    model = model_of(body, step_s)
    data, (qpos, qvel) = mujoco.MjData(model), starts_of(model, count)
    mujoco.mj_forward(model, data)
    with wp.ScopedDevice(device):
        m = mjw.put_model(model)
        d = mjw.put_data(model, data, nworld=len(VARIANTS) * count, nconmax=16, njmax=64)
        for name, install in (("points", contact_bias.install), ("exact", contact_place.install)):
            worlds = np.repeat([variant == name for variant in VARIANTS], count).tolist()
            install(SimpleNamespace(mjw_model=m, mjw_data=d), centred=True, normal=True, worlds=worlds)
        mjw.step(m, d)  # compiles, which must not happen inside a capture
        with wp.ScopedCapture() as capture:
            for _ in range(round(SAMPLE_S / step_s)):
                mjw.step(m, d)
        aside = qvel + np.array([0.0, 0.0, 0.0, ASIDE_RAD_S, 0.0, 0.0])
        d.qpos.assign(np.tile(qpos, (len(VARIANTS), 1)).astype(np.float32))
        d.qvel.assign(np.concatenate([aside if name == "aside" else qvel for name in VARIANTS]).astype(np.float32))
        d.qacc_warmstart.zero_()
        mjw.forward(m, d)
        start = d.energy.numpy().sum(axis=1, dtype=float)
        for _ in range(round(SECONDS / SAMPLE_S)):
            wp.capture_launch(capture.graph)
        mjw.forward(m, d)
        return (d.energy.numpy().sum(axis=1, dtype=float) / start).reshape(len(VARIANTS), count)
