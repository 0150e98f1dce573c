"""The example: the shake test as Newton's examples are run, and what it has measured."""

from typing import Any

import numpy as np
import warp as wp

from experiments.facts.case import Case
from experiments.facts.trace import Trace
from experiments.simulation.measurement import summarize
from experiments.simulation.simulation import Simulation

SLIP_LIMIT_MM = 20.0
"""Half the cube's edge: with more slip the pads no longer cover the cube's centre."""


class TestFailed(ValueError):
    """The scene's own test failed; the message is one line."""


class Example:
    """What ``newton.examples.run`` drives: one frame a step, drawn after it, judged at the end."""

    def __init__(self, viewer, case: Case, world_count: int):
        self.viewer = viewer
        self.case = case
        device = wp.get_device("cpu") if self.case.backend == "mujoco" else wp.get_device()
        self.simulation = Simulation([case] * world_count, device)
        self.model = self.simulation.model
        self.state_0 = self.simulation.state
        self.control = self.simulation.control
        self.contacts = self.simulation.contacts
        self.frame_count = 0
        viewer.set_model(self.model)

    def step(self) -> None:
        self.simulation.step()
        self.frame_count += 1

    def render(self) -> None:
        self.viewer.begin_frame(self.frame_count * self.simulation.frame_dt)
        self.viewer.log_state(self.state_0)
        self.viewer.end_frame()

    def summaries(self) -> list[dict[str, Any]]:
        """Return the measured summary of each world so far."""
        frame_count = min(self.frame_count, self.case.frame_count)
        traces = self.simulation.recorder.traces(self.simulation.frame_dt, frame_count, wall_s=0.0)
        return [summary_of(self.case, trace) for trace in traces]

    def test_final(self) -> None:
        """Raise TestFailed where the cube of any world is not in the grasp any more."""
        for world, summary in enumerate(self.summaries()):
            if summary["failure"]:
                raise TestFailed(f"world {world}: {summary['failure']}")
            if summary["slip_mm"] is None:
                raise TestFailed(f"world {world}: {summary['slip_mm_reason']} in {self.frame_count} frames")
            if summary["dropped"] or summary["slip_mm"] > SLIP_LIMIT_MM:
                raise TestFailed(f"world {world}: the cube left the grasp (slip {summary['slip_mm']:.2f} mm)")


def summary_of(case: Case, trace: Trace) -> dict[str, Any]:
    """Return the row of a trace, in which a cube that was not shaken, and perhaps not grasped yet, is not called
    dropped."""
    row = summarize(case, trace)
    del row["wall_s"]  # nothing is timed here
    reason = row.get("slip_mm_reason")
    return row | ({"dropped": None, "dropped_reason": reason} if reason else {})


def headline(summary: dict[str, Any]) -> str:
    """Return the summary in a line."""
    if summary["slip_mm"] is None:
        return f"no slip: {summary['slip_mm_reason']}"
    return f"slip {summary['slip_mm']:.3g} mm, drift {summary['drift_mm_s']:.3g} mm/s"


def plain(row: dict[str, Any]) -> dict[str, Any]:
    """Return the row with numpy's scalars turned into Python's."""
    return {name: value.item() if isinstance(value, np.generic) else value for name, value in row.items()}
