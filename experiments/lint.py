"""The lint on the shake test: contact parameters that say one thing and do another in MuJoCo's engines."""

from dataclasses import replace

import newton
import warp as wp

from experiments.facts.case import AS_SHIPPED, UNTRIMMED
from experiments.simulation.measurement import SETUP_FRAME_COUNT, Conditions, Measurement
from experiments.simulation.scene import build_scene
from experiments.simulation.task import FRAME_RATE
from newton_lint.findings import Buffer, Group, grouped
from newton_lint.newton_models.rules import Engine, lint

NEEDS_GPU = False
"""Read by ``measured_report.measuring.machine``: what it finds is the same on any machine."""


PEAK_FRAME_COUNT = SETUP_FRAME_COUNT + FRAME_RATE
"""Frames of the run for the peaks: the set-up and one cycle of the shake."""
ENGINE = Engine(
    1.0 / FRAME_RATE / UNTRIMMED.substeps, contacts=UNTRIMMED.contacts, cone=UNTRIMMED.cone, impratio=UNTRIMMED.impratio
)


def as_shipped() -> newton.Model:
    """Build the scene exactly as shipped."""
    return build_scene([UNTRIMMED], wp.get_device("cpu")).model


def measure(conditions: Conditions) -> Measurement:
    """Run the scene as far as its peaks and lint it: a row for each group of findings."""
    # The buffers of the untrimmed scene make a run on the CPU slow; what it needs of them the trimmed one needs too.
    [trace] = conditions.simulate([replace(AS_SHIPPED, frame_count=PEAK_FRAME_COUNT)], title="lint")
    buffers = (
        Buffer("contacts", UNTRIMMED.contact_max, trace.peak_contact_count),
        Buffer("constraints", UNTRIMMED.constraint_max, trace.peak_constraint_count),
    )
    groups = enumerate(grouped(lint(as_shipped(), ENGINE, buffers)), 1)
    return Measurement(
        [{"case": f"as-shipped-{index}", "scene": "as-shipped", **columns(group)} for index, group in groups]
    )


def columns(group: Group) -> dict[str, object]:
    """Return a group as columns of a row; values in a column that says their unit."""
    finding = group.first
    unit = "" if finding.unit == "1" else f"_{finding.unit}"
    used = {f"used{unit}": finding.used}
    if finding.used is None:
        used[f"used{unit}_reason"] = "the solver does not read it"
    return {
        "rule": finding.rule,
        "subject": group.subject,
        "against": group.against,
        "pair_count": group.count,
        "parameter": finding.parameter,
        f"authored{unit}": finding.value,
        **used,
        "message": finding.message,
    }
