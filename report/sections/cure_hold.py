"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from collections.abc import Iterator, Mapping

import numpy as np
from matplotlib.figure import Figure as Drawing

from experiments.facts.case import AS_SHIPPED
from measured_report import ROOT
from measured_report.claims.claim import Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Download, Figure, Section
from measured_report.values.results import Results, Row, Series
from report.names import name_of
from report.shared.arithmetic import by_case, departure, noise_floor, other_cell, ratio, settles, share

order = 143
page = "cure"
label = "held for a minute"

POSITIONS_FILE = ROOT / "assets/fix/compensated_positions.py"
CASES = ("rounded", "rounded-impratio", "kept", "kept-stiff", "kept-impratio", "best")
COLUMNS = {
    "slip": "slip_mm",
    "first second": "increment_first_mm",
    "last second": "increment_final_mm",
    "along the shake": "creep_x_mm_s",
    "along the tool": "creep_z_mm_s",
}


def derive(results: Results) -> Section:
    rows = {case: results.row[case] for case in CASES}
    traces = {case: results.trace(case) for case in CASES}
    numbers = {case: rows[case].slip_mm for case in ("rounded", "kept", "best")}
    numbers["duration"] = rows["rounded"].shake_duration_s
    return Section(
        tables={"cases": by_case(list(rows.values()), COLUMNS)},
        figures={"motion": Figure(lambda: _draw(traces), list(traces.values()), numbers)},
        claims=[
            *_compensation_helps(results, rows),
            *_impratio_takes_the_rest(results, rows),
            _best_stays(results, rows),
        ],
        downloads=[Download(POSITIONS_FILE.name, POSITIONS_FILE.read_text(encoding="utf-8"))],
    )


def _compensation_helps(results: Results, rows: Mapping[str, Row]) -> Iterator[Claim]:
    """Tell whether compensated positions take the creep away, with shipped pads and with stiff ones."""
    floor = noise_floor(results, "slip_floor")
    before, after = rows["rounded"], rows["kept"]
    rounded, kept = before.increment_final_mm, after.increment_final_mm
    bound = results.chosen("creep_bound", "a millimetre or so in a minute", 0.02, unit="mm")
    formula = "slip with positions rounded over that with compensated ones"
    gain = ratio(results, "kept_gain", formula, before.slip_mm, after.slip_mm)
    outcome = all_of(greater(rounded, kept, noise=floor), at_most(kept, bound), at_least(gain, 2.0, why="less by half"))
    numbers = {"rounded": rounded, "kept": kept, "slip": before.slip_mm, "slip_kept": after.slip_mm}
    numbers |= {"bound": bound, "duration": before.shake_duration_s}
    yield Claim("compensation_helps", outcome, numbers)

    kept, rounded = rows["kept-stiff"].slip_mm, other_cell(results, "hold", "hold-60s-stiff", "slip_mm", unit="mm")
    gain = ratio(results, "kept_stiff_gain", f"{formula}, both with stiff pads", rounded, kept)
    outcome = all_of(greater(rounded, kept, noise=floor), settles(gain))
    yield Claim("stiff_creep_is_rounding", outcome, {"kept": kept, "rounded": rounded, "gain": gain})


def _impratio_takes_the_rest(results: Results, rows: Mapping[str, Row]) -> Iterator[Claim]:
    """Tell that a high impratio alone does not help, and that what compensated positions leave goes with it.

    Regularization under load is in proportion to 1 / impratio, and nothing else of what is left is.
    """
    before, after = (rows[case].slip_mm for case in ("rounded", "rounded-impratio"))
    formula = "slip with a high impratio, of that as shipped, both rounded"
    left = share(results, "impratio_share", formula, after, before)
    numbers = {"before": before, "after": after, "impratio": rows["rounded-impratio"].impratio}
    yield Claim("impratio_alone_does_not", at_least(left, 50.0, why="most of it remains"), numbers)

    creeps = before, after = [rows[case].creep_z_mm_s for case in ("kept", "kept-impratio")]
    formula = "rate of the creep along the tool with impratio as shipped over that with a high one, both compensated"
    gain = ratio(results, "rest_gain", formula, before, after)
    shipped, high = AS_SHIPPED.impratio, rows["kept-impratio"].impratio
    formula = f"impratio over the {shipped:g} of the scene"
    raised = results.value("impratio_raised", formula, lambda impratio: impratio / shipped, high)
    off = departure(results, "rest_gain_off", "how far that is from how much impratio was raised", gain, raised)
    sizes = [
        results.value(f"rest_size_{case}", "size of the creep along the tool", abs, creep, unit="mm/s")
        for case, creep in zip(("before", "after"), creeps, strict=True)
    ]
    falls = greater(*sizes, noise=noise_floor(results, "drift_floor"))
    numbers = {"before": before, "after": after, "gain": gain, "raised": raised}
    yield Claim("rest_goes_with_impratio", all_of(at_most(off, 5.0, why="in proportion"), falls), numbers)


def _best_stays(results: Results, rows: Mapping[str, Row]) -> Claim:
    rounded, best = (rows[case].slip_mm for case in ("rounded", "best"))
    gain = ratio(results, "best_gain", "slip as shipped over that with all remedies", rounded, best)
    is_told = None not in (gain.value, gain.noise) and gain.noise < gain.value
    numbers = {"best": best, "rounded": rounded, "gain": gain, "is_told": is_told}
    return Claim("best_stays", settles(gain), numbers | {"duration": rows["best"].shake_duration_s})


def _draw(traces: Mapping[str, Series]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.6)
    for number, (case, trace) in enumerate(traces.items()):
        if trace.value is not None:
            moved = np.linalg.norm(trace.value[["x_mm", "y_mm", "z_mm"]], axis=1)
            place = (number / len(CASES) * 0.1, 0.1)
            axes.plot(trace.value["time_s"].iloc[1:], moved[1:], label=name_of(case), markevery=place)
    axes.set(yscale="log", ylabel="displacement [mm]", xlabel="time since the shake would begin [s]")
    axes.set_ylim(bottom=1e-3)
    drawing.legend(loc="outside upper center", ncols=2)
    return drawing
