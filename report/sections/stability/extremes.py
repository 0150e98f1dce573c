"""Claims of section stability about loads, sizes, masses, bad starts, long runs and small buffers."""

from collections.abc import Sequence

from markupsafe import Markup

from experiments.facts.case import AS_SHIPPED
from measured_report.claims.claims import (
    HOLDS,
    Claim,
    Outcome,
    all_of,
    at_least,
    at_most,
    contiguous,
    decided,
    greater,
    increases,
    within,
)
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import cases_html
from report.sections.stability.classes import CLASSES, is_stable
from report.sections.stability.families import count, family, family_claim
from report.sections.stability.passing import ENERGY_LARGEST, GROWTH_LARGEST, passed
from report.shared.arithmetic import cell_or_absent, extreme, share

MU = {"shake": 0.0187, "grip": 0.1}
"""Friction coefficient of the pads in runs that are shaken harder, and gripped less, until the cube is lost."""
GRIP_LEAST_N = 0.1
"""Grips that differ by no more than that are the same."""
MASS_DRIFT_RATIO = 2.0
SINK_LEAST_MM = 0.1
"""A hand that comes down by no more than that has not come down."""


def crossover(results: Results, name: str, margin: Value) -> Claim:
    rows = [row for row in family(results, name) if row.load.value is not None]
    kept = extreme(results, f"{name}_kept", "largest load that holds", max, [r.load for r in rows if is_stable(r)])
    lost = extreme(
        results, f"{name}_lost", "least load that drops", min, [r.load for r in rows if r["class"] == "dropped"]
    )
    over = {
        kind: results.value(f"{name}_{kind}_over", f"{load.formula}, over the limit", _over, load, unit="%")
        for kind, load in (("kept", kept), ("lost", lost))
    }
    mu = results.value(f"{name}_mu", "given: friction coefficient of the pads", lambda: MU[name])
    return family_claim(
        results,
        f"{name}_crossover",
        family(results, name),
        also=decided(True, kept, lost),
        numbers=over | {"mu": mu, "margin": margin},
    )


def _over(load: float) -> float:
    """How far a share of the limit is over it, in percent; negative below it."""
    return 100.0 * (load - 1.0)


def friction(results: Results) -> Claim:
    rows = family(results, "friction")
    kept = extreme(results, "friction_kept", "least μ that holds", min, [row.pad_mu for row in rows if is_stable(row)])
    most = extreme(
        results, "friction_most", "largest μ that holds", max, [row.pad_mu for row in rows if is_stable(row)]
    )
    return family_claim(
        results,
        "friction_extremes",
        rows,
        also=_unbroken(sorted(rows, key=lambda row: row.pad_mu.value), kept, most),
        numbers={"kept": kept, "most": most},
    )


def _unbroken(rows: list[Row], *ends: Value) -> Outcome:
    """Whether those that hold stand together in the order given."""
    return contiguous([is_stable(row) for row in rows], *ends)


def _by_mass(results: Results) -> list[Row]:
    return sorted(family(results, "mass"), key=lambda row: row.cube_mass_kg.value)


def mass(results: Results) -> Claim:
    rows = _by_mass(results)
    held = [row for row in rows if is_stable(row)]
    light = extreme(results, "mass_least", "least mass that is held", min, [row.cube_mass_kg for row in held])
    heavy = extreme(results, "mass_most", "largest mass that is held", max, [row.cube_mass_kg for row in held])
    return family_claim(
        results, "masses", rows, also=_unbroken(rows, light, heavy), numbers={"light": light, "heavy": heavy}
    )


def mass_grip(results: Results) -> Claim:
    grips = [row.grip_force_n for row in _by_mass(results)] or [absent("N", "it was not measured")]
    same = results.chosen("mass_grip_bound", "the same grip", GRIP_LEAST_N, unit="N")
    return Claim("mass_grip", increases(grips, noise=same), {"least": grips[0], "most": grips[-1]})


def mass_drift(results: Results) -> Claim:
    held = [row for row in _by_mass(results) if is_stable(row)]
    drifts = [row.drift_mm_s for row in held]
    formula = "drift of masses that are held, in size"
    low = extreme(results, "mass_drift_least", f"least {formula}", lambda *found: min(map(abs, found)), drifts)
    high = extreme(results, "mass_drift_most", f"largest {formula}", lambda *found: max(map(abs, found)), drifts)
    bound = results.chosen("mass_drift_bound", "alike", MASS_DRIFT_RATIO)
    least = results.value(
        "mass_drift_allowed", "the largest drift over that bound", lambda a, b: a / b, high, bound, unit="mm/s"
    )
    is_one_way = len({drift.value > 0 for drift in drifts if drift.value is not None}) == 1
    outcome = all_of(at_least(low, least), decided(is_one_way, *drifts))
    return Claim("mass_drift", outcome, numbers={"low": low, "high": high, "bound": bound})


def mass_sink(results: Results) -> Claim:
    rows = _by_mass(results)
    sinks = _sinks(rows)
    sink = extreme(results, "mass_sink", "largest sink of the hand", max, sinks)
    noise = results.chosen("mass_sink_bound", "no sinking", SINK_LEAST_MM, unit="mm")
    heavy = rows[-1].cube_mass_kg if rows else absent("kg", "it was not measured")
    return Claim("mass_sink", increases(sinks, noise=noise), numbers={"sink": sink, "heavy": heavy})


def _sinks(rows: Sequence[Row]) -> list[Quantity]:
    return [cell_or_absent(row, "hand_sink_mm", "mm") for row in rows]


def size(results: Results, bound: Value) -> Claim:
    rows = family(results, "size")
    edges = {grip: [row.cube_edge_mm for row in passed(rows) if row.grip == grip] for grip in ("as-shipped", "scaled")}
    shipped = extreme(results, "size_shipped", "least edge that passes, grip as shipped", min, edges["as-shipped"])
    scaled = extreme(results, "size_scaled", "least edge that passes, grip scaled", min, edges["scaled"])
    least = {"as-shipped": shipped.value, "scaled": scaled.value}
    small_ones_fail = None not in least.values() and all(
        row.cube_edge_mm.value < least[row.grip] for row in rows if row not in passed(rows)
    )
    return family_claim(
        results,
        "sizes",
        rows,
        numbers={"bound": bound, "shipped": shipped, "scaled": scaled, "small_ones_fail": small_ones_fail},
    )


def overlap(results: Results) -> Claim:
    rows = family(results, "overlap")
    shares = [
        share(
            results,
            f"exit_share_{row.case}",
            "exit speed over that of an undamped spring",
            row.exit_speed_mm_s,
            row.exit_bound_mm_s,
        )
        for row in rows
    ]
    most = extreme(results, "exit_share_most", "largest share", max, shares)
    extreme(results, "exit_fastest", "largest exit speed", max, [row.exit_speed_mm_s for row in rows])
    whole = results.chosen("exit_share_bound", "no faster than an undamped spring", 100.0, unit="%")
    deepest = extreme(results, "overlap_deepest", "deepest start", max, [row.overlap_mm for row in rows])
    return family_claim(
        results, "overlaps", rows, also=at_most(most, whole), numbers={"deepest": deepest, "most": most}
    )


def gravity(results: Results) -> Claim:
    rows = [row for row in family(results, "gravity") if not row.freed]
    lost = [row for row in rows if not is_stable(row)]
    tried = Markup(", ").join(row.gravity_m_s2.bare for row in rows)
    text = Markup(", ").join(Markup("{} ({})").format(row.gravity_m_s2, row["class"]) for row in lost)
    return family_claim(results, "gravities", rows, numbers={"tried": tried, "lost": text})


def arm_gives_way(results: Results) -> Claim:
    """Whether the hand sinks farther where gravity takes the cube than with any cube that is held, though friction
    could carry it."""
    rows = [*(row for row in family(results, "gravity") if not row.freed), *family(results, "mass")]
    lost = [row for row in rows if row.family == "gravity" and not is_stable(row)]
    sink = extreme(results, "gravity_sink", "least sink of the hand where gravity takes the cube", min, _sinks(lost))
    held = [row for row in rows if is_stable(row)]
    most = extreme(results, "held_sink", "largest sink of the hand where a cube is held", max, _sinks(held))
    needed = "largest share of the friction that is needed there"
    load = results.value("gravity_load", needed, lambda *share: 100 * max(share), *(row.load for row in lost), unit="%")
    ample = results.chosen("gravity_load_bound", "friction to spare", 50.0, unit="%")
    outcome = all_of(greater(sink, most, noise=results.derived["mass_sink_bound"]), at_most(load, ample))
    if not lost:
        outcome = Outcome("unknown", "no gravity that was tried takes the cube")
    return Claim("arm_gives_way", outcome, numbers={"sink": sink, "load": load})


def freed(results: Results) -> Claim:
    rows = [row for row in family(results, "gravity") if row.freed]
    growth = extreme(
        results,
        "energy_growth_most",
        "largest ratio of the energies",
        max,
        [cell_or_absent(row, "energy_growth", "1") for row in rows],
    )
    bound = results.chosen("energy_growth_bound", "no energy gained", ENERGY_LARGEST)
    at_rest = [row.case for row in passed(rows) if row.energy_growth.value is None]
    return family_claim(
        results,
        "freed_cube",
        rows,
        also=at_most(growth, bound),
        numbers={"growth": growth, "at_rest": cases_html(at_rest) if at_rest else ""},
    )


def long(results: Results) -> Claim:
    rows = family(results, "long")
    cells, ends = _long_cells(results), rows[0]["class"] if rows else ""
    largest = results.chosen("long_growth_bound", "hardly more", GROWTH_LARGEST)
    allowed = results.value(
        "long_creep_allowed",
        "creep per cycle in the first tenth times that bound",
        lambda first, bound: first * bound,
        cells["first"],
        largest,
        unit="mm/cycle",
    )
    is_lost = any(not is_stable(row) for row in rows)
    return family_claim(
        results,
        "long_run",
        rows,
        also=HOLDS if is_lost else at_most(cells["last"], allowed),
        numbers={**cells, "ends": ends, "is_lost": is_lost, "bound": largest},
    )


def _long_cells(results: Results) -> dict[str, Quantity]:
    rows = family(results, "long")
    columns = {"duration": "shake_duration_s", "first": "increment_first_mm_per_cycle"}
    columns |= {"last": "increment_last_mm_per_cycle", "slip": "slip_mm"}
    return {name: cell_or_absent(rows[0] if rows else None, column, "1") for name, column in columns.items()}


def long_adds_up(results: Results) -> Claim:
    """Whether the cube creeps all the time: as far as by the mean of its first and its last creep."""
    cells = _long_cells(results)
    found = results.value(
        "long_slip_share",
        "slip over the mean of the creep per cycle in the first and in the last tenth, times the cycles",
        lambda slip, first, last, seconds: (
            100 * slip / (0.5 * (first + last) * seconds * AS_SHIPPED.shake_frequency_hz)
        ),
        *(cells[name] for name in ("slip", "first", "last", "duration")),
        unit="%",
    )
    low = results.chosen("long_slip_least", "about as far as that", 90.0, unit="%")
    high = results.chosen("long_slip_most", "about as far as that", 110.0, unit="%")
    numbers = {"duration": cells["duration"], "slip": cells["slip"], "share": found}
    return Claim("long_adds_up", all_of(at_least(found, low), at_most(found, high)), numbers=numbers)


def buffers(results: Results) -> Claim:
    """Whether every buffer that is too small is named, and those are that hold less than the grasp was seen to need."""
    rows = family(results, "buffers")
    ample = results.row.get("buffers-ample")
    columns = {"contacts": "peak_contact_count", "constraints": "peak_constraint_count"}
    peaks = {name: cell_or_absent(ample, column, "1") for name, column in columns.items()}
    small = {
        name: extreme(
            results,
            f"{name}_too_few",
            f"largest buffer of {name} that was too small",
            max,
            [row[column] for row in rows if row["class"] == "overflow" and f"-{name[:-1]}-" in row.case],
        )
        for name, column in (("contacts", "contact_max"), ("constraints", "constraint_max"))
    }
    room = [cell_or_absent(ample, column, "1") for column in ("contact_max", "constraint_max")]
    fits = [at_most(peak, most) for peak, most in zip(peaks.values(), room, strict=True)]
    needed = [at_least(peaks[name], small[name]) for name in peaks]
    return family_claim(results, "buffers", rows, also=all_of(*fits, *needed), numbers=peaks)


def neighbours(results: Results) -> Claim:
    alone, batch = results.row.get("buffers-ample"), results.row.get("steps-stiff-16")
    if not alone or not batch:
        difference = floor = absent("mm/s", "it was not measured")
    else:
        difference = results.value(
            "neighbour_difference",
            "difference in creep of the same case alone and among worlds that fail",
            lambda a, b: abs(a - b),
            alone.creep_mm_s,
            batch.creep_mm_s,
            unit="mm/s",
        )
        floor = batch.creep_floor_mm_s
    return Claim("neighbours_unharmed", within(difference, floor), numbers={"difference": difference, "floor": floor})


def repeats_agree(results: Results) -> Claim:
    rows = [row for row in results.rows if (row.repeat_count.value or 0) > 1]
    split = [row for row in rows if len(set(row["classes"].split(", ")) & set(CLASSES)) > 1]
    split_count = count(results, "split_count", "cases whose repeats end in different classes", split)
    none = results.chosen("split_bound", "none", 0)
    repeats = extreme(results, "repeats_least", "least number of repeats", min, [row.repeat_count for row in rows])
    total = count(results, "repeated_count", "cases with repeats", rows)
    return Claim(
        "repeats_agree",
        at_most(split_count, none) if rows else Outcome("unknown", "no case was repeated"),
        numbers={"total": total, "repeats": repeats, "split": split_count},
    )
