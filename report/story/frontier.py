"""Draw slip against run time for engines and remedies, and recommend a setup."""

import math
from dataclasses import dataclass, replace
from typing import Any

from markupsafe import Markup

from report.shared import (
    FAILS,
    HOLDS,
    SLOWER,
    TIMED_WORLDS,
    Claim,
    Outcome,
    Quantity,
    Sections,
    all_of,
    at_least,
    at_most,
    decided,
    greater,
)

ALONE = TIMED_WORLDS[0]
MANY = TIMED_WORLDS[-1]
NOTHING, ARGUMENT, SOLVER, PATCH = range(4)  # effort of a setup; advice prefers less


@dataclass(frozen=True)
class Setup:
    """Settings and an engine with which the cube is shaken."""

    name: str
    effort: int
    run: str  # section and case of its slip
    # Section and variant of its run time, relative to MuJoCo Warp as shipped.
    timed: str

    def slip(self, sections: Sections, column: str = "slip_mm") -> Quantity:
        section, _, case = self.run.partition("/")
        return sections.cell(section, case, column)

    def is_offered(self, sections: Sections) -> bool:
        """Return whether a release contains this setup.

        This is false if the release does not have the solver.
        """
        section, _, variant = self.timed.partition("/")
        cases = [row.case for row in sections.rows(section)]
        is_there = any(case.startswith(f"{variant}-") for case in cases)
        return is_there or not (self.is_other and cases)

    def keeps(self, sections: Sections, bound: Quantity) -> Outcome:
        """Test whether the slip stays below a bound.

        In another solver the slip without weight has to stay below the bound as well,
        and the hand has to move about as far as in MuJoCo Warp.
        """
        section, _, case = self.run.partition("/")
        variant = self.timed.partition("/")[2]
        cases = [case, f"{variant}-3cm"] if self.is_other else [case]
        runs = [row.plain for row in sections.rows(section) if row.case in cases]
        # In another solver a failed run is a finding about that solver.
        ends = ("dropped", "failure") if self.is_other else ("dropped",)
        slip = self.slip(sections)
        if any(run.get(end) for run in runs for end in ends):
            return FAILS.having_read(slip)
        tests = [at_most(slip, bound)]
        if self.is_other:
            slip = sections.cell(section, f"{variant}-3cm", "slip_mm")
            hand = sections.value(section, f"{variant}_hand")
            as_far = sections.value(section, "as_far")
            tests += [at_most(slip, bound), at_most(hand, as_far)]
        return all_of(*tests)

    @property
    def is_other(self) -> bool:
        """Return whether the setup uses a solver other than MuJoCo's."""
        return self.effort == SOLVER

    def ratios(self, sections: Sections) -> dict[int, Quantity]:
        """Return the run times by number of worlds, relative to MuJoCo Warp as shipped."""
        section, _, name = self.timed.partition("/")
        names = {name, f"{name}-only", f"{name}-{MANY}"}
        times = {}
        for row in sections.rows(section):
            if names & {row.case, row.plain.get("variant")}:
                for column in ("frame_ratio", "time_ratio"):
                    if column in row and row[column].value is not None:
                        times[row.plain.get("worlds", ALONE)] = row[column]
        return {count: times[count] for count in (ALONE, MANY) if count in times}


def _solver(name: str, variant: str = "", section: str = "newton_solvers") -> Setup:
    run = f"{section}/{variant or name.lower()}"
    return Setup(name, SOLVER, f"{run}-weight", run)


SETUPS = (
    Setup(
        "as shipped",
        NOTHING,
        "reproduction/as-shipped",
        "cure_cost/as-shipped",
    ),
    Setup("stiff pads", ARGUMENT, "reproduction/stiff-pads", "speed/stiff-pads"),
    Setup(
        "64 substeps",
        ARGUMENT,
        "time_step/newton-elliptic/shipped/substeps-64",
        "step_cost/stiff/substeps-64",
    ),
    *(
        Setup(
            f"{substeps} substeps and matching stiff pads",
            ARGUMENT,
            f"time_step/newton-elliptic/kd-1/substeps-{substeps}",
            f"step_cost/stiff/substeps-{substeps}",
        )
        for substeps in (32, 64)
    ),
    Setup(
        "RK4",
        ARGUMENT,
        "cure/newton-rk4-50-shipped-3cm-plain-rounded",
        "error_runtime/as-shipped/newton-rk4/substeps-16",
    ),
    Setup(
        "RK4 with stiff pads",
        ARGUMENT,
        "cure/newton-rk4-50-stiff-3cm-plain-rounded",
        "error_runtime/stiff/newton-rk4/substeps-16",
    ),
    _solver("Steel"),
    _solver("Steel, no anchors", "steel-points"),
    _solver("Kamino"),
    _solver("Kamino, DVI", "dvi", "kamino"),
    _solver("Kamino, LOX", "lox", "kamino"),
    _solver("XPBD"),
    _solver("VBD"),
    Setup(
        "the term",
        PATCH,
        "cure/newton-implicitfast-50-shipped-3cm-term-rounded",
        "cure_cost/term",
    ),
    Setup(
        "the term with RK4",
        PATCH,
        "cure/newton-rk4-50-shipped-3cm-term-rounded",
        "cure_cost/term-rk4",
    ),
    Setup(
        "the root cure with shipped pads",
        PATCH,
        "cure/newton-euler-400-shipped-3cm-full-kept",
        "cure_cost/best",
    ),
    Setup(
        "the root cure with stiff pads",
        PATCH,
        "cure/newton-implicitfast-400-stiff-3cm-centred-kept",
        "cure_cost/firm",
    ),
)
BOUNDS = {
    "advice": ("reproduction", "slip_bound"),
    "ends_creep": ("newton_solvers", "ended_bound"),
}
NUMBERS = (
    *("way", "slip", "ratio", "many", "off", "elsewhere", "faster"),
    *("is_argument", "is_other"),
    *("patch", "patch_slip", "patch_ratio", "patch_many", "has_patch"),
)
"""Names that the wording of the advice can print, which are empty without advice."""


def advice(sections: Sections, by_release: dict[str, Sections]) -> list[Claim]:
    """Recommend a setup for each bound: a visible slip, and a tenth of it."""
    return [
        _advised(sections, name, sections.value(*bound), by_release)
        for name, bound in BOUNDS.items()
    ]


def _unmeasured(
    sections: Sections,
    tests: dict[Setup, Outcome],
    times: dict[Setup, Quantity],
    effort: int,
) -> Outcome | None:
    """Return unknown if a setup that could be recommended was not measured.

    Without this test, missing data could lead to the recommendation of a more expensive
    setup.
    """
    fastest = min(
        (time.number for setup, time in times.items() if setup.effort == effort),
        default=math.inf,
    )
    for setup, test in tests.items():
        is_untimed = test == HOLDS and setup not in times
        is_unknown = test.name == "unknown" and not test.is_inconclusive
        if not (is_untimed or is_unknown) or setup.effort > effort:
            continue
        time = setup.ratios(sections).get(ALONE)
        is_slower = time is not None and time.number >= fastest
        is_slower = is_slower or fastest <= 1 + 0.01 * SLOWER[1]
        if (setup.effort == effort and is_slower) or not setup.is_offered(sections):
            continue
        verb = "timed" if is_untimed else "measured"
        reason = f"{setup.name}, which may be cheaper, was not {verb}"
        if is_unknown:
            reason += f" ({test.reason})"
        section = (setup.timed if is_untimed else setup.run).partition("/")[0]
        if "make rerun" not in reason:
            reason += f"; make rerun SECTION={section} measures it"
        return Outcome("unknown", reason, reads=test.reads)
    return None


def _fastest(setups: list[Setup], times: dict[Setup, Quantity]) -> Setup:
    """Return the first timed setup that cannot be distinguished from the fastest one."""
    timed = [setup for setup in setups if setup in times]
    fastest = min((times[setup] for setup in timed), key=lambda time: time.number)
    return next(
        setup
        for setup in timed
        if times[setup] is fastest or not (times[setup] - fastest).is_distinct
    )


def _faster(sections: Sections, setup: Setup, time: Quantity) -> Quantity | str:
    """Return the speed-up of a setup, or an empty text if it may not be faster."""
    section, _, variant = setup.timed.partition("/")
    speedup = sections.value(section, f"{variant}_speedup")
    return speedup if greater(1.0, time, "as fast") == HOLDS and speedup.value else ""


def _advised(
    sections: Sections, name: str, bound: Quantity, by_release: dict[str, Sections]
) -> Claim:
    """Recommend the fastest setup of the least effort that keeps the slip below a bound."""
    numbers: dict[str, Any] = dict.fromkeys(NUMBERS, "") | {"bound": bound}
    tests = {setup: setup.keeps(sections, bound) for setup in SETUPS}
    holding = [setup for setup, test in tests.items() if test == HOLDS]
    ratios = {setup: setup.ratios(sections) for setup in holding}
    times = {setup: ratio[ALONE] for setup, ratio in ratios.items() if ALONE in ratio}
    effort = min((setup.effort for setup in holding), default=PATCH)
    least = [setup for setup in holding if setup.effort == effort]
    if lack := _unmeasured(sections, tests, times, effort):
        return Claim(name, lack, numbers)
    near = [
        test
        for setup, test in tests.items()
        if test.is_inconclusive and ARGUMENT <= setup.effort < effort
    ]
    least = [setup for setup in least if setup in times]
    if near or not least:
        reason = bound.reason or "no setup that was tried keeps the slip this small"
        outcome = near[0] if near else Outcome("unknown", reason)
        return Claim(name, outcome, numbers)

    setup = _fastest(least, times)
    section, _, variant = setup.timed.partition("/")
    off = sections.cell(section, f"{variant}-3cm", "wander_mm")
    exceeding = []  # slips above the bound in other releases
    for release, findings in by_release.items() if setup.is_other else ():
        slip = setup.slip(findings)
        if slip.value is not None and slip.value > bound.number:
            exceeding.append((slip, release))
    elsewhere = Markup(", ").join(
        Markup("{} in {}").format(slip, release) for slip, release in exceeding
    )
    numbers |= {
        "way": setup.name,
        "slip": setup.slip(sections),
        "ratio": times[setup],
        "many": ratios[setup].get(MANY, ""),
        "off": off if at_least(off, bound) == HOLDS else "",
        "elsewhere": elsewhere,
        "is_argument": setup.effort != NOTHING,
        "is_other": setup.is_other,
        "faster": _faster(sections, setup, times[setup]),
    }
    patches = [setup for setup in times if setup.effort == PATCH]
    if patches:
        patch = _fastest(patches, times)
        numbers |= {
            "patch": patch.name,
            "patch_slip": patch.slip(sections),
            "patch_ratio": times[patch],
            "patch_many": ratios[patch].get(MANY, ""),
            "has_patch": True,
        }
    # Each number is read in a test of its own, because a test of numbers from several
    # machines cannot tell.
    cells = [
        off,
        *(slip for slip, _ in exceeding),
        *(setup.slip(sections) for setup in SETUPS),
    ]
    cells = [cell for cell in cells if cell.value is not None]
    cells += [
        *ratios[setup].values(),
        *(times[other] for other in (*least, *patches) if other in times),
        bound,
    ]
    outcome = all_of(*(decided(setup.effort != PATCH, cell) for cell in cells))
    # A setup that does not hold, or whose test misses a number, changes the advice as well.
    reads = outcome.reads.union(*(test.reads for test in tests.values()))
    return Claim(name, replace(outcome, reads=reads), numbers)
