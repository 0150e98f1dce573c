"""What MuJoCo makes of two geoms' parameters where they touch, as ``mj_contactParam`` does; arrays over pairs."""

from dataclasses import dataclass

import mujoco
import numpy as np

from newton_lint.law import Contact, Option
from newton_lint.pairs import pairs_of

MIN_MU = 1e-5
"""Least friction that the engine takes."""
OVERRIDE = int(mujoco.mjtEnableBit.mjENBL_OVERRIDE)
REFSAFE_OFF = int(mujoco.mjtDisableBit.mjDSBL_REFSAFE)
CONES = ("pyramidal", "elliptic")


@dataclass(frozen=True)
class Contacts:
    """Pairs that may touch, and the parameters of their contacts; arrays of shape [pair_count, …]."""

    first: np.ndarray
    """Geom of higher priority, if one has it."""
    second: np.ndarray
    named: np.ndarray
    """Index of the ``<pair>`` that names it, whose parameters it has; -1 of others."""
    outranked: np.ndarray
    """Whether the first geom's priority leaves the second's parameters out."""
    solref: np.ndarray
    solreffriction: np.ndarray
    solimp: np.ndarray
    condim: np.ndarray
    friction: np.ndarray
    """Sliding, spinning and rolling."""
    weight: np.ndarray
    """Sum of the bodies' translational body_invweight0 [1/kg]."""

    def __len__(self) -> int:
        return len(self.first)

    def contact(self, index: int) -> Contact:
        """Return one pair's, for the law."""
        return Contact(
            solref=tuple(self.solref[index].tolist()),
            solimp=tuple(self.solimp[index].tolist()),
            mu=float(self.friction[index, 0]),
            weight_1_kg=float(self.weight[index]),
            solreffriction=tuple(self.solreffriction[index].tolist()),
            condim=int(self.condim[index]),
        )


def option_of(model: mujoco.MjModel) -> Option:
    """Return what the engine is told of all contacts."""
    opt = model.opt
    return Option(
        timestep_s=opt.timestep,
        integrator=int(opt.integrator),
        cone=CONES[int(opt.cone)],
        impratio=max(opt.impratio, mujoco.mjMINVAL),
        refsafe=not opt.disableflags & REFSAFE_OFF,
        noslip=opt.noslip_iterations > 0,
    )


def contacts_of(model: mujoco.MjModel, engine: str = "mujoco") -> Contacts:
    """Return all pairs that may touch. MuJoCo Warp takes the least of direct solrefs whatever their priority."""
    pairs, named = pairs_of(model)
    priority = model.geom_priority[pairs]
    swap = priority[:, 0] < priority[:, 1]
    first, second = np.where(swap[:, None], pairs[:, ::-1], pairs).T
    plain = named < 0
    outranked = (priority[:, 0] != priority[:, 1]) & plain
    weights = share(model.geom_solmix[first], model.geom_solmix[second], outranked)
    solrefs = model.geom_solref[first], model.geom_solref[second]
    mixed = weights * solrefs[0] + (1.0 - weights) * solrefs[1]
    # Taken from a higher priority it stays direct; MuJoCo Warp looks at the minimum first.
    unranked = ~outranked[:, None] if engine == "mujoco" else True
    direct = (np.minimum(solrefs[0][:, :1], solrefs[1][:, :1]) <= 0.0) & unranked
    solref = np.where(direct, np.minimum(*solrefs), mixed)
    solimp = (
        weights * model.geom_solimp[first] + (1.0 - weights) * model.geom_solimp[second]
    )
    larger = np.maximum(model.geom_friction[first], model.geom_friction[second])
    friction = np.where(outranked[:, None], model.geom_friction[first], larger)
    condims = model.geom_condim[first], model.geom_condim[second]
    condim = np.where(outranked, condims[0], np.maximum(*condims))
    solreffriction = np.zeros((len(pairs), 2))
    indices = named[~plain]
    solref[~plain] = model.pair_solref[indices]
    solimp[~plain] = model.pair_solimp[indices]
    friction[~plain] = model.pair_friction[indices][
        :, (0, 2, 3)
    ]  # two sliding, one spinning, two rolling
    condim[~plain] = model.pair_dim[indices]
    solreffriction[~plain] = model.pair_solreffriction[indices]
    if (
        model.opt.enableflags & OVERRIDE
    ):  # mj_assignRef: in a <pair> as well; condim has no override
        solref[:] = solreffriction[:] = model.opt.o_solref
        solimp[:] = model.opt.o_solimp
        friction[:] = model.opt.o_friction[[0, 2, 3]]
    weight = model.body_invweight0[model.geom_bodyid, 0]
    return Contacts(
        first, second, named, outranked, solref, solreffriction, solimp, condim, np.maximum(friction, MIN_MU),
        weight[first] + weight[second],
    )  # fmt: skip


def share(mix1: np.ndarray, mix2: np.ndarray, outranked: np.ndarray) -> np.ndarray:
    """Return what the first geom of each pair counts by solmix, all where it outranks the second."""
    mix1, mix2 = (np.where(mix < mujoco.mjMINVAL, 0.0, mix) for mix in (mix1, mix2))
    total = mix1 + mix2
    share = np.where(
        total > 0.0, mix1 / np.where(total > 0.0, total, 1.0), 0.5
    )  # mj_contactParam: two of 0 are even
    return np.where(outranked, 1.0, share)[:, None]
