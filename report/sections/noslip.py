"""Does MuJoCo's own remedy for slip help? With noslip and without, in C and, where it is there, in Warp."""

from collections.abc import Mapping

import pandas as pd

from measured_report.claims.claims import Claim, at_most
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html
from report.shared.arithmetic import told

order = 75
page = "cause"
label = "noslip"

ENGINES = {"mujoco-c": "MuJoCo's C engine", "warp": "MuJoCo Warp"}
PADS = ("as-shipped", "stiff-pads")


def derive(results: Results) -> Section:
    pairs = {
        f"{pads}-{engine}": (results.row[f"{pads}-{engine}"], results.row[f"{pads}-{engine}-noslip"])
        for engine in ENGINES
        for pads in PADS
    }
    changes = {case: _change(results, case, *pair) for case, pair in pairs.items()}
    bound = results.chosen("change_bound", "it is the same drift", 10.0, unit="%")
    return Section(
        tables={"cases": _table(pairs, changes)},
        claims=[_does_not_help(results, engine, pairs, changes, bound) for engine in ENGINES],
    )


def _change(results: Results, case: str, without: Row, treated: Row) -> Value:
    return results.value(
        f"{case}_change",
        f"drift of {case} with noslip less that without, of that without",
        lambda found, before: 100 * (found / before - 1),
        treated.drift_mm_s,
        without.drift_mm_s,
        unit="%",
    )


def _does_not_help(
    results: Results, engine: str, pairs: Mapping[str, tuple[Row, Row]], changes: Mapping[str, Value], bound: Value
) -> Claim:
    formula = f"larger change that noslip makes in a drift, in size, in {ENGINES[engine]}"
    of_engine = (changes[f"{pads}-{engine}"] for pads in PADS)
    largest = results.value(f"{engine}_change", formula, lambda *change: max(map(abs, change)), *of_engine, unit="%")
    (without, treated), (without_stiff, treated_stiff) = (pairs[f"{pads}-{engine}"] for pads in PADS)
    drifts = {
        "treated": treated.drift_mm_s,
        "without": without.drift_mm_s,
        "treated_stiff": treated_stiff.drift_mm_s,
        "without_stiff": without_stiff.drift_mm_s,
    }
    return Claim(
        f"noslip_does_not_help_in_{engine.replace('-', '_')}",
        at_most(largest, bound),
        numbers={"iterations": treated.noslip_iterations, **told(largest, drifts)},
    )


def _table(pairs: Mapping[str, tuple[Row, Row]], changes: Mapping[str, Value]) -> Table:
    columns = {
        "drift": [without.drift_mm_s for without, _ in pairs.values()],
        "drift with noslip": [treated.drift_mm_s for _, treated in pairs.values()],
        "change": [changes[case] for case in pairs],
        "slip": [without.slip_mm for without, _ in pairs.values()],
        "slip with noslip": [treated.slip_mm for _, treated in pairs.values()],
    }
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, pairs), name="case")))
