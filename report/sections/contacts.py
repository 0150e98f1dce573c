"""The solver's live contact rows in the middle of the shake: forces, residuals, and what their velocities add up to."""

import pandas as pd
from matplotlib.figure import Figure as Drawing

from report.claims import Claim, at_most, greater
from report.figures import SERIES, new_figure
from report.parts import Figure, Section, Table
from report.quantities import Value
from report.results import Results, Row, Trace
from report.sections._common import ratio

order = 70

CASES = ("as-shipped", "stiff-pads")


def derive(results: Results) -> Section:
    runs = {row.case: row for row in _of_kind(results, "run")}
    gaps = {case: _gap(results, row) for case, row in runs.items()}
    tables = {case: results.trace(case) for case in CASES}
    rows = Figure(
        draw=lambda: _draw_contacts(tables, runs),
        caption="Left: how fast each loaded contact slides along the shake's main axis in the middle frame. Right: the "
        "mean of these velocities added up over every frame of the shake, next to the motion that was measured.",
        alt=f"Sliding speeds of the loaded contacts, as shipped and with stiff pads; added up over the shake they give "
        f"{runs['as-shipped'].slide_mm} as shipped, where {runs['as-shipped'].along_mm} was measured.",
        sources=[*tables.values(), *(row.slide_mm for row in runs.values())],
    )
    return Section(
        tables={
            "forces": _force_table(_of_kind(results, "frame")),
            "parameters": _parameter_table(_of_kind(results, "frame")),
            "rows": _row_table(_of_kind(results, "row")),
            "missing": _missing_table(results),
        },
        figures={"rows": rows},
        claims=[
            _far_inside_cone(results, runs["as-shipped"]),
            _no_friction_residual(results),
            _slide_accounts(results, runs["as-shipped"], gaps["as-shipped"]),
            _slide_accounts_when_stiff(results, runs["stiff-pads"], gaps),
            _missing_term(results),
            _term_restored(results),
            _rest_is_creep(results),
            _slide_falls_with_timeconst(results),
        ],
    )


def _of_kind(results: Results, kind: str) -> list[Row]:
    return [row for row in results.rows if row.kind == kind]


def _in_c(results: Results, kind: str) -> list[Row]:
    """The runs of one kind through MuJoCo C, one for each of CASES."""
    return [results.row[f"{case}-{kind}"] for case in CASES]


def _gap(results: Results, run: Row) -> Value:
    return results.value(
        f"slide_gap_{run.case}",
        "what the velocities of the loaded friction rows add up to, less the motion measured along the same axis",
        lambda slide, along: slide - along,
        run.slide_mm,
        run.along_mm,
        unit="mm",
    )


def _departure(results: Results, run: Row, gap: Value) -> Value:
    return results.value(
        f"slide_departure_{run.case}",
        "size of that difference, of the motion measured",
        lambda difference, along: 100 * abs(difference / along),
        gap,
        run.along_mm,
        unit="%",
    )


def _far_inside_cone(results: Results, run: Row) -> Claim:
    bound = results.chosen("cone_use_bound", "far from sliding, which is 1", 0.1)
    return Claim(
        "far_inside_cone",
        at_most(run.cone_use_max, bound),
        holds="The grasp is nowhere near the limit of friction: through the whole shake no contact uses more than "
        "{use} of its friction cone, where sliding would be {one}.",
        fails="The grasp does come near the limit of friction: a contact uses up to {use} of its friction cone, where "
        "sliding is {one}.",
        unknown="How much of the friction cone the grasp uses cannot be told.",
        numbers={"use": run.cone_use_max, "one": results.value("cone_limit", "by definition", lambda: 1.0)},
        explanation="The grasp is not too weak, so what the cube slips is not for want of friction or of grip.",
    )


def _no_friction_residual(results: Results) -> Claim:
    frames = _of_kind(results, "frame")
    largest = results.value(
        "friction_residual",
        "largest position residual of a loaded contact's friction rows, over all looks",
        max,
        *(row.friction_residual_mm for row in frames),
        unit="mm",
    )
    normal = results.value(
        "normal_residual",
        "largest position residual of a loaded contact's normal row as shipped, over all looks",
        max,
        *(row.normal_residual_mm for row in frames if row.case == "as-shipped"),
        unit="mm",
    )
    bound = results.value("friction_residual_bound", "none at all", lambda: 0.0, unit="mm")
    return Claim(
        "no_friction_residual",
        at_most(largest, bound),
        holds="The friction rows carry no position residual: {largest} at every look, in both cases, while the normal "
        "rows next to them carry up to {normal}.",
        fails="The friction rows do carry a position residual, of up to {largest}.",
        unknown="Whether the friction rows carry a position residual cannot be told.",
        numbers={"largest": largest, "normal": normal},
        explanation="A normal row knows how deep the cube is in the pad and pushes it back out. A friction row knows "
        "only a velocity: the acceleration that it asks for is −b·v, with b = 2 / (dmax · timeconst) of that row. It "
        "slows a sliding cube down, and once the cube has slid, nothing remembers where it was.",
    )


def _slide_accounts(results: Results, run: Row, gap: Value) -> Claim:
    departure = _departure(results, run, gap)
    return Claim(
        "slide_accounts",
        at_most(departure, _departure_bound(results)),
        holds="The velocity that is left in the friction rows accounts for the motion: added up over the {duration} of "
        "the shake it gives {slide} along the main axis as shipped, where {along} was measured.",
        fails="The velocity in the friction rows does not account for the motion: added up over the {duration} of the "
        "shake it gives {slide} along the main axis as shipped, where {along} was measured.",
        unknown="Whether the velocity in the friction rows accounts for the motion cannot be told.",
        numbers={"slide": run.slide_mm, "along": run.along_mm, "duration": run.shake_duration_s},
        explanation="So the motion is sliding at the contacts, at velocities that the solver sees and lets be.",
    )


def _departure_bound(results: Results) -> Value:
    name = "slide_departure_bound"
    return results.derived.get(name) or results.value(name, "chosen: the same motion", lambda: 15.0, unit="%")


def _slide_accounts_when_stiff(results: Results, run: Row, gaps: dict[str, Value]) -> Claim:
    departure = _departure(results, run, gaps[run.case])
    numbers = {
        "slide": run.slide_mm,
        "along": run.along_mm,
        "gap": gaps[run.case],
        "gap_shipped": gaps["as-shipped"],
    }
    return Claim(
        "slide_accounts_when_stiff",
        at_most(departure, _departure_bound(results)),
        holds="With stiff pads it does as well: {slide} from the rows, {along} measured.",
        fails="With stiff pads the same sum gives {slide} where {along} was measured. The two differ by {gap}, as "
        "shipped by {gap_shipped}: against so small a motion what is no sliding counts as well.",
        unknown="Whether it does so with stiff pads cannot be told.",
        numbers=numbers,
    )


def _missing_term(results: Results) -> Claim:
    rows = _in_c(results, "missing-term")
    departures = [
        results.value(
            f"missing_term_departure_{row.case}",
            "slide that the left-out acceleration gives, less the slide of the friction rows, in size, of the latter",
            lambda predicted, slide: 100 * abs(predicted / slide - 1),
            row.predicted_slide_mm,
            row.slide_mm,
            unit="%",
        )
        for row in rows
    ]
    largest = results.value("missing_term_departure", "larger of both departures", max, *departures, unit="%")
    bound = results.chosen("missing_term_bound", "the same slide", 5.0, unit="%")
    shipped, stiff = rows
    return Claim(
        "missing_term",
        at_most(largest, bound),
        holds="What makes them slide is an acceleration that the contact rows leave out. From the positions and "
        "velocities of a run through MuJoCo C, with nothing fitted, it gives {predicted} of slide as shipped where the "
        "friction rows show {slide}, and with stiff pads {predicted_stiff} where they show {slide_stiff}: never more "
        "than {departure} apart.",
        fails="An acceleration that the contact rows leave out does not account for the slide: it gives {predicted} as "
        "shipped where the friction rows show {slide}, and with stiff pads {predicted_stiff} where they show "
        "{slide_stiff}.",
        unknown="What makes the friction rows slide cannot be told.",
        numbers={
            "predicted": shipped.predicted_slide_mm,
            "slide": shipped.slide_mm,
            "predicted_stiff": stiff.predicted_slide_mm,
            "slide_stiff": stiff.slide_mm,
            "departure": largest,
        },
        explanation="A contact point of the arm accelerates by J·q̈ + J̇·q̇: the second part comes from the joints' "
        "velocities, as when a point moves on a curve. A contact row sets only J·q̈, to −b·v. To follow the arm all "
        "the same the row has to slide at v = J̇·q̇ / b. That goes with the square of the speed, so it does not cancel "
        "over a cycle; no friction coefficient and no iteration changes it, and b = 2 / (dmax · timeconst) is the only "
        "thing that stands against it.",
    )


def _term_restored(results: Results) -> Claim:
    """The intervention: the same runs, with the left-out acceleration in the contact rows."""
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    shares = [
        results.value(
            f"restored_share_{without.case.removesuffix('-missing-term')}",
            "size of the slide of the friction rows with the term put back, of that without it",
            lambda put_back, slide: 100 * abs(put_back / slide),
            put_back.slide_mm,
            without.slide_mm,
            unit="%",
        )
        for without, put_back in zip(left_out, restored, strict=True)
    ]
    largest = results.value("restored_share", "larger of both shares", max, *shares, unit="%")
    bound = results.chosen("restored_share_bound", "no slide to speak of", 5.0, unit="%")
    numbers = {"share": largest}
    for name, without, put_back in zip(("", "_stiff"), left_out, restored, strict=True):
        numbers |= {f"slide{name}": without.slide_mm, f"restored{name}": put_back.slide_mm}
    return Claim(
        "term_restored",
        at_most(largest, bound),
        holds="Put back into the contact rows, it ends the slide: {restored} in place of {slide} as shipped, "
        "{restored_stiff} in place of {slide_stiff} with stiff pads. So it is the cause.",
        fails="Put back into the contact rows, it does not end the slide: {restored} in place of {slide} as shipped, "
        "{restored_stiff} in place of {slide_stiff} with stiff pads.",
        unknown="Whether the slide ends when the term is put back cannot be told.",
        numbers=numbers,
    )


def _rest_is_creep(results: Results) -> Claim:
    """What the rows' slide leaves over is the motion that is there without any slide."""
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    rests = [
        results.value(
            f"rest_{without.case.removesuffix('-missing-term')}",
            "size of: measured displacement less slide of the rows, less the displacement with the term put back",
            lambda along, slide, creep: abs(along - slide - creep),
            without.along_mm,
            without.slide_mm,
            put_back.along_mm,
            unit="mm",
        )
        for without, put_back in zip(left_out, restored, strict=True)
    ]
    largest = results.value("rest", "larger of both", max, *rests, unit="mm")
    bound = results.chosen("rest_bound", "all accounted for", 0.03, unit="mm")
    shipped, stiff = restored
    return Claim(
        "rest_is_creep",
        at_most(largest, bound),
        holds="What the rows' slide and the measured displacement differ by is the motion that stays when nothing "
        "slides: {creep} as shipped, {creep_stiff} with stiff pads. With it the account closes to within {rest}.",
        fails="The rows' slide and the motion that stays when nothing slides, {creep} as shipped and {creep_stiff} "
        "with stiff pads, do not add up to the measured displacement: {rest} are left over.",
        unknown="Whether the rows' slide and the rest add up to the measured displacement cannot be told.",
        numbers={"creep": shipped.along_mm, "creep_stiff": stiff.along_mm, "rest": largest},
    )


def _slide_falls_with_timeconst(results: Results) -> Claim:
    """What stiff pads really gain: the displacement also has the creep, which hides a part of what still slides."""
    shipped, stiff = _in_c(results, "missing-term")
    formula = "slide of the friction rows as shipped, over that with stiff pads"
    slide = ratio(results, "slide_gain", formula, shipped.slide_mm, stiff.slide_mm)
    formula = "measured displacement as shipped, over that with stiff pads"
    along = ratio(results, "along_gain", formula, shipped.along_mm, stiff.along_mm)
    return Claim(
        "slide_falls_less_than_displacement",
        greater(along, slide, noise=results.chosen("gain_bound", "the same gain", 1.0)),
        holds="With stiff pads the cube slides {slide} times less, while its displacement falls {along} times.",
        fails="With stiff pads the cube slides {slide} times less, and its displacement falls {along} times.",
        unknown="With stiff pads the cube slides {slide} times less and its displacement falls {along} times; whether "
        "these differ cannot be told.",
        numbers={"slide": slide, "along": along},
        explanation="The motion that stays goes against the slide and hides a part of what is left of it.",
    )


def _missing_table(results: Results) -> Table:
    left_out, restored = _in_c(results, "missing-term"), _in_c(results, "term-restored")
    columns = {
        "from the left-out term": [row.predicted_slide_mm for row in left_out],
        "from the friction rows": [row.slide_mm for row in left_out],
        "measured displacement": [row.along_mm for row in left_out],
        "friction rows, term put back": [row.slide_mm for row in restored],
        "displacement, term put back": [row.along_mm for row in restored],
    }
    index = pd.Index([row.case.removesuffix("-missing-term") for row in left_out], name="case")
    return Table(
        pd.DataFrame(columns, index=index),
        "Slide along the main axis over two periods of the shake, in runs through MuJoCo C: J̇·q̇ / b at the loaded "
        "contacts, with J̇ from MuJoCo's mj_jacDot; the velocity of the same contacts' friction rows; how far the cube "
        "has moved; and the last two again in a run whose contact rows ask for −b·v − J̇·q̇.",
    )


def _force_table(frames: list[Row]) -> Table:
    columns = {
        "frame": [row.frame for row in frames],
        "contacts": [row.row_count for row in frames],
        "loaded": [row.loaded_row_count for row in frames],
        "normal": [row.normal_force_n for row in frames],
        "tangential": [row.tangential_force_n for row in frames],
        "cone use": [row.cone_use for row in frames],
        "penetration": [row.penetration_mm for row in frames],
        "sliding": [row.friction_velocity_mm_s for row in frames],
    }
    index = pd.Index([row.case for row in frames], name="case")
    return Table(
        pd.DataFrame(columns, index=index),
        "Three looks at the live contacts, a quarter of a cycle apart. Normal and tangential forces are sums over the "
        "loaded contacts, the penetration is their mean, cone use and sliding velocity are the largest among them.",
    )


def _parameter_table(frames: list[Row]) -> Table:
    first = {row.case: row for row in reversed(frames)}
    rows = [first[case] for case in CASES]
    columns = {
        "timeconst": [row.timeconst_s for row in rows],
        "dampratio": [row.dampratio for row in rows],
        "dmin": [row.dmin for row in rows],
        "dmax": [row.dmax for row in rows],
        "friction": [row.friction for row in rows],
        "dim": [row.dim for row in rows],
    }
    index = pd.Index([row.case for row in rows], name="case")
    return Table(
        pd.DataFrame(columns, index=index),
        "What the strongest contact really has: solref (timeconst, dampratio), solimp (dmin, dmax), friction and "
        "dimension, read from the solver and not from what was authored.",
    )


def _row_table(rows: list[Row]) -> Table:
    columns = {
        "row": [row.row for row in rows],
        "pair": [row.pair for row in rows],
        "position residual": [row.residual_mm for row in rows],
        "velocity": [row.velocity_mm_s for row in rows],
        "force": [row.force_n for row in rows],
    }
    index = pd.Index([row.case for row in rows], name="case")
    return Table(pd.DataFrame(columns, index=index), "The three rows of the contact that carries most force.")


def _draw_contacts(tables: dict[str, Trace], runs: dict[str, Row]) -> Drawing:
    drawing, (left, right) = new_figure(7.2, 3.2, ncols=2, width_ratios=(3, 2))
    for number, (case, trace) in enumerate(tables.items()):
        if trace.value is not None:
            loaded = trace.value.query("normal_force_n > 0").sort_values(["geom_1", "slide_mm_s"])
            places = range(1, len(loaded) + 1)
            left.plot(
                places, loaded["slide_mm_s"], linestyle="", marker="os"[number], markersize=6, markevery=1, label=case
            )
    left.axhline(0.0, color=SERIES[5], linewidth=0.8)
    left.set_xlabel("loaded contact (left finger, then right)")
    left.set_ylabel("sliding velocity [mm/s]")
    left.legend(loc="best")
    for number, run in enumerate(runs.values()):
        for place, quantity in ((number - 0.2, run.slide_mm), (number + 0.2, run.along_mm)):
            measured = place > number
            right.bar(
                place,
                quantity.value,
                width=0.36,
                color=SERIES[0 if measured else 4],
                hatch=None if measured else "///",
                label=("measured" if measured else "from the rows") if number == 0 else None,
            )
    right.set_xticks(range(len(runs)), list(runs))
    right.grid(visible=False, axis="x")
    right.set_ylabel("motion along the main axis [mm]")
    right.legend(loc="upper right")
    right.margins(y=0.35)
    return drawing
