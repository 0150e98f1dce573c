"""Does MuJoCo's own remedy for slip help? With noslip and without, in C and, where it is there, in Warp."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results
from report.shared.arithmetic import excess, largest_size, told

order = 75
page = "cause"
label = "noslip"

ENGINES = {"mujoco-c": "MuJoCo's C engine", "warp": "MuJoCo Warp"}
PADS = ("as-shipped", "stiff-pads")


def derive(results: Results) -> Section:
    cases = [f"{pads}-{engine}" for engine in ENGINES for pads in PADS]
    without, treated = [results.row[case] for case in cases], [results.row[f"{case}-noslip"] for case in cases]
    changes = {}
    for case, row, found in zip(cases, without, treated, strict=True):
        formula = f"drift of {case} with noslip less that without, of that without"
        changes[case] = excess(results, f"{case}_change", formula, found.drift_mm_s, row.drift_mm_s)
    return Section(claims=[_does_not_help(results, engine, changes) for engine in ENGINES])


def _does_not_help(results: Results, engine: str, changes: Mapping[str, Value]) -> Claim:
    formula = f"larger change that noslip makes in a drift, in size, in {ENGINES[engine]}"
    of_engine = (changes[f"{pads}-{engine}"] for pads in PADS)
    largest = largest_size(results, f"{engine}_change", formula, of_engine, unit="%")
    drifts = {
        name + end: results.row[f"{pads}-{engine}{way}"].drift_mm_s
        for pads, end in zip(PADS, ("", "_stiff"), strict=True)
        for name, way in (("without", ""), ("treated", "-noslip"))
    }
    return Claim(
        f"noslip_does_not_help_in_{engine.replace('-', '_')}",
        at_most(largest, 10.0, why="it is the same drift"),
        {"iterations": results.row[f"{PADS[0]}-{engine}-noslip"].noslip_iterations, **told(largest, drifts)},
    )
