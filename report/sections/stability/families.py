"""What the parts of section stability share: its rows by family, and claims about a family."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup

from measured_report.claims.claims import HOLDS, Claim, Outcome, all_of, at_most, decided
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, some_html
from report.sections.stability.passing import judged_by, passing
from report.shared.arithmetic import cell_count


def family(results: Results, name: str) -> list[Row]:
    return [row for row in results.rows if row["family"] == name]


def count(results: Results, name: str, formula: str, rows: Sequence[Row]) -> Value:
    """How many rows there are, as a value that points to them."""
    return cell_count(results, name, formula, [row.step_ms for row in rows])


def family_claim(
    results: Results,
    name: str,
    rows: Sequence[Row],
    *,
    numbers: Mapping[str, Quantity | str | bool] | None = None,
    also: Outcome = HOLDS,
) -> Claim:
    """Whether all rows of a family pass, of those of which something is asked, and something else holds ``also``.

    Its wording can name ``count``, ``failed_count`` and ``failed``, the cases that do not pass and how they ended.
    """
    verdicts = [(row, passes) for row, passes in zip(rows, passing(rows), strict=True) if passes is not None]
    asked, failed = [row for row, _ in verdicts], [row for row, passes in verdicts if not passes]
    failed_count = count(results, f"{name}_failed", f"runs of {name} that do not pass", failed)
    none = results.chosen(f"{name}_bound", "all of them pass", 0)
    own = {
        "count": count(results, f"{name}_count", f"runs of {name} of which something is asked", asked),
        "failed_count": failed_count,
        "failed": some_html([Markup("{} {}").format(case_html(row.case), row["class"]) for row in failed]),
    }
    cells = [cell for row in rows for cell in judged_by(row)]
    outcome = all_of(at_most(failed_count, none), decided(True, *cells), also)
    if not rows:
        outcome = Outcome("unknown", "they were not measured")
    return Claim(name, outcome, own | dict(numbers or {}))
