"""Run the tasks that a release seemed to change with seeds that were not used to choose them."""

from experiments.episodes import CHANGED, FRESH_SEEDS, row
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement


def measure(conditions: Conditions) -> Plan:
    seeds = FRESH_SEEDS[:2] if conditions.quick else FRESH_SEEDS
    rows = yield [Batch(task, row, (task, seeds)) for task in CHANGED]
    return Measurement(rows)
