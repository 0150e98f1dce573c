"""Collect the helpers of derivations: rows, values, tests, tables and arithmetic.

The helpers of figures are in ``drawing`` and ``maps``, because importing Matplotlib is
slow.
"""

# ruff: noqa: F401
from measured_report.parts.claim import (
    FAILS,
    HOLDS,
    OPPOSITE,
    Claim,
    Outcome,
    all_of,
    at_least,
    at_most,
    decided,
    decreases,
    greater,
    negligible,
)
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import (
    PERCENT,
    Quantity,
    Value,
    absent,
    combined,
    constant,
)
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import (
    AS_PUBLISHED,
    CASES,
    CAUSE_BOUND,
    DEVICES,
    FRAME_RATE,
    MM_PER_M,
    MS_PER_S,
    SETTLES,
    SLIP_BOUND,
    SUBSTEP_S,
    VISIBLE,
    Sections,
    cell_count,
    cell_or_absent,
    contiguous,
    departure,
    extreme,
    gathered,
    is_held,
    joined,
    largest_size,
    quantile,
    relevance,
    rows_with,
    sections_of,
    settings_of,
    spread,
)
from report.shared.tables import (
    by_case,
    case_html,
    cell_or_lost,
    measurable_creep,
    some_html,
    table_of,
)
from report.shared.timing import (
    SLOWER,
    TIMED_WORLDS,
    RowsBy,
    resolution,
    worlds_name,
)
from report.shared.variants import change_of, variants_claim
