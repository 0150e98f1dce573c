"""The interface between a simulation and what steps it, whichever solver that is.

There is a file for each kind: ``stepper_warp`` for MuJoCo Warp, ``stepper_c`` for MuJoCo's C engine, and
``newton_solvers.stepper`` for Newton's other solvers.
"""

from collections.abc import Sequence

import newton
from newton import CollisionPipeline, Contacts
from newton.solvers import SolverBase

from experiments.facts.case import Case
from experiments.simulation.recorder import Recorder
from experiments.simulation.scene import Scene

CONTACT_MAX = 64
"""Contacts per world when a case asks for none, as ``stepper_mujoco.CONSTRAINT_MAX`` rows. The measured peaks are 49
contacts and 50 constraint rows as shipped; every record keeps the peaks of its runs, and a run that needs more is
marked, not cut."""


class Stepper:
    """Steps the worlds of a batch, which are cases with the same ``batch_key``, and shows what their contacts carry.

    ``pipeline`` and ``contacts`` are Newton's, or None where the solver finds the contacts itself. ``solver``,
    ``state`` and ``recorder`` are there once it is built. ``case`` is the first one, until it is varied.
    """

    @property
    def is_queued(self) -> bool:
        """Tell whether a step is launches on the device alone, which a graph can hold."""

    def __init__(self, scene: Scene, cases: Sequence[Case]):
        self.scene = scene
        self.model = scene.model
        self.world_count = len(cases)
        self.cases = cases
        self.case = cases[0]
        self.pipeline, self.contacts = self._build_collision()

    def build(self, state: newton.State, frame_count: int) -> None:
        """Build the solver, whose worlds start from ``state``, and what records ``frame_count`` frames of them."""
        self.state = state
        self.solver = self._build_solver()
        self.recorder = self._build_recorder(frame_count)
        self.vary(self.case)

    def vary(self, case: Case) -> None:
        """Go on as another case, which may differ in RUN_TIME_FIELDS only."""
        self.case = case

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        """Queue a substep of a frame, and collisions where they are due in it."""

    def _build_collision(self) -> tuple[CollisionPipeline | None, Contacts | None]: ...

    def _build_solver(self) -> SolverBase: ...

    def _build_recorder(self, frame_count: int) -> Recorder: ...
