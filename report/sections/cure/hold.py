"""A minute with the arm held still: what creeps once positions are summed with what rounding takes from them kept?"""

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.shared.arithmetic import ratio, share


def derive(results: Results) -> Section:
    before, after, best = (results.row[case] for case in ("rounded", "kept", "best"))
    kept = after.increment_final_mm
    bound = results.chosen("creep_bound", "a millimetre or so in a minute", 0.02, unit="mm")
    formula = "slip with positions rounded over that with compensated ones"
    gain = ratio(results, "kept_gain", formula, before.slip_mm, after.slip_mm)
    rest = share(results, "best_share", "of the former slip, that with the cure", best.slip_mm, before.slip_mm)
    outcome = all_of(
        at_most(kept, bound), at_least(gain, 2.0, why="less by half"), at_most(rest, 50.0, why="less by half")
    )
    numbers = {"slip": before.slip_mm, "slip_kept": after.slip_mm, "best": best.slip_mm}
    return Section(claims=[Claim("compensation_helps", outcome, numbers | {"duration": before.shake_duration_s})])
