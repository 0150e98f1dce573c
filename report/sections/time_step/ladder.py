"""Group the rows of section time_step by setting, pads and number of substeps."""

from dataclasses import dataclass

from report.shared import FRAME_RATE, Quantity, Results, Row, RowsBy, constant

NEWTON = "newton-elliptic"
PYRAMIDAL = "newton-pyramidal"
ELLIPTIC = (NEWTON, "mujoco-elliptic")
RULE = "kd-1"
GENTLE = "ke-0.0625"
"""Pads with the kd of the rule and a sixteenth of its ke, for the pyramidal cone."""
RULES = {
    NEWTON: RULE,
    PYRAMIDAL: GENTLE,
    "mujoco-elliptic": RULE,
    "mujoco-pyramidal": GENTLE,
}
"""The recommended pads for each source of contacts and cone."""
CRITICAL = ("kd-0.125", "kd-0.25", "kd-0.5", RULE, "kd-2")
"""Pads with a damping ratio of 1, in the order of their kd."""
COMPARED = ("shipped", "stiff", *CRITICAL)
FIRMER = ("ke-2", "ke-4", "ke-16")
"""Pads with the kd of the rule and a larger ke, in the order of ke."""
MOST_SUBSTEPS = 32  # chosen: with more substeps, rounding decides the slip
FRAME_MS = constant(1e3 / FRAME_RATE, "ms")


@dataclass(frozen=True)
class Ladder:
    """The rows of a record by setting, pads and number of substeps."""

    results: Results
    rows: RowsBy

    def substeps(self, setting: str = NEWTON, pads: str = RULE) -> list[int]:
        """Return the numbers of substeps that were measured, the longest step first."""
        return sorted(
            count for kind, name, count in self.rows if (kind, name) == (setting, pads)
        )

    def row(self, setting: str, pads: str, substeps: int) -> Row:
        return self.rows[setting, pads, substeps]

    def step(self, substeps: int) -> Quantity:
        """Return the length of a step [ms], which follows from the number of substeps."""
        name = f"step_{substeps}"
        count = self.row(NEWTON, RULE, substeps).substeps
        return self.results.derived.get(name) or self.results.value(
            name, "length of a frame divided by its substeps", FRAME_MS / count
        )

    def slip(self, setting: str, pads: str, substeps: int) -> Quantity:
        return self.row(setting, pads, substeps).slip_mm

    def resolved(self, setting: str = NEWTON) -> list[int]:
        """Return the numbers of substeps whose step is short enough for the shake."""
        return [count for count in self.substeps(setting) if count > 1]

    def usual(self, setting: str = NEWTON) -> list[int]:
        """Return the resolved numbers of substeps at which rounding is negligible."""
        return [count for count in self.resolved(setting) if count <= MOST_SUBSTEPS]
