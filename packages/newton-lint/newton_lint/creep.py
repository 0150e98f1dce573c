"""How fast a contact that holds will slide: predicted from its parameters alone, by the report's law.

A friction row asks for the acceleration -b v and yields R f to its force f (MuJoCo documentation, "Computation",
constraint model). At a steady rate both balance what the row does not know of, an acceleration a such as J̇·q̇:

    b v = a + R f,    b = 2 / (dmax timeconst),    R = (1 - d) / d · w / impratio,

with the contact's impedance d and w, the sum of both bodies' body_invweight0; (1 + μ²) w in a row of a pyramid.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

M = 1e3
"""mm in a metre."""


@dataclass(frozen=True)
class Creep:
    """A predicted slide of one contact."""

    response_s: float
    """1 / b [s]: m/s for each m/s² of acceleration that the rows leave out."""
    yield_m_s_n: float
    """R / b [m/s/N]: m/s for each newton of tangential force that one contact point carries."""
    acceleration_mm_s: float
    load_mm_s: float


def predicted_creep(
    solref: Sequence[float],
    dmax: float,
    *,
    timestep_s: float = 0.0,
    acceleration_m_s2: float = 0.0,
    load_n: float = 0.0,
    inverse_mass_1_kg: float = 0.0,
    impedance: float | None = None,
    impratio: float = 1.0,
    cone: str = "elliptic",
    mu: float = 1.0,
) -> Creep:
    """Return the slide of a contact in a friction cone that it does not reach the edge of.

    Args:
        solref: Of the friction rows: timeconst [s] and dampratio, or, both negative, -stiffness and -damping [1/s].
        dmax: Second entry of solimp.
        timestep_s: Of the engine, which takes no timeconst below two of them [s]; 0 where refsafe is off.
        acceleration_m_s2: Steady acceleration along the contact that its rows leave out [m/s²].
        load_n: Tangential force on one contact point [N]: a load that n points share is a n-th on each.
        inverse_mass_1_kg: Sum of the translational body_invweight0 of both bodies [1/kg]: of a free one 1 / mass.
        impedance: d at the contact's depth; None: dmax. As dmax it counts as the engine takes it.
        impratio: Of the engine; ``math.inf`` for a noslip pass that converges, which leaves R out.
        cone: ``elliptic`` or ``pyramidal``.
        mu: Sliding friction, which only a pyramid's R reads.
    """
    response_s = response(solref, dmax, timestep_s)
    d = clamped(dmax if impedance is None else impedance)
    regularization = (1.0 - d) / d * inverse_mass_1_kg / impratio
    if cone == "pyramidal":
        regularization *= 1.0 + mu**2
    return Creep(
        response_s=response_s,
        yield_m_s_n=regularization * response_s,
        acceleration_mm_s=M * response_s * acceleration_m_s2,
        load_mm_s=M * response_s * regularization * load_n,
    )


def response(solref: Sequence[float], dmax: float, timestep_s: float = 0.0) -> float:
    """Return 1 / b of a row [s], infinite where it has no damping; see ``predicted_creep``."""
    first, second = solref
    if second == 0.0:
        return math.inf
    if second < 0.0:
        return clamped(dmax) / -second
    return 0.5 * clamped(dmax) * max(first, 2.0 * timestep_s)


def clamped(impedance: float) -> float:
    """Return an impedance, or solimp's midpoint, as the engine takes it: between 0 and 1, and never either of them."""
    return min(max(impedance, mujoco.mjMINIMP), mujoco.mjMAXIMP)


def impedance_at(solimp: Sequence[float], depth_m: float) -> float:
    """Return d at a depth [m], as MuJoCo interpolates it between dmin and dmax over solimp's width."""
    dmin, dmax, width, midpoint, power = solimp
    dmin, dmax, midpoint, power = clamped(dmin), clamped(dmax), clamped(midpoint), max(power, 1.0)
    x = min(abs(depth_m) / width, 1.0) if width > 0.0 else 1.0
    if power == 1.0 or x in (0.0, 1.0):
        y = x
    elif x <= midpoint:
        y = x**power / midpoint ** (power - 1.0)
    else:
        y = 1.0 - (1.0 - x) ** power / (1.0 - midpoint) ** (power - 1.0)
    return dmin + y * (dmax - dmin)
