"""A scene for the rules: its compiled model, its pairs and its source."""

import copy
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import mujoco
import numpy as np
from mujoco import MjModel

from newton_lint.combined import CONES, Contacts, contacts_of, option_of
from newton_lint.law import Option
from newton_lint.pairs import keys_of, masks_of
from newton_lint.source import Element, Source, Texts

FREE, BALL, SLIDE, HINGE = range(4)
"""Values of ``mjtJoint``."""
ON_JOINT = int(mujoco.mjtTrn.mjTRN_JOINT)
WEIGHTLESS = int(mujoco.mjtDisableBit.mjDSBL_GRAVITY)


def qualified(owner: str, name: str) -> str:
    """Return a name with its body's name, unless the body has no name or the same
    name."""
    return name if owner in ("", name) else f"{owner}/{name}"


@dataclass(frozen=True)
class Engine:
    """An engine, and options that replace those of the scene."""

    name: str = "mujoco"
    """``mujoco``, ``warp`` or ``newton``."""
    timestep_s: float | None = None
    cone: str | None = None
    impratio: float | None = None

    def configured(self, model: MjModel) -> MjModel:
        """Return a model with these options in place of the scene's."""
        cone = CONES.index(self.cone) if self.cone else None
        options = {"timestep": self.timestep_s, "cone": cone, "impratio": self.impratio}
        model = copy.copy(model)
        for name, value in options.items():
            if value is not None:
                setattr(model.opt, name, value)
        return model


@dataclass(frozen=True)
class Scene:
    """A MuJoCo model with its source and its engine."""

    model: MjModel
    source: Source
    engine: Engine = Engine()
    texts: Texts = field(default_factory=dict)
    """Contents that replace those of files while a change is tried."""
    touching: np.ndarray | None = None
    """Keys of the pairs that count, or None if all do."""

    @cached_property
    def option(self) -> Option:
        return option_of(self.model)

    contact_engine = property(lambda self: self.engine.name)
    """The engine that combines the parameters of contacts."""

    @cached_property
    def contacts(self) -> Contacts:
        contacts = contacts_of(self.model, self.contact_engine)
        if self.touching is None:
            return contacts
        return contacts.among(np.isin(keys_of(contacts.geoms), self.touching))

    @cached_property
    def colliding(self) -> int:
        """Return the number of geoms that can collide."""
        model = self.model
        # A <pair> makes contacts even if the masks of its geoms do not match.
        named = np.isin(np.arange(model.ngeom), [model.pair_geom1, model.pair_geom2])
        return np.count_nonzero(masks_of(model) | named)

    def name(self, kind: str, index: int) -> str:
        """Return the name of an element, or its kind with its number."""
        return getattr(self.model, kind)(index).name or f"{kind}_{index}"

    @cached_property
    def bodies(self) -> list[str]:
        """Return the names of the bodies, with numbers for bodies without a name."""
        return [
            self.model.body(index).name or f"body_{index}"
            for index in range(self.model.nbody)
        ]

    @cached_property
    def names(self) -> list[str]:
        """Return the body and geom of each geom, such as ``cube/box``."""
        model = self.model
        geoms = [
            model.geom(index).name or f"geom_{index}" for index in range(model.ngeom)
        ]
        owners = [self.bodies[body] if body else "" for body in model.geom_bodyid]
        return list(map(qualified, owners, geoms))

    def place(self, name: str) -> Element | None:
        """Return the element of a geom or a body with a name, or None."""
        if name in self.names:
            return self.source.find("geom", self.names.index(name))
        if name in self.bodies:
            return self.source.find("body", self.bodies.index(name))
        return None

    @cached_property
    def _indices(self) -> dict[int, int]:
        # There may be millions of pairs, and numbers are hashed faster.
        keys = keys_of(self.contacts.geoms).tolist()
        return dict(zip(keys, range(len(keys)), strict=True))

    def pair_index(self, geoms: Sequence[int]) -> int | None:
        """Return the index of the pair of two geoms, or None if they cannot touch."""
        return self._indices.get(keys_of(np.array([geoms]))[0])

    def pair_element(self, contact: int) -> Element | None:
        """Return the ``<pair>`` that names the geoms of a contact."""
        geoms = (self.contacts.first[contact], self.contacts.second[contact])
        return self.source.pair(*(self.model.geom(geom).name for geom in geoms))

    @cached_property
    def counts(self) -> np.ndarray:
        """Return whether any pair uses the parameters of each geom itself."""
        contacts = self.contacts
        counting = np.zeros(self.model.ngeom, dtype=bool)
        # mj_collide reads the parameters of a <pair> instead of those of its geoms.
        plain = contacts.named < 0
        counting[contacts.first[plain]] = True
        counting[contacts.second[plain & ~contacts.outranked]] = True
        return counting

    @cached_property
    def free(self) -> np.ndarray:
        """Return whether each body is welded to a body with a free joint."""
        model = self.model
        loose = np.zeros(model.nbody, dtype=bool)
        loose[model.jnt_bodyid[model.jnt_type == FREE]] = True
        # A body without joints moves with the body that it is welded to.
        return loose[model.body_weldid]
