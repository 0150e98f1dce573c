"""Run the shake in Newton's SolverSteel and record dropped constraint rows."""

from collections.abc import Sequence

import warp as wp

from experiments.facts.case import Case
from experiments.newton_solvers.box import STEEL, Variant
from experiments.newton_solvers.stepper import SolverRecorder, SolverStepper
from experiments.simulation.scene import Scene

# The default is 32. Rows that do not fit are dropped.
ROWS = {"articulation_constraint_max": 256}
# Distance [rad, m] from a joint's limit below which the limit gets a row.
LIMIT_GAP = 1e-3
VARIANTS = (  # one change at a time; the last has the solver's default number of rows
    Variant("steel"),
    *STEEL,
    Variant("steel-substeps", steps_between_contacts=1),
    Variant("steel-iterations", options={"iterations": 96}),
    Variant("steel-32-rows", options={"articulation_constraint_max": 32}),
)


class SteelStepper(SolverStepper):
    """Step the shake with Steel, which may count the rows that it needs."""

    def __init__(
        self,
        variant: Variant,
        scene: Scene,
        cases: Sequence[Case],
        *,
        is_counting: bool = False,
    ):
        self.is_counting = is_counting
        super().__init__(variant, scene, cases)

    def row_peak(self) -> dict[str, object]:
        """Return the peak number of rows in all worlds, including dropped rows."""
        return {
            "peak_constraint_count": self.solver.constraint_row_watermarks()[
                "articulation_raw_high_water"
            ]
        }

    def _build_recorder(self, frame_count: int) -> SolverRecorder:
        self.observed = self._observe()
        return SteelRecorder(self, frame_count)

    def _options(self) -> dict[str, object]:
        return {
            "enable_joint_limits": self.case.limits,
            "joint_limit_activation_gap": LIMIT_GAP,
            "row_watermark": self.is_counting,
            # The overflow is recorded, and a world with an overflow counts as failed.
            "warn_constraint_overflow": False,
            **ROWS,
            **self.variant.options,
        }


@wp.kernel
def watch_overflow(
    cursor: wp.array[int], is_over: wp.array[wp.bool], first: wp.array[int]
):
    world = wp.tid()
    if is_over[world]:
        first[world] = wp.min(first[world], cursor[world])


class SteelRecorder(SolverRecorder):
    """Record the contacts, and the first frame in which rows did not fit."""

    def watch_substep(self) -> None:
        super().watch_substep()
        is_over = self.solver.constraint_overflow
        wp.launch(
            watch_overflow,
            dim=self.cursor.shape,
            inputs=[self.cursor, is_over],
            outputs=[self.constraint_overflow],
        )
