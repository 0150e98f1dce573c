"""How a run of section stability ends."""

from experiments import classify
from report.results import Row

CLASSES = classify.CLASSES[::-1]
"""From the best to the worst."""


def is_stable(row: Row) -> bool:
    return row["class"] in classify.STABLE
