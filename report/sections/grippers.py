"""Count the grasps that hold, creep and drop, with all kinds of pads and both engines."""

from collections.abc import Callable, Iterable
from functools import partial
from itertools import product
from statistics import median

from measured_report.files.columns import PLAIN
from report.shared import (
    PERCENT,
    Claim,
    Figure,
    Quantity,
    Results,
    Section,
    Table,
    Value,
    at_least,
    at_most,
    cell_count,
    gathered,
    greater,
    rows_with,
    table_of,
)
from report.shared.drawing import (
    INK,
    SHIPPED,
    STIFF,
    Drawing,
    draw_line,
    is_narrow,
    mark_points,
    name_lines,
    new_figure,
    plain_labels,
)

order = 186
page = "scenes"
label = "hands"
HANDS = {
    "franka": "Franka hand",
    "robotiq": "Robotiq 2F-85",
    "robotiq-v4": "Robotiq 2F-85 v4",
    "xarm": "xArm gripper",
    "umi": "UMI gripper",
    "so-arm100": "SO-ARM100",
    "viperx": "ViperX 300",
    "allegro": "Allegro hand",
    "leap": "LEAP hand",
    "shadow": "Shadow hand",
}
MARKERS = {"cube": "s", "can": "o", "cup": "^"}
PADS = {  # labels and colours of settings
    "published": ("as published", SHIPPED),
    "firm": ("stiff pads, elliptic cone, impratio 50", STIFF),
}
C, RULE, FIRM = (f"{pads}-c" for pads in ("published", "rule", "firm"))
WARP, FIRM_WARP = (f"{pads}-warp" for pads in PADS)
STILL_MM = 1.0
LOST_MM = 20.0  # the record does not distinguish longer distances
VERDICTS = ("holds", "creeps", "drops")


def derive(results: Results) -> Section:
    measured = {
        column: {row.case: row[column] for row in rows_with(results, column)}
        for column in ("moved_mm", "creep_mm_s")
    }
    moved = measured["moved_mm"]
    grasps = [
        grasp
        for grasp in map("-".join, product(HANDS, MARKERS))
        if all(f"{grasp}-{name}" in moved for name in (C, RULE, FIRM, WARP, FIRM_WARP))
    ]
    still = results.chosen(
        "still", "an object that moves less counts as held", STILL_MM, "mm"
    )
    far = results.chosen(
        "far", "an object that moves this far counts as dropped", LOST_MM, "mm"
    )

    def cells(*settings: str, column: str = "moved_mm") -> list[Quantity]:
        found = measured[column]
        return [found[f"{grasp}-{name}"] for grasp in grasps for name in settings]

    def count(
        name: str,
        words: str,
        is_so: Callable[..., bool],
        *settings: str,
        column: str = "moved_mm",
    ) -> Value:
        """Derive the number of grasps whose numbers in a column meet a condition."""

        def counted(mm: Iterable[float]) -> int:
            groups = zip(*[iter(mm)] * len(settings), strict=True)
            return sum(is_so(*group) for group in groups)

        found = cells(*settings, column=column)
        return results.value(name, words, gathered(counted, found, PLAIN))

    def cured(published: float, other: float) -> bool:
        return other < STILL_MM <= published

    def agrees(in_c: float, in_warp: float) -> bool:
        return _verdict(in_c) == _verdict(in_warp)

    def share(name: str, part, whole):
        return results.value(name, "share of these grasps", PERCENT * part / whole)

    every = results.value("grasps", "hands times objects", cell_count(cells(C)))
    moving = count(
        "moving", "grasps in which the object moves", lambda mm: mm >= STILL_MM, C
    )
    lost = count("lost", "grasps that drop the object", lambda mm: mm >= LOST_MM, C)
    by_rule = count("by_rule", "grasps that hold only by the rule", cured, C, RULE)
    same = count(
        "same",
        "grasps that the rule does not change, judged by the creep at rest",
        lambda a, b: a == b,
        C,
        RULE,
        column="creep_mm_s",
    )
    by_firm = count("by_firm", "grasps that only firm pads hold", cured, C, FIRM)
    spoiled = count("spoiled", "grasps that firm pads do not hold", cured, FIRM, C)
    agreed = count(
        "agreed", "grasps with the same verdict in both engines", agrees, C, WARP
    )
    agreed_firm = count(
        "agreed_firm",
        "grasps with the same verdict in both engines and firm pads",
        agrees,
        FIRM,
        FIRM_WARP,
    )
    agreed_share = share("agreed_share", agreed, every)
    before, after = (
        results.value(f"median_{name}", "median motion", gathered(median, cells(name)))
        for name in (C, FIRM)
    )
    common = {"moving": moving, "count": every}
    half = "most of them"
    claims = [
        Claim(
            "moves",
            at_least(share("moving_share", moving, every), 50.0, half),
            common | {"lost": lost, "bound": still, "median": before},
        ),
        Claim(
            "rule_cures",
            at_least(share("rule_share", by_rule, moving), 50.0, half),
            {"cured": by_rule, "moving": moving},
        ),
        Claim(
            "firm_cures",
            at_least(share("firm_share", by_firm, moving), 50.0, half),
            {"cured": by_firm, "moving": moving},
        ),
        Claim("firm_calms", greater(before, after), {"before": before, "after": after}),
        Claim(
            "firm_spoils_none",
            at_most(spoiled, 0.0, "all of them"),
            {"spoiled": spoiled},
        ),
        Claim("engines_agree", at_least(agreed_share, 80.0, "nearly all")),
    ]
    verdicts = {
        f"{kind}, {words}": [
            _told(moved.get(f"{hand}-{kind}-{pads}-c")) for hand in HANDS
        ]
        for (pads, words), kind in product(
            {"published": "published", "firm": "firm"}.items(), MARKERS
        )
    }
    columns = {
        "as published": C,
        "rule": RULE,
        "firm": FIRM,
        "published, Warp": WARP,
        "firm, Warp": FIRM_WARP,
    }
    rows = {
        heading: [moved[f"{grasp}-{name}"] for grasp in grasps]
        for heading, name in columns.items()
    }
    counts: dict[str, list] = {
        verdict: [
            count(
                f"{name}_{verdict}",
                f"grasps with the verdict {verdict}",
                partial(_has_verdict, verdict),
                name,
            )
            for name in (C, RULE, FIRM)
        ]
        for verdict in VERDICTS
    }
    counts["had this timeconst before"] = ["n/a", same, same]
    counts["same verdict in MuJoCo Warp"] = [agreed, "not run", agreed_firm]
    figure = Figure(lambda: _draw(moved), [*moved.values()], {"bound": still})
    return Section(
        tables={
            "verdicts": table_of(
                "hand", HANDS.values(), verdicts, bound=still, far=far
            ),
            "counts": table_of(
                "settings", ["published", "stiff pads alone", "firm"], counts
            ),
            "moved": table_of("grasp", map(_name_of, grasps), rows),
            "costs": _costs(results),
        },
        figures={"moved": figure},
        claims=claims,
    )


def _costs(results: Results) -> Table:
    """Return a table of the run times with the cube in each hand."""
    times = {row.case: row.ms_per_s for row in rows_with(results, "ms_per_s")}
    settings = {
        f"{pads}, {name}": f"{pads}-{engine}"
        for engine, name in {"c": "C", "warp": "Warp"}.items()
        for pads in PADS
    }
    columns = {
        heading: [times.get(f"{hand}-cube-{name}/time", "not timed") for hand in HANDS]
        for heading, name in settings.items()
    }
    return table_of("hand", HANDS.values(), columns)


def _name_of(grasp: str) -> str:
    hand, _, kind = grasp.rpartition("-")
    return f"{HANDS[hand]}, {kind}"


def _verdict(moved_mm: float) -> str:
    return VERDICTS[(moved_mm >= STILL_MM) + (moved_mm >= LOST_MM)]


def _has_verdict(verdict: str, moved_mm: float) -> bool:
    return _verdict(moved_mm) == verdict


def _told(cell: Quantity | None) -> str:
    return _verdict(cell.value) if cell else "not measured"


def _draw(moved: dict[str, Quantity]) -> Drawing:
    drawing, axes = new_figure(7.2, 5.0)
    for (pads, (words, color)), (kind, marker) in product(
        PADS.items(), MARKERS.items()
    ):
        offset = 0.15 if pads == "firm" else -0.15
        places = [
            (cell.value, line + offset)
            for line, hand in enumerate(HANDS)
            if (cell := moved.get(f"{hand}-{kind}-{pads}-c"))
        ]
        mark_points(axes, places, color=color, marker=marker, label=f"{kind}, {words}")
    draw_line(axes, [STILL_MM] * 2, [-0.5, len(HANDS) - 0.5], color=INK, linewidth=0.8)
    name_lines(axes, HANDS.values())
    axes.set(xscale="log", xlabel="motion of the object in the hand [mm]")
    axes.xaxis.set_major_formatter(plain_labels())
    drawing.legend(loc="outside upper center", ncols=1 if is_narrow() else 2)
    return drawing
