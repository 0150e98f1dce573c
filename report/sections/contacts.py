"""Show the residuals of the solver's contact rows, and why the contacts slide."""

from dataclasses import replace

from report.shared import (
    CASES,
    FAILS,
    PERCENT,
    Claim,
    Results,
    Section,
    Sections,
    all_of,
    at_most,
    combined,
    decided,
    departure,
    greater,
    table_of,
)

order = 70
page = "cause"
reads = ("reproduction",)
label = "contact rows"


def derive(results: Results) -> Section:
    frames = [row for row in results.rows if row.kind == "frame"]
    shipped = [row for row in frames if row.case == "as-shipped"]
    runs = [row for row in results.rows if row.kind == "run"]
    shipped_runs = (row for row in runs if row.case == "as-shipped")
    run = next(shipped_runs, results.row["as-shipped"])
    # These runs in MuJoCo C leave out the acceleration, or restore it.
    left_out = [results.row[f"{case}-missing-term"] for case in CASES]
    restored = [results.row[f"{case}-term-restored"] for case in CASES]

    used = results.value(
        "grip_used_shipped",
        "largest share of its friction cone that a contact uses in the shake, shipped"
        " pads",
        PERCENT * run.cone_use_max,
    )
    inside = at_most(run.cone_use_max, 0.1, "far from the limit of 1")
    load = results.value(
        "load_along",
        "largest force that all contacts together carry along the pads, over all"
        " samples",
        combined(max, *(row.tangential_force_n for row in shipped)),
    )
    weight = Sections(results.others).value("reproduction", "cube_weight")
    results.value(
        "load_by_weight", "this load over the weight of the cube", load / weight
    )

    largest = results.value(
        "friction_residual",
        "largest position residual of the friction rows of a loaded contact, over all"
        " samples",
        combined(max, *(row.friction_residual_mm for row in frames)),
    )
    normal = results.value(
        "normal_residual",
        "largest position residual of the normal row of a loaded contact as shipped,"
        " over all samples",
        combined(max, *(row.normal_residual_mm for row in shipped)),
    )
    none = results.chosen("friction_residual_bound", "no residual at all", 0.0, "mm")
    no_residual = all_of(at_most(largest, none), greater(normal, largest))
    first = shipped[0] if shipped else results.row["as-shipped"]
    timeconst = first.friction_timeconst_s

    slide = run.slide_mm
    along = run.along_mm
    same = results.chosen("slide_departure_bound", "the same motion", 15.0, "%")
    gap = results.value(
        "slide_gap_as-shipped",
        "integrated velocity of the loaded friction rows minus the motion measured"
        " along the same axis",
        slide - along,
    )
    off = results.value(
        "slide_departure_as-shipped",
        "absolute value of this difference, relative to the measured motion",
        PERCENT * abs(gap / along),
    )
    is_more = greater(slide, along).answer

    departures = [
        results.value(
            f"missing_term_departure_{row.case}",
            "absolute difference between the slide predicted from the left-out"
            " acceleration and the slide of the friction rows, relative to the latter",
            departure(row.predicted_slide_mm, row.slide_mm),
        )
        for row in left_out
    ]
    missing = results.value(
        "missing_term_departure",
        "larger of the two differences",
        combined(max, *departures),
    )
    close = results.chosen("missing_term_bound", "the same slide", 5.0, "%")

    little = results.chosen("restored_share_bound", "a negligible slide", 5.0, "%")
    shares = []
    falls = []
    for case, plain, back in zip(CASES, left_out, restored, strict=True):
        share = results.value(
            f"restored_share_{case}",
            "absolute slide of the friction rows with the term restored, relative to"
            " the slide without it",
            PERCENT * abs(back.slide_mm / plain.slide_mm),
        )
        shares.append(share)
        size = abs(back.slide_mm)
        less = results.value(
            f"restored_{case}_small_size", "absolute slide with the term", size
        )
        size = abs(plain.slide_mm)
        more = results.value(
            f"restored_{case}_large_size", "absolute slide without the term", size
        )
        falls.append(greater(more, less))
    rest = results.value(
        "restored_share", "larger of the two shares", combined(max, *shares)
    )
    ends = all_of(at_most(rest, little), *falls)

    has_own = decided(bool(timeconst.value), timeconst)
    # The engine reports its time constant, so that a missing one proves the opposite.
    has_own = replace(has_own, is_opposite=has_own == FAILS)
    predicted = left_out[0].predicted_slide_mm
    without = left_out[0].slide_mm
    rows = [row for row in results.rows if row.kind == "row"]
    rows = [row for row in rows if row.case == "as-shipped"]
    columns = {
        "residual": "residual_mm",
        "velocity": "velocity_mm_s",
        "force": "force_n",
    }
    return Section(
        tables={"rows": table_of("row", [row.row for row in rows], columns, rows)},
        claims=[
            Claim("far_inside_cone", inside.having_read(used), {"used": used}),
            Claim("no_friction_residual", no_residual, {"normal": normal}),
            Claim("own_friction_timeconst", has_own),
            Claim(
                "slide_accounts",
                at_most(off, same),
                {"slide": slide, "along": along, "bound": same, "is_more": is_more},
            ),
            Claim(
                "missing_term",
                at_most(missing, close),
                {"predicted": predicted, "slide": without, "departure": missing},
                effect=ends,
            ),
            Claim(
                "term_restored",
                ends,
                {"slide": without, "restored": restored[0].slide_mm},
            ),
        ],
    )
