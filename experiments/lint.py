"""The lint on the shake test: contact parameters that say one thing and do another in MuJoCo's engines."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import newton
import warp as wp

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, UNTRIMMED, Case
from experiments.simulation.measurement import SETUP_FRAME_COUNT, Conditions, Measurement
from experiments.simulation.scene import build_scene
from experiments.simulation.simulation import CONSTRAINT_MAX, CONTACT_MAX
from experiments.simulation.task import FRAME_RATE
from newton_lint.findings import Buffer, Finding, Group, grouped
from newton_lint.newton_models.rules import Engine, lint

NEEDS_GPU = False
"""Read by ``measured_report.measuring.machine``: what it finds is the same on any machine."""


@dataclass(frozen=True)
class LintedScene:
    """A scene to be linted, and the case whose run says what its buffers need."""

    case: Case
    peaks: Case

    @property
    def engine(self) -> Engine:
        case = self.case
        step = 1.0 / FRAME_RATE / case.substeps
        return Engine(step, contacts=case.contacts, cone=case.cone, impratio=case.impratio)

    def model(self) -> newton.Model:
        return build_scene([self.case], wp.get_device("cpu")).model


SCENES = {
    # The buffers of the untrimmed scene make a run on the CPU slow; what it needs of them the trimmed one needs too.
    "as-shipped": LintedScene(UNTRIMMED, AS_SHIPPED),
    "fixed": LintedScene(*[replace(STIFF_PADS, cube_gap_m=STIFF_PADS.robot_gap_m)] * 2),
}
PEAK_FRAME_COUNT = SETUP_FRAME_COUNT + FRAME_RATE
"""Frames of the run for the peaks: the set-up and one cycle of the shake."""


def lint_scenes(conditions: Conditions, names: Sequence[str]) -> dict[str, list[Finding]]:
    """Build each scene, run it as far as its peaks, and lint it."""
    runs = [replace(SCENES[name].peaks, frame_count=PEAK_FRAME_COUNT) for name in names]
    traces = conditions.simulate(runs, title="lint")
    found = {}
    for name, trace in zip(names, traces, strict=True):
        scene = SCENES[name]
        buffers = (
            Buffer("contacts", scene.case.contact_max or CONTACT_MAX, trace.peak_contact_count),
            Buffer("constraints", scene.case.constraint_max or CONSTRAINT_MAX, trace.peak_constraint_count),
        )
        found[name] = lint(scene.model(), scene.engine, buffers)
    return found


def measure(conditions: Conditions) -> Measurement:
    """A row for each scene, and one for each group of its findings."""
    rows = []
    for name, findings in lint_scenes(conditions, list(SCENES)).items():
        groups = grouped(findings)
        rows.append({"case": name, "finding_count": len(groups)})
        rows += [{"case": f"{name}-{index}", "scene": name, **columns(group)} for index, group in enumerate(groups, 1)]
    return Measurement(rows)


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
