"""Claims of section stability about loads, sizes, masses, bad starts, long runs and small buffers."""

from markupsafe import Markup

from report.claims import Claim, Outcome, at_most, within
from report.deriving.arithmetic import cell_or_absent, extreme, share
from report.names import cases_html
from report.quantities import Value, absent
from report.results import Results
from report.sections.stability.classes import CLASSES, is_stable
from report.sections.stability.families import count, family, family_claim
from report.sections.stability.passing import passed


def crossover(results: Results, name: str) -> Claim:
    rows = [row for row in family(results, name) if row.load.value is not None]
    kept = extreme(results, f"{name}_kept", "largest load that holds", max, [r.load for r in rows if is_stable(r)])
    lost = extreme(
        results, f"{name}_lost", "least load that drops", min, [r.load for r in rows if r["class"] == "dropped"]
    )
    one_sided = None in (kept.value, lost.value)
    return family_claim(
        results,
        f"{name}_crossover",
        family(results, name),
        outcome=Outcome("unknown", "not both sides of the limit were reached") if one_sided else None,
        numbers={"kept": kept, "lost": lost},
    )


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
        numbers={"kept": kept, "most": most},
    )


def mass(results: Results) -> Claim:
    rows = family(results, "mass")
    held = [row for row in rows if is_stable(row)]
    light = extreme(results, "mass_least", "least mass that is held", min, [row.cube_mass_kg for row in held])
    heavy = extreme(results, "mass_most", "largest mass that is held", max, [row.cube_mass_kg for row in held])
    low = extreme(results, "mass_drift_least", "least drift of them", min, [row.drift_mm_s for row in held])
    high = extreme(results, "mass_drift_most", "largest drift of them", max, [row.drift_mm_s for row in held])
    sink = extreme(
        results,
        "mass_sink",
        "largest sink of the hand",
        max,
        [cell_or_absent(row, "hand_sink_mm", "mm") for row in rows],
    )
    return family_claim(
        results,
        "masses",
        rows,
        numbers={"light": light, "heavy": heavy, "low": low, "high": high, "sink": sink},
    )


def size(results: Results, bound: Value) -> Claim:
    rows = family(results, "size")
    edges = {grip: [row.cube_edge_mm for row in passed(rows) if row.grip == grip] for grip in ("as-shipped", "scaled")}
    shipped = extreme(results, "size_shipped", "least edge that passes, grip as shipped", min, edges["as-shipped"])
    scaled = extreme(results, "size_scaled", "least edge that passes, grip scaled", min, edges["scaled"])
    return family_claim(
        results,
        "sizes",
        rows,
        numbers={"bound": bound, "shipped": shipped, "scaled": scaled},
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
    fastest = extreme(results, "exit_fastest", "largest exit speed", max, [row.exit_speed_mm_s for row in rows])
    deepest = extreme(results, "overlap_deepest", "deepest start", max, [row.overlap_mm for row in rows])
    return family_claim(
        results,
        "overlaps",
        rows,
        numbers={"deepest": deepest, "most": most, "fastest": fastest},
    )


def gravity(results: Results) -> Claim:
    rows = [row for row in family(results, "gravity") if not row.freed]
    lost = [row for row in rows if not is_stable(row)]
    sink = extreme(
        results,
        "gravity_sink",
        "sink of the hand where the cube is lost",
        max,
        [cell_or_absent(row, "hand_sink_mm", "mm") for row in lost],
    )
    text = Markup(", ").join(Markup("{} ({})").format(row.gravity_m_s2, row["class"]) for row in lost)
    return family_claim(
        results,
        "gravities",
        rows,
        numbers={"lost": text, "sink": sink},
    )


def freed(results: Results) -> Claim:
    rows = [row for row in family(results, "gravity") if row.freed]
    growth = extreme(
        results,
        "energy_growth_most",
        "largest ratio of the energies",
        max,
        [cell_or_absent(row, "energy_growth", "1") for row in rows],
    )
    at_rest = [row.case for row in passed(rows) if row.energy_growth.value is None]
    return family_claim(
        results,
        "freed_cube",
        rows,
        numbers={"growth": growth, "at_rest": cases_html(at_rest) if at_rest else ""},
    )


def long(results: Results) -> Claim:
    rows = family(results, "long")
    row = rows[0] if rows else None
    columns = {"duration": "shake_duration_s", "first": "increment_first_mm_per_cycle"}
    columns |= {"last": "increment_last_mm_per_cycle", "slip": "slip_mm"}
    cells = {name: cell_or_absent(row, column, "1") for name, column in columns.items()}
    numbers = {**cells, "ends": row["class"] if row else ""}
    return family_claim(
        results,
        "long_run",
        rows,
        numbers=numbers,
    )


def buffers(results: Results) -> Claim:
    rows = family(results, "buffers")
    ample = results.row.get("buffers-ample")
    columns = {"contacts": "peak_contact_count", "constraints": "peak_constraint_count"}
    peaks = {name: cell_or_absent(ample, column, "1") for name, column in columns.items()}
    return family_claim(
        results,
        "buffers",
        rows,
        numbers=peaks,
    )


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
    return Claim(
        "neighbours_unharmed",
        within(difference, floor),
        numbers={"difference": difference, "floor": floor},
    )


def repeats_agree(results: Results) -> Claim:
    rows = [row for row in results.rows if row.repeat_count.value > 1]
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
