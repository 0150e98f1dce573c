"""Show the effect of each part of the root cure on several scenes, and recommend a setup."""

from dataclasses import replace

from measured_report.files.root import ROOT
from report.sections.cure import bodies, budget, controls, limits, turntable
from report.shared import Results, Section, joined

order = 141
page = "cure"
label = "the root cure"
first = True
labels = {
    "steps-as-shipped-1-plain": "shipped pads, 1 substep",
    "steps-as-shipped-#-plain": "shipped pads, {} substeps",
    "steps-stiff-1-plain": "stiff pads, 1 substep",
    "steps-stiff-#-plain": "stiff pads, {} substeps",
    "ke-critical-#-#-plain": "pads' ke {}, kd = 2√ke, {} substeps",
    "ke-kd-#-#-#-plain": "pads' ke {1}, kd {0}, {2} substeps",
}

# These are complete paths, because the cache of a section depends on the files that its
# code names.
FILES = (
    "packages/contact-bias/contact_bias.py",
    "packages/contact-bias/contact_place.py",
    "experiments/simulation/compensated_positions.py",
    "packages/contact-bias/upstream/mujoco_warp-4.0.0-equality.patch",
    "packages/contact-bias/upstream/mujoco_warp-4.0.0.patch",
    "packages/contact-bias/upstream/mujoco_warp-4.0.0-plane-capsule.patch",
    "packages/contact-bias/upstream/newton-1.8.0.patch",
    "packages/contact-bias/upstream/upstream.md",
)


def derive(results: Results) -> Section:
    downloads = {
        file.name: file.read_text(encoding="utf-8")
        for file in map(ROOT.joinpath, FILES)
    }
    # The budget comes last, because it reads values of the limits.
    parts = (turntable, controls, limits, bodies, budget)
    return replace(
        joined([part.derive(results) for part in parts]), downloads=downloads
    )
