"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure as Drawing

from experiments.facts.case import AS_SHIPPED
from measured_report.files.root import ROOT
from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import SERIES, new_figure
from measured_report.parts.section import Download, Figure, Section
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import departure, noise_floor, ratio, settles
from report.shared.drawing import CURE, SHIPPED

POSITIONS_FILE = ROOT / "experiments/simulation/compensated_positions.py"
CASES = ("rounded", "kept", "kept-impratio", "best")
DRAWN = {
    "rounded": ("as shipped", SHIPPED),
    "rounded-impratio": ("high impratio", SERIES[4]),
    "kept": ("compensated positions", SERIES[5]),
    "best": ("the whole cure", CURE),
}
"""Name and colour of each trace that is drawn."""


def derive(results: Results) -> Section:
    rows = {case: results.row[case] for case in CASES}
    traces = {case: results.trace(case) for case in DRAWN}
    helps, stays = _compensation_helps(results, rows), _best_stays(results, rows)
    numbers = {case: rows[case].slip_mm for case in ("rounded", "kept", "best")}
    numbers |= {"duration": rows["rounded"].shake_duration_s, "stays": all_of(helps.outcome, stays.outcome) == HOLDS}
    return Section(
        figures={"motion": Figure(lambda: _draw(traces), list(traces.values()), numbers)},
        claims=[helps, _impratio_takes_the_rest(results, rows), stays],
        downloads=[Download(POSITIONS_FILE.name, POSITIONS_FILE.read_text(encoding="utf-8"))],
    )


def _compensation_helps(results: Results, rows: Mapping[str, Row]) -> Claim:
    floor = noise_floor(results, "slip_floor")
    before, after = rows["rounded"], rows["kept"]
    rounded, kept = before.increment_final_mm, after.increment_final_mm
    bound = results.chosen("creep_bound", "a millimetre or so in a minute", 0.02, unit="mm")
    formula = "slip with positions rounded over that with compensated ones"
    gain = ratio(results, "kept_gain", formula, before.slip_mm, after.slip_mm)
    outcome = all_of(greater(rounded, kept, noise=floor), at_most(kept, bound), at_least(gain, 2.0, why="less by half"))
    numbers = {"rounded": rounded, "kept": kept, "slip": before.slip_mm, "slip_kept": after.slip_mm}
    numbers |= {"duration": before.shake_duration_s}
    return Claim("compensation_helps", outcome, numbers)


def _impratio_takes_the_rest(results: Results, rows: Mapping[str, Row]) -> Claim:
    """Tell that what compensated positions leave goes with impratio.

    Regularization under load is in proportion to 1 / impratio, and nothing else of what is left is.
    """
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
    return Claim("rest_goes_with_impratio", all_of(at_most(off, 5.0, why="in proportion"), falls), numbers)


def _best_stays(results: Results, rows: Mapping[str, Row]) -> Claim:
    rounded, best = (rows[case].slip_mm for case in ("rounded", "best"))
    return Claim("best_stays", settles(rounded, best), {"best": best, "rounded": rounded})


def _draw(traces: Mapping[str, Series]) -> Drawing:
    drawing, axes = new_figure(7.2, 3.2)
    for number, (case, (name, colour)) in enumerate(DRAWN.items()):
        if (trace := traces[case].value) is not None:
            shown = trace.iloc[1 :: max(1, len(trace) // 400)]
            moved = np.linalg.norm(shown[["x_mm", "y_mm", "z_mm"]], axis=1)
            axes.plot(shown["time_s"], moved, color=colour, label=name, markevery=(0.03 * number, 0.12))
    axes.set(yscale="log", ylabel="the cube has crept [mm]", xlabel="time held still [s]")
    axes.set_ylim(bottom=1e-3)
    drawing.legend(loc="outside upper center", ncols=4)
    return drawing
