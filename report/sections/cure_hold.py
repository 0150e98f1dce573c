"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure as Drawing

from experiments.facts.case import AS_SHIPPED
from measured_report import ROOT
from measured_report.claims.claims import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import new_figure
from measured_report.parts.parts import Download, Figure, Section, Table
from measured_report.values.results import Results, Row, Series
from report.names import name_of
from report.shared.arithmetic import SETTLES, by_case, departure, noise_floor, other_cell, ratio, share

order = 143
page = "cure"
label = "held for a minute"

POSITIONS_FILE = ROOT / "assets/fix/compensated_positions.py"
CASES = ("rounded", "rounded-impratio", "kept", "kept-stiff", "kept-impratio", "best")


def derive(results: Results) -> Section:
    rows = {case: results.row[case] for case in CASES}
    traces = {case: results.trace(case) for case in CASES}
    motion = Figure(
        draw=lambda: _draw(traces),
        sources=list(traces.values()),
        numbers={
            "duration": rows["rounded"].shake_duration_s,
            "rounded": rows["rounded"].slip_mm,
            "kept": rows["kept"].slip_mm,
            "best": rows["best"].slip_mm,
        },
    )
    return Section(
        tables={"cases": _table(rows)},
        figures={"motion": motion},
        claims=[
            _compensation_helps(results, rows),
            _stiff_creep_is_rounding(results, rows),
            _impratio_alone_does_not(results, rows),
            _rest_goes_with_impratio(results, rows),
            _best_stays(results, rows),
        ],
        downloads=[Download(POSITIONS_FILE.name, POSITIONS_FILE.read_text(encoding="utf-8"))],
    )


def _compensation_helps(results: Results, rows: Mapping[str, Row]) -> Claim:
    rounded, kept = (rows[case].increment_final_mm for case in ("rounded", "kept"))
    bound = results.chosen("creep_bound", "a millimetre or so in a minute", 0.02, unit="mm")
    outcome = all_of(greater(rounded, kept, noise=noise_floor(results, "slip_floor")), at_most(kept, bound))
    numbers = {"rounded": rounded, "kept": kept, "slip": rows["rounded"].slip_mm, "slip_kept": rows["kept"].slip_mm}
    gain = ratio(results, "kept_gain", "slip with positions rounded over that with compensated ones", *_slips(rows))
    return Claim(
        "compensation_helps",
        all_of(outcome, at_least(gain, results.chosen("kept_gain_bound", "less by half", 2.0))),
        numbers=numbers | {"bound": bound, "duration": rows["rounded"].shake_duration_s},
    )


def _stiff_creep_is_rounding(results: Results, rows: Mapping[str, Row]) -> Claim:
    kept, rounded = rows["kept-stiff"].slip_mm, other_cell(results, "hold", "hold-60s-stiff", "slip_mm", unit="mm")
    formula = "slip with positions rounded over that with compensated ones, both with stiff pads"
    gain = ratio(results, "kept_stiff_gain", formula, rounded, kept)
    is_less = greater(rounded, kept, noise=noise_floor(results, "slip_floor"))
    outcome = all_of(is_less, at_least(gain, results.chosen("kept_stiff_bound", *SETTLES)))
    return Claim("stiff_creep_is_rounding", outcome, {"kept": kept, "rounded": rounded, "gain": gain})


def _slips(rows: Mapping[str, Row]) -> tuple:
    return rows["rounded"].slip_mm, rows["kept"].slip_mm


def _impratio_alone_does_not(results: Results, rows: Mapping[str, Row]) -> Claim:
    before, after = (rows[case].slip_mm for case in ("rounded", "rounded-impratio"))
    left = share(
        results, "impratio_share", "slip with a high impratio, of that as shipped, both rounded", after, before
    )
    bound = results.chosen("impratio_bound", "most of it remains", 50.0, unit="%")
    numbers = {"before": before, "after": after, "impratio": rows["rounded-impratio"].impratio}
    return Claim("impratio_alone_does_not", at_least(left, bound), numbers=numbers)


def _rest_goes_with_impratio(results: Results, rows: Mapping[str, Row]) -> Claim:
    """Regularization under load is in proportion to 1 / impratio, and nothing else of what is left is."""
    before, after = (rows[case].creep_z_mm_s for case in ("kept", "kept-impratio"))
    formula = "rate of the creep along the tool with impratio as shipped over that with a high one, both compensated"
    gain = ratio(results, "rest_gain", formula, before, after)
    formula = f"impratio over the {AS_SHIPPED.impratio:g} of the scene"
    high = rows["kept-impratio"].impratio
    raised = results.value("impratio_raised", formula, lambda impratio: impratio / AS_SHIPPED.impratio, high)
    off = departure(results, "rest_gain_off", "how far that is from how much impratio was raised", gain, raised)
    bound = results.chosen("rest_gain_bound", "in proportion", 5.0, unit="%")
    sizes = [
        results.value(f"rest_size_{case}", "size of the creep along the tool", abs, creep, unit="mm/s")
        for case, creep in (("before", before), ("after", after))
    ]
    return Claim(
        "rest_goes_with_impratio",
        all_of(at_most(off, bound), greater(*sizes, noise=noise_floor(results, "drift_floor"))),
        numbers={"before": before, "after": after, "gain": gain, "raised": raised},
    )


def _best_stays(results: Results, rows: Mapping[str, Row]) -> Claim:
    rounded, best = (rows[case].slip_mm for case in ("rounded", "best"))
    gain = ratio(results, "best_gain", "slip as shipped over that with all remedies", rounded, best)
    bound = results.chosen("best_gain_bound", *SETTLES)
    is_told = None not in (gain.value, gain.noise) and gain.noise < gain.value
    numbers = {"best": best, "rounded": rounded, "gain": gain, "is_told": is_told}
    numbers |= {"duration": rows["best"].shake_duration_s}
    return Claim("best_stays", at_least(gain, bound), numbers=numbers)


def _table(rows: Mapping[str, Row]) -> Table:
    columns = {
        "slip": [row.slip_mm for row in rows.values()],
        "first second": [row.increment_first_mm for row in rows.values()],
        "last second": [row.increment_final_mm for row in rows.values()],
        "along the shake": [row.creep_x_mm_s for row in rows.values()],
        "along the tool": [row.creep_z_mm_s for row in rows.values()],
    }
    return by_case(list(rows.values()), columns)


def _draw(traces: Mapping[str, Series]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    for number, (case, trace) in enumerate(traces.items()):
        if trace.value is not None:
            moved = np.linalg.norm(trace.value[["x_mm", "y_mm", "z_mm"]], axis=1)
            place = (number / len(CASES) * 0.1, 0.1)
            axes.plot(trace.value["time_s"].iloc[1:], moved[1:], label=name_of(case), markevery=place)
    axes.set_yscale("log")
    axes.set_ylim(bottom=1e-3)
    axes.set_ylabel("displacement [mm]")
    axes.set_xlabel("time since the shake would begin [s]")
    drawing.legend(loc="outside upper center", ncols=2)
    return drawing
