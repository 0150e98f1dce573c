"""Numbers that others published, beside ours; ``templates/sources.toml`` has their links."""

from dataclasses import dataclass
from decimal import Decimal

from report.sections.scenes.capsule import PUBLISHED_MM_S, VARIANTS
from report.shared import (
    AS_PUBLISHED,
    Claim,
    Quantity,
    Results,
    Section,
    Sections,
    at_least,
    cell_count,
    constant,
    table_of,
)


@dataclass(frozen=True)
class Published:
    """A number as it was published, and where ours is.

    Half of its last digit counts, unless its source shows noise.
    """

    source: str
    what: str
    theirs: str
    case: str
    column: str
    section: str = "engines"
    noise: float = 0.0
    is_bound: bool = False  # a test passes what is below it

    @property
    def within(self) -> float:
        return self.noise or 0.5 * 10.0 ** int(Decimal(self.theirs).as_tuple().exponent)

    def agrees(self, ours: float) -> bool:
        over = ours - float(self.theirs)
        return over <= 0.0 if self.is_bound else abs(over) <= self.within


PUBLISHED = (
    Published(
        "MotrixSim",
        "friction that just holds",
        "0.0902",
        "friction-motrixsim",
        "critical_friction",
    ),
    Published(
        "MotrixSim", "fall with a tenth more", "0.0", "friction-motrixsim", "fall_mm"
    ),
    # By its table five cubes fell to the floor, by 150.5 to 153.5 mm.
    Published(
        "MotrixSim",
        "the same, MuJoCo C, Euler",
        "150.5",
        "friction-euler",
        "fall_mm",
        noise=3.0,
    ),
    Published(
        "MotrixSim",
        "the same, implicitfast",
        "11.3",
        "friction-implicitfast",
        "fall_mm",
    ),
    Published(
        "phys-bench", "drops of a cube, MotrixSim", "0", "shake-cube", "dropped_count"
    ),
    Published(
        "phys-bench", "drops of a ball, MotrixSim", "0", "shake-ball", "dropped_count"
    ),
    Published("Genesis", "creep at a wall, MuJoCo C", "4.5", "wall-c", "creep_mm_s"),
    Published("Genesis", "the same, MuJoCo Warp", "4.5", "wall-warp", "creep_mm_s"),
    *(  # Without the first rate of these: the capsule is as long as makes it come out.
        Published(
            "MuJoCo issue",
            f"capsule, {VARIANTS[name]}",
            str(rate),
            f"{name}-c",
            "creep_mm_s",
            "scenes",
        )
        for name, rate in list(PUBLISHED_MM_S.items())[1:]
    ),
    Published(
        "FET005",
        "drop in holds and an orbit",
        "100",
        "orbit",
        "creep_mm",
        is_bound=True,
    ),
    Published(
        "FET028", "slip in a shake", "30", "fet028-pad-kd-100", "slip_mm", is_bound=True
    ),
)


def derive(results: Results) -> Section:
    sections = Sections({**results.others, results.record.section: results})
    lines = []
    compared = []
    agreed = []
    for each in PUBLISHED:
        ours = sections.cell(each.section, each.case, each.column)
        agrees = "" if ours.value is None else each.agrees(ours.value)
        name = f"{each.case}_{each.column}"
        published = constant(float(each.theirs), results.columns[each.column].unit)
        theirs = results.value(f"theirs_{name}", AS_PUBLISHED, published)
        cells: list[Quantity | str] = ["", "a bound"]
        if not each.is_bound:
            compared.append(ours)
            agreed.append(agrees is True)
            off = results.value(
                f"off_{name}", "ours less theirs, in size", abs(ours - theirs)
            )
            within = results.chosen(
                f"within_{name}",
                "half the last digit, or noise of the source",
                each.within,
                theirs.unit,
            )
            cells = [off, within]
        lines.append((each.what, theirs, ours, *cells, agrees))
    above = ("what", "theirs", "ours", "off by", "within", "agrees")
    columns = dict(zip(above, zip(*lines, strict=True), strict=True))
    table = table_of("published by", [each.source for each in PUBLISHED], columns)
    agreeing = results.value(
        "agreeing", "how many agree", lambda *_: sum(agreed), *compared, across=True
    )
    count = results.value(
        "compared", "numbers beside published ones", cell_count(compared), across=True
    )
    are_most = 2 * sum(agreed) > len(agreed)
    claim = Claim(
        "as_others_published",
        at_least(agreeing, count),
        {"count": count, "agreeing": agreeing, "are_most": are_most},
    )
    return Section(tables={"published": table}, claims=[claim])
