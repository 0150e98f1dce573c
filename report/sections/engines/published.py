"""Compare published numbers with ours. ``templates/sources.toml`` contains their links."""

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
    """A published number, and the cell that is compared with it.

    We assume that it is correct to half of its last digit, or to the noise of its
    source.
    """

    source: str
    quantity: str
    theirs: str
    case: str
    column: str
    section: str = "engines"
    noise: float = 0.0
    is_bound: bool = False  # a test passes below it

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
        "MotrixSim",
        "fall with a tenth more friction",
        "0.0",
        "friction-motrixsim",
        "fall_mm",
    ),
    # In its table, five cubes fell to the floor, by 150.5 to 153.5 mm.
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
    *(  # without the first rate, because the length of the capsule was fitted to it
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
    for number in PUBLISHED:
        ours = sections.cell(number.section, number.case, number.column)
        agrees = "" if ours.value is None else number.agrees(ours.value)
        name = f"{number.case}_{number.column}"
        published = constant(float(number.theirs), results.columns[number.column].unit)
        theirs = results.value(f"theirs_{name}", AS_PUBLISHED, published)
        cells: list[Quantity | str] = ["", "a bound"]
        if not number.is_bound:
            compared.append(ours)
            agreed.append(agrees is True)
            off = results.value(
                f"off_{name}",
                "absolute difference between the two numbers",
                abs(ours - theirs),
            )
            within = results.chosen(
                f"within_{name}",
                "half of the last digit, or the noise of the source",
                number.within,
                theirs.unit,
            )
            cells = [off, within]
        lines.append((number.quantity, theirs, ours, *cells, agrees))
    headings = ("quantity", "theirs", "ours", "difference", "tolerance", "agrees")
    columns = dict(zip(headings, zip(*lines, strict=True), strict=True))
    table = table_of("published by", [number.source for number in PUBLISHED], columns)
    agreeing = results.value(
        "agreeing", "numbers that agree", lambda *_: sum(agreed), *compared, across=True
    )
    count = results.value(
        "compared",
        "numbers compared with published ones",
        cell_count(compared),
        across=True,
    )
    are_most = 2 * sum(agreed) > len(agreed)
    claim = Claim(
        "as_others_published",
        at_least(agreeing, count),
        {"count": count, "agreeing": agreeing, "are_most": are_most},
    )
    return Section(tables={"published": table}, claims=[claim])
