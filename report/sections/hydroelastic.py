"""Compare hydroelastic pads, which touch over an area, with contact points."""

from collections.abc import Iterable, Mapping
from itertools import takewhile

from report.shared import (
    CAUSE_BOUND,
    HOLDS,
    OPPOSITE,
    PERCENT,
    Claim,
    Outcome,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Table,
    Value,
    all_of,
    at_least,
    at_most,
    by_case,
    cell_count,
    constant,
    departure,
    extreme,
    greater,
    negligible,
    table_of,
    worlds_name,
)

order = 185
page = "scenes"
label = "hydroelastic pads"
labels = {
    "points": "points",
    "points/stiff": "points, stiff pads",
    "points/held": "points, arm held still",
    "points/plate": "points, thin plate",
    "points/edge": "points, cube gripped at two edges",
    "area": "hydroelastic",
    "area/held": "hydroelastic, arm held still",
    "area/held-collide-16": "hydroelastic, arm held still, contacts found in each substep",
    "area/term-restored": "hydroelastic, missing term restored",
    "area/default-gap": "hydroelastic, default gap of the cube",
    "area/collide-#": "hydroelastic, contacts found {} times per frame",
    "area/substeps-#": "hydroelastic, {} substeps",
    "area/kh-#": "hydroelastic, kh {}",
    "area/resolution-#": "hydroelastic, {} cells along a side",
    "area/plate": "hydroelastic, thin plate",
    "area/edge": "hydroelastic, cube gripped at two edges",
}
WORLDS = (1, 64)
BYTES_PER_MB = constant(1e6, "B/MB")
PADS = {"points": "points", "hydroelastic": "hydroelastic"}
OBJECTS = ("plate", "edge")
PARTS = (
    "same_slip",
    "term_remains",
    "stays_if_held",
    "depends_on_kh",
    "holds_in_all_runs",
    "holds_edges",
    "costs",
    "grasps",
    "times",
)


def derive(results: Results) -> Section:
    """Derive the section. Records of a CPU contain only the reason why they are empty."""
    if "area" not in results.row:
        return Section(unmeasured=PARTS)
    timed = RowsBy(results, results.rows, "pads", "worlds")
    rows = [row for row in results.rows if "worlds" not in row]
    columns = {
        "slip": "slip_mm",
        "drift": "drift_mm_s",
        "contacts": "row_count",
        "contacts with a force": "loaded_row_count",
        "time constant": "timeconst_ms",
        "penetration": "penetration_mm",
    }
    return Section(
        {"grasps": by_case(rows, columns), "times": _time_table(results, timed)},
        claims=[
            *_slip_claims(results),
            _lost_runs(results, rows),
            _edges(results),
            _cost(results, timed),
        ],
    )


def _time_table(results: Results, timed: Mapping) -> Table:
    columns: dict[str, list] = {}
    for count in WORLDS:
        of_count = [timed[pads, count] for pads in PADS]
        columns[f"time of a frame, {worlds_name(count)}"] = [
            row.frame_ms for row in of_count
        ]
        columns[f"memory of a world, {worlds_name(count)}"] = [
            results.value(
                f"{pads}_{count}_memory",
                f"memory of one of {worlds_name(count)}",
                timed[pads, count].bytes_per_world / BYTES_PER_MB,
            )
            for pads in PADS
        ]
    return table_of("pads", PADS.values(), columns)


def _slip_claims(results: Results) -> list[Claim]:
    points, area, held = (results.row[name] for name in ("points", "area", "area/held"))
    restored = results.row["area/term-restored"]
    change = results.value(
        "change",
        "absolute difference of the slips with areas and with points, relative to the"
        " latter",
        departure(area.slip_mm, points.slip_mm),
    )
    same = negligible(change, results.chosen("cause_bound", *CAUSE_BOUND))
    numbers = {"points": points.slip_mm, "area": area.slip_mm, "kh": area.kh_n_m3}
    claims = [Claim("same_slip", same.having_read(*numbers.values()), numbers)]

    def caused(name: str, row: Row) -> Value:
        return results.value(
            name,
            f"drift of {row.case} minus the drift with the arm held still, without sign",
            abs(row.drift_mm_s - held.drift_mm_s),
        )

    by_shake = caused("caused_by_shake", area)
    remaining = caused("remaining", restored)
    remains = greater(by_shake, remaining)
    claims.append(
        Claim("term_remains", remains, {"shake": by_shake, "remaining": remaining})
    )

    bound = results.chosen("bound", "a tenth of a slip that can be seen", 0.1, "mm")
    stays = at_most(held.slip_mm, bound)
    numbers = {"slip": held.slip_mm, "bound": bound}
    numbers["duration"] = held.shake_duration_s
    claims.append(Claim("stays_if_held", stays, numbers))

    swept = [area] + [
        row for row in results.rows if str(row.plain["case"]).startswith("area/kh-")
    ]
    slips = [row.slip_mm for row in swept]
    least = results.value("least_slip", "smallest slip over kh", extreme(min, slips))
    most = results.value("most_slip", "largest slip over kh", extreme(max, slips))
    span = results.value(
        "kh_span",
        "largest slip over the smallest, minus one",
        PERCENT * (most / least - 1),
    )
    matters = at_least(span, results.chosen("kh_bound", "a tenth", 10.0, "%"))
    numbers = {"least": least, "most": most, "lost": _lost_up_to(swept)}
    claims.append(Claim("depends_on_kh", matters, numbers))
    return claims


def _lost_up_to(swept: Iterable[Row]) -> Quantity | str:
    """Return the largest kh up to which every run loses the cube, or "" if there is none."""
    softest_first = sorted(swept, key=lambda row: row.plain["kh_n_m3"])
    lost = takewhile(_is_lost, softest_first)
    return max((row.kh_n_m3 for row in lost), key=lambda kh: kh.number, default="")


def _is_lost(row: Row) -> bool:
    return bool(row.plain.get("dropped"))


def _lost_runs(results: Results, rows: Iterable[Row]) -> Claim:
    """Return whether the cube stays in all runs of the table with hydroelastic pads."""
    runs = [row for row in rows if str(row.plain["case"]).startswith("area")]
    lost = results.value(
        "lost_runs",
        "count of hydroelastic runs that lose the cube",
        cell_count([row.kh_n_m3 for row in filter(_is_lost, runs)]),
    )
    count = results.value(
        "runs", "count of hydroelastic runs", cell_count([row.kh_n_m3 for row in runs])
    )
    outcome = at_most(lost, 0.0, "none of them")
    return Claim("holds_in_all_runs", outcome, {"lost": lost, "count": count})


def _edges(results: Results) -> Claim:
    held = {name: results.row[f"area/{name}"] for name in OBJECTS}
    lost = {name: row.plain.get("dropped") for name, row in held.items()}
    names = {"plate": "the thin plate", "edge": "the cube gripped at its edges"}
    dropped = [
        words
        for name, words in names.items()
        if results.row[f"points/{name}"].plain.get("dropped")
    ]
    outcome = OPPOSITE if any(lost.values()) else HOLDS
    if None in lost.values():
        outcome = Outcome("unknown", "one of these runs failed, or was not measured")
    reads = [row.kh_n_m3 for row in held.values()]
    numbers = lost | {"dropped": " and ".join(dropped)}
    return Claim("holds_edges", outcome.having_read(*reads), numbers)


def _cost(results: Results, timed: Mapping) -> Claim:
    one, many = (timed["hydroelastic", count] for count in WORLDS)
    outcome = all_of(
        greater(one.frame_ratio, 1.0, "the time with points"),
        greater(many.frame_ratio, 1.0, "the time with points"),
    )
    numbers = {
        "one": one.frame_ratio,
        "many": many.frame_ratio,
        "worlds": many.worlds,
    }
    return Claim("costs", outcome, numbers)
