"""The seam between a simulation and what steps it: nothing on this side asks which solver that is.

A file has each kind: ``stepper_warp`` MuJoCo Warp, ``stepper_c`` MuJoCo's C engine in its place where a case asks for
it, and ``newton_solvers.stepper`` Newton's other solvers.
"""

from collections.abc import Sequence

import newton
from newton import CollisionPipeline, Contacts
from newton.solvers import SolverBase

from experiments.facts.case import Case
from experiments.simulation.recorder import Recorder
from experiments.simulation.scene import Scene

CONTACT_MAX = 64
"""Contacts per world when a case asks for none, as ``stepper_warp.CONSTRAINT_MAX`` rows. The measured peaks are 49
contacts and 50 constraint rows as shipped; every record keeps the peaks of its runs, and a run that needs more is
marked, not cut."""


class Stepper:
    """Steps the worlds of a batch, which are cases with the same ``batch_key``, and shows what their contacts carry.

    ``pipeline`` and ``contacts`` are Newton's, or None where the solver finds the contacts itself. ``solver``,
    ``state`` and ``recorder`` are there once it is built. ``case`` is the first one, and may become another that
    differs in RUN_TIME_FIELDS.
    """

    @property
    def is_queued(self) -> bool:
        """Tell whether a step is launches on the device alone, which a graph can hold."""

    def __init__(self, scene: Scene, cases: Sequence[Case]):
        self.scene, self.model, self.world_count = scene, scene.model, len(cases)
        self.case, self.cases = cases[0], cases
        self.pipeline, self.contacts = self._build_collision()

    def build(self, state: newton.State, frame_count: int) -> None:
        """Build the solver, whose worlds start from ``state``, and what records ``frame_count`` frames of them."""
        self.state = state
        self.solver = self._build_solver()
        self.recorder = self._build_recorder(frame_count)

    def set_flags(self, solver: SolverBase) -> None:
        """Switch a solver's stages on and off as ``case`` says, where it has some."""

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        """Queue a substep of a frame, and collisions where they are due in it."""

    def _build_collision(self) -> tuple[CollisionPipeline | None, Contacts | None]: ...

    def _build_solver(self) -> SolverBase: ...

    def _build_recorder(self, frame_count: int) -> Recorder: ...
