"""Newton's own solvers beside MuJoCo Warp: the box on a table, and the shake itself."""

from collections.abc import Mapping
from typing import Any

from report.shared import (
    HOLDS,
    OPPOSITE,
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Column,
    Outcome,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Table,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    cell_or_lost,
    creep_or_unseen,
    decided,
    departure,
    greater,
    is_held,
    table_of,
    worlds_name,
)

order = 188
page = "scenes"
label = "Newton's solvers"

NAMES = {  # labels of solvers that are not their names
    "warp": "MuJoCo Warp, shipped pads",
    "mujoco": "MuJoCo Warp",
    "xpbd": "XPBD",
    "vbd": "VBD",
    "semi-implicit": "Semi-implicit",
    "steel-points": "Steel without anchors",
    "steel-matched": "Steel, warm start by matched contacts",
    "steel-frames": "Steel, contacts found every eighth step",
    "steel-substeps": "Steel, contacts found in each substep",
    "steel-iterations": "Steel, eight times the iterations",
    "steel-32-rows": "Steel, as many rows as it comes with",
}
SCENES = {
    "step of 2 ms": "2ms",
    "step of 1 ms": "1ms",
    "on a slope": "slope",
    "held still": "still",
}
OF_STEEL = "steel_stays slips_less anchors_help contacts_strain rows_overflow fails_sooner costs_more".split()


def derive(results: Results) -> Section:
    """Derive the section; of a release without Steel there is no shake."""
    rows = RowsBy(results, results.rows, "variant", "shake")
    times = RowsBy(results, results.rows, "variant", "worlds")
    bound = results.chosen(
        "ended_bound", "a tenth of a slip that can be seen", 0.1, "mm"
    )
    walk = results.chosen(
        "seen", "rounding of a place in single precision makes so much", 2e-3, "%/s"
    )
    seen = {
        "%/s": walk,
        "mm/s": results.chosen(
            "creep_seen", "a millimetre in a quarter of an hour", 1e-3, "mm/s"
        ),
    }
    names = [
        name
        for name in dict.fromkeys(variant for variant, _ in times)
        if name != "warp"
    ]
    # Over a frame in MuJoCo Warp with as many worlds.
    columns = {
        worlds_name(count): [times[name, count].frame_ratio for name in names]
        for count in TIMED_WORLDS
    }
    tables = {"boxes": _box_table(results, seen), "shakes": _shake_table(rows)}
    tables["times"] = table_of("solver", map(_label, names), columns)
    has_steel = ("steel", "3cm") in rows
    offered = Claim(
        "offered", decided(has_steel, results.row["mujoco-2ms"].growth_per_s)
    )
    as_far = results.chosen(
        "as_far", "a hand that goes farther off is shaken in another way", 10.0, "%"
    )
    hands = _hands(results, rows)
    claims = [
        offered,
        _others_hold(rows, times, hands, bound, as_far),
        _hands_go_as_far(rows, hands, as_far),
    ]
    claims.append(_slips_repeat(rows, bound))
    if not has_steel:
        return Section(tables=tables, claims=claims, unmeasured=OF_STEEL)
    warp, steel = (rows[name, "3cm"].slip_mm for name in ("warp", "steel"))
    slips_less = Claim(
        "slips_less", greater(warp, steel), {"warp": warp, "steel": steel}
    )
    claims += [_steel_stays(results, walk), slips_less, _anchors_help(rows)]
    claims += [
        _contacts_strain(results, rows),
        _rows_overflow(results, rows),
        _fails_sooner(rows),
        _costs_more(times),
    ]
    return Section(tables=tables, claims=claims)


def _label(name: str) -> str:
    return NAMES.get(name, name.capitalize())


def _box_table(results: Results, seen: Mapping[str, Quantity]) -> Table:
    """Make a line for each of Newton's solvers; one that is excused has the reason beside its name."""
    names = list(
        dict.fromkeys(row["solver"] for row in results.rows if "solver" in row)
    )
    excused = [row for row in results.rows if "of" in row and "solver" not in row]
    columns: dict[str, Column] = {
        above: [
            *(_of_box(results, name, end, seen) for name in names),
            *("" for _ in excused),
        ]
        for above, end in SCENES.items()
    }
    solvers = [
        *map(_label, names),
        *(f"{row['of']}: {row.plain['growth_per_s_reason']}" for row in excused),
    ]
    return table_of("solver", solvers, columns, walk=seen["%/s"], creep=seen["mm/s"])


def _of_box(
    results: Results, name: str, end: str, seen: Mapping[str, Quantity]
) -> Quantity | str:
    """Say how fast the box walks outward, or creeps where the table stands still, if it is seen to."""
    row, is_turning = results.row[f"{name}-{end}"], end.endswith("ms")
    cell = row["growth_per_s" if is_turning else "creep_mm_s"]
    if cell.value is not None and not row.stays:
        return "sinks in or lost"
    if is_turning:
        cell = results.value(
            f"{name}_{end}",
            "growth of the distance from the axis, in percent of it",
            PERCENT * cell,
        )
    return (
        cell
        if cell.value is None or abs(cell.value) >= seen[cell.unit].number
        else "not seen"
    )


def _steel_stays(results: Results, seen: Quantity) -> Claim:
    """Tell whether the box stays where it is on the turning table by the anchors of Steel's friction."""
    anchors, points, warp = (
        results.derived[f"{name}_2ms"] for name in ("steel", "steel-points", "mujoco")
    )
    size = results.value("anchors_size", "size of Steel's walk", abs(anchors))
    outcome = all_of(at_most(size, seen), at_least(points, seen), at_least(warp, seen))
    return Claim("steel_stays", outcome, {"points": points, "warp": warp})


def _shake_table(rows: RowsBy) -> Table:
    """Say what each solver does in the shake, and in others how far the cube slips, if it is kept."""
    names = list(dict.fromkeys(variant for variant, _ in rows))
    shaken = [rows[name, "3cm"] for name in names]
    columns: dict[str, Column] = {
        "hand goes": "hand_amplitude_mm",
        "slip": [_slip(row) for row in shaken],
    }
    columns |= {
        "on the way": [_slip(row, "wander_mm") for row in shaken],
        "creep": creep_or_unseen,
    }
    means = {
        "along over normal force": "friction_share",
        "normal force": "normal_force_n",
    }
    for above, mean in (means | {"penetration": "penetration_mm"}).items():
        columns[above] = [
            "lost" if row.plain.get("dropped") else row[mean] for row in shaken
        ]
    for above, shake in (
        ("with weight", "weight"),
        ("shaken 100 mm", "10cm"),
        ("held still", "held"),
    ):
        columns[above] = [_slip(rows[name, shake]) for name in names]
    return table_of(
        "solver",
        map(_label, names),
        columns,
        shaken,
        told=rows["warp", "3cm"].shake_amplitude_m,
    )


def _slip(row: Row, column: str = "slip_mm") -> Any:
    return "fails" if row.plain.get("failure") else cell_or_lost(row, column)


def _hands(results: Results, rows: RowsBy) -> dict[str, Value]:
    """Derive how much farther or less far than in MuJoCo Warp the hand goes in each solver that keeps the cube [%]."""
    mine, formula = (
        rows["warp", "3cm"].hand_amplitude_mm,
        "of how far the hand goes in MuJoCo Warp, off it",
    )
    held = {
        name: row
        for (name, shake), row in rows.items()
        if shake == "3cm" and name != "warp" and is_held(row)
    }
    cells = {name: row.hand_amplitude_mm for name, row in held.items()}
    return {
        name: results.value(f"{name}_hand", formula, departure(cell, mine))
        for name, cell in cells.items()
    }


def _others_hold(
    rows: RowsBy,
    times: RowsBy,
    hands: dict[str, Value],
    bound: Quantity,
    as_far: Quantity,
) -> Claim:
    """Tell which other solvers keep the slip below the bound in the same shake, with and without weight."""
    slips = {
        name: [rows[name, shake].slip_mm for shake in ("3cm", "weight")]
        for name in hands
    }
    below = {
        name: [at_most(slip, bound) for slip in cells] for name, cells in slips.items()
    }
    tests = {
        name: all_of(*below[name], at_most(hand, as_far))
        for name, hand in hands.items()
    }
    holding = [name for name, test in tests.items() if test == HOLDS]
    unclear = [test for test in tests.values() if test.is_inconclusive]
    read = [slip for name in holding or slips for slip in slips[name]]
    taken = {name: times[name, TIMED_WORLDS[0]].frame_ratio for name in holding}
    timed = {name: ratio for name, ratio in taken.items() if ratio.value is not None}
    fastest = min(timed, key=lambda name: timed[name].number, default="")
    names = [_label(name) for name in holding if "-" not in name]
    warp, ratio = (
        rows["warp", "3cm"].slip_mm,
        timed.get(fastest, absent("1", "none of them was timed")),
    )
    numbers = {
        "solvers": " and ".join(names),
        "fastest": _label(fastest),
        "bound": bound,
        "warp": warp,
    }
    outcome = unclear[0] if unclear and not holding else decided(bool(holding), *read)
    numbers |= {
        "is_timed": bool(fastest),
        "are_many": len(names) > 1,
        "ratio": ratio if fastest else "",
    }
    way = rows[fastest or "warp", "3cm"].wander_mm
    numbers |= {
        "is_longer": (ratio.value or 0.0) - 1.0 > (ratio.noise or 0.0),
        "way": way,
    }
    numbers["gives"] = bool(fastest) and at_least(way, bound) == HOLDS
    farther = at_least(warp, bound)
    farther = (
        Outcome("unknown", "in MuJoCo Warp it stays below that, too")
        if farther.name == "fails"
        else farther
    )
    return Claim(
        "others_hold",
        all_of(outcome, farther.having_read(warp)).having_read(ratio, way),
        numbers,
    )


def _hands_go_as_far(rows: RowsBy, hands: dict[str, Value], as_far: Quantity) -> Claim:
    """Tell whether the arm that is told the same goes as far in each solver that keeps the cube."""
    worst = max(hands, key=lambda name: hands[name].value or 0.0, default="warp")
    tests = [at_most(hand, as_far, why="another shake") for hand in hands.values()]
    outcome = (
        all_of(*tests) if tests else Outcome("unknown", "none of them keeps the cube")
    )
    far, mine = (rows[name, "3cm"].hand_amplitude_mm for name in (worst, "warp"))
    is_farther = None not in (far.value, mine.value) and far.value > mine.value
    numbers = {
        "worst": _label(worst),
        "far": far,
        "mine": mine,
        "is_farther": is_farther,
    }
    return Claim("hands_go_as_far", outcome.having_read(far, mine), numbers)


def _slips_repeat(rows: RowsBy, bound: Quantity) -> Claim:
    """Tell whether the cube slips as far in each that keeps it when it is measured again."""
    slips = [(name, row.slip_mm) for (name, _), row in rows.items() if is_held(row)]
    measured = [
        (name, slip, [each for each in slip.samples if each is not None])
        for name, slip in slips
    ]
    several = {
        (name, slip): max(samples) - min(samples)
        for name, slip, samples in measured
        if len(samples) > 1
    }
    names = dict.fromkeys(
        _label(name) for (name, _), apart in several.items() if apart > bound.number
    )
    outcome = (
        OPPOSITE
        if names
        else HOLDS
        if several
        else Outcome("unknown", "each was measured once")
    )
    read = outcome.having_read(*(slip for _, slip in several))
    return Claim(
        "slips_repeat", read, {"solvers": " and in ".join(names), "bound": bound}
    )


def _anchors_help(rows: RowsBy) -> Claim:
    """Tell whether friction that remembers where a contact began lets the cube slip less far, in either shake."""
    points, anchors = (
        [rows[name, shake] for shake in ("3cm", "10cm")]
        for name in ("steel-points", "steel")
    )
    outcome = all_of(
        *(greater(a.slip_mm, b.slip_mm) for a, b in zip(points, anchors, strict=True))
    )
    near, far = points
    return Claim(
        "anchors_help",
        outcome,
        {"near": near.slip_mm, "points": far.slip_mm, "wide": far.shake_amplitude_m},
    )


def _contacts_strain(results: Results, rows: RowsBy) -> Claim:
    """Tell whether contacts carry as much along themselves where nothing pulls at the cube."""
    shaken = results.value(
        "used_3cm",
        "of what friction allows",
        PERCENT * rows["steel", "3cm"].friction_share,
    )
    held = results.value(
        "used_held",
        "of what friction allows",
        PERCENT * rows["steel", "held"].friction_share,
    )
    strain = results.value(
        "strain",
        "the same with the arm held still, of that shaken",
        PERCENT * held / shaken,
    )
    return Claim(
        "contacts_strain",
        at_least(strain, 50.0, why="most of it"),
        {"shaken": shaken, "held": held},
    )


def _rows_overflow(results: Results, rows: RowsBy) -> Claim:
    """Tell whether as many rows as Steel comes with are too few for the arm and the cube, and enough are enough."""
    few, enough = rows["steel-32-rows", "3cm"], rows["steel", "3cm"]
    is_so, needed = (
        bool(few.failure) and not enough.failure,
        enough.peak_constraint_count,
    )
    given = results.chosen("rows_given", "given: as the solver comes with", 32)
    return Claim(
        "rows_overflow",
        all_of(decided(is_so, needed), at_least(needed, given)),
        {"needed": needed},
    )


def _fails_sooner(rows: RowsBy) -> Claim:
    """Tell whether in a wide shake Steel alone loses the cube; that MuJoCo Warp alone does is the opposite."""
    lost = {name: bool(rows[name, "10cm"].dropped) for name in ("warp", "steel")}
    cells = [rows[name, "10cm"].wander_mm for name in lost]
    outcome = (
        OPPOSITE
        if lost["warp"] and not lost["steel"]
        else decided(lost["steel"] and not lost["warp"], *cells)
    )
    numbers = {
        "wide": rows["steel", "10cm"].shake_amplitude_m,
        "are_lost": lost["steel"],
    }
    return Claim("fails_sooner", outcome.having_read(*cells), numbers)


def _costs_more(times: RowsBy) -> Claim:
    """Tell whether a frame takes longer in Steel, with one world and with the most."""
    alone, many = (
        times["steel", count] for count in (TIMED_WORLDS[0], TIMED_WORLDS[-1])
    )
    outcome = all_of(
        *(greater(row.frame_ratio, 1.0, why="as long") for row in (alone, many))
    )
    return Claim(
        "costs_more",
        outcome,
        {"alone": alone.frame_ratio, "many": many.frame_ratio, "worlds": many.worlds},
    )
