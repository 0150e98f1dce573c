"""Contact parameters of a model on the host, as ``SolverMuJoCo`` reads and combines them."""

from collections.abc import Sequence
from dataclasses import dataclass

import newton
import numpy as np

SAME = 1e-5
"""Relative difference up to which two float32 parameters are the same."""
FORCE_SPACE, RAW, CONVERTED = 0, 1, 2
"""``mujoco.solref_mode`` of a shape: ke and kd act as a force, solref is taken as authored, or made from ke and kd."""
DEFAULT_SOLREF = (0.02, 1.0)
"""What Newton writes when ke or kd is 0."""
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)
CONDIM = 3
"""Defaults of the solver's custom attributes."""
CONES = ("pyramidal", "elliptic")
"""By MuJoCo's number; the first is what a model has that says none."""


class Shapes:
    """Contact parameters of a model's shapes, arrays of shape [shape_count, …]."""

    def __init__(self, model: newton.Model):
        self.model = model
        self._attributes = getattr(model, "mujoco", None)
        self.body = model.shape_body.numpy()
        self.world = model.shape_world.numpy()
        self.priority = self._attribute("geom_priority", 0)
        self.condim = self._attribute("condim", CONDIM)
        self.gap = model.shape_gap.numpy()
        self.mix = self._attribute("geom_solmix", 1.0)
        self.mode = self._attribute("solref_mode", CONVERTED)
        self.solimp = self._attribute("geom_solimp", SOLIMP)
        self.ke, self.kd = model.shape_material_ke.numpy(), model.shape_material_kd.numpy()
        self.kf, self.mu = model.shape_material_kf.numpy(), model.shape_material_mu.numpy()
        self.restitution = model.shape_material_restitution.numpy()
        self.mu_torsional = model.shape_material_mu_torsional.numpy()
        self.mu_rolling = model.shape_material_mu_rolling.numpy()
        raw = self._attribute("solref", (0.0, 0.0))
        self.solref = np.where((self.mode == RAW)[:, None], raw, self._converted_solref())

    def _attribute(self, name: str, default: float | Sequence[float]) -> np.ndarray:
        array = getattr(self._attributes, name, None)
        return np.array([default] * self.model.shape_count) if array is None else array.numpy()

    def _converted_solref(self) -> np.ndarray:
        there = (self.ke > 0.0) & (self.kd > 0.0)
        ke, kd = np.where(there, self.ke, 1.0), np.where(there, self.kd, 1.0)
        converted = np.stack([2.0 / kd, kd / (2.0 * np.sqrt(ke))], axis=1)
        return np.where(there[:, None], converted, DEFAULT_SOLREF)

    def option(self, name: str, default: float) -> float:
        """Return an option of the engine that the model says, as one read from MJCF does."""
        array = getattr(self._attributes, name, None)
        return default if array is None else float(array.numpy().reshape(-1)[0])

    def names(self) -> list[str]:
        """Return body and shape of each, as ``fr3_leftfinger/shape_21``."""
        shapes = [label.rsplit("/", 1)[-1] for label in self.model.shape_label]
        bodies = [label.rsplit("/", 1)[-1] for label in self.model.body_label]
        owners = [bodies[body] if body >= 0 else label for body, label in zip(self.body, shapes, strict=True)]
        return [label if owner == label else f"{owner}/{label}" for owner, label in zip(owners, shapes, strict=True)]

    def inverse_mass(self) -> np.ndarray:
        """Return translational body_invweight0 of each shape's body [1/kg]: 1 / mass of a free one, 0 of the world,
        and NaN of one with joints, whose inverse weight depends on all that it hangs on."""
        model = self.model
        held = np.zeros(model.body_count, dtype=bool)
        free = np.zeros(model.body_count, dtype=bool)
        if model.joint_count:
            parent, child = model.joint_parent.numpy(), model.joint_child.numpy()
            loose = (model.joint_type.numpy() == int(newton.JointType.FREE)) & (parent < 0)
            free[child[loose]] = True
            for bodies in (parent[~loose], child[~loose]):
                held[bodies[bodies >= 0]] = True
        with np.errstate(divide="ignore"):
            inverse = np.where(free & ~held, 1.0 / model.body_mass.numpy(), np.nan)
        return np.where(self.body >= 0, np.append(inverse, 0.0)[self.body], 0.0)


@dataclass(frozen=True)
class Contacts:
    """Pairs of shapes that may touch, and what their contacts are solved with; arrays of shape [pair_count, …]."""

    first: np.ndarray
    """Index of the shape of higher priority, if one has it."""
    second: np.ndarray
    explicit: np.ndarray
    """Whether the pair is one of MJCF's ``<pair>``, which has parameters of its own and reads those of no shape."""
    mix: np.ndarray
    """Weight of the first shape."""
    solref: np.ndarray
    """NaN where it depends on the bodies' masses."""
    solimp: np.ndarray
    condim: np.ndarray
    mu: np.ndarray

    @property
    def timeconst(self) -> np.ndarray:
        """Return [s]; of a solref that is given as stiffness and damping, negative."""
        return self.solref[:, 0]

    @property
    def dampratio(self) -> np.ndarray:
        """Return share of critical damping, also of a solref that is given as stiffness and damping."""
        first, second = self.solref.T
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(first > 0.0, second, -second / (2.0 * np.sqrt(-first)))


def contacts_of(shapes: Shapes, named: bool = True) -> Contacts:
    """Return the pairs of the first world that no filter keeps apart, combined as ``contact_params``
    of Newton's MuJoCo kernels does.

    Args:
        named: Whether pairs that MJCF names are taken as named there.
    """
    explicit, parameters = _explicit_pairs(shapes, named)
    pairs = np.zeros((0, 2), dtype=int)
    found = shapes.model.shape_contact_pairs
    if found is not None and len(found):
        pairs = found.numpy().reshape(-1, 2).astype(int)
        pairs = pairs[_in_first_world(shapes.world[pairs]).all(axis=1)]
        if len(explicit):
            pairs = pairs[~np.isin(_key(pairs, shapes), _key(explicit, shapes))]
    swap = shapes.priority[pairs[:, 0]] < shapes.priority[pairs[:, 1]]
    first, second = np.where(swap[:, None], pairs[:, ::-1], pairs).T
    outranks = shapes.priority[first] != shapes.priority[second]
    total = shapes.mix[first] + shapes.mix[second]
    share = np.where(total > 0.0, shapes.mix[first] / np.where(total > 0.0, total, 1.0), 0.5)
    mix = np.where(outranks, 1.0, share)
    solref = [shapes.solref[index] for index in (first, second)]
    usual = (solref[0][:, :1] > 0.0) & (solref[1][:, :1] > 0.0)
    combined = np.where(usual, _mixed(solref, mix), np.minimum(*solref))
    combined[(shapes.mode[first] == FORCE_SPACE) & (shapes.mode[second] == FORCE_SPACE)] = np.nan
    condim = np.maximum(shapes.condim[first], shapes.condim[second])
    mu = np.maximum(shapes.mu[first], shapes.mu[second])
    count = len(explicit)
    return Contacts(
        first=np.append(first, explicit[:, 0]),
        second=np.append(second, explicit[:, 1]),
        explicit=np.repeat([False, True], [len(pairs), count]),
        mix=np.append(mix, np.ones(count)),
        solref=np.concatenate([combined, parameters["pair_solref"]]),
        solimp=np.concatenate(
            [_mixed([shapes.solimp[index] for index in (first, second)], mix), parameters["pair_solimp"]]
        ),
        condim=np.append(np.where(outranks, shapes.condim[first], condim), parameters["pair_condim"]),
        mu=np.append(np.where(outranks, shapes.mu[first], mu), parameters["pair_friction"][:, 0]),
    )


PAIR_DEFAULTS = {"pair_solref": DEFAULT_SOLREF, "pair_solimp": SOLIMP, "pair_condim": CONDIM, "pair_friction": (1.0,)}


def _explicit_pairs(shapes: Shapes, named: bool) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    attributes = getattr(shapes.model, "mujoco", None)
    arrays = {name: getattr(attributes, name, None) for name in ("pair_geom1", "pair_geom2", "pair_world")}
    if not named or any(array is None or not len(array) for array in arrays.values()):
        return np.zeros((0, 2), dtype=int), {name: np.array([value])[:0] for name, value in PAIR_DEFAULTS.items()}
    pairs = np.stack([arrays["pair_geom1"].numpy(), arrays["pair_geom2"].numpy()], axis=1).astype(int)
    there = (pairs >= 0).all(axis=1) & _in_first_world(arrays["pair_world"].numpy())
    found = {}
    for name, default in PAIR_DEFAULTS.items():
        array = getattr(attributes, name, None)
        found[name] = np.array([default] * len(pairs)) if array is None else array.numpy()
    return pairs[there], {name: values[there] for name, values in found.items()}


def _in_first_world(worlds: np.ndarray) -> np.ndarray:
    return (worlds == 0) | (worlds == -1)


def _key(pairs: np.ndarray, shapes: Shapes) -> np.ndarray:
    return pairs.min(axis=1) * shapes.model.shape_count + pairs.max(axis=1)


def _mixed(values: Sequence[np.ndarray], mix: np.ndarray) -> np.ndarray:
    return mix[:, None] * values[0] + (1.0 - mix[:, None]) * values[1]


def same(a: np.ndarray, b: np.ndarray | float) -> np.ndarray:
    return np.isclose(a, b, rtol=SAME, atol=0.0)
