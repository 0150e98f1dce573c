"""The slip's causes taken out one by one and together: what is predicted, what is measured, and what to use."""

import math
from collections.abc import Iterator, Mapping
from itertools import pairwise

from markupsafe import Markup

from measured_report.claims.claim import HOLDS, Claim, Outcome, all_of, at_least, at_most, decreases, greater
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results
from report.names import some_html
from report.sections.cure.budget import (
    budget_table,
    closed_count,
    closing_table,
    draw_budget,
    kept_runs,
    lacks_the_sway,
    parts_of,
    run_count,
)
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
Slips = Mapping[str, Quantity]
"""At 3 cm, by the name of the way."""


def derive(results: Results) -> Section:
    least = results.chosen("remainder_least", "what a grasp of this kind does not show", 0.02, unit="mm")
    most = results.chosen("remainder_share", "as good as the law", 5.0, unit="%")
    grasp = results.chosen("grasp_bound", "farther from where it was, a cube is out of the grasp", GRASP_MM, unit="mm")
    near, far = (amplitude_mm(results, shake) for shake in ("3cm", "10cm"))
    parts = {way.name: parts_of(results, way) for way in WAYS}
    slips = {way.name: way.row(results, "3cm").slip_mm for way in WAYS}
    numbers = {"shipped": slips["shipped pads"], "term": slips["the term"], "best": slips[BEST.name], "amplitude": near}
    numbers |= {name: parts["shipped pads"][name] for name in ("left_out", "sum")}
    return Section(
        tables={
            "use": use_table(results),
            "cost": cost_table(results),
            "budget": budget_table(results, parts, near),
            "closing": closing_table(results, least, most),
        },
        figures={"budget": Figure(lambda: draw_budget(results, parts), list(slips.values()), numbers)},
        claims=[
            what_to_use(results, far, grasp),
            _budget_closes(results, least, most),
            *_remedies_hold(results, slips, far, grasp),
            _term_uncovers_step(results, parts["the term"]),
            *_stiff_pads(results, slips),
            _with_other_contacts(results),
            _pyramid_yields(results),
            lacks_the_sway(results, far),
        ],
    )


def _way(name: str) -> Way:
    return next(way for way in WAYS if way.name == name)


def _budget_closes(results: Results, least: Value, most: Value) -> Claim:
    kept = kept_runs(results)
    closed = closed_count(results, "closed_count", kept, least, most)
    count = run_count(results, "kept_count", kept)
    part = share(results, "closed_share", "of the runs that keep the cube, those of them", closed, count)
    outcome = all_of(at_least(closed, 8.0, why="not by chance"), at_least(part, 80.0, why="by far the most of them"))
    numbers = {"closed": closed, "count": count, "share": part, "least": least, "most": most}
    return Claim("budget_closes", outcome, numbers)


def _remedies_hold(results: Results, slips: Slips, far: Value, grasp: Value) -> Iterator[Claim]:
    """Tell how little the cube slips with the term alone, with one remedy after the other, and with all of them."""
    noise = noise_floor(results, "slip_floor")
    shipped, term, best, stiff = (slips[name] for name in ("shipped pads", "the term", BEST.name, "stiff pads"))
    gains = greater(shipped, term, noise=noise)
    outcome = all_of(at_most(term, 0.6, why="a tenth of the slip as shipped"), gains)
    yield Claim("term_alone", outcome, {"shipped": shipped, "term": term})

    steps = {step: slips[name] for step, name in STEPS.items()}
    added = list(STEPS.values())[1:]
    idle = [
        Markup.escape(name.removeprefix(ADDS))
        for name, (before, after) in zip(added, pairwise(steps.values()), strict=True)
        if greater(before, after, noise=noise) != HOLDS
    ]
    falls = decreases(list(steps.values()), noise=noise)
    yield Claim("each_takes_its_part", falls, {**steps, "idle": some_html(idle)})

    is_little = at_most(best, 0.03, why="what a grasp of this kind does not show")
    outcome = all_of(is_little, greater(shipped, best, noise=noise))
    yield Claim("best_holds", outcome, {"best": best, "shipped": shipped})
    yield _best_holds_farther(results, far, grasp)
    yield Claim("stiff_pads_hold_better", greater(term, stiff, noise=noise), {"term": term, "stiff": stiff})


def _best_holds_farther(results: Results, amplitude: Value, grasp: Value) -> Claim:
    slip, shipped = (way.row(results, "10cm").slip_mm for way in (BEST, _way("shipped pads")))
    outcome = at_most(slip, 0.1, why="a tenth of a millimetre at a shake three times as wide")
    if at_least(shipped, grasp) != HOLDS:
        outcome = Outcome("unknown", "the scene with shipped pads keeps the cube there").having_read(shipped)
        slip = absent("mm", outcome.reason)
    return Claim("best_holds_farther", outcome, {"best": slip, "amplitude": amplitude})


def _term_uncovers_step(results: Results, parts: Mapping[str, Value]) -> Claim:
    """The error of the step goes against what the term would have added, so that it shows once that is gone."""
    plain, term = (_way(name).row(results, "3cm") for name in ("shipped pads", "the term"))
    turned = results.value(
        "turned",
        "cosine of the angle between the slip with the term put back and that as shipped, along the pads",
        lambda ax, az, bx, bz: (ax * bx + az * bz) / ((ax**2 + az**2) * (bx**2 + bz**2)) ** 0.5,
        *(cell for row in (plain, term) for cell in (row.slip_x_mm, row.slip_z_mm)),
    )
    formula = "predicted error of the step, along the way that the cube went with the term put back, of the slip then"
    part = share(results, "step_share", formula, parts["step"], term.slip_mm)
    outcome = all_of(at_most(turned, -0.5, why="about the other way"), at_least(part, 50.0, why="most of it"))
    return Claim("term_uncovers_step", outcome, {"term": term.slip_mm, "step": parts["step"], "share": part})


def _stiff_pads(results: Results, slips: Slips) -> Iterator[Claim]:
    """Tell whether stiff pads lose by the term, and why they can: the error of the step alone is more than what it and
    the term come to."""
    plain, term, noise = slips["stiff pads"], slips["stiff pads, the term"], noise_floor(results, "slip_floor")
    yield Claim("stiff_pads_with_term", greater(term, plain, noise=noise), {"plain": plain, "term": term})

    row = _way("stiff pads").row(results, "3cm")
    of_term, of_step = ((row[f"{name}_x_mm"], row[f"{name}_z_mm"]) for name in ("left_out", "step"))
    sizes = {
        name: results.value(f"stiff_{name}", f"size of {words} along the pads, predicted", _size, *cells, unit="mm")
        for name, words, cells in (
            ("term", "the term", of_term),
            ("step", "the error of the step", of_step),
            ("both", "both together", of_term + of_step),
        )
    }
    outcome = greater(sizes["step"], sizes["both"], noise=noise).having_read(sizes["term"])
    yield Claim("step_alone_is_more", outcome, sizes)


def _size(*cells: float) -> float:
    """Compute the length of the sum of vectors, each given as x and z."""
    return math.hypot(sum(cells[::2]), sum(cells[1::2]))


def _with_other_contacts(results: Results) -> Claim:
    slips = {name: results.row[case].slip_mm for name, case in OTHER_CONTACTS.items()}
    largest = results.value("other_slip", "larger of both", max, *slips.values(), unit="mm")
    tests = {
        name: at_most(slip, 0.1, why="as good as with Newton's contacts, or nearly")
        for name, slip in (slips | {"largest": largest}).items()
    }
    worse = some_html([Markup.escape(words) for name, words in CONTACTS.items() if tests[name] != HOLDS])
    return Claim("with_other_contacts", tests["largest"], slips | {"worse": worse})


def _pyramid_yields(results: Results) -> Claim:
    """What the pyramidal cone leaves is load alone, on rows that are softer the less deep the contacts are."""
    row = results.row[OTHER_CONTACTS["pyramid"]]
    cells = row.creep_x_mm, row.creep_z_mm
    load = results.value("pyramid_load", "size of the part of load", math.hypot, *cells, unit="mm")
    off = departure(results, "pyramid_load_off", "slip less that part, in size, of the slip", load, row.slip_mm)
    outcome = at_most(off, 15.0, why="that part and no other")
    return Claim("pyramid_yields", outcome, {"slip": row.slip_mm, "load": load})
