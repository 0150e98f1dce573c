"""Computes how fast a contact creeps under each integrator, cone and flag of MuJoCo C.

A friction row has the reference acceleration -b v, and yields R f under its force f
(MuJoCo documentation, "Computation", constraint model). At a steady speed these two
balance the acceleration a that the row leaves out, such as J̇·q̇:

    b v = a + R f,    b = 2 / (dmax timeconst),    R = (1 - d) / d · w / impratio

Here d is the impedance of the contact, and w is the sum of the body_invweight0 of the
two bodies, or (1 + μ²) times that in a row of a pyramid.

With the time step h, a contact also slides by a h/2 less under integrators that move
bodies by their new velocity, and by a h/2 more under ``discrete``. This integrator also
multiplies R by (1 + b h) / (1 + b h + h² k d).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

M = 1e3
"""Millimetres per metre."""
EULER, RK4, IMPLICIT, IMPLICITFAST, DISCRETE = range(5)
"""Values of ``mjtIntegrator``; the last one exists since MuJoCo 3.13."""
STEP_SHARE = {EULER: -0.5, RK4: 0.0, IMPLICIT: -0.5, IMPLICITFAST: -0.5, DISCRETE: 0.5}
"""The response to an acceleration is 1/b plus this share of the time step."""
DEFAULT_SOLREF = (0.02, 1.0)
MIN_WIDTH = 1e-15
"""mjMINVAL: a narrower solimp has a constant impedance."""


@dataclass(frozen=True)
class Option:
    """Engine options that affect all contacts."""

    timestep_s: float
    integrator: int = EULER
    cone: str = "pyramidal"
    impratio: float = 1.0
    refsafe: bool = True
    noslip: bool = False
    """Whether a noslip pass follows, which removes R."""

    @property
    def discrete(self) -> bool:
        return self.integrator == DISCRETE


@dataclass(frozen=True)
class Contact:
    """The combined parameters of a contact between two geoms."""

    solref: tuple[float, float]
    solimp: tuple[float, ...]
    mu: float
    weight_1_kg: float
    """Diagonal of A along a tangent: the sum of the two translational invweight0."""
    solreffriction: tuple[float, float] = (0.0, 0.0)
    condim: int = 3


@dataclass(frozen=True)
class Response:
    """The creep of a contact per unit of load, at one depth."""

    acceleration_s: float
    """Creep per m/s² of acceleration that the rows leave out."""
    load_m_s_n: float
    """Creep per newton of tangential force; in a pyramid, up to half the cone."""
    edge_count: int = 0
    """Number of edges of the pyramid; 0 for an elliptic cone."""
    mu: float = 1.0

    def force_n(self, slide_m_s: float, normal_n: float) -> float:
        """Return the friction of a point that slides along an axis of the contact [N].

        Beyond 2/n of the cone, one of the n edges of a pyramid lets go, and the others
        share the rest of the load.
        """
        most = self.mu * normal_n
        force = slide_m_s / self.load_m_s_n if self.load_m_s_n else math.inf
        if self.edge_count and force * self.edge_count > 2.0 * most:
            edges_across = self.edge_count - 2
            force = (0.5 * force * edges_across + most) / (edges_across + 1)
        return min(force, most)


def shared_slide_m_s(points: Sequence[tuple[Response, float]], load_n: float) -> float:
    """Return the speed at which points share a load, infinite beyond their cones [m/s].

    Args:
        points: The response and the normal force of each point.
    """
    if load_n >= sum(response.mu * normal for response, normal in points):
        return math.inf
    low, high = 0.0, 1.0
    for _ in range(80):
        slide = 0.5 * (low + high)
        if sum(response.force_n(slide, normal) for response, normal in points) < load_n:
            low = slide
        else:
            high = slide
    return high


def solref_taken(solref: Sequence[float]) -> tuple[float, float]:
    """Return the solref that the engine uses: the default if it mixes both forms."""
    first, second = solref
    return DEFAULT_SOLREF if (first > 0.0) != (second > 0.0) else (first, second)


def response_of(contact: Contact, option: Option, d: float | None = None) -> Response:
    """Return the response of a contact, which is infinite without damping.

    Args:
        d: Impedance; by default that at the full width of solimp.
    """
    dmax = clamped(contact.solimp[1])
    d = impedance(contact.solimp, contact.solimp[2]) if d is None else clamped(d)
    h = option.timestep_s
    safe_step = h if option.refsafe and not option.discrete else 0.0
    pyramid = option.cone == "pyramidal"
    stiff, damp = stiffness(contact, option, d), normal_damping(contact, option, d)
    friction_solref = (
        contact.solreffriction
    )  # mj_makeImpedance reads solreffriction only with an elliptic cone.
    is_read = (
        not pyramid
        and any(friction_solref)
        and (friction_solref[0] > 0.0) == (friction_solref[1] > 0.0)
    )
    inverse_b = response(
        friction_solref if is_read else solref_taken(contact.solref), dmax, safe_step
    )
    r = (
        (1.0 - d)
        / d
        * contact.weight_1_kg
        / option.impratio
        * (1.0 + contact.mu**2 if pyramid else 1.0)
    )
    weight = 1.0
    if option.discrete and pyramid:
        inverse_b = 1.0 / (damp + h * stiff * d) if damp + h * stiff * d else math.inf
    elif option.discrete:
        own_damp = 1.0 / inverse_b if inverse_b else math.inf
        weight = (1.0 + own_damp * h) / (1.0 + damp * h + h * h * stiff * d)
    return Response(
        acceleration_s=inverse_b + STEP_SHARE.get(option.integrator, 0.0) * h,
        load_m_s_n=0.0 if option.noslip else r * weight * inverse_b if r else 0.0,
        edge_count=2 * (contact.condim - 1) if pyramid else 0,
        mu=contact.mu,
    )


def impedance(solimp: Sequence[float], depth_m: float) -> float:
    """Return the impedance at a depth; for a solimp without width, this is the mean."""
    if solimp[2] <= MIN_WIDTH:
        return 0.5 * (clamped(solimp[0]) + clamped(solimp[1]))
    return impedance_at(solimp, depth_m)


def stiffness(contact: Contact, option: Option, d: float) -> float:
    """Return k of the normal row of a contact [1/s²]."""
    dmax = clamped(contact.solimp[1])
    first, second = solref_taken(contact.solref)
    if first <= 0.0:
        return -first / dmax**2
    if option.refsafe and not option.discrete:
        first = max(first, 2.0 * option.timestep_s)
    k = 1.0 / (dmax * first * second) ** 2
    return (
        min(k, 1.0 / (option.timestep_s**2 * d))
        if option.refsafe and option.discrete
        else k
    )


def normal_damping(contact: Contact, option: Option, d: float) -> float:
    """Return b of the normal row of a contact [1/s].

    Under ``discrete`` with refsafe, b belongs to the clamped stiffness.
    """
    solref = solref_taken(contact.solref)
    dmax = clamped(contact.solimp[1])
    if solref[0] > 0.0 and option.discrete and option.refsafe:
        authored = 1.0 / (dmax * solref[0] * solref[1]) ** 2
        if (k := stiffness(contact, option, d)) < authored:
            return 2.0 * solref[1] * math.sqrt(k)
    inverse = response(
        solref,
        dmax,
        option.timestep_s if option.refsafe and not option.discrete else 0.0,
    )
    return 1.0 / inverse if inverse else math.inf


def settled_impedance(contact: Contact, option: Option, normal_n: float) -> float:
    """Return the impedance at the depth to which a normal force presses a point."""
    return impedance(contact.solimp, settled_depth_m(contact, option, normal_n))


def settled_depth_m(contact: Contact, option: Option, normal_n: float) -> float:
    """Return the depth to which a normal force presses a contact point [m].

    There k d r balances R f, for any mass of the body. As d depends on r, the depth is
    found by bisection.
    """
    weight = contact.weight_1_kg
    if option.cone == "pyramidal" and contact.condim > 1:
        # All edges of the pyramid bear the force, each with the R for its friction.
        weight *= (
            (1.0 + contact.mu**2)
            * contact.mu**2
            / option.impratio
            / (contact.condim - 1)
        )
    low, high = 0.0, 1.0
    for _ in range(60):
        depth = 0.5 * (low + high)
        d = impedance(contact.solimp, depth)
        if (
            stiffness(contact, option, d) * d * depth
            < (1.0 - d) / d * weight * normal_n
        ):
            low = depth
        else:
            high = depth
    return 0.5 * (low + high)


def response(solref: Sequence[float], dmax: float, timestep_s: float = 0.0) -> float:
    """Return 1 / b of a row [s], which is infinite without damping.

    Args:
        solref: Timeconst [s] and dampratio or, both negative, -stiffness and -damping.
        timestep_s: Time step of an engine that clamps the timeconst to two steps [s]; 0
            if refsafe is off.
    """
    first, second = solref
    if second == 0.0:
        return math.inf
    if second < 0.0:
        return clamped(dmax) / -second
    return 0.5 * clamped(dmax) * max(first, 2.0 * timestep_s)


def clamped(impedance: float) -> float:
    """Return an impedance or a midpoint of solimp as the engine clamps it."""
    return min(max(impedance, mujoco.mjMINIMP), mujoco.mjMAXIMP)


def impedance_at(solimp: Sequence[float], depth_m: float) -> float:
    """Return the impedance at a depth [m], interpolated from dmin to dmax."""
    dmin, dmax, width, midpoint, power = solimp
    dmin, dmax, midpoint, power = (
        clamped(dmin),
        clamped(dmax),
        clamped(midpoint),
        max(power, 1.0),
    )
    x = min(abs(depth_m) / width, 1.0) if width > 0.0 else 1.0
    if power == 1.0 or x in (0.0, 1.0):
        y = x
    elif x <= midpoint:
        y = x**power / midpoint ** (power - 1.0)
    else:
        y = 1.0 - (1.0 - x) ** power / (1.0 - midpoint) ** (power - 1.0)
    return dmin + y * (dmax - dmin)
