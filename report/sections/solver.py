"""Is it the solver? Its convergence, its treatment of friction, the time step, and MuJoCo's own remedy for slip."""

from collections.abc import Mapping

from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results
from report.shared.arithmetic import excess, largest_size
from report.shared.variants import variant_section

order = 50
reads = ("noise",)
label = "solver and time step"
labels = {
    "iterations-15": "shipped settings",
    "iterations-#": "{} iterations",
    "tolerance-#": "tolerance {}",
    "cone-pyramidal": "pyramidal cone",
    "as-shipped-warp-noslip": "shipped pads, MuJoCo Warp, noslip",
    "stiff-pads-warp-noslip": "stiff pads, MuJoCo Warp, noslip",
}

ENGINES = {"mujoco-c": "MuJoCo's C engine", "warp": "MuJoCo Warp"}
PADS = ("as-shipped", "stiff-pads")


def derive(results: Results) -> Section:
    changes = {}
    for case in (f"{pads}-{engine}" for engine in ENGINES for pads in PADS):
        formula = f"drift of {case} with noslip less that without, of that without"
        drifts = results.row[f"{case}-noslip"].drift_mm_s, results.row[case].drift_mm_s
        changes[case] = excess(results, f"{case}_change", formula, *drifts)
    remedies = (*changes, *(f"{case}-noslip" for case in changes))
    claims = [_noslip_does_not_help(results, engine, changes) for engine in ENGINES]
    return variant_section(results, "iterations-15", apart=remedies, claims=claims)


def _noslip_does_not_help(results: Results, engine: str, changes: Mapping[str, Value]) -> Claim:
    formula = f"larger change that noslip makes in a drift, in size, in {ENGINES[engine]}"
    of_engine = (changes[f"{pads}-{engine}"] for pads in PADS)
    largest = largest_size(results, f"{engine}_change", formula, of_engine, unit="%")
    drifts = {
        name + end: results.row[f"{pads}-{engine}{way}"].drift_mm_s
        for pads, end in zip(PADS, ("", "_stiff"), strict=True)
        for name, way in (("without", ""), ("treated", "-noslip"))
    }
    iterations = results.row[f"{PADS[0]}-{engine}-noslip"].noslip_iterations
    name, same = f"noslip_does_not_help_in_{engine.replace('-', '_')}", at_most(largest, 10.0, why="the same drift")
    return Claim(name, same, {"iterations": iterations, **drifts})
