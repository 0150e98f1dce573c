"""The shake in Newton's SolverSteel, whose rows of constraints are watched: those that do not fit are dropped."""

from collections.abc import Sequence

import warp as wp

from experiments.facts.case import Case
from experiments.newton_solvers.box import STEEL, Variant
from experiments.newton_solvers.robot import SolverRecorder, SolverSimulation

ROWS = {"articulation_constraint_max": 256}
"""In place of 32: rows that do not fit are dropped."""
LIMIT_GAP = 1e-3
"""Distance [rad, m] from a joint's limit at which it gets a row."""
VARIANTS = (
    Variant("steel"),
    *STEEL,
    Variant("steel-substeps", steps_between_contacts=1),
    Variant("steel-iterations", options={"iterations": 96}),
    Variant("steel-32-rows", options={"articulation_constraint_max": 32}),
)
"""One thing changed at a time; the last has as many rows as the solver comes with."""


class SteelSimulation(SolverSimulation):
    """A simulation with Steel."""

    def __init__(self, variant: Variant, cases: Sequence[Case], device: wp.Device, *, is_counting: bool = False):
        self.is_counting = is_counting
        super().__init__(variant, cases, device)

    def _build_recorder(self) -> SolverRecorder:
        return SteelRecorder(self)

    def _options(self) -> dict[str, object]:
        return {
            "enable_joint_limits": self.case.limits,
            "joint_limit_activation_gap": LIMIT_GAP,
            "row_watermark": self.is_counting,
            "warn_constraint_overflow": False,  # it is recorded, and a world with it counts as one that failed
            **ROWS,
            **self.variant.options,
        }


@wp.kernel
def watch_overflow(cursor: wp.array[int], is_over: wp.array[wp.bool], first: wp.array[int]):
    world = wp.tid()
    if is_over[world]:
        first[world] = wp.min(first[world], cursor[world])


class SteelRecorder(SolverRecorder):
    """Records the first frame in which rows did not fit, too."""

    def watch_substep(self) -> None:
        super().watch_substep()
        is_over = self.solver.constraint_overflow
        wp.launch(
            watch_overflow, dim=self.cursor.shape, inputs=[self.cursor, is_over], outputs=[self.constraint_overflow]
        )
