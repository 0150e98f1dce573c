"""Compute theoretical values for the runs of section stability."""

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.simulation.task import FRAME_RATE, SHAKE_RATIO_Z

PAD_DMAX = AS_SHIPPED.pad_dmax


def step_s(case: Case) -> float:
    return 1.0 / FRAME_RATE / case.substeps


def solref(ke: float, kd: float) -> tuple[float, float]:
    """Return the timeconst [s] and dampratio that Newton computes from ke and kd.

    The formulas are 2 / kd and kd / (2 √ke) (``convert_solref``).
    """
    return 2.0 / kd, 0.5 * kd / ke**0.5


def is_clamped(case: Case) -> bool:
    """Return whether the engine raises the timeconst to two steps."""
    return (
        case.refsafe
        and not case.pad_direct
        and solref(case.pad_ke, case.pad_kd)[0] < 2.0 * step_s(case)
    )


def reference_stiffness(
    timeconst_s: float, dampratio: float, shortest_s: float, dmax: float = PAD_DMAX
) -> float:
    """Return the stiffness k [1/s²] of the reference acceleration -b v - k r.

    k = 1 / (dmax² timeconst² dampratio²), with a timeconst of at least ``shortest_s``
    (MuJoCo documentation, "Modeling", solver parameters).
    """
    return 1.0 / (dmax * max(timeconst_s, shortest_s) * dampratio) ** 2


def cube_mass_kg(case: Case) -> float:
    return case.cube_density_kg_m3 * case.cube_edge_m**3


def target_demand_m_s2(case: Case) -> float:
    """Return the largest acceleration that friction must give to a cube [m/s²].

    The cube follows the target of the shake. The pads press along y, and friction acts
    along the two other axes: |(a_x, g + a_z)|.
    """
    rate, time = (
        2.0 * np.pi * case.shake_frequency_hz,
        np.linspace(0.0, 2.0 / case.shake_frequency_hz, 1000),
    )
    size = case.shake_amplitude_m * rate**2
    x, z = (
        size * np.sin(rate * time),
        2.25 * float(SHAKE_RATIO_Z) * size * np.sin(1.5 * rate * time),
    )
    return float(np.hypot(x, case.gravity_m_s2 + z).max())


def demand_m_s2(case: Case, trace: Trace) -> float:
    """Return the same acceleration for the actual motion of the hand.

    It is evaluated in the last whole period of the shake, as the second difference of
    the TCP's positions. The part along the pressing direction of the pads, the y axis
    of the hand, does not need friction.
    """
    poses = trace.poses[trace.phase == metrics.SHAKE][:, metrics.TCP].astype(np.float64)
    period = round(2.0 / (case.shake_frequency_hz * trace.frame_dt))
    poses = poses[-period - 2 :]
    acceleration = np.diff(poses[:, :3], 2, axis=0) / trace.frame_dt**2 + [
        0.0,
        0.0,
        case.gravity_m_s2,
    ]
    in_hand = metrics.rotate_inverse(poses[1:-1, 3:], acceleration)
    return float(np.linalg.norm(in_hand[:, [0, 2]], axis=1).max())


def friction_load(case: Case, demand: float, grip_force_n: float) -> float:
    """Return the required friction as a fraction of the limit, m |a| / (μ Σ N).

    Above 1, the cube slides. This is Coulomb's law, which the engine's elliptic cone
    imposes on each contact (MuJoCo documentation, "Computation", friction cones). Only
    the coefficient of the pads counts, because they have priority.
    """
    return cube_mass_kg(case) * demand / (max(case.pad_mu, 1e-5) * grip_force_n)


def exit_bound_m_s(case: Case) -> float:
    """Return the largest exit speed [m/s] from ``start_overlap_m``, which is overlap
    √k.

    An undamped spring would throw the cube out at this speed.
    """
    parts = [(case.pad_ke, case.pad_kd)]
    if not case.cube_in_hand:
        # Cube and ground have the same priority, so the engine uses the mean of their
        # solrefs.
        parts = [(case.cube_ke, case.cube_kd), (AS_SHIPPED.pad_ke, AS_SHIPPED.pad_kd)]
    timeconst, dampratio = np.mean([solref(*material) for material in parts], axis=0)
    return (
        case.start_overlap_m
        * reference_stiffness(timeconst, dampratio, 2.0 * step_s(case)) ** 0.5
    )
