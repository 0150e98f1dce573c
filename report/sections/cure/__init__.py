"""The cure: what each of its parts does, on which scenes, and what to use."""

from dataclasses import replace

from measured_report.files.root import ROOT
from measured_report.parts.section import Download, Section
from measured_report.values.results import Results
from report.sections.cure import bodies, budget, controls, limits, tumbles, turntable
from report.shared.arithmetic import joined

order = 141
page = "cure"
label = "the root cure"
leads = True
labels = {
    "steps-as-shipped-1-plain": "shipped pads, 1 substep",
    "steps-as-shipped-#-plain": "shipped pads, {} substeps",
    "steps-stiff-1-plain": "stiff pads, 1 substep",
    "steps-stiff-#-plain": "stiff pads, {} substeps",
    "ke-critical-#-#-plain": "pads' ke {}, kd = 2√ke, {} substeps",
    "ke-kd-#-#-#-plain": "pads' ke {1}, kd {0}, {2} substeps",
}

PARTS = (turntable, controls, limits, bodies, tumbles, budget)
"""The modules of its parts; the last one reads what the limits are."""


UPSTREAM = ("mujoco_warp-4.0.0-equality.patch", "mujoco_warp-4.0.0.patch", "newton-1.8.0.patch", "upstream.md")
FILES = [
    ROOT / f"experiments/simulation/{name}.py" for name in ("contact_bias", "contact_place", "compensated_positions")
]
FILES += [ROOT / f"assets/upstream/{name}" for name in UPSTREAM]


def derive(results: Results) -> Section:
    downloads = [Download(file.name, file.read_text(encoding="utf-8")) for file in FILES]
    return replace(joined([part.derive(results) for part in PARTS]), downloads=downloads)
