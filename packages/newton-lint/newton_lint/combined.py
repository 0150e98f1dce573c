"""Combines the parameters of touching geoms as ``mj_contactParam`` does."""

from dataclasses import dataclass, fields
from functools import cached_property

import mujoco
import numpy as np

from newton_lint.law import Contact, Option
from newton_lint.pairs import pairs_of

MIN_MU = 1e-5
"""Least friction coefficient that the engine uses."""
OVERRIDE = int(mujoco.mjtEnableBit.mjENBL_OVERRIDE)
REFSAFE_OFF = int(mujoco.mjtDisableBit.mjDSBL_REFSAFE)
CONES = ("pyramidal", "elliptic")


@dataclass(frozen=True)
class Contacts:
    """The pairs that may touch, with their parameters; arrays [pair_count, …]."""

    first: np.ndarray
    """The geom with the higher priority, if the priorities differ."""
    second: np.ndarray
    named: np.ndarray
    """Index of the ``<pair>`` that sets the parameters; -1 for other pairs."""
    outranked: np.ndarray
    """Whether the parameters of the second geom are ignored because of the priority."""
    solref: np.ndarray
    solreffriction: np.ndarray
    solimp: np.ndarray
    condim: np.ndarray
    friction: np.ndarray
    """Coefficients of sliding, spinning and rolling friction."""
    weight: np.ndarray
    """Sum of the bodies' translational body_invweight0 [1/kg]."""

    def __len__(self) -> int:
        return len(self.first)

    def among(self, rows: np.ndarray) -> "Contacts":
        """Return the pairs for which a mask is true."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return Contacts(**{name: array[rows] for name, array in values.items()})

    @cached_property
    def geoms(self) -> np.ndarray:
        """Return the geoms of each pair, shape [pair_count, 2]."""
        return np.stack([self.first, self.second], axis=1)

    @cached_property
    def dampratio(self) -> np.ndarray:
        """Return the damping ratio of each pair, which may be NaN or infinite."""
        first, second = self.solref.T
        with np.errstate(divide="ignore", invalid="ignore"):
            direct = -second / (2.0 * np.sqrt(-first))
        return np.where(first > 0.0, second, direct)

    def contact(self, index: int) -> Contact:
        """Return the contact of one pair, as input for the law."""
        return Contact(
            solref=tuple(self.solref[index].tolist()),
            solimp=tuple(self.solimp[index].tolist()),
            mu=self.friction[index, 0],
            weight_1_kg=self.weight[index],
            solreffriction=tuple(self.solreffriction[index].tolist()),
            condim=self.condim[index],
        )


def option_of(model: mujoco.MjModel) -> Option:
    """Return the options that affect all contacts."""
    opt = model.opt
    return Option(
        timestep_s=opt.timestep,
        integrator=opt.integrator,
        cone=CONES[opt.cone],
        impratio=max(opt.impratio, mujoco.mjMINVAL),
        refsafe=not opt.disableflags & REFSAFE_OFF,
        noslip=opt.noslip_iterations > 0,
    )


def contacts_of(model: mujoco.MjModel, engine: str = "mujoco") -> Contacts:
    """Return all pairs that may touch.

    MuJoCo Warp uses the minimum of direct solrefs and ignores their priorities.
    """
    pairs, named = pairs_of(model)
    priority = model.geom_priority[pairs]
    swap = priority[:, 0] < priority[:, 1]
    first, second = np.where(swap[:, None], pairs[:, ::-1], pairs).T
    plain = named < 0
    outranked = (priority[:, 0] != priority[:, 1]) & plain
    weights = share(model.geom_solmix[first], model.geom_solmix[second], outranked)
    solref1 = model.geom_solref[first]
    solref2 = model.geom_solref[second]
    mixed = weights * solref1 + (1.0 - weights) * solref2
    # In MuJoCo C a direct solref with priority counts; MuJoCo Warp uses the minimum.
    unranked = ~outranked[:, None] if engine == "mujoco" else True
    direct = (np.minimum(solref1[:, :1], solref2[:, :1]) <= 0.0) & unranked
    solref = np.where(direct, np.minimum(solref1, solref2), mixed)
    solimp = (
        weights * model.geom_solimp[first] + (1.0 - weights) * model.geom_solimp[second]
    )
    larger = np.maximum(model.geom_friction[first], model.geom_friction[second])
    friction = np.where(outranked[:, None], model.geom_friction[first], larger)
    condim1 = model.geom_condim[first]
    condim = np.where(
        outranked, condim1, np.maximum(condim1, model.geom_condim[second])
    )
    solreffriction = np.zeros((len(pairs), 2))
    indices = named[~plain]
    solref[~plain] = model.pair_solref[indices]
    solimp[~plain] = model.pair_solimp[indices]
    # A <pair> has two coefficients of sliding, one of spinning and two of rolling.
    friction[~plain] = model.pair_friction[indices][:, (0, 2, 3)]
    condim[~plain] = model.pair_dim[indices]
    solreffriction[~plain] = model.pair_solreffriction[indices]
    # mj_assignRef: the override applies to each <pair> too, but not to condim.
    if model.opt.enableflags & OVERRIDE:
        solref[:] = model.opt.o_solref
        solreffriction[:] = model.opt.o_solref
        solimp[:] = model.opt.o_solimp
        friction[:] = model.opt.o_friction[[0, 2, 3]]
    weight = model.body_invweight0[model.geom_bodyid, 0]
    return Contacts(
        first=first,
        second=second,
        named=named,
        outranked=outranked,
        solref=solref,
        solreffriction=solreffriction,
        solimp=solimp,
        condim=condim,
        friction=np.maximum(friction, MIN_MU),
        weight=weight[first] + weight[second],
    )


def share(mix1: np.ndarray, mix2: np.ndarray, outranked: np.ndarray) -> np.ndarray:
    """Return the weight of the first geom by solmix; 1 if it outranks the second."""
    mix1 = np.where(mix1 < mujoco.mjMINVAL, 0.0, mix1)
    mix2 = np.where(mix2 < mujoco.mjMINVAL, 0.0, mix2)
    total = mix1 + mix2
    # mj_contactParam: two weights of 0 count as equal.
    share = np.where(total > 0.0, mix1 / np.where(total > 0.0, total, 1.0), 0.5)
    return np.where(outranked, 1.0, share)[:, None]
