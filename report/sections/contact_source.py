"""The slip with contacts from another engine, at other rates, and on other shapes."""

from dataclasses import replace

from report.shared import Results, Section, by_case, variant_section, variants_of

order = 30
reads = ("reproduction",)
label = "contact points"
labels = {
    "contacts-#hz": "contacts at {} Hz",
    "contacts-mujoco": "contacts found by MuJoCo",
    "engine-mujoco-c": "MuJoCo's C engine",
    "pads-convex-mesh": "pads as convex meshes",
}


def derive(results: Results) -> Section:
    section = variant_section(results, variants_of(results, "contacts-60hz"))
    return replace(
        section,
        tables={
            "cases": by_case(results.rows, {"slip": "slip_mm", "drift": "drift_mm_s"})
        },
    )
