"""Compare the slips with contacts from another engine, at other rates and on other shapes."""

from report.shared import Results, Section, by_case, variants_claim

order = 30
folded = True
reads = ("reproduction",)
label = "contact points"
labels = {
    "contacts-#hz": "contacts at {} Hz",
    "contacts-mujoco": "contacts found by MuJoCo",
    "engine-mujoco-c": "MuJoCo's C engine",
    "pads-convex-mesh": "pads as convex meshes",
}


def derive(results: Results) -> Section:
    cases = by_case(results.rows, {"slip": "slip_mm", "drift": "drift_mm_s"})
    claim = variants_claim(results, "contacts-60hz")
    return Section(tables={"cases": cases}, claims=[claim])
