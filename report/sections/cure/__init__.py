"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

import math
from collections.abc import Sequence

from markupsafe import Markup

from measured_report.claims.claims import HOLDS, Claim, Outcome, all_of, at_least, at_most, decreases, greater
from measured_report.parts.parts import Figure, Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results
from report.names import some_html
from report.sections.cure.budget import (
    budget_table,
    closed_count,
    closing_table,
    kept_runs,
    lacks_the_sway,
    parts_of,
    run_count,
)
from report.sections.cure.figures import draw_budget
from report.sections.cure.ways import (
    ADDS,
    BEST,
    GRASP_MM,
    STEPS,
    WAYS,
    Way,
    amplitude_mm,
    cost_table,
    use_table,
    what_to_use,
)
from report.shared.arithmetic import departure, noise_floor, share

order = 149  # after all of its page, which it reads
page = "cure"
label = "the cure"
leads = True

OTHER_CONTACTS = {
    "mujoco": "mujoco-euler-400-shipped-3cm-full-kept",
    "pyramid": "pyramidal-euler-400-shipped-3cm-full-kept",
}
"""All remedies with other contacts than Newton's and with another cone."""
CONTACTS = {"mujoco": "contacts that MuJoCo finds", "pyramid": "a pyramidal cone"}


def derive(results: Results) -> Section:
    least = results.chosen("remainder_least", "what a grasp of this kind does not show", 0.02, unit="mm")
    most = results.chosen("remainder_share", "as good as the law", 5.0, unit="%")
    grasp = results.chosen("grasp_bound", "farther from where it was, a cube is out of the grasp", GRASP_MM, unit="mm")
    near, far = (amplitude_mm(results, shake) for shake in ("3cm", "10cm"))
    parts = {way.name: parts_of(results, way) for way in WAYS}
    budget = Figure(
        draw=lambda: draw_budget(results, parts),
        sources=[way.row(results, "3cm").slip_mm for way in WAYS],
        numbers={
            **{name: way.row(results, "3cm").slip_mm for name, way in _named().items()},
            **{name: parts["shipped pads"][name] for name in ("left_out", "sum")},
            "amplitude": near,
        },
    )
    return Section(
        tables={
            "use": use_table(results),
            "cost": cost_table(results),
            "budget": budget_table(results, parts, near),
            "closing": closing_table(results, least, most),
        },
        figures={"budget": budget},
        claims=[
            what_to_use(results, far, grasp),
            _budget_closes(results, least, most),
            _term_alone(results),
            _each_takes_its_part(results),
            _best_holds(results),
            _best_holds_farther(results, far, grasp),
            _stiff_pads_hold_better(results),
            _term_uncovers_step(results, parts["the term"]),
            _stiff_pads_with_term(results),
            _step_alone_is_more(results),
            _with_other_contacts(results),
            _pyramid_yields(results),
            lacks_the_sway(results, far),
        ],
    )


def _named() -> dict[str, Way]:
    return {"shipped": _way("shipped pads"), "term": _way("the term"), "best": BEST}


def _way(name: str) -> Way:
    return next(way for way in WAYS if way.name == name)


def _budget_closes(results: Results, least: Value, most: Value) -> Claim:
    kept = kept_runs(results)
    closed = closed_count(results, "closed_count", kept, least, most)
    count = run_count(results, "kept_count", kept)
    part = share(results, "closed_share", "of the runs that keep the cube, those of them", closed, count)
    enough = results.chosen("closed_bound", "not by chance", 8.0)
    usual = results.chosen("closed_share_bound", "by far the most of them", 80.0, unit="%")
    numbers = {"closed": closed, "count": count, "share": part, "least": least, "most": most}
    return Claim("budget_closes", all_of(at_least(closed, enough), at_least(part, usual)), numbers=numbers)


def _term_alone(results: Results) -> Claim:
    shipped, term = (_way(name).row(results, "3cm").slip_mm for name in ("shipped pads", "the term"))
    bound = results.chosen("term_alone_bound", "a tenth of the slip as shipped", 0.6, unit="mm")
    outcome = all_of(at_most(term, bound), greater(shipped, term, noise=noise_floor(results, "slip_floor")))
    return Claim("term_alone", outcome, numbers={"shipped": shipped, "term": term})


def _each_takes_its_part(results: Results) -> Claim:
    """One remedy after the other."""
    slips = [_way(name).row(results, "3cm").slip_mm for name in STEPS.values()]
    noise = noise_floor(results, "slip_floor")
    numbers: dict[str, Quantity | Markup] = dict(zip(STEPS, slips, strict=True))
    idle = [
        Markup.escape(name.removeprefix(ADDS))
        for name, before, after in zip(list(STEPS.values())[1:], slips, slips[1:], strict=False)
        if greater(before, after, noise=noise) != HOLDS
    ]
    return Claim("each_takes_its_part", decreases(slips, noise=noise), numbers=numbers | {"idle": some_html(idle)})


def _best_holds(results: Results) -> Claim:
    best = BEST.row(results, "3cm")
    bound = results.chosen("best_bound", "what a grasp of this kind does not show", 0.03, unit="mm")
    shipped = _way("shipped pads").row(results, "3cm").slip_mm
    gains = greater(shipped, best.slip_mm, noise=noise_floor(results, "slip_floor"))
    numbers = {"best": best.slip_mm, "shipped": shipped}
    return Claim("best_holds", all_of(at_most(best.slip_mm, bound), gains), numbers=numbers)


def _best_holds_farther(results: Results, amplitude: Value, grasp: Value) -> Claim:
    best, shipped = (way.row(results, "10cm") for way in (BEST, _way("shipped pads")))
    bound = results.chosen("best_far_bound", "a tenth of a millimetre at a shake three times as wide", 0.1, unit="mm")
    slip, outcome = best.slip_mm, at_most(best.slip_mm, bound)
    if at_least(shipped.slip_mm, grasp) != HOLDS:
        outcome = Outcome("unknown", "the scene with shipped pads keeps the cube there").having_read(shipped.slip_mm)
        slip = absent("mm", outcome.reason)
    return Claim("best_holds_farther", outcome, numbers={"best": slip, "amplitude": amplitude})


def _stiff_pads_hold_better(results: Results) -> Claim:
    term, stiff = (_way(name).row(results, "3cm").slip_mm for name in ("the term", "stiff pads"))
    outcome = greater(term, stiff, noise=noise_floor(results, "slip_floor"))
    return Claim("stiff_pads_hold_better", outcome, numbers={"term": term, "stiff": stiff})


def _term_uncovers_step(results: Results, parts: dict[str, Value]) -> Claim:
    """The error of the step goes against what the term would have added, so that it shows once that is gone."""
    plain, term = (_way(name).row(results, "3cm") for name in ("shipped pads", "the term"))
    turned = results.value(
        "turned",
        "cosine of the angle between the slip with the term put back and that as shipped, along the pads",
        lambda ax, az, bx, bz: (ax * bx + az * bz) / ((ax**2 + az**2) * (bx**2 + bz**2)) ** 0.5,
        *_along_pads(plain),
        *_along_pads(term),
    )
    part = share(
        results,
        "step_share",
        "predicted error of the step, along the way that the cube went with the term put back, of the slip then",
        parts["step"],
        term.slip_mm,
    )
    against = results.chosen("turned_bound", "about the other way", -0.5)
    most = results.chosen("step_share_bound", "most of it", 50.0, unit="%")
    outcome = all_of(at_most(turned, against), at_least(part, most))
    return Claim("term_uncovers_step", outcome, numbers={"term": term.slip_mm, "step": parts["step"], "share": part})


def _along_pads(row) -> Sequence[Quantity]:
    return row.slip_x_mm, row.slip_z_mm


def _stiff_pads_with_term(results: Results) -> Claim:
    plain, term = (_way(name).row(results, "3cm").slip_mm for name in ("stiff pads", "stiff pads, the term"))
    outcome = greater(term, plain, noise=noise_floor(results, "slip_floor"))
    return Claim("stiff_pads_with_term", outcome, numbers={"plain": plain, "term": term})


def _step_alone_is_more(results: Results) -> Claim:
    """Why stiff pads can lose by the term: the error of the step alone against what it and the term come to."""
    row = _way("stiff pads").row(results, "3cm")
    of_term, of_step = ((row[f"{name}_x_mm"], row[f"{name}_z_mm"]) for name in ("left_out", "step"))
    term, step, both = (
        results.value(f"stiff_{name}", f"size of {words} along the pads, predicted", _size, *cells, unit="mm")
        for name, words, cells in (
            ("term", "the term", of_term),
            ("step", "the error of the step", of_step),
            ("both", "both together", of_term + of_step),
        )
    )
    outcome = greater(step, both, noise=noise_floor(results, "slip_floor")).having_read(term)
    return Claim("step_alone_is_more", outcome, numbers={"term": term, "step": step, "both": both})


def _size(*cells: float) -> float:
    """Of the sum of vectors, each given as x and z."""
    return math.hypot(sum(cells[::2]), sum(cells[1::2]))


def _with_other_contacts(results: Results) -> Claim:
    rows = {name: results.row[case] for name, case in OTHER_CONTACTS.items()}
    slips = {name: row.slip_mm for name, row in rows.items()}
    largest = results.value("other_slip", "larger of both", max, *slips.values(), unit="mm")
    bound = results.chosen("other_bound", "as good as with Newton's contacts, or nearly", 0.1, unit="mm")
    worse = some_html([Markup.escape(CONTACTS[name]) for name, slip in slips.items() if at_most(slip, bound) != HOLDS])
    return Claim("with_other_contacts", at_most(largest, bound), numbers=slips | {"worse": worse})


def _pyramid_yields(results: Results) -> Claim:
    """What the pyramidal cone leaves is load alone, on rows that are softer the less deep the contacts are."""
    row = results.row[OTHER_CONTACTS["pyramid"]]
    load = results.value(
        "pyramid_load", "size of the part of load", math.hypot, row.creep_x_mm, row.creep_z_mm, unit="mm"
    )
    formula = "slip less that part, in size, of the slip"
    off = departure(results, "pyramid_load_off", formula, load, row.slip_mm)
    bound = results.chosen("pyramid_load_bound", "that part and no other", 15.0, unit="%")
    return Claim("pyramid_yields", at_most(off, bound), numbers={"slip": row.slip_mm, "load": load})
