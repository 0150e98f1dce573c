"""The turntable and the pinched capsule in other engines: does each do what its contact model says?"""

from collections.abc import Mapping
from dataclasses import dataclass

from measured_report.claims.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.shared.arithmetic import cell_count, extreme, other_cell, ratio, share, table_of

order = 187
page = "scenes"
label = "other engines"

LONG, SHORT = "2ms", "1ms"
LAWS = {
    "mujoco": "ω²((1 + Rm/n)/b − h/2)",
    "step": "ω²h/2",
    "sap": "ω²h/2 + σwhω²m/n",
    "mixed": "ω²h/2 + εwhω²m/n",
    "tamsi": "ω²h/2 + v/r, s(2 − s) = x",
    "lagged": "ω²h/2 + v/r, s/√(1 + s²) = x",
    "stribeck": "v/r, s³(10 − 15s + 6s²) = x",
    "anchored": "none",
    "": "none derived",
}
"""Of the walk. Each gives the sinking as well, by the same v."""
STOPS = {
    "mujoco": "the term put back",
    "step": "a shorter step",
    "sap": "a shorter step",
    "mixed": "a shorter step",
    "tamsi": "a shorter step, a smaller v_s",
    "lagged": "a shorter step, a smaller v_s",
    "stribeck": "a smaller v_s",
    "anchored": "there is nothing to stop",
    "": "a shorter step",
}


@dataclass(frozen=True)
class Line:
    """A line of the table: a contact model, and where its numbers are."""

    name: str
    engine: str
    law: str
    release: str
    """A package of the stack, or a release."""
    walks: Mapping[str, Quantity]
    """Measured, by step."""
    walk_law: Quantity
    sinks: Quantity
    sink_law: Quantity


MODELS = {
    "drake-sap-point": ("Drake, SAP, points", "sap"),
    "drake-sap-hydroelastic": ("Drake, SAP, hydroelastic", "sap"),
    "drake-tamsi-point": ("Drake, TAMSI, points", "tamsi"),
    "drake-tamsi-hydroelastic": ("Drake, TAMSI, hydroelastic", "tamsi"),
    "drake-tamsi-strict": ("Drake, TAMSI, points, a tenth of v_s", "tamsi"),
    "drake-lagged-point": ("Drake, lagged, points", "lagged"),
    "drake-continuous-point": ("Drake, continuous, points", "stribeck"),
    "dart": ("DART", "mixed"),
    "pybullet": ("PyBullet", "step"),
    "physx": ("PhysX, TGS", "anchored"),
}
SHAKES = ("stiff-pads", *(f"pad-kd-{kd}" for kd in (100, 50, 20, 10, 5, 2)))


def derive(results: Results) -> Section:
    walk_bound = results.chosen(
        "walk_bound",
        "a place 200 mm from the axis is rounded to 15 nm in single precision, half of it in each step of 2 ms",
        2e-3,
        unit="%/s",
    )
    sink_bound = results.chosen("sink_bound", "10 nm in a second", 0.01, unit="µm/s")
    lines = [*_of_mujoco(results), *_of_others(results), *_of_newton(results)]
    laws, anchors = _as_their_laws_say(results, lines, walk_bound, sink_bound), _anchors_hold(results, lines, walk_bound)
    table = _table(lines, walk_bound, sink_bound)
    table.numbers.update({"walk_bound": walk_bound, "sink_bound": sink_bound})
    test = table_of("pads", SHAKES, _shake_columns(results))
    return Section(
        tables={"engines": table, "test": test},
        claims=[laws, _walks_most_in_mujoco(results, lines), anchors, _test_lets_through(results)],
    )
