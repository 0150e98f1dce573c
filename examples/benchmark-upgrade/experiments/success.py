"""Run all tasks without changes, and count successes, steps and grasped objects."""

from experiments.episodes import FIRST_SEEDS, TASKS, row
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement


def measure(conditions: Conditions) -> Plan:
    seeds = FIRST_SEEDS[:2] if conditions.quick else FIRST_SEEDS
    rows = yield [Batch(task, row, (task, seeds)) for task in TASKS]
    return Measurement(rows)
