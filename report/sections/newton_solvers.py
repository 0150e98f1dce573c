"""Newton's own solvers beside MuJoCo Warp: the box on a table, and in SolverSteel the shake itself."""

from collections.abc import Sequence
from itertools import product

from measured_report.parts.claim import FAILS, HOLDS, OPPOSITE, Claim, all_of, at_least, at_most, decided, greater
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.shared.arithmetic import Column, departure, noise_floor, table_of
from report.shared.timing import TIMED_WORLDS, RowsBy, compared, resolution, worlds_name

order = 188
page = "scenes"
reads = ("noise",)
label = "Newton's solvers"

NAMES = {
    "warp": "MuJoCo Warp",
    "steel": "Steel",
    "steel-points": "without friction anchors",
    "steel-matched": "warm start by matched contacts",
    "steel-substeps": "contacts found in each substep",
    "steel-iterations": "eight times the iterations",
    "steel-32-rows": "as many rows as it comes with",
}
TIMED = ("steel", "steel-points")
BOXES = {
    "mujoco": "MuJoCo Warp",
    "xpbd": "XPBD",
    "vbd": "VBD",
    "steel-points": "Steel, without anchors",
    "steel-matched": "Steel, warm start by matched contacts",
    "steel-frames": "Steel, contacts found every eighth step",
}
"""Labels of Newton's solvers that are not their names."""
SCENES = {"step of 2 ms": "2ms", "step of 1 ms": "1ms", "on a slope": "slope", "held still": "still"}
OF_STEEL: tuple[str, ...] = (
    "steel_stays",
    "slips_less",
    "anchors_help",
    "rows_overflow",
    "weight_is_carried",
    "fails_sooner",
)
OF_STEEL += ("costs_more", "shakes", "times")


def derive(results: Results) -> Section:
    """Derive the section; of a release without Steel there is no shake."""
    rows = RowsBy(results, results.rows, "variant", "shake")
    results.chosen("ended_bound", "a tenth of a slip that can be seen", 0.1, unit="mm")
    tables = {"boxes": _box_table(results)}
    offered = Claim("offered", (HOLDS if rows else FAILS).having_read(results.row["mujoco-2ms"].growth_per_s))
    if not rows:
        return Section(tables=tables, claims=[offered], unmeasured=OF_STEEL)
    times = RowsBy(results, results.rows, "variant", "worlds")
    claims = [
        offered,
        _steel_stays(results),
        _slips_less(results, rows),
        _anchors_help(results, rows),
        _rows_overflow(rows),
        _weight_is_carried(results, rows),
        _fails_sooner(rows),
        _costs_more(results, times),
    ]
    there = [name for name in NAMES if (name, "3cm") in rows]
    tables["shakes"] = table_of("solver", [NAMES[name] for name in there], _columns(rows, there))
    extra = {worlds_name(n): [results.derived[f"{name}_extra_{n}"] for name in TIMED] for n in TIMED_WORLDS}
    tables["times"] = table_of("solver", map(NAMES.__getitem__, TIMED), extra, resolution=results.derived["resolution"])
    return Section(tables=tables, claims=claims)


def _box_table(results: Results) -> Table:
    """Make a line for each of Newton's solvers; one that is excused has the reason."""
    names = list(dict.fromkeys(row["solver"] for row in results.rows if "solver" in row))
    excused = [row for row in results.rows if "of" in row and "solver" not in row]
    columns: dict[str, Column] = {
        above: [_of_box(results, name, end) for name in names] + [row.growth_per_s for row in excused]
        for above, end in SCENES.items()
    }
    labels = [BOXES.get(name, name.capitalize()) for name in names] + [row["of"] for row in excused]
    return table_of("solver", labels, columns)


def _of_box(results: Results, solver: str, end: str) -> Quantity | str:
    """Say how fast the box walks outward, or creeps where the table stands still."""
    row = results.row[f"{solver}-{end}"]
    is_turning = end.endswith("ms")
    cell = row["growth_per_s" if is_turning else "creep_mm_s"]
    if cell.value is not None and not row.stays:
        return "sinks in or lost"
    return _percent(results, f"{solver}_{end}", cell) if is_turning else cell


def _percent(results: Results, name: str, cell: Quantity) -> Value:
    return results.value(name, "in percent of the distance from the axis", lambda rate: 100 * rate, cell, unit="%/s")


def _steel_stays(results: Results) -> Claim:
    """Tell whether the box stays where it is on the turning table by the anchors of Steel's friction."""
    anchors, points, warp = (results.derived[f"{name}_2ms"] for name in ("steel", "steel-points", "mujoco"))
    seen = results.chosen("seen", "rounding of a place in single precision makes so much", 2e-3, unit="%/s")
    size, without = (
        results.value(f"{name}_size", "its size", abs, walk, unit="%/s")
        for name, walk in (("anchors", anchors), ("points", points))
    )
    outcome = all_of(at_most(size, seen), at_least(without, seen))
    return Claim("steel_stays", outcome, {"anchors": anchors, "points": points, "warp": warp})


def _columns(rows: RowsBy, names: Sequence[str]) -> dict[str, Column]:
    """Return what each variant does in the shake, and in others how far the cube slips, if it is kept."""

    def column(shake: str, name: str) -> list[Quantity | str]:
        found = [rows[each, shake] for each in names]
        return ["lost" if row.dropped else row[name] for row in found]

    grasp = {"friction used": "friction_share", "normal force": "normal_force_n", "penetration": "penetration_mm"}
    columns: dict[str, Column] = {"slip": column("3cm", "slip_mm"), "creep": column("3cm", "creep_mm_per_cycle")}
    columns |= {above: column("3cm", name) for above, name in grasp.items()}
    others = {"with weight": "weight", "shaken 100 mm": "10cm", "held still": "held"}
    return columns | {above: column(shake, "slip_mm") for above, shake in others.items()}


def _slips_less(results: Results, rows: RowsBy) -> Claim:
    """Tell whether the cube slips less far in Steel than in MuJoCo Warp, in the same scene without weight."""
    warp, steel = rows["warp", "3cm"], rows["steel", "3cm"]
    used = results.value("used", "friction used, in percent", lambda part: 100 * part, steel.friction_share, unit="%")
    outcome = greater(warp.slip_mm, steel.slip_mm, noise=noise_floor(results, "slip_floor"))
    numbers = {"warp": warp.slip_mm, "steel": steel.slip_mm, "creep": steel.creep_mm_per_cycle, "used": used}
    return Claim("slips_less", outcome, numbers | {"held": rows["steel", "held"].slip_mm})


def _anchors_help(results: Results, rows: RowsBy) -> Claim:
    """Tell whether friction that remembers where a contact began lets the cube slip less far."""
    anchors, points = rows["steel", "3cm"].slip_mm, rows["steel-points", "3cm"].slip_mm
    outcome = greater(points, anchors, noise=noise_floor(results, "slip_floor"))
    return Claim("anchors_help", outcome, {"anchors": anchors, "points": points})


def _rows_overflow(rows: RowsBy) -> Claim:
    """Tell whether as many rows as Steel comes with are too few for the arm and the cube, and enough are enough."""
    few, enough = rows["steel-32-rows", "3cm"], rows["steel", "3cm"]
    is_so = bool(few.failure) and not enough.failure
    needed = enough.peak_constraint_count
    return Claim("rows_overflow", decided(is_so, needed), {"needed": needed})


def _weight_is_carried(results: Results, rows: RowsBy) -> Claim:
    """Tell whether gravity, with forces that carry the arm's weight, changes little of how far the cube slips."""
    light, heavy = rows["steel", "3cm"].slip_mm, rows["steel", "weight"].slip_mm
    change = departure(results, "weight_change", "change by weight, of the slip without", heavy, light)
    return Claim("weight_is_carried", at_most(change, 20.0, why="a fifth"), {"light": light, "heavy": heavy})


def _fails_sooner(rows: RowsBy) -> Claim:
    """Tell whether Steel loses the cube in a wide shake in which MuJoCo Warp keeps it; the other way round is the
    opposite."""
    lost = {name: bool(rows[name, "10cm"].dropped) for name in ("warp", "steel")}
    cells = [rows[name, "10cm"].wander_mm for name in lost]
    found = OPPOSITE if lost["warp"] and not lost["steel"] else decided(lost["steel"] and not lost["warp"], *cells)
    numbers = {
        "steel": cells[1],
        "warp": cells[0],
        "both_keep": not any(lost.values()),
        "both_lose": all(lost.values()),
    }
    return Claim("fails_sooner", found.having_read(*cells), numbers)


def _costs_more(results: Results, times: RowsBy) -> Claim:
    """Tell whether a frame takes longer in Steel, with one world and with the most."""
    extra = {}
    for variant, count in product(TIMED, TIMED_WORLDS):
        formula = f"time of a frame of {variant} over that of MuJoCo Warp, timed in turn, less one"
        ratio = times[variant, count].frame_ratio
        extra[variant, count] = results.value(
            f"{variant}_extra_{count}", formula, lambda taken: 100 * (taken - 1), ratio, unit="%"
        )
    known = resolution(results, "resolution", compared(times.values()))
    alone, many = (extra["steel", count] for count in (TIMED_WORLDS[0], TIMED_WORLDS[-1]))
    outcome = all_of(greater(alone, 0.0, noise=known, why="none"), greater(many, 0.0, noise=known, why="none"))
    worlds = times["steel", TIMED_WORLDS[-1]].worlds
    return Claim("costs_more", outcome, {"alone": alone, "many": many, "worlds": worlds})
