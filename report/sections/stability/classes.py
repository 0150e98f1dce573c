"""How a run of section stability ends."""

from experiments.facts import classes as classify
from measured_report.values.results import Row

CLASSES = classify.CLASSES[::-1]
"""From the best to the worst."""


def is_stable(row: Row) -> bool:
    return row["class"] in classify.STABLE
