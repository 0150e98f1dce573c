"""Claims of section stability about loads, sizes, masses, bad starts, long runs and small buffers."""

from collections.abc import Iterable, Iterator, Sequence

from markupsafe import Markup

from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_least, at_most, contiguous, decided, greater
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.sections.stability.families import family, family_claim, least, most
from report.sections.stability.passing import ENERGY_LARGEST, GROWTH_LARGEST, is_stable, passed
from report.shared.arithmetic import cases_html, cell_or_absent, extreme, share

MU = {"shake": 0.0187, "grip": 0.1}
"""Friction coefficient of the pads in runs that are shaken harder, and gripped less, until the cube is lost."""
SINK_LEAST_MM, NO_SINKING = 0.1, "no sinking"
"""A hand that comes down by no more than that has not come down."""


def crossover(results: Results, name: str, margin: Value) -> Claim:
    rows = [row for row in family(results, name) if row.load.value is not None]
    dropped = [row for row in rows if row["class"] == "dropped"]
    kept = most(results, f"{name}_kept", "largest load that holds", filter(is_stable, rows), "load")
    lost = least(results, f"{name}_lost", "least load that drops", dropped, "load")
    over = {}
    for kind, load in (("kept", kept), ("lost", lost)):
        formula = f"{load.formula}, over the limit"
        over[kind] = results.value(f"{name}_{kind}_over", formula, lambda share: 100.0 * (share - 1.0), load, unit="%")
    mu = results.value(f"{name}_mu", "given: friction coefficient of the pads", lambda: MU[name])
    also = decided(True, kept, lost)
    return family_claim(results, f"{name}_crossover", family(results, name), also, mu=mu, margin=margin, **over)


def friction(results: Results) -> Claim:
    rows = sorted(family(results, "friction"), key=lambda row: row.pad_mu.value)
    kept = least(results, "friction_kept", "least μ that holds", filter(is_stable, rows), "pad_mu")
    largest = most(results, "friction_most", "largest μ that holds", filter(is_stable, rows), "pad_mu")
    also = contiguous([is_stable(row) for row in rows], kept, largest)
    return family_claim(results, "friction_extremes", rows, also, kept=kept, most=largest)


def masses(results: Results) -> Claim:
    rows = sorted(family(results, "mass"), key=lambda row: row.cube_mass_kg.value)
    held = list(filter(is_stable, rows))
    light = least(results, "mass_least", "least mass that is held", held, "cube_mass_kg")
    heavy = most(results, "mass_most", "largest mass that is held", held, "cube_mass_kg")
    also = contiguous([is_stable(row) for row in rows], light, heavy)
    return family_claim(results, "masses", rows, also, light=light, heavy=heavy)


def _sinks(rows: Iterable[Row]) -> list[Quantity]:
    return [cell_or_absent(row, "hand_sink_mm", "mm") for row in rows]


def size(results: Results, bound: Value) -> Claim:
    rows = family(results, "size")
    kept = passed(rows)
    by_grip = {grip: [row for row in kept if row.grip == grip] for grip in ("as-shipped", "scaled")}
    formula = "least edge that passes, grip"
    shipped = least(results, "size_shipped", f"{formula} as shipped", by_grip["as-shipped"], "cube_edge_mm")
    scaled = least(results, "size_scaled", f"{formula} scaled", by_grip["scaled"], "cube_edge_mm")
    smallest = {"as-shipped": shipped.value, "scaled": scaled.value}
    lost = [row for row in rows if row not in kept]
    small = None not in smallest.values() and all(row.cube_edge_mm.value < smallest[row.grip] for row in lost)
    return family_claim(results, "sizes", rows, bound=bound, shipped=shipped, scaled=scaled, small_ones_fail=small)


def overlap(results: Results) -> Claim:
    rows = family(results, "overlap")
    formula = "exit speed over that of an undamped spring"
    shares = [share(results, f"exit_share_{r.case}", formula, r.exit_speed_mm_s, r.exit_bound_mm_s) for r in rows]
    largest = extreme(results, "exit_share_most", "largest share", max, shares)
    deepest = most(results, "overlap_deepest", "deepest start", rows, "overlap_mm")
    also = at_most(largest, 100.0, why="no faster than an undamped spring")
    return family_claim(results, "overlaps", rows, also, deepest=deepest, most=largest)


def gravity(results: Results) -> Iterator[Claim]:
    """Say which gravities take the cube, whether the arm gives way there, and whether a freed cube gains energy."""
    rows = family(results, "gravity")
    pulled = [row for row in rows if not row.freed]
    lost = [row for row in pulled if not is_stable(row)]
    tried = Markup(", ").join(row.gravity_m_s2.bare for row in pulled)
    text = Markup(", ").join(Markup("{} ({})").format(row.gravity_m_s2, row["class"]) for row in lost)
    yield family_claim(results, "gravities", pulled, tried=tried, lost=text)
    yield _arm_gives_way(results, lost, filter(is_stable, [*pulled, *family(results, "mass")]))

    freed = [row for row in rows if row.freed]
    cells = [cell_or_absent(row, "energy_growth", "1") for row in freed]
    growth = extreme(results, "energy_growth_most", "largest ratio of the energies", max, cells)
    at_rest = [row for row in passed(freed) if row.energy_growth.value is None]
    also = at_most(growth, ENERGY_LARGEST, why="no energy gained")
    yield family_claim(results, "freed_cube", freed, also, growth=growth, at_rest=at_rest and cases_html(at_rest))


def _arm_gives_way(results: Results, lost: Sequence[Row], held: Iterable[Row]) -> Claim:
    sink = extreme(results, "gravity_sink", "least sink of the hand where gravity takes the cube", min, _sinks(lost))
    held_sink = extreme(results, "held_sink", "largest sink of the hand where a cube is held", max, _sinks(held))
    needed = "largest share of the friction that is needed there"
    load = results.value("gravity_load", needed, lambda *share: 100 * max(share), *(row.load for row in lost), unit="%")
    is_farther = greater(sink, held_sink, noise=SINK_LEAST_MM, why=NO_SINKING)
    outcome = all_of(is_farther, at_most(load, 50.0, why="friction to spare"))
    if not lost:
        outcome = Outcome("unknown", "no gravity that was tried takes the cube")
    return Claim("arm_gives_way", outcome, {"sink": sink, "load": load})


def long(results: Results) -> Claim:
    """Tell whether the long run speeds up, as far as its first and its last creep say."""
    rows = family(results, "long")
    columns = {"duration": "shake_duration_s", "first": "increment_first_mm_per_cycle"}
    columns |= {"last": "increment_last_mm_per_cycle"}
    cells = {name: cell_or_absent(rows[0] if rows else None, column, "1") for name, column in columns.items()}
    bound = results.chosen("long_growth_bound", "hardly more", GROWTH_LARGEST)
    formula = "creep per cycle in the first tenth times that bound"
    allowed = results.value("long_creep_allowed", formula, lambda a, b: a * b, cells["first"], bound, unit="mm/cycle")
    is_lost, ends = not all(map(is_stable, rows)), rows[0]["class"] if rows else ""
    also = HOLDS if is_lost else at_most(cells["last"], allowed)
    return family_claim(results, "long_run", rows, also, **cells, ends=ends, is_lost=is_lost, bound=bound)


def buffers(results: Results) -> Claim:
    """Tell whether every buffer that is too small is named, and those are that hold less than the grasp was seen to
    need."""
    rows, ample = family(results, "buffers"), results.row.get("buffers-ample")
    peaks, fits, needed = {}, [], []
    for kind in ("contact", "constraint"):
        full = [row for row in rows if row["class"] == "overflow" and f"-{kind}-" in row.case]
        formula = f"largest buffer of {kind}s that was too small"
        too_few = most(results, f"{kind}s_too_few", formula, full, f"{kind}_max")
        peak = peaks[f"{kind}s"] = cell_or_absent(ample, f"peak_{kind}_count", "1")
        fits.append(at_most(peak, cell_or_absent(ample, f"{kind}_max", "1")))
        needed.append(at_least(peak, too_few))
    return family_claim(results, "buffers", rows, all_of(*fits, *needed), **peaks)
