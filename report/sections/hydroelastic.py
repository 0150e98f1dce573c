"""Compare pads that touch over an area, with a pressure, with pads that touch at points."""

from collections.abc import Mapping

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Row,
    RowsBy,
    Section,
    all_of,
    at_least,
    at_most,
    by_case,
    decided,
    extreme,
    greater,
    resolution,
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
    "points/edge": "points, sharp edge",
    "area": "hydroelastic",
    "area/held": "arm held still",
    "area/held-collide-16": "arm held still, contacts found in each substep",
    "area/term-restored": "missing term restored",
    "area/default-gap": "default gap of the cube",
    "area/collide-#": "contacts found {} times in a frame",
    "area/substeps-#": "{} substeps",
    "area/kh-#": "kh {}",
    "area/resolution-#": "{} cells along a side",
    "area/plate": "thin plate",
    "area/edge": "sharp edge",
}
WORLDS = (1, 64)
PADS = {"points": "points", "hydroelastic": "hydroelastic"}
OBJECTS = ("plate", "edge")
CLAIMS = (
    "slips_less",
    "term_remains",
    "stays_if_held",
    "depends_on_kh",
    "holds_edges",
    "costs",
)


def derive(results: Results) -> Section:
    """Derive the section. Records of a CPU contain only the reason why they are empty."""
    if "area" not in results.row:
        return Section(unmeasured=CLAIMS)
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
        claims=[*_slip_claims(results), _edges(results), _cost(results, timed)],
    )


def _time_table(results: Results, timed: Mapping):
    columns: dict[str, list] = {}
    for count in WORLDS:
        of_count = [timed[pads, count] for pads in PADS]
        columns[f"time of a frame, {worlds_name(count)}"] = [
            row.frame_ms for row in of_count
        ]
        columns[f"memory of a world, {worlds_name(count)}"] = [
            row.bytes_per_world for row in of_count
        ]
    worst = resolution(results, "resolution", timed.values())
    return table_of("pads", PADS.values(), columns, resolution=worst)


def _slip_claims(results: Results) -> list[Claim]:
    points, area, held = (results.row[name] for name in ("points", "area", "area/held"))
    restored = results.row["area/term-restored"]
    less = greater(points.slip_mm, area.slip_mm)
    claims = [
        Claim("slips_less", less, {"points": points.slip_mm, "area": area.slip_mm})
    ]

    def caused(name: str, row: Row):
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
    resting = results.row["points/held"].slip_mm
    stays = at_most(held.slip_mm, bound).having_read(resting)
    numbers = {"slip": held.slip_mm, "points": resting, "bound": bound}
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
    numbers = {"least": least, "most": most}
    claims.append(Claim("depends_on_kh", matters, numbers))
    return claims


def _edges(results: Results) -> Claim:
    held = [results.row[f"area/{name}"] for name in OBJECTS]
    lost = [results.row[f"points/{name}"] for name in OBJECTS]
    keeps = [row.plain.get("dropped") is False for row in held]
    names = {"plate": "the thin plate", "edge": "the cube on its edges"}
    dropped = [
        name
        for name, row in zip(names.values(), lost, strict=True)
        if row.plain.get("dropped")
    ]
    outcome = decided(all(keeps), *(row.slip_mm for row in held))
    slips = {name: row.slip_mm for name, row in zip(OBJECTS, held, strict=True)}
    return Claim("holds_edges", outcome, slips | {"dropped": " and ".join(dropped)})


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
        "memory": many.bytes_per_world,
    }
    return Claim("costs", outcome.having_read(many.bytes_per_world), numbers)
