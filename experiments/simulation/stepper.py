"""Define the interface between a simulation and the solver that steps it.

``stepper_warp`` implements MuJoCo Warp, ``stepper_c`` adds MuJoCo's C engine for cases
that request it, and ``newton_solvers.stepper`` implements Newton's other solvers.
"""

from collections.abc import Sequence

import newton
from newton import CollisionPipeline, Contacts
from newton.solvers import SolverBase

from experiments.facts.case import Case
from experiments.simulation.recorder import Recorder
from experiments.simulation.scene import Scene

CONTACT_MAX = 64
"""Default number of contacts per world; for rows see ``stepper_warp.CONSTRAINT_MAX``.

In the scene as shipped, the measured peaks are 49 contacts and 50 constraint rows.
Every record contains the peaks of its runs. A run that needs more is marked as a
failure.
"""


class Stepper:
    """Step the worlds of a batch and record their contacts.

    The worlds are cases with the same ``batch_key``. ``pipeline`` and ``contacts`` are
    Newton's, or None if the solver detects the contacts itself. ``solver``, ``state``
    and ``recorder`` exist after ``build``. ``case`` is the first one, and may be
    replaced by another that differs only in RUN_TIME_FIELDS.
    """

    @property
    def is_queued(self) -> bool:
        """Return whether a step only launches kernels, so that a graph can contain it."""

    def __init__(self, scene: Scene, cases: Sequence[Case]):
        self.scene, self.model, self.world_count = scene, scene.model, len(cases)
        self.case, self.cases = cases[0], cases
        self.pipeline, self.contacts = self._build_collision()

    def build(self, state: newton.State, frame_count: int) -> None:
        """Build the solver and the recorder.

        The worlds start from ``state``, and ``frame_count`` frames are recorded.
        """
        self.state = state
        self.solver = self._build_solver()
        self.recorder = self._build_recorder(frame_count)

    def set_flags(self, solver: SolverBase) -> None:
        """Switch the stages of a solver on and off, as in ``case``."""

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        """Queue a substep of a frame, with collisions if they are due."""

    def _build_collision(self) -> tuple[CollisionPipeline | None, Contacts | None]: ...

    def _build_solver(self) -> SolverBase: ...

    def _build_recorder(self, frame_count: int) -> Recorder: ...
