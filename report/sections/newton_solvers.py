"""Compare Newton's own solvers with MuJoCo Warp: the box on a table, and the shake."""

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
    Row,
    RowsBy,
    Section,
    Table,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
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

NAMES = {  # labels of variants; the others are labelled by their capitalized name
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
    "steel-32-rows": "Steel, its default number of rows",
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
    """Derive the section. Releases without Steel lack the claims about it."""
    rows = RowsBy(results, results.rows, "variant", "shake")
    times = RowsBy(results, results.rows, "variant", "worlds")
    why = "the rounding of positions in single precision causes this much"
    walk = results.chosen("seen", why, 2e-3, "%/s")
    timed = [
        name for name in dict.fromkeys(name for name, _ in times) if name != "warp"
    ]
    columns = {  # relative to a frame in MuJoCo Warp with the same number of worlds
        worlds_name(count): [times[name, count].frame_ratio for name in timed]
        for count in TIMED_WORLDS
    }
    for name in timed:
        ratio = times[name, TIMED_WORLDS[0]].frame_ratio
        results.value(
            f"{name}_speedup",
            "speed of one world, relative to MuJoCo Warp, timed in turn",
            1 / ratio,
        )
    tables = {
        "boxes": _box_table(results, walk),
        "shakes": _shake_table(rows),
        "times": table_of("solver", map(_label, timed), columns),
    }
    # A single run may be missing, so a release has Steel if any run used it.
    has_steel = any(row.plain.get("backend") == "steel" for row in results.rows)
    offered = decided(has_steel, results.row["mujoco-2ms"].growth_per_s)
    claims = [Claim("offered", offered), *_other_solver_claims(results, rows, times)]
    steel_claims = _steel_claims(results, rows, times, walk) if has_steel else []
    return Section(
        tables=tables,
        claims=claims + steel_claims,
        unmeasured=() if has_steel else STEEL_CLAIMS,
    )


def _label(name: str) -> str:
    return NAMES.get(name, name.capitalize())


def _box_table(results: Results, walk: Value) -> Table:
    """Make a table with one line per solver, or a reason if a solver cannot run.

    On the rotating table the box moves outward. On a table held still it may creep.
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
                "growth of the distance from the axis, relative to the distance",
                PERCENT * cell,
            )
        bound = walk if is_turning else creep
        is_measurable = cell.value is None or abs(cell.value) >= bound.number
        return cell if is_measurable else "not measurable"

    names = list(
        dict.fromkeys(row["solver"] for row in results.rows if "solver" in row)
    )
    excused = [row for row in results.rows if "of" in row and "solver" not in row]
    columns = {
        label: [cell_of(name, scene) for name in names] + [""] * len(excused)
        for label, scene in SCENES.items()
    }
    solvers = [_label(name) for name in names]
    solvers += [f"{row['of']}: {row.plain['growth_per_s_reason']}" for row in excused]
    return table_of("solver", solvers, columns, walk=walk, creep=creep)


def _shake_table(rows: RowsBy) -> Table:
    """Make a table of the cube's slips and the contact forces in each solver."""
    names = list(dict.fromkeys(variant for variant, _ in rows))
    shaken = [rows[name, "3cm"] for name in names]

    def cells(shake: str, column: str) -> list[Any]:
        return [_number_or_end(rows[name, shake], column) for name in names]

    columns = {
        "hand amplitude": "hand_amplitude_mm",
        "slip": cells("3cm", "slip_mm"),
        "largest displacement": cells("3cm", "wander_mm"),
        "creep": map(measurable_creep, shaken),
        "ratio of tangential to normal force": cells("3cm", "friction_share"),
        "normal force": cells("3cm", "normal_force_n"),
        "penetration": cells("3cm", "penetration_mm"),
        "slip with weight": cells("weight", "slip_mm"),
        "slip in a shake of 100 mm": cells("10cm", "slip_mm"),
        "slip with the arm held still": cells("held", "slip_mm"),
    }
    commanded = rows["warp", "3cm"].shake_amplitude_m
    return table_of("solver", map(_label, names), columns, shaken, told=commanded)


def _number_or_end(row: Row, column: str) -> Any:
    """Return a cell, or how the run ended if it did not keep the cube."""
    if row.plain.get("failure"):
        return "fails"
    return "lost" if row.plain.get("dropped") else row[column]


def _other_solver_claims(results: Results, rows: RowsBy, times: RowsBy) -> list[Claim]:
    """Test which other solvers keep the cube, and whether their hands move as far."""
    warp = rows["warp", "3cm"]
    slip = warp.slip_mm
    amplitude = warp.hand_amplitude_mm
    bound = results.chosen(
        "ended_bound", "a tenth of a slip that can be seen", 0.1, "mm"
    )
    as_far = results.chosen(
        "as_far", "with a larger difference the hand makes another motion", 10.0, "%"
    )
    hands = {
        name: results.value(
            f"{name}_hand",
            "absolute difference between the amplitude of the hand and its amplitude in MuJoCo"
            " Warp, relative to the latter",
            departure(row.hand_amplitude_mm, amplitude),
        )
        for (name, shake), row in rows.items()
        if shake == "3cm" and name != "warp" and is_held(row)
    }

    # A solver holds the cube if the slip is small with and without weight, and if the
    # hand moves as far as in MuJoCo Warp.
    slips = {
        name: [rows[name, shake].slip_mm for shake in ("3cm", "weight")]
        for name in hands
    }
    tests = {
        name: all_of(
            *(at_most(slip, bound) for slip in slips[name]), at_most(hand, as_far)
        )
        for name, hand in hands.items()
    }
    holding = [name for name, test in tests.items() if test == HOLDS]
    unclear = [test for test in tests.values() if test.is_inconclusive]
    if unclear and not holding:
        hold = unclear[0]
    else:
        cells = (slip for name in holding or slips for slip in slips[name])
        hold = decided(bool(holding), *cells)
    farther = at_least(slip, bound)
    if farther.name == "fails":
        farther = Outcome(
            "unknown", "in MuJoCo Warp the slip stays below the bound as well"
        )
    ratios = {name: times[name, TIMED_WORLDS[0]].frame_ratio for name in holding}
    ratios = {name: ratio for name, ratio in ratios.items() if ratio.value is not None}
    fastest = min(ratios, key=lambda name: ratios[name].number, default="")
    ratio = ratios.get(fastest, absent("1", "no such solver was timed"))
    speedup = results.derived.get(f"{fastest}_speedup", ratio)
    wander = rows[fastest or "warp", "3cm"].wander_mm
    names = [_label(name) for name in holding if "-" not in name]
    others_hold = Claim(
        "others_hold",
        all_of(hold, farther.having_read(slip)).having_read(ratio, speedup, wander),
        {
            "solvers": " and ".join(names),
            "fastest": _label(fastest),
            "bound": bound,
            "warp": slip,
            "is_timed": bool(fastest),
            "ratio": ratio if fastest else "",
            "faster": speedup if greater(1.0, ratio, "as long") == HOLDS else "",
            "way": wander,
            "gives": bool(fastest) and at_least(wander, bound) == HOLDS,
        },
    )

    worst = max(hands, key=lambda name: hands[name].value or 0.0, default="warp")
    far = rows[worst, "3cm"].hand_amplitude_mm
    alike = Outcome("unknown", "no other solver keeps the cube")
    if hands:
        alike = all_of(
            *(at_most(hand, as_far, "another shake") for hand in hands.values())
        )
    is_farther = None not in (far.value, amplitude.value)
    is_farther = is_farther and far.value > amplitude.value
    hands_go_as_far = Claim(
        "hands_go_as_far",
        alike.having_read(far, amplitude),
        {
            "worst": _label(worst),
            "far": far,
            "mine": amplitude,
            "is_farther": is_farther,
        },
    )

    # Test whether repeated measurements give the same slip.
    repeated = []
    unlike = {}
    for (name, _), row in rows.items():
        samples = [sample for sample in row.slip_mm.samples if sample is not None]
        if is_held(row) and len(samples) > 1:
            repeated.append(row.slip_mm)
            if max(samples) - min(samples) > bound.number:
                unlike[_label(name)] = True
    repeat = OPPOSITE if unlike else HOLDS
    if not repeated:
        repeat = Outcome("unknown", "each slip was measured once")
    slips_repeat = Claim(
        "slips_repeat",
        repeat.having_read(*repeated),
        {"solvers": " and in ".join(unlike), "bound": bound},
    )
    return [others_hold, hands_go_as_far, slips_repeat]


def _steel_claims(
    results: Results, rows: RowsBy, times: RowsBy, walk: Value
) -> list[Claim]:
    near, far, held = (rows["steel", shake] for shake in ("3cm", "10cm", "held"))
    warp = rows["warp", "3cm"]
    warp_far = rows["warp", "10cm"]
    points = rows["steel-points", "3cm"]
    points_far = rows["steel-points", "10cm"]

    # The anchors of Steel's friction keep the box in place on the rotating table.
    anchors, pointed, plain = (
        results.derived[f"{name}_2ms"] for name in ("steel", "steel-points", "mujoco")
    )
    size = results.value("anchors_size", "absolute growth in Steel", abs(anchors))
    stays = all_of(at_most(size, walk), at_least(pointed, walk), at_least(plain, walk))
    helps = all_of(
        greater(points.slip_mm, near.slip_mm), greater(points_far.slip_mm, far.slip_mm)
    )

    # Test whether contacts carry tangential force although no load acts on the cube.
    used, used_held = (
        results.value(
            f"used_{shake}",
            "share of the available friction",
            PERCENT * row.friction_share,
        )
        for shake, row in (("3cm", near), ("held", held))
    )
    strain = results.value(
        "strain",
        "the share with the arm held still, relative to the share in the shake",
        PERCENT * used_held / used,
    )

    few = rows["steel-32-rows", "3cm"]
    needed = near.peak_constraint_count
    overflow = decided(
        bool(few.failure) and not near.failure, needed, few.peak_constraint_count
    )

    # If only MuJoCo Warp loses the cube, the opposite holds.
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
        *(greater(row.frame_ratio, 1.0, why="the same time") for row in (alone, many))
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
            all_of(overflow, at_least(needed, 32, "the default of the solver")),
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
