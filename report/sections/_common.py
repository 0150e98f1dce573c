"""What several sections share. The underscore keeps it from being taken for a section."""

from report.quantities import Quantity
from report.results import Results


def noise_floor(results: Results, name: str) -> Quantity:
    """``slip_floor`` [mm] or ``drift_floor`` [mm/s]: how far apart identical runs come out."""
    return other_value(results, "noise", name, unit={"slip_floor": "mm", "drift_floor": "mm/s"}[name])


def other_value(results: Results, section: str, name: str, *, unit: str = "1") -> Quantity:
    """A value that an earlier section derived; without a number, and with a reason, when it isn't there."""
    other = results.others.get(section)
    if other and name in other.derived:
        return other.derived[name]
    return Quantity(None, unit, "", f"section {section} does not say")


def friction_rows_differ(contacts: Results | None) -> bool:
    """Whether friction rows have a time constant of their own, by what section contacts found; C's never have."""
    rows = contacts.rows if contacts else []
    return any("friction_timeconst_s" in row and row.friction_timeconst_s.value for row in rows)


def other_cell(results: Results, section: str, case: str, column: str, *, unit: str) -> Quantity:
    """What an earlier section measured; without a number, and with a reason, when it isn't there."""
    other = results.others.get(section)
    if other and case in other.row and column in other.row[case]:
        return other.row[case][column]
    return Quantity(None, unit, "", f"section {section} does not say")
