"""Scatter: how measurements as a whole come out apart, on other hosts and by other builds.

A number's variance is its own together with that of its column, which counts for the degrees of freedom of ``POOLED``
numbers: the moderated t of Smyth (2004), Statistical Applications in Genetics and Molecular Biology 3, article 3. More
would pretend to more measurements than there are, since they share their hosts. The measurement is the random effect of
a mixed model (Laird and Ware 1982, Biometrics 38, 963-974), and the noise the prediction interval of one more of them.
"""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from statistics import NormalDist
from typing import Any

from measured_report.files.config import config
from measured_report.records.columns import REASON, column_of, is_number
from measured_report.records.record import Record
from measured_report.values.noise import CONFIDENCE, PAIRS, ROUNDING_SHARE, TIMES, is_lost, is_repeated

POOLED = 4
"""Chosen: the numbers of a column that its variance counts for."""
TYPICAL = 0.9
"""Chosen: so large a share of a column's numbers vary no more: neither an outlier counts nor one that repeats."""
Key = tuple[Any, ...]
Row = Mapping[str, Any]


@dataclass(frozen=True)
class Scatter:
    """Tells how far apart measurements of a column come out, each number of it by its row."""

    typical: float
    """Variance of a number of the column; of larger ones than ``size`` in proportion, unless that is 0."""
    size: float
    freedom: int
    """Degrees of freedom of a number: measurements less one."""
    own: Mapping[Key, Sequence[float]] = field(default_factory=dict)
    """Variance that a number had itself, and the least and the largest that was measured."""

    @property
    def all_freedom(self) -> int:
        return (1 + POOLED) * self.freedom

    def noise(self, key: Key, value: float) -> float:
        """Bound how far from this number that of another measurement comes out: ``PAIRS`` of all come no farther."""
        common = self.typical * max(1.0, abs(value) / self.size if self.size else 1.0) ** 2
        together = (POOLED * common + self.own.get(key, [common])[0]) / (POOLED + 1)
        return quantile(self.all_freedom) * math.sqrt(2 * together)


@cache
def quantile(freedom: int) -> float:
    """Return Student's t that ``PAIRS`` of all lie within, by Wallace (1959), Ann. Math. Statist. 30, 1124-1130."""
    z = NormalDist().inv_cdf((1 + PAIRS) / 2) * (8 * freedom + 3) / (8 * freedom + 1)
    return math.sqrt(freedom * math.expm1(z * z / freedom))


def chance_of(times: float, freedom: int) -> float:
    """Tell how often measurements come out so many times their noise apart, or farther."""
    t = times * quantile(freedom)
    z = math.sqrt(freedom * math.log1p(t * t / freedom)) * (8 * freedom + 1) / (8 * freedom + 3)
    return 2 * NormalDist().cdf(-z)


def discoveries(chances: Sequence[float]) -> float:
    """Return the largest chance that counts as none, by Benjamini and Hochberg (1995), J. R. Stat. Soc. B 57, 289."""
    ranked = enumerate(sorted(chances), 1)
    return max((each for rank, each in ranked if each <= (1 - CONFIDENCE) * rank / len(chances)), default=0.0)


@dataclass(frozen=True)
class Apart:
    """Holds how the measurements of a section are apart."""

    count: int = 1
    columns: Mapping[Key, Scatter] = field(default_factory=dict)
    """By the column and what says whose numbers these are: an engine that repeats has nothing of one that does not."""
    edge: frozenset[Key] = frozenset()
    """Rows that were lost in one measurement and not in another, or are text otherwise: which of both is chance."""

    def of(self, column: str, row: Row) -> Scatter | None:
        """Find how numbers such as that of a row come out."""
        return self.columns.get((column, *engine_of(row)))

    def noise(self, column: str, row: Row) -> float | None:
        """Return the noise of a number of a row; None where the measurements tell none."""
        scatter, number = self.of(column, row), scattered(column, row)
        if scatter is None or number is None:
            return None
        return max(scatter.noise(key_of(row), number), ROUNDING_SHARE * abs(number))

    def interval(self, column: str, row: Row) -> str:
        """Say between which numbers the measurements of a number of a row lie; empty where there is one."""
        scatter = self.of(column, row)
        found = scatter.own.get(key_of(row)) if scatter else None
        return f"{scatter.freedom + 1} measurements from {found[1]:.6g} to {found[2]:.6g}" if scatter and found else ""


def key_of(row: Row) -> Key:
    """Return what tells a row from the others of its section, in any measurement."""
    return tuple(row.get(name) for name in config().changes.keys)


def engine_of(row: Row) -> Key:
    """Return what tells whose numbers a row has, as to how well they repeat."""
    return tuple(row.get(name) for name in config().repeating)


def apart(records: Sequence[Record]) -> Apart:
    """Compare the measurements of a section, the first of them that which is shown."""
    keyed = [_by_key(record.rows) for record in records]
    shared = [key for key in keyed[0] if all(key in rows for rows in keyed)]
    words = {name for rows in keyed for row in rows.values() for name, cell in row.items() if not is_number(cell)}
    words = {name for name in words - {"case"} if name not in records[0].units and not name.endswith(REASON)}
    edge = frozenset(key for key in shared if any(len({rows[key].get(name) for rows in keyed}) > 1 for name in words))
    there = [key for key in shared if key not in edge and not is_lost(keyed[0][key])]
    columns: dict[Key, Scatter] = {}
    shown = records[0].processor  # whose times say nothing of those of another kind
    for name in records[0].units:
        about = column_of(name)
        is_cost = "cost" in about.kinds or about.unit in TIMES
        mine = [rows for rows, record in zip(keyed, records, strict=True) if not is_cost or record.processor == shown]
        cells: dict[Key, dict[Key, list[Row]]] = {}
        for key in there if len(mine) > 1 else ():
            cells.setdefault((name, *engine_of(keyed[0][key])), {})[key] = [rows[key] for rows in mine]
        columns |= {each: scatter for each, found in cells.items() if (scatter := _scatter(name, found))}
    return Apart(len(records), columns, edge)


def _by_key(rows: Sequence[Row]) -> dict[Key, Row]:
    count = Counter(map(key_of, rows))
    return {key_of(row): row for row in rows if count[key_of(row)] == 1}


def _scatter(column: str, cells: Mapping[Key, Sequence[Row]]) -> Scatter | None:
    import numpy as np  # it takes long, and what is kept from before needs none of it

    read = {key: [scattered(column, row) for row in rows] for key, rows in cells.items()}
    found = {key: [*filter(is_number, numbers)] for key, numbers in read.items() if None not in numbers}
    if not any(len(set(numbers)) > 1 for numbers in found.values()):
        return None
    measured = np.array(list(found.values()), float)  # by number and measurement
    least, largest = measured.min(axis=1), measured.max(axis=1)
    variances = np.where(least < largest, measured.var(axis=1, ddof=1), 0.0)
    own = dict(zip(found, zip(variances.tolist(), least.tolist(), largest.tolist(), strict=True), strict=True))
    magnitudes = abs(measured.mean(axis=1))

    def typical(size: float) -> tuple[float, float]:
        """Return how unlike the variances are, in proportion to numbers of that size or not, and the typical one."""
        scaled = np.sort(variances / np.maximum(1.0, magnitudes / size if size else 1.0) ** 2)
        middle, most = (float(scaled[math.ceil(share * len(scaled)) - 1]) for share in (0.5, TYPICAL))
        return most / middle if middle else math.inf, most

    sizes = 0.0, float(np.median(magnitudes)), float(magnitudes[magnitudes > 0].min())
    (_, most), size = min((typical(size), size) for size in sizes)
    freedom = measured.shape[1] - 1
    part = 2 / (9 * freedom)  # chi-squared by Wilson and Hilferty, as in ``tolerance``
    chi_squared = freedom * (1 - part + NormalDist().inv_cdf(TYPICAL) * math.sqrt(part)) ** 3
    return Scatter(most * freedom / chi_squared, size, freedom, own)


def scattered(column: str, row: Row) -> float | None:
    """Return the number of a column, where it was measured and no engine repeats it to the last bit."""
    number = row.get(column)
    is_same = not is_number(number) or column_of(column).is_exact or is_repeated(column, row)
    return None if is_same else number
