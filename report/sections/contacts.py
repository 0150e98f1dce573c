"""The solver's live contact rows: their residuals, what their velocities add up to, and what makes them slide."""

from collections.abc import Iterator

from report.shared import (
    CASES,
    PERCENT,
    Claim,
    Outcome,
    Quantity,
    Results,
    Row,
    Section,
    all_of,
    at_most,
    combined,
    decided,
    departure,
    greater,
    noise_floor,
    other_value,
    table_of,
)

order = 70
page = "cause"
reads = ("noise", "reproduction")
label = "contact rows"


def derive(results: Results) -> Section:
    frames, more_runs = (
        [row for row in results.rows if row.kind == kind] for kind in ("frame", "run")
    )
    first = {row.case: row for row in reversed(frames)}
    # Through MuJoCo C, and the same with the left-out acceleration in the contact rows.
    left_out, restored = (
        [results.row[f"{case}-{way}"] for case in CASES]
        for way in ("missing-term", "term-restored")
    )
    run = next(
        (row for row in more_runs if row.case == "as-shipped"),
        results.row["as-shipped"],
    )
    ends = _term_restored(results, left_out, restored)
    claims = [
        _far_inside_cone(
            results, run, [row for row in frames if row["case"] == "as-shipped"]
        )
    ]
    claims += [
        *_friction_rows(results, frames, first["as-shipped"].friction_timeconst_s)
    ]
    claims += [
        _slide_accounts(results, run),
        _missing_term(results, left_out, ends.outcome),
        ends,
    ]
    rows = [
        row for row in results.rows if row.kind == "row" and row["case"] == "as-shipped"
    ]
    columns = {
        "residual": "residual_mm",
        "velocity": "velocity_mm_s",
        "force": "force_n",
    }
    return Section(
        tables={"rows": table_of("row", [row.row for row in rows], columns, rows)},
        claims=claims,
    )


def _far_inside_cone(results: Results, run: Row, frames: list[Row]) -> Claim:
    used = results.value(
        "grip_used_shipped",
        "most of its friction cone that a contact uses through the shake, with shipped pads",
        PERCENT * run.cone_use_max,
    )
    outcome = at_most(
        run.cone_use_max, 0.1, why="far from the limit, which is 1"
    ).having_read(used)
    along = combined(max, *(row.tangential_force_n for row in frames))
    load = results.value(
        "load_along",
        "most that all contacts carry along the pads, over all looks",
        along,
    )
    weight = other_value(results, "reproduction", "cube_weight")
    results.value(
        "load_by_weight", "this load, by the weight of the cube", load / weight
    )
    return Claim("far_inside_cone", outcome, {"used": used})


def _friction_rows(
    results: Results, frames: list[Row], timeconst: Quantity
) -> Iterator[Claim]:
    largest = results.value(
        "friction_residual",
        "largest position residual of a loaded contact's friction rows, over all looks",
        combined(max, *(row.friction_residual_mm for row in frames)),
    )
    cells = [row.normal_residual_mm for row in frames if row.case == "as-shipped"]
    normal = results.value(
        "normal_residual",
        "largest position residual of a loaded contact's normal row as shipped, over all looks",
        combined(max, *cells),
    )
    bound = results.chosen("friction_residual_bound", "none at all", 0.0, "mm")
    carries = greater(normal, largest, noise=noise_floor(results, "slip_floor"))
    yield Claim(
        "no_friction_residual",
        all_of(at_most(largest, bound), carries),
        {"normal": normal},
    )
    yield Claim("own_friction_timeconst", decided(bool(timeconst.value), timeconst))


def _slide_accounts(results: Results, run: Row) -> Claim:
    bound = results.chosen("slide_departure_bound", "the same motion", 15.0, "%")
    gap = results.value(
        "slide_gap_as-shipped",
        "what the velocities of the loaded friction rows add up to, less the motion measured along the same axis",
        run.slide_mm - run.along_mm,
    )
    off = results.value(
        "slide_departure_as-shipped",
        "size of that difference, of the motion measured",
        PERCENT * abs(gap / run.along_mm),
    )
    is_more = greater(
        run.slide_mm, run.along_mm, noise=noise_floor(results, "slip_floor")
    ).answer
    numbers = {
        "slide": run.slide_mm,
        "along": run.along_mm,
        "bound": bound,
        "is_more": is_more,
    }
    return Claim("slide_accounts", at_most(off, bound), numbers)


def _missing_term(results: Results, rows: list[Row], ends: Outcome) -> Claim:
    name, pairs = (
        "missing_term_departure",
        [(row.case, row.predicted_slide_mm, row.slide_mm) for row in rows],
    )
    departures = [
        results.value(
            f"{name}_{case}",
            "slide that the left-out acceleration gives, less the slide of the friction rows, in size, of the latter",
            departure(*pair),
        )
        for case, *pair in pairs
    ]
    largest = results.value(
        name, "larger of both departures", combined(max, *departures)
    )
    bound = results.chosen("missing_term_bound", "the same slide", 5.0, "%")
    numbers = {
        "predicted": rows[0].predicted_slide_mm,
        "slide": rows[0].slide_mm,
        "departure": largest,
    }
    return Claim("missing_term", at_most(largest, bound), numbers, effect=ends)


def _term_restored(results: Results, left_out: list[Row], restored: list[Row]) -> Claim:
    bound = results.chosen("restored_share_bound", "no slide to speak of", 5.0, "%")
    shares, falls = [], []
    for case, plain, back in zip(CASES, left_out, restored, strict=True):
        shares.append(
            results.value(
                f"restored_share_{case}",
                "size of the slide of the friction rows with the term put back, of that without it",
                PERCENT * abs(back.slide_mm / plain.slide_mm),
            )
        )
        less = results.value(
            f"restored_{case}_small_size", "its size", abs(back.slide_mm)
        )
        more = results.value(
            f"restored_{case}_large_size", "its size", abs(plain.slide_mm)
        )
        falls.append(greater(more, less, noise=noise_floor(results, "slip_floor")))
    largest = results.value(
        "restored_share", "larger of both shares", combined(max, *shares)
    )
    numbers = {"slide": left_out[0].slide_mm, "restored": restored[0].slide_mm}
    return Claim("term_restored", all_of(at_most(largest, bound), *falls), numbers)
