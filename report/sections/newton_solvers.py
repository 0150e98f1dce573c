"""Newton's own solvers beside MuJoCo Warp: the box on a table, and the shake itself."""

from typing import Any

from report.shared import (
    HOLDS,
    OPPOSITE,
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Outcome,
    Quantity,
    Results,
    RowsBy,
    Section,
    Table,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    cell_or_lost,
    decided,
    departure,
    greater,
    is_held,
    measurable_creep,
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
STEEL_CLAIMS = (
    "steel_stays",
    "slips_less",
    "anchors_help",
    "contacts_strain",
    "rows_overflow",
    "fails_sooner",
    "costs_more",
)
SCENES = {
    "step of 2 ms": "2ms",
    "step of 1 ms": "1ms",
    "on a slope": "slope",
    "held still": "still",
}


def derive(results: Results) -> Section:
    """Derive the section; in a release without Steel nothing was shaken."""
    rows = RowsBy(results, results.rows, "variant", "shake")
    times = RowsBy(results, results.rows, "variant", "worlds")
    why = "rounding of a place in single precision makes so much"
    walk = results.chosen("seen", why, 2e-3, "%/s")
    timed = [
        name for name in dict.fromkeys(name for name, _ in times) if name != "warp"
    ]
    columns = {  # over a frame in MuJoCo Warp with as many worlds
        worlds_name(count): [times[name, count].frame_ratio for name in timed]
        for count in TIMED_WORLDS
    }
    for name in timed:
        ratio = times[name, TIMED_WORLDS[0]].frame_ratio
        results.value(
            f"{name}_speedup",
            "speed of one world, of that in MuJoCo Warp, timed in turn",
            1 / ratio,
        )
    tables = {
        "boxes": _box_table(results, walk),
        "shakes": _shake_table(rows),
        "times": table_of("solver", map(_label, timed), columns),
    }
    has_steel = ("steel", "3cm") in rows
    offered = decided(has_steel, results.row["mujoco-2ms"].growth_per_s)
    claims = [Claim("offered", offered), *_of_others(results, rows, times)]
    steel_claims = _of_steel(results, rows, times, walk) if has_steel else []
    return Section(
        tables=tables,
        claims=claims + steel_claims,
        unmeasured=() if has_steel else STEEL_CLAIMS,
    )


def _label(name: str) -> str:
    return NAMES.get(name, name.capitalize())


def _box_table(results: Results, walk: Value) -> Table:
    """Make a line for each solver; one that is excused has a reason beside its name.

    A box walks outward, or creeps where the table stands still.
    """
    why = "a millimetre in a quarter of an hour"
    creep = results.chosen("creep_seen", why, 1e-3, "mm/s")

    def cell_of(name: str, scene: str) -> Quantity | str:
        row = results.row[f"{name}-{scene}"]
        is_turning = scene.endswith("ms")
        cell = row["growth_per_s" if is_turning else "creep_mm_s"]
        if cell.value is not None and not row.stays:
            return "sinks in or lost"
        if is_turning:
            cell = results.value(
                f"{name}_{scene}",
                "growth of the distance from the axis, in percent of it",
                PERCENT * cell,
            )
        least = walk if is_turning else creep
        is_seen = cell.value is None or abs(cell.value) >= least.number
        return cell if is_seen else "not measurable"

    names = list(
        dict.fromkeys(row["solver"] for row in results.rows if "solver" in row)
    )
    excused = [row for row in results.rows if "of" in row and "solver" not in row]
    columns = {
        above: [cell_of(name, scene) for name in names] + [""] * len(excused)
        for above, scene in SCENES.items()
    }
    solvers = [_label(name) for name in names]
    solvers += [f"{row['of']}: {row.plain['growth_per_s_reason']}" for row in excused]
    return table_of("solver", solvers, columns, walk=walk, creep=creep)


def _shake_table(rows: RowsBy) -> Table:
    """Say what each solver does in the shakes, and how far the cube slips."""
    names = list(dict.fromkeys(variant for variant, _ in rows))
    shaken = [rows[name, "3cm"] for name in names]

    def means(column: str) -> list[Any]:
        return ["lost" if row.plain.get("dropped") else row[column] for row in shaken]

    def slips(shake: str, column: str = "slip_mm") -> list[Any]:
        return [
            "fails" if row.plain.get("failure") else cell_or_lost(row, column)
            for row in (rows[name, shake] for name in names)
        ]

    columns = {
        "hand goes": "hand_amplitude_mm",
        "slip": slips("3cm"),
        "on the way": slips("3cm", "wander_mm"),
        "creep": map(measurable_creep, shaken),
        "along over normal force": means("friction_share"),
        "normal force": means("normal_force_n"),
        "penetration": means("penetration_mm"),
        "with weight": slips("weight"),
        "shaken 100 mm": slips("10cm"),
        "held still": slips("held"),
    }
    told = rows["warp", "3cm"].shake_amplitude_m
    return table_of("solver", map(_label, names), columns, shaken, told=told)


def _of_others(results: Results, rows: RowsBy, times: RowsBy) -> list[Claim]:
    """Tell which other solvers keep the cube, and whether they shake it alike."""
    warp = rows["warp", "3cm"]
    slip = warp.slip_mm
    mine = warp.hand_amplitude_mm
    bound = results.chosen(
        "ended_bound", "a tenth of a slip that can be seen", 0.1, "mm"
    )
    as_far = results.chosen(
        "as_far", "a hand that goes farther off is shaken in another way", 10.0, "%"
    )
    hands = {
        name: results.value(
            f"{name}_hand",
            "of how far the hand goes in MuJoCo Warp, off it",
            departure(row.hand_amplitude_mm, mine),
        )
        for (name, shake), row in rows.items()
        if shake == "3cm" and name != "warp" and is_held(row)
    }

    # A solver holds the cube with and without weight, in the same shake.
    slips = {
        name: [rows[name, shake].slip_mm for shake in ("3cm", "weight")]
        for name in hands
    }
    tests = {
        name: all_of(
            *(at_most(each, bound) for each in slips[name]), at_most(hand, as_far)
        )
        for name, hand in hands.items()
    }
    holding = [name for name, test in tests.items() if test == HOLDS]
    unclear = [test for test in tests.values() if test.is_inconclusive]
    if unclear and not holding:
        hold = unclear[0]
    else:
        read = (each for name in holding or slips for each in slips[name])
        hold = decided(bool(holding), *read)
    farther = at_least(slip, bound)
    if farther.name == "fails":
        farther = Outcome("unknown", "in MuJoCo Warp it stays below that, too")
    ratios = {name: times[name, TIMED_WORLDS[0]].frame_ratio for name in holding}
    ratios = {name: ratio for name, ratio in ratios.items() if ratio.value is not None}
    fastest = min(ratios, key=lambda name: ratios[name].number, default="")
    ratio = ratios.get(fastest, absent("1", "none of them was timed"))
    speedup = results.derived.get(f"{fastest}_speedup", ratio)
    way = rows[fastest or "warp", "3cm"].wander_mm
    names = [_label(name) for name in holding if "-" not in name]
    others_hold = Claim(
        "others_hold",
        all_of(hold, farther.having_read(slip)).having_read(ratio, speedup, way),
        {
            "solvers": " and ".join(names),
            "fastest": _label(fastest),
            "bound": bound,
            "warp": slip,
            "is_timed": bool(fastest),
            "are_many": len(names) > 1,
            "ratio": ratio if fastest else "",
            "faster": speedup if greater(1.0, ratio, "as long") == HOLDS else "",
            "way": way,
            "gives": bool(fastest) and at_least(way, bound) == HOLDS,
        },
    )

    worst = max(hands, key=lambda name: hands[name].value or 0.0, default="warp")
    far = rows[worst, "3cm"].hand_amplitude_mm
    alike = Outcome("unknown", "none of them keeps the cube")
    if hands:
        alike = all_of(
            *(at_most(hand, as_far, "another shake") for hand in hands.values())
        )
    is_farther = None not in (far.value, mine.value) and far.value > mine.value
    hands_go_as_far = Claim(
        "hands_go_as_far",
        alike.having_read(far, mine),
        {"worst": _label(worst), "far": far, "mine": mine, "is_farther": is_farther},
    )

    # Whether a slip repeats when it is measured again.
    several = []
    unlike = {}
    for (name, _), row in rows.items():
        samples = [each for each in row.slip_mm.samples if each is not None]
        if is_held(row) and len(samples) > 1:
            several.append(row.slip_mm)
            if max(samples) - min(samples) > bound.number:
                unlike[_label(name)] = True
    repeat = OPPOSITE if unlike else HOLDS
    if not several:
        repeat = Outcome("unknown", "each was measured once")
    slips_repeat = Claim(
        "slips_repeat",
        repeat.having_read(*several),
        {"solvers": " and in ".join(unlike), "bound": bound},
    )
    return [others_hold, hands_go_as_far, slips_repeat]


def _of_steel(
    results: Results, rows: RowsBy, times: RowsBy, walk: Value
) -> list[Claim]:
    near, far, held = (rows["steel", shake] for shake in ("3cm", "10cm", "held"))
    warp = rows["warp", "3cm"]
    warp_far = rows["warp", "10cm"]
    points = rows["steel-points", "3cm"]
    points_far = rows["steel-points", "10cm"]

    # By the anchors of Steel's friction the box stays where it is on the table.
    anchors, pointed, plain = (
        results.derived[f"{name}_2ms"] for name in ("steel", "steel-points", "mujoco")
    )
    size = results.value("anchors_size", "size of Steel's walk", abs(anchors))
    stays = all_of(at_most(size, walk), at_least(pointed, walk), at_least(plain, walk))
    helps = all_of(
        greater(points.slip_mm, near.slip_mm), greater(points_far.slip_mm, far.slip_mm)
    )

    # Whether contacts carry as much along themselves where nothing pulls at the cube.
    used, used_held = (
        results.value(
            f"used_{shake}", "of what friction allows", PERCENT * row.friction_share
        )
        for shake, row in (("3cm", near), ("held", held))
    )
    strain = results.value(
        "strain",
        "the same with the arm held still, of that shaken",
        PERCENT * used_held / used,
    )

    few = rows["steel-32-rows", "3cm"]
    needed = near.peak_constraint_count
    given = results.chosen("rows_given", "given: as the solver comes with", 32)
    overflow = decided(bool(few.failure) and not near.failure, needed)

    # That MuJoCo Warp alone loses the cube is the opposite.
    is_lost = bool(far.dropped)
    is_lost_in_warp = bool(warp_far.dropped)
    sooner = decided(is_lost and not is_lost_in_warp, warp_far.wander_mm, far.wander_mm)
    if None in (far.plain.get("dropped"), warp_far.plain.get("dropped")):
        sooner = Outcome("unknown", "one of these runs failed, or was not measured")
        sooner = sooner.having_read(warp_far.wander_mm, far.wander_mm)
    elif is_lost_in_warp and not is_lost:
        sooner = OPPOSITE.having_read(warp_far.wander_mm, far.wander_mm)

    alone = times["steel", TIMED_WORLDS[0]]
    many = times["steel", TIMED_WORLDS[-1]]
    costs = all_of(
        *(greater(row.frame_ratio, 1.0, why="as long") for row in (alone, many))
    )
    return [
        Claim("steel_stays", stays, {"points": pointed, "warp": plain}),
        Claim(
            "slips_less",
            greater(warp.slip_mm, near.slip_mm),
            {"warp": warp.slip_mm, "steel": near.slip_mm},
        ),
        Claim(
            "anchors_help",
            helps,
            {
                "near": points.slip_mm,
                "points": points_far.slip_mm,
                "wide": points_far.shake_amplitude_m,
            },
        ),
        Claim(
            "contacts_strain",
            at_least(strain, 50.0, "most of it"),
            {"shaken": used, "held": used_held},
        ),
        Claim(
            "rows_overflow",
            all_of(overflow, at_least(needed, given)),
            {"needed": needed},
        ),
        Claim(
            "fails_sooner", sooner, {"wide": far.shake_amplitude_m, "are_lost": is_lost}
        ),
        Claim(
            "costs_more",
            costs,
            {
                "alone": alone.frame_ratio,
                "many": many.frame_ratio,
                "worlds": many.worlds,
            },
        ),
    ]
