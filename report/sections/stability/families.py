"""What the parts of section stability share: its rows by family, and claims about a family."""

from collections.abc import Iterable, Sequence
from typing import Any

from markupsafe import Markup

from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_most, decided
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.sections.stability.passing import judged_by, passing
from report.shared.arithmetic import case_html, cell_count, extreme, some_html


def family(results: Results, name: str) -> list[Row]:
    return [row for row in results.rows if row["family"] == name]


def count(results: Results, name: str, formula: str, rows: Sequence[Row]) -> Value:
    """Count the rows, as a value that points to them."""
    return cell_count(results, name, formula, [row.step_ms for row in rows])


def least(results: Results, name: str, formula: str, rows: Iterable[Row], column: str) -> Value:
    """Derive the least of a column; without a number when there is none."""
    return extreme(results, name, formula, min, [row[column] for row in rows])


def most(results: Results, name: str, formula: str, rows: Iterable[Row], column: str) -> Value:
    """Derive the largest of a column; without a number when there is none."""
    return extreme(results, name, formula, max, [row[column] for row in rows])


def family_claim(results: Results, name: str, rows: Sequence[Row], also: Outcome = HOLDS, **numbers: Any) -> Claim:
    """Claim that all rows of a family pass, of those of which something is asked, and something else holds ``also``.

    Its wording can name ``numbers``, ``count``, ``failed_count`` and ``failed``, which cases do not pass and how they
    ended.
    """
    verdicts = [(row, passes) for row, passes in zip(rows, passing(rows), strict=True) if passes is not None]
    asked, failed = [row for row, _ in verdicts], [row for row, passes in verdicts if not passes]
    failed_count = count(results, f"{name}_failed", f"runs of {name} that do not pass", failed)
    own = {
        "count": count(results, f"{name}_count", f"runs of {name} of which something is asked", asked),
        "failed_count": failed_count,
        "failed": some_html([Markup("{} {}").format(case_html(row), row["class"]) for row in failed]),
    }
    cells = [cell for row in rows for cell in judged_by(row)]
    outcome = all_of(at_most(failed_count, 0, why="all of them pass"), decided(True, *cells), also)
    return Claim(name, outcome if rows else Outcome("unknown", "they were not measured"), own | numbers)
