"""Define the families of section stability and their cases."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from experiments.facts.case import AS_SHIPPED, LEAN, STIFF_PADS, Case
from experiments.simulation.limits import (
    cube_mass_kg,
    is_clamped,
    step_s,
    target_demand_m_s2,
)
from experiments.simulation.scene import EFFORT_LIMIT, PAD_FACE, TARGET_KE

HOLD_FRAME_COUNT = 91  # frames in which a cube that starts in the hand is held still
# Frames of two periods of the shake, or of one.
SHAKE_FRAME_COUNT = {
    "full": 241,
    "quick": 121,
}
LONG_FRAME_COUNT = {"full": HOLD_FRAME_COUNT + 36_001, "quick": HOLD_FRAME_COUNT + 361}

BASE = replace(LEAN, cube_in_hand=True, contact_max=64, constraint_max=192)
"""The base case with larger buffers than a grasp needs.

An arm that falls to the ground has more contacts, which must not overflow the buffers.
"""
PADS = {
    "as-shipped": {},
    "stiff": {"pad_ke": STIFF_PADS.pad_ke, "pad_kd": STIFF_PADS.pad_kd},
}
REFERENCE_SUBSTEPS = AS_SHIPPED.substeps

STEPS = {"full": (1, 2, 4, 8, 16, 32, 64, 128), "quick": (4, 16)}
GRID_STEPS = {"full": STEPS["full"], "quick": (2, 4)}
GRID_KE = {"full": np.logspace(1, 9, 25), "quick": (1e4, 1e6)}
DAMPING = {"ke-critical": lambda ke: 2.0 * ke**0.5, "ke-kd-100": lambda ke: 100.0}
"""kd of the two grids as a function of ke: with a damping ratio of 1, or at its import
default.
"""
TIMECONST_STEPS = {"full": np.geomspace(4.0, 0.25, 9), "quick": (4.0, 0.25)}
SHAKE_MU = 0.0187
"""Friction with which the default grip could hold 1.4 times the cube's weight at rest.
"""
SHAKES = {  # amplitude [m] and frequency [Hz]
    "full": [
        (a, 2.0)
        for a in (0.01, 0.02, 0.03, 0.04, 0.045, 0.05, 0.055, 0.06, 0.07, 0.08, 0.1)
    ]
    + [(0.05, f) for f in (0.5, 1.0, 1.5, 1.75, 2.25, 2.5, 3.0)],
    "quick": [(0.02, 2.0)],
}
GRIP_MU = 0.1
GRIPS = {
    "full": (0.25, 0.5, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.4, 2.0, 4.0),
    "quick": (0.5,),
}
"""Grip force relative to the force that the default shake needs."""
FRICTIONS = {"full": (0.0, 1e-3, 0.1, 1.0, 2.0, 100.0), "quick": (0.0, 100.0)}
MASSES_KG = {"full": np.geomspace(1e-3, 10.0, 9), "quick": (10.0,)}
EDGES_M = {
    "full": (0.002, 0.003, 0.005, 0.008, 0.012, 0.02, 0.03, 0.04, 0.06, 0.08),
    "quick": (0.08,),
}
OVERLAPS_M = {"full": (1e-4, 3e-4, 1e-3, 3e-3, 5e-3), "quick": (5e-3,)}
GRAVITIES = {"full": (0.0, 9.81, 98.1, -9.81), "quick": (-9.81,)}
SPRINGY = {"cube_ke": 1e8, "cube_kd": 1e3}
"""Material of a cube that leaves the ground. The default material is damped too much.
"""
BUFFERS = (
    {},
    {"contact_max": 8},
    {"contact_max": 4},
    {"constraint_max": 24},
    {"constraint_max": 12},
)  # type: tuple[dict, ...]
"""Unchanged buffers, then smaller buffers than the grasp needs."""
OVERFLOW_FRAME_COUNT = 4  # an overflow occurs in the first frame
# Grip that is added for the inertia of the fingers if the grip scales with the cube's
# mass.
FINGER_FORCE_N = 1.0


@dataclass(frozen=True)
class Probe:
    """Describe one case of a family, which runs several times with different starts."""

    family: str
    case: Case
    parameters: dict[str, object]  # varied parameters, as columns of the row


def probe(family: str, name: str, changes: Mapping[str, Any], **parameters) -> Probe:
    case = replace(BASE, name=f"{family}-{name}", **changes)
    columns = {"pad_ke": case.pad_ke, "pad_kd": case.pad_kd, "substeps": case.substeps}
    return Probe(family, case, columns | parameters)


def probes(profile: str) -> list[Probe]:
    """Return all families except the buffers, whose runs have another length."""
    return [
        *steps(profile),
        *grids(profile),
        *without_clamp(profile),
        *shakes(profile),
        *grips(profile),
        *frictions(profile),
        *masses(profile),
        *sizes(profile),
        *overlaps(profile),
        *gravities(profile),
    ]


def steps(profile: str) -> list[Probe]:
    return [
        probe("steps", f"{pads}-{count}", changes | {"substeps": count}, pads=pads)
        for pads, changes in PADS.items()
        for count in STEPS[profile]
    ]


def grids(profile: str) -> list[Probe]:
    return [
        grid_cell(family, float(ke), count)
        for family in DAMPING
        for ke in GRID_KE[profile]
        for count in GRID_STEPS[profile]
    ]


def grid_cell(family: str, ke: float, substeps: int) -> Probe:
    changes = {"pad_ke": ke, "pad_kd": DAMPING[family](ke), "substeps": substeps}
    cell = probe(family, f"{ke:.3g}-{substeps}", changes)
    return replace(
        cell, parameters=cell.parameters | {"clamped": is_clamped(cell.case)}
    )


def without_clamp(profile: str) -> list[Probe]:
    """Return cases with damping ratio 1 and a timeconst of several steps.

    Each case runs once with the clamp off and once with a direct solref.
    """
    cells = []
    for way, changes in (("off", {"refsafe": False}), ("direct", {"pad_direct": True})):
        for count in TIMECONST_STEPS[profile]:
            rate = 1.0 / (count * step_s(BASE))
            stiff = {"pad_ke": rate**2, "pad_kd": 2.0 * rate}
            cells.append(
                probe(
                    "clamp",
                    f"{way}-{count:.3g}",
                    changes | stiff,
                    clamp=way,
                    timeconst_steps=float(count),
                )
            )
    return cells


def shakes(profile: str) -> list[Probe]:
    return [
        probe(
            "shake",
            f"{1e3 * a:g}mm-{f:g}hz",
            PADS["stiff"]
            | {"pad_mu": SHAKE_MU, "shake_amplitude_m": a, "shake_frequency_hz": f},
            shake_amplitude_m=a,
            shake_frequency_hz=f,
        )
        for a, f in SHAKES[profile]
    ]


def grips(profile: str) -> list[Probe]:
    needed = cube_mass_kg(BASE) * target_demand_m_s2(BASE) / GRIP_MU / 2.0
    return [
        probe(
            "grip",
            f"{ratio:g}",
            PADS["stiff"]
            | {
                "pad_mu": GRIP_MU,
                "finger_closed_m": closed_m(BASE.cube_edge_m, ratio * needed),
            },
            grip_ratio=ratio,
        )
        for ratio in GRIPS[profile]
    ]


def frictions(profile: str) -> list[Probe]:
    return [
        probe("friction", f"{mu:g}", PADS["stiff"] | {"pad_mu": mu}, pad_mu=mu)
        for mu in FRICTIONS[profile]
    ]


def masses(profile: str) -> list[Probe]:
    found = []
    for mass in (float(mass) for mass in MASSES_KG[profile]):
        changes = {"cube_density_kg_m3": mass / BASE.cube_edge_m**3}
        changes["finger_closed_m"] = closed_m(BASE.cube_edge_m, carrying_force_n(mass))
        found.append(
            probe("mass", f"{mass:.3g}kg", PADS["stiff"] | changes, cube_mass_kg=mass)
        )
    return found


def sizes(profile: str) -> list[Probe]:
    """Return cubes of one density, in the default grip and in a grip that scales with
    the mass.
    """
    found = []
    as_shipped_n = TARGET_KE * (
        0.5 * BASE.cube_edge_m + PAD_FACE - AS_SHIPPED.finger_closed_m
    )
    for edge in EDGES_M[profile]:
        mass = BASE.cube_density_kg_m3 * edge**3
        for grip, force in (
            ("as-shipped", as_shipped_n),
            ("scaled", carrying_force_n(mass)),
        ):
            changes = PADS["stiff"] | {
                "cube_edge_m": edge,
                "finger_closed_m": closed_m(edge, force),
            }
            found.append(
                probe(
                    "size",
                    f"{1e3 * edge:g}mm-{grip}",
                    changes,
                    cube_edge_mm=1e3 * edge,
                    grip=grip,
                )
            )
    return found


def overlaps(profile: str) -> list[Probe]:
    """Return cases that start with an overlap.

    The cube overlaps both pads or the ground, with the default contacts or with springy
    contacts.
    """
    starts = {f"pads-{pads}": changes for pads, changes in PADS.items()}
    if profile == "full":  # a quick run ends before a cube from the ground is shaken
        starts["ground"] = {"cube_in_hand": False}
        starts["ground-springy"] = starts["ground"] | SPRINGY
    return [
        probe(
            "overlap",
            f"{start}-{1e3 * overlap:g}mm",
            changes | {"start_overlap_m": overlap},
            start=start,
            overlap_mm=1e3 * overlap,
        )
        for start, changes in starts.items()
        for overlap in OVERLAPS_M[profile]
    ]


def gravities(profile: str) -> list[Probe]:
    return [
        probe(
            "gravity",
            f"{gravity:g}",
            PADS["stiff"] | {"gravity_m_s2": gravity},
            gravity_m_s2=gravity,
        )
        for gravity in GRAVITIES[profile]
    ]


def long_run(profile: str) -> Probe:
    """Return the long run, which is one world for ten minutes.

    For one world a CPU is as fast as a GPU. The CPU runs this case while the GPU runs
    all other cases.
    """
    room = {"contact_max": LEAN.contact_max, "constraint_max": LEAN.constraint_max}
    changes = (
        PADS["stiff"]
        | room
        | {"frame_count": LONG_FRAME_COUNT[profile], "device": "cpu"}
    )
    return probe("long", "stiff", changes)


def buffers(frame_count: int) -> list[Probe]:
    return [
        probe(
            "buffers",
            "-".join(
                f"{name.removesuffix('_max')}-{count}" for name, count in room.items()
            )
            or "ample",
            PADS["stiff"]
            | room
            | {"frame_count": OVERFLOW_FRAME_COUNT if room else frame_count},
            contact_max=room.get("contact_max", BASE.contact_max),
            constraint_max=room.get("constraint_max", BASE.constraint_max),
        )
        for room in BUFFERS
    ]


def carrying_force_n(mass_kg: float) -> float:
    """Return the force [N] of each finger that holds ``mass_kg`` with a margin.

    Friction could hold slightly more than twice the mass in the default shake. The
    force is limited to the effort limit of the fingers.
    """
    return min(
        mass_kg * target_demand_m_s2(BASE) / BASE.pad_mu + FINGER_FORCE_N,
        EFFORT_LIMIT[-1],
    )


def closed_m(edge_m: float, force_n: float) -> float:
    """Return the finger's target [m] at which it presses on a cube with ``force_n``."""
    return 0.5 * edge_m + PAD_FACE - force_n / TARGET_KE
