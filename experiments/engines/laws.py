"""Laws of how fast a body slides that other engines hold by friction, by what they document of their contacts.

A time-stepping engine has the velocity at a contact vanish at the end of a step of h, and moves by that velocity: on
a table that turns at ω a body goes along a tangent, and dr/dt = r ω² h/2 (as in ``newton_solvers.box``). Besides it
slides at the v at which its friction carries the load F:

- ``rigid``: no v at all.
- ``sap``: R = σ w of each contact, which carries v/(σ w h) and at most μ of its normal force; w is a third of the
  Frobenius norm of the contact's block of the Delassus matrix (Castro et al., 2022).
- ``mixed``: as that, with ε in the place of σ and the block's entry along the load in that of w (DART's constraint
  force mixing), so that v = ε h F / Σ 1/w where no contact slides.
- ``tamsi``: F = μ N s (2 - s), s = v/v_s (Castro et al., 2019).
- ``lagged``: F = μ N s / √(1 + s²) (Castro et al., 2023).
- ``stribeck``: F = μ N s³ (10 - 15 s + 6 s²), in continuous time.
- ``discrete``: MuJoCo's integrator since 3.13. With b = 2/(dmax · timeconst) a row brakes as if at the end of the
  step, by b/(1 + hb), and yields R to the force; it does not see that the place under the body accelerates at F/m, so
  that v = (1 + R m/n) (1/b + h) F/m, less the h F/m of the tangent. The walk is r ω² (1/b + h/2) but for R.
- ``anchored``: friction pulls back to where a contact began (PhysX), so that nothing slides.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

SAP_SIGMA = 1e-3
MUJOCO_DMAX = 0.95
DART_MIXING = 1e-5


@dataclass(frozen=True)
class Load:
    """A load on friction, and the contacts that carry it."""

    force_n: float
    direction: tuple[float, float, float]
    """Direction of the force in the body's frame."""
    friction: float
    normal_n: float
    """Normal force of all contacts together."""
    step_s: float
    stiction_m_s: float
    contacts: Sequence[Sequence[float]]
    """Place from the centre of mass [m], in the body's frame, and normal force [N], shape [contact, 4]."""
    mass_kg: float
    inertia_kg_m2: Sequence[float]
    """Principal moments in the body's frame, shape [3]."""
    support_inverse_mass_1_kg: np.ndarray
    """Inverse mass of the support, shape [3, 3]."""
    timeconst_s: float | None = None
    """Time constant of MuJoCo's contacts."""
    yields_1_kg: float | None = None
    """R of each of MuJoCo's friction rows."""

    @property
    def share(self) -> float:
        """Share of what friction could carry."""
        return self.force_n / (self.friction * self.normal_n)


def delassus(load: Load) -> np.ndarray:
    """Return the velocity that an impulse gives each contact where it acts [1/kg], shape [contact, 3, 3]."""
    across = np.array([[[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]] for x, y, z, _ in load.contacts])
    turned = across @ np.diag(1.0 / np.array(load.inertia_kg_m2)) @ across.transpose(0, 2, 1)
    return np.eye(3) / load.mass_kg + load.support_inverse_mass_1_kg + turned


def rigid(load: Load) -> float:
    return 0.0


def sap(load: Load) -> float:
    softness = SAP_SIGMA * load.step_s * np.linalg.norm(delassus(load), axis=(1, 2)) / 3.0
    limits = load.friction * np.array([normal for *_, normal in load.contacts])
    if limits.sum() <= load.force_n:
        return math.inf
    speeds = np.sort(limits * softness)  # at which one contact after the other slides
    carried = np.array([np.minimum(limits, speed / softness).sum() for speed in speeds])
    return float(np.interp(load.force_n, [0.0, *carried], [0.0, *speeds]))


def mixed(load: Load) -> float:
    along = np.einsum("i,kij,j->k", load.direction, delassus(load), load.direction)
    return float(DART_MIXING * load.step_s * load.force_n / np.sum(1.0 / along))


def tamsi(load: Load) -> float:
    return load.stiction_m_s * (1.0 - math.sqrt(1.0 - load.share))


def lagged(load: Load) -> float:
    return load.stiction_m_s * load.share / math.sqrt(1.0 - load.share**2)


def stribeck(load: Load) -> float:
    roots = np.roots([6.0, -15.0, 10.0, 0.0, 0.0, -load.share])
    [sliding] = [root.real for root in roots if abs(root.imag) < 1e-9 and 0.0 < root.real < 1.0]
    return load.stiction_m_s * float(sliding)


def discrete(load: Load) -> float:
    acceleration, yielding = load.force_n / load.mass_kg, load.yields_1_kg * load.mass_kg / len(load.contacts)
    late_s = MUJOCO_DMAX * load.timeconst_s / 2.0 + load.step_s
    return acceleration * ((1.0 + yielding) * late_s - load.step_s)


def anchored(load: Load) -> float:
    return 0.0


def walk_per_s(law: Callable[[Load], float], load: Load, turn_rad_s: float, radius_m: float) -> float:
    """Return how fast the distance of a body from a turning table's axis grows [1/s]."""
    tangent = 0.0 if law is anchored else turn_rad_s**2 * load.step_s / 2.0
    return tangent + law(load) / radius_m
