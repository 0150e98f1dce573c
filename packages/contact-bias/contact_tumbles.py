# SPDX-License-Identifier: Apache-2.0
"""Measures whether the exact term adds energy to bodies that tumble.

    python -m contact_tumbles            # 24,000 pairs of worlds, for a GPU
    python -m contact_tumbles --quick    # 192 pairs, for a CPU

Each world is run with and without the term. For both, the benchmark records the largest
energy relative to the energy of the body at rest, and the largest height. The spins are slow
enough for the term to have an effect. Tumbling is chaotic, and the time step causes an
error too, so some worlds gain energy without the term. To see the effect of the term,
compare the pairs in which only one of the two worlds gains energy or rises higher.
"""

import argparse
import math
from collections.abc import Callable, Iterator, Sequence
from copy import copy
from functools import partial
from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp

import contact_place

STEPS_S = {"full": (0.0005, 0.001, 0.002, 0.005, 0.01), "quick": (0.005,)}
# The number of pairs for each body, step and start. 12 bodies, 5 steps and 4 starts make
# 24,000 pairs.
PAIR_COUNT = {
    "full": 100,
    "quick": 4,
}
SECONDS = wp.constant(1.0)
RADIUS_M, HELD_M, FRICTION, GAIN, RISE_M = 0.03, 0.2, 0.8, 1.01, 1e-3
# Larger ratios of energy, and worlds without a finite energy, count as this ratio.
BROKEN = 1e3
# Each start has a tilt [rad], a spin [rad/s] and a height above the ground or block [m].
STARTS = {
    "wobbles": ((0.03, 0.3), (2.0, 30.0), (0.0, 0.0)),
    "spins": ((0.03, 0.3), (10.0, 40.0), (0.0, 0.0)),
    "rolls": ((0.8, 1.5), (5.0, 30.0), (0.0, 0.0)),
    "falls": ((0.0, np.pi), (0.0, 40.0), (0.05, 0.5)),
}
AT_RANDOM = ("wobbles", "falls")  # In the other starts, bodies spin about their axis.
CORNERS = " ".join(
    f"{x} {y} {z}"
    for x, y, z in np.random.default_rng(7).normal(scale=0.03, size=(14, 3)).round(4)
)
RIM = [
    (RADIUS_M * np.cos(angle), RADIUS_M * np.sin(angle), 0.0)
    for angle in np.linspace(0, 2 * np.pi, 24, False)
]
CONE = " ".join(f"{x:.5f} {y:.5f} {z}" for x, y, z in [*RIM, (0.0, 0.0, 0.06)])
CAN, COIN = (
    f'type="cylinder" size="{RADIUS_M} {RADIUS_M}"',
    f'type="cylinder" size="{RADIUS_M} 0.003"',
)
BLOCK = f'<body pos="0 0 0.03"><freejoint/><geom type="box" size="0.06 0.06 0.03" mass="1" friction="{FRICTION}"/></body>'
PADS = "".join(
    f"""<body pos="{sign * (RADIUS_M + 0.01)} 0 {HELD_M}">
    <joint type="slide" axis="{-sign} 0 0" stiffness="1000" springref="0.01"/>
    <geom type="box" size="0.01 0.04 0.04" mass="0.2" friction="{FRICTION}"/></body>"""
    for sign in (-1, 1)
)
BODIES = {  # Each entry has the geom of the body, and further bodies on the ground.
    "box": (f'type="box" size="{RADIUS_M} 0.02 0.045"', ""),
    "can": (CAN, ""),
    "coin": (COIN, ""),
    "capsule": (f'type="capsule" size="{RADIUS_M} {RADIUS_M}"', ""),
    "ellipsoid": (f'type="ellipsoid" size="{RADIUS_M} 0.02 0.045"', ""),
    "lens": (f'type="ellipsoid" size="{RADIUS_M} {RADIUS_M} 0.006"', ""),
    "hull": ('type="mesh" mesh="hull"', ""),
    "cone": ('type="mesh" mesh="cone"', ""),
    "top": ('type="mesh" mesh="cone" euler="180 0 0"', ""),
    "can-on-block": (CAN, BLOCK),
    "coin-on-block": (COIN, BLOCK),
    "can-in-pads": (CAN, PADS),
}


def measure(body: str, profile: str, device: str) -> list[dict]:
    """Return a row for each time step with the pairs that differ in energy or height.

    Args:
        body: One of ``BODIES``.
        profile: ``full`` or ``quick``.
        device: Warp device, such as ``cuda:0``.
    """
    steps_s = STEPS_S[profile]
    energies, heights_m = peaks(body, steps_s, PAIR_COUNT[profile], device)
    return [
        row_of(body, *of_step)
        for of_step in zip(steps_s, energies, heights_m, strict=True)
    ]


def row_of(
    body: str, step_s: float, energies: np.ndarray, heights_m: np.ndarray
) -> dict[str, object]:
    """Count the worlds that gain over 1 % of energy, and the pairs that differ.

    Args:
        energies: Largest energy of each world relative to its start, of shape
            [2, worlds]: first without the term, then with it.
        heights_m: The largest height [m] that the body reaches in each world, of the
            same shape.
    """
    (plain, exact), (plain_m, exact_m) = np.minimum(energies, BROKEN), heights_m
    counts = {
        "plain_gain_count": plain > GAIN,
        "exact_gain_count": exact > GAIN,
        "plain_alone_count": (plain > GAIN) & (exact <= GAIN),
        "exact_alone_count": (exact > GAIN) & (plain <= GAIN),
        "higher_count": exact_m > plain_m + RISE_M,
        "lower_count": exact_m < plain_m - RISE_M,
    }
    row = {
        "case": f"tumble-{body}-{1e3 * step_s:g}ms",
        "tumbling": body,
        "step_ms": 1e3 * step_s,
    }
    row |= {"contact_bias": True, "pair_count": energies.shape[1]}
    row |= {name: int(chosen.sum()) for name, chosen in counts.items()}
    return row | {
        "plain_most_energy": float(plain.max()),
        "exact_most_energy": float(exact.max()),
    }


def model_of(body: str) -> mujoco.MjModel:
    geom, beside = BODIES[body]
    return mujoco.MjModel.from_xml_string(f"""<mujoco>
      <option cone="elliptic" integrator="implicitfast" impratio="10">
        <flag energy="enable"/>
      </option>
      <asset><mesh name="hull" vertex="{CORNERS}"/><mesh name="cone" vertex="{CONE}"/></asset>
      <worldbody>
        <geom type="plane" size="5 5 1" friction="{FRICTION}"/>{beside}
        <body pos="0 0 {HELD_M}"><freejoint/><geom {geom} mass="0.2" friction="{FRICTION}"/></body>
      </worldbody>
    </mujoco>""")


def starts_of(
    model: mujoco.MjModel, count: int
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the positions and velocities of the starts, which all steps share.

    Args:
        count: Number of draws for each start. Bodies between pads are not tilted.
    """
    random, data, near = np.random.default_rng(0), mujoco.MjData(model), copy(model)
    near.geom_margin[:] = 1.0  # With this margin there is a distance to the ground.
    is_free = model.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE
    block_m = 2.0 * model.geom_size[1:-1, 2].sum()
    for start, (tilts, spins, heights_m) in STARTS.items():
        for _ in range(count):
            data.qpos[:], data.qvel[:] = model.qpos0, 0.0
            heading, way = random.uniform(0.0, 2.0 * np.pi), random.normal(size=3)
            axis = np.array([np.cos(heading), np.sin(heading), 0.0])
            mujoco.mju_axisAngle2Quat(
                data.qpos[-4:], axis, random.uniform(*tilts) if is_free else 0.0
            )
            turning = (
                way / np.linalg.norm(way)
                if start in AT_RANDOM
                else np.array([0.0, 0.0, 1.0])
            )
            data.qvel[-3:] = random.uniform(*spins) * turning
            mujoco.mj_fwdPosition(near, data)
            if is_free:
                to_ground = [
                    contact
                    for contact in data.contact
                    if tuple(contact.geom) == (0, model.ngeom - 1)
                ]
                nearest = min(to_ground, key=lambda contact: contact.dist)
                if start == "rolls":
                    spin = data.xmat[-1].reshape(3, 3) @ data.qvel[-3:]
                    data.qvel[-6:-3] = np.cross(nearest.pos - data.xpos[-1], spin)
                data.qpos[-5] += block_m + random.uniform(*heights_m) - nearest.dist
            yield data.qpos.copy(), data.qvel.copy()


@wp.kernel(enable_backward=False)
def keep_peaks(
    energy: wp.array[wp.vec2],
    places: wp.array2d[wp.vec3],
    timestep: wp.array[float],
    time: wp.array[float],
    last: wp.array[float],
    most: wp.array[float],
    highest: wp.array[float],
):
    world = wp.tid()
    if time[world] > SECONDS + 0.5 * timestep[world]:
        return
    last[world] = energy[world][0] + energy[world][1]
    most[world] = wp.max(
        most[world], wp.where(wp.isfinite(last[world]), last[world], wp.inf)
    )
    highest[world] = wp.max(highest[world], places[world, places.shape[1] - 1][2])


def captured(queue: Callable[[], None]) -> Callable[[], None]:
    """Return a function that replays ``queue`` as a graph on the current stream."""
    with wp.ScopedCapture() as capture:
        queue()
    return partial(wp.capture_launch, capture.graph)


def peaks(
    body: str, steps_s: Sequence[float], count: int, device: str
) -> tuple[np.ndarray, np.ndarray]:
    """Return the largest relative energy of each world, and the height of its body [m].

    Both have the shape [steps, 2, worlds]. The worlds of all time steps run as one
    batch. A world that has reached its end time continues, but is no longer recorded.
    """
    model = model_of(body)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    qpos, qvel = map(np.array, zip(*starts_of(model, count), strict=True))
    shape = (len(steps_s), 2, len(qpos))
    with wp.ScopedDevice(device):
        m = mjw.put_model(model)
        d = mjw.put_data(model, data, nworld=math.prod(shape), nconmax=32, njmax=128)
        m.opt.timestep = wp.array(
            np.repeat(steps_s, d.nworld // len(steps_s)), dtype=float
        )
        worlds = np.broadcast_to([[False], [True]], shape).ravel().tolist()
        contact_place.install(
            SimpleNamespace(mjw_model=m, mjw_data=d), normal=True, worlds=worlds
        )
        last, most, highest = (wp.empty(d.nworld, dtype=float) for _ in range(3))

        def step() -> None:
            mjw.step(m, d)  # It computes energy and positions before the step.
            wp.launch(
                keep_peaks,
                dim=d.nworld,
                inputs=[d.energy, d.xipos, m.opt.timestep, d.time, last, most, highest],
            )

        step()  # This compiles the kernels, which is not possible inside a capture.
        advance = captured(step)
        d.qpos.assign(np.tile(qpos, (d.nworld // len(qpos), 1)).astype(np.float32))
        d.qvel.assign(np.tile(qvel, (d.nworld // len(qpos), 1)).astype(np.float32))
        d.qacc_warmstart.zero_()
        d.time.zero_()
        mjw.forward(m, d)
        start = d.energy.numpy().sum(axis=1, dtype=float)
        for values in (most, highest):
            values.fill_(-wp.inf)
        for _ in range(round(SECONDS / min(steps_s))):
            advance()
        energies = relative(
            *(values.reshape(shape) for values in (start, most.numpy(), last.numpy()))
        )
        return energies, highest.numpy().reshape(shape)


def relative(start: np.ndarray, most: np.ndarray, last: np.ndarray) -> np.ndarray:
    """Return the largest energy relative to that at the start.

    Energies are measured from the lowest energy at which a world without the term ends;
    worlds that end without a finite energy are ignored. All arrays have the shape
    [steps, 2, worlds].
    """
    floor = np.nanmin(last[:, :1], axis=-1, keepdims=True)
    return (most - floor) / (start - floor)


def main() -> None:
    """Print a line for each body and step."""
    parser = argparse.ArgumentParser(
        prog="python -m contact_tumbles", description="Pairs of tumbling bodies"
    )
    parser.add_argument("--quick", action="store_true", help="one step and few pairs")
    parser.add_argument(
        "--device", help="Warp device, as cuda:0 or cpu; CUDA if there is one"
    )
    arguments = parser.parse_args()
    profile, device = (
        "quick" if arguments.quick else "full",
        wp.get_device(arguments.device).alias,
    )
    for body in BODIES:
        for row in measure(body, profile, device):
            print(
                f"{body:13} {row['step_ms']:4g} ms, {row['pair_count']} pairs: "
                f"{row['exact_gain_count']} gain energy with the term and {row['plain_gain_count']} without it, "
                f"{row['higher_count']} rise higher with it and {row['lower_count']} less",
                flush=True,
            )


if __name__ == "__main__":
    main()
