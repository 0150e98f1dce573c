"""What a new release changes: numbers, claims, and the contact rows that say why."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from report.claims import FAILS, HOLDS, Claim, Outcome, at_least, at_most
from report.compare import is_beyond
from report.figures import new_figure
from report.parts import Figure, Section, Table
from report.quantities import Quantity, Value
from report.results import Results
from report.sections._common import all_of
from report.sections._releases import Headline, Releases, TurnList, cell, change, floor, marked, turns

order = 200

SHIPPED, TAKEN, GIVEN, SWITCHED = (
    "as-shipped",
    "as-shipped-friction-timeconst-off",
    "as-shipped-friction-timeconst-on",
    "as-shipped-kf-off",
)
"""Cases of this section: the scene, and with the time constant of the friction rows taken away, given, switched off."""
SLIP = Headline("slip as shipped", "upgrade", SHIPPED, "slip_mm", "mm")
MUJOCO_CONTACTS = Headline(
    "slip with contacts found by MuJoCo", "upgrade", "as-shipped-mujoco-contacts", "slip_mm", "mm"
)
MUJOCO_C = Headline("slip in MuJoCo's C engine", "reproduction", "as-shipped-mujoco-c", "slip_mm", "mm")
HEADLINES = (
    SLIP,
    Headline("drift as shipped", "upgrade", SHIPPED, "drift_mm_s", "mm/s"),
    Headline("slip with stiff pads", "upgrade", "stiff-pads", "slip_mm", "mm"),
    Headline("slip with the arm held still", "upgrade", "hold", "slip_mm", "mm"),
    MUJOCO_CONTACTS,
    MUJOCO_C,
    Headline("slip with ke raised alone", "stiffness", "pad-ke-2.5e6-kd-100", "slip_mm", "mm"),
    Headline("slip with equal priorities", "priority", "priority-0", "slip_mm", "mm"),
    Headline("slip with no contact gap", "gap", "all-gaps-zero", "slip_mm", "mm"),
    Headline("slip of the fixed scene", "fix", "fixed", "slip_mm", "mm"),
)
SPEEDS = (
    Headline("a frame as shipped", "speed", SHIPPED, "frame_ms", "ms"),
    Headline("a frame of the fixed scene", "speed", "fixed", "frame_ms", "ms"),
    Headline("a frame of the most worlds", "scaling", "worlds-16384", "frame_ms", "ms"),
)
EDGES = ("_p5", "_p95")
"""Ends of the columns that say how far the time of a frame spreads."""
FLOORS = {"mm": "slip_floor", "mm/s": "drift_floor"}
LIVE = {
    "timeconst_s": ("time constant", "s"),
    "dampratio": ("damping ratio", "1"),
    "friction_timeconst_s": ("friction rows' own time constant", "s"),
    "friction_dampratio": ("friction rows' own damping ratio", "1"),
    "friction_damping_per_s": ("friction rows' damping, measured", "1/s"),
    "friction": ("friction", "1"),
    "dmin": ("dmin", "1"),
    "dmax": ("dmax", "1"),
    "dim": ("rows a contact", "1"),
    "peak_contact_count": ("most contacts", "1"),
}
"""Columns that say what a live contact of the scene as shipped has."""
TRIED = {
    SHIPPED: "as shipped",
    TAKEN: "friction rows' time constant taken out",
    GIVEN: "two substeps written into it",
    SWITCHED: "switched off: kf below zero",
    "as-shipped-kf-100": "kf 100",
    "as-shipped-kf-30": "kf 30",
    "as-shipped-kf-10": "kf 10",
    "as-shipped-kf-3": "kf 3",
    "as-shipped-mujoco-contacts": "contacts found by MuJoCo",
    "stiff-pads": "stiff pads",
    "stiff-pads-kf-off": "stiff pads, kf below zero",
    "stiff-pads-mujoco-contacts": "stiff pads, contacts found by MuJoCo",
    "hold": "arm held still",
    "hold-kf-off": "arm held still, kf below zero",
}


SETTINGS = {"option": "solver option", "default": "default", "sum": "sum of the engine's"}
"""Kinds of rows that are no runs: each has a name and a value."""


def derive(results: Results, releases: Releases) -> Section:
    floors = {unit: floor(results, releases, name, unit) for unit, name in FLOORS.items()}
    turned = turns(releases)
    ends = _Ends(releases)
    tables = {
        "headlines": _headline_table(results, releases, floors),
        "turns": TurnList(turned, list(results.others)),
        "live": _live_table(releases),
        "tried": _tried_table(releases),
        "speed": _speed_table(results, releases),
        "options": _option_table(releases),
    }
    slips = [cell(releases, release, headline) for headline in HEADLINES[:1] + HEADLINES[2:6] for release in releases]
    figure = Figure(
        draw=lambda: _draw_slips(releases),
        caption="The slip by release, on a logarithmic axis.",
        alt="; ".join(f"Newton {release}: {cell(releases, release, SLIP)} as shipped" for release in releases),
        sources=slips,
    )
    return Section(
        tables=tables,
        figures={"slips": figure},
        claims=[
            _slip_is_the_same(results, ends, floors["mm"]),
            _in_one_step(results, releases, floors["mm"]),
            _claims_stand(results, turned, list(releases)),
            *_cause_claims(results, ends),
            _same_speed(results, ends),
        ],
    )


@dataclass(frozen=True)
class _Ends:
    """The oldest and the newest release that has results, between which changes are told."""

    releases: Releases

    @property
    def old(self) -> str:
        return next(iter(self.releases))

    @property
    def new(self) -> str:
        return next(reversed(self.releases))

    @property
    def one(self) -> Outcome | None:
        """Why nothing can be told, when both are the same."""
        return Outcome("unknown", f"only Newton {self.old} has results") if self.old == self.new else None

    def cells(self, headline: Headline) -> tuple[Quantity, Quantity]:
        return cell(self.releases, self.old, headline), cell(self.releases, self.new, headline)

    def live(self, case: str, column: str, unit: str) -> tuple[Quantity, Quantity]:
        """What this section measured in the two."""
        return self.cells(Headline("", "upgrade", case, column, unit))


def _slip_is_the_same(results: Results, ends: _Ends, noise: Value) -> Claim:
    old, new = ends.cells(SLIP)
    moved = change(results, "slip_change", old, new)
    return Claim(
        "slip_is_the_same",
        ends.one or _within(old, new, moved, noise),
        holds="From Newton {a} to {b} the scene as shipped does the same: the cube slips {before} and {after}, and "
        "runs of one release differ by up to {noise}.",
        fails="Newton {b} does not do what Newton {a} did: as shipped the cube slips {after}, where it slipped "
        "{before}. Runs of one release differ by up to {noise}.",
        unknown="Whether the scene as shipped does the same from release to release cannot be told.",
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "noise": noise},
    )


def _within(before: Quantity, after: Quantity, moved: Value, noise: Quantity) -> Outcome:
    """Whether a change is no more than noise and rounding."""
    for quantity in (moved, noise):
        if quantity.value is None:
            return Outcome("unknown", quantity.reason)
    processors = sorted({origin.processor for origin in moved.origins})
    if len(processors) > 1:
        return Outcome("unknown", f"one was measured on {processors[0]}, the other on {processors[1]}")
    return FAILS if is_beyond(noise.value, before.value, after.value) else HOLDS


def _in_one_step(results: Results, releases: Releases, noise: Value) -> Claim:
    """Between which neighbours the slip changes, of the releases that say."""
    cells = {release: cell(releases, release, SLIP) for release in releases}
    there = [release for release in releases if cells[release].value is not None]
    steps = []
    for before, after in pairwise(there):
        moved = change(results, f"slip_step_{after}", cells[before], cells[after])
        if _within(cells[before], cells[after], moved, noise) == FAILS:
            steps.append(f"from Newton {before} to {after}")
    outcome = HOLDS if len(steps) == 1 else FAILS
    if len(there) < 3:
        outcome = Outcome("unknown", "no release between was measured")
    return Claim(
        "in_one_step",
        outcome,
        holds="All of it comes in one step, {steps}.",
        fails="It does not come in one step: {steps}.",
        unknown="In how many steps it comes cannot be told.",
        numbers={"steps": ", ".join(steps) or "none is beyond the noise"},
    )


def _claims_stand(results: Results, turned: Sequence, releases: Sequence[str]) -> Claim:
    count = results.value("turned_count", "claims whose outcome is not the same in all releases", lambda: len(turned))
    outcome = FAILS if turned else HOLDS
    if len(releases) < 2:
        outcome = Outcome("unknown", f"only Newton {releases[0]} has results")
    return Claim(
        "claims_stand",
        outcome,
        holds="Every claim of this report that can be told has the same outcome in all of them.",
        fails="Claims whose outcome is not the same in all of them: {count}.",
        unknown="Whether the claims of this report stand in other releases cannot be told.",
        numbers={"count": count},
    )


def _cause_claims(results: Results, ends: _Ends) -> list[Claim]:
    """What is new in the live contacts, and whether the old number comes back without it."""
    own = ends.live(SHIPPED, "friction_timeconst_s", "s")
    normal = ends.live(SHIPPED, "timeconst_s", "s")
    is_new = ends.one or _is_new(*own)
    old, new = ends.live(SHIPPED, "slip_mm", "mm")
    taken, given = ends.live(TAKEN, "slip_mm", "mm")[1], ends.live(GIVEN, "slip_mm", "mm")[0]
    off = ends.live(SWITCHED, "slip_mm", "mm")[1]
    bound = results.value("recovery_bound", "chosen: as good as all of the change", lambda: 95.0, unit="%")
    shares = {
        name: _share(results, name, start, end, goal)
        for name, start, end, goal in (
            ("taken_share", new, taken, old),
            ("given_share", old, given, new),
            ("off_share", new, off, old),
        )
    }
    found, engine = ends.cells(MUJOCO_CONTACTS), ends.cells(MUJOCO_C)
    elsewhere = results.value(
        "elsewhere_change",
        "larger change in slip where MuJoCo finds the contacts, of the older slip",
        lambda a, b, c, d: 100 * max(abs(b / a - 1), abs(d / c - 1)),
        *found,
        *engine,
        unit="%",
        across=True,
    )
    same = results.value("elsewhere_bound", "chosen: the same slip", lambda: 2.0, unit="%")
    brings_back, ends_it, switches = (ends.one or at_least(share, bound) for share in shares.values())
    numbers = {"a": ends.old, "b": ends.new, "before": old, "after": new}
    numbers |= {"taken": taken, "given": given, "off": off, **shares}
    return [
        Claim(
            "friction_timeconst_is_new",
            is_new,
            holds="The live contacts of Newton {b} have what those of {a} had not: their friction rows have a time "
            "constant of their own, {own}. In Newton {a} they took that of the normal row, {normal}.",
            fails="In this the live contacts of Newton {a} and {b} are alike: the friction rows' own time constant is "
            "{was} in one and {own} in the other (zero: they take that of the normal row).",
            unknown="Whether the friction rows of the live contacts are other than they were cannot be told.",
            numbers=numbers | {"own": own[1], "was": own[0], "normal": normal[0]},
        ),
        Claim(
            "taking_it_away_brings_it_back",
            brings_back,
            holds="Taken out of the live contacts of Newton {b}, and nothing else changed, the old number comes back: "
            "the cube slips {taken}.",
            fails="Taken out of the live contacts of Newton {b}, the cube slips {taken}, where Newton {a} had {before} "
            "and {b} has {after}: that is not what makes the difference.",
            unknown="Whether the old number comes back when it is taken away cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "giving_it_does_the_same",
            ends_it,
            holds="Written into those of Newton {a}, it does there what the new release does: the cube slips {given}.",
            fails="Written into those of Newton {a}, it does not do there what the new release does: the cube slips "
            "{given}.",
            unknown="Whether the older release does the same when it is given cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "release_has_a_switch",
            switches,
            holds="The release has a switch for it: with kf below zero on the pads the cube slips {off} again.",
            fails="With kf below zero on the pads the cube slips {off}.",
            unknown="Whether the release's own parameter switches it off cannot be told.",
            numbers=numbers,
        ),
        Claim(
            "cause",
            ends.one or all_of(is_new, brings_back, ends_it),
            holds="So the friction rows' own time constant is the reason for the difference in slip.",
            fails="So the friction rows' time constant does not account for the difference between Newton {a} and {b}.",
            unknown="What makes the difference cannot be told.",
            numbers=numbers,
            explanation="Newton makes it from the shapes' kf, which this solver did not read before, for contacts that "
            "its own collision pipeline finds. What comes out below two substeps is clamped to them, as the timeconst "
            "of the stiff pads is.",
        ),
        Claim(
            "mujoco_contacts_as_before",
            ends.one or at_most(elsewhere, same),
            holds="Where MuJoCo finds the contacts nothing has changed: with them the cube slips {found} in Newton "
            "{b}, in MuJoCo's C engine {c}.",
            fails="Where MuJoCo finds the contacts the slip has changed as well, by up to {elsewhere}: with them the "
            "cube slips {found} in Newton {b}, in MuJoCo's C engine {c}.",
            unknown="Whether anything has changed where MuJoCo finds the contacts cannot be told.",
            numbers=numbers | {"found": found[1], "c": engine[1], "elsewhere": elsewhere},
        ),
    ]


def _is_new(before: Quantity, after: Quantity) -> Outcome:
    for quantity in (before, after):
        if quantity.value is None:
            return Outcome("unknown", quantity.reason)
    return HOLDS if not before.value and after.value else FAILS


def _share(results: Results, name: str, start: Quantity, end: Quantity, goal: Quantity) -> Value:
    return results.value(
        name,
        "how far the switched case goes from the slip of its own release to that of the other",
        lambda a, b, whole: 100 * (b - a) / (whole - a),
        start,
        end,
        goal,
        unit="%",
        across=True,
    )


def _same_speed(results: Results, ends: _Ends) -> Claim:
    """Only what was measured on one machine is compared."""
    headline = SPEEDS[0]
    old, new = ends.cells(headline)
    edges = [cell(ends.releases, release, _edge(headline, end)) for release in (ends.old, ends.new) for end in EDGES]
    spread = results.value(
        "frame_spread",
        "larger of the ranges from the 5th to the 95th percentile of a frame's time",
        lambda a, b, c, d: max(b - a, d - c),
        *edges,
        unit="ms",
        across=True,
    )
    moved = change(results, "frame_change", old, new)
    return Claim(
        "same_speed",
        ends.one or _machines_differ(ends.releases, headline.section) or _within(old, new, moved, spread),
        holds="One world is as fast as it was: a frame as shipped takes {after}, and took {before}; frames of one run "
        "spread over up to {spread}.",
        fails="A frame as shipped takes {after} in Newton {b}, where it took {before} in Newton {a}, on the same "
        "machine; frames of one run spread over up to {spread}.",
        unknown="Whether one world is as fast as it was cannot be told.",
        numbers={"a": ends.old, "b": ends.new, "before": old, "after": new, "spread": spread},
    )


def _edge(headline: Headline, end: str) -> Headline:
    return Headline(headline.label, headline.section, headline.case, headline.column + end, headline.unit)


def _machines_differ(releases: Releases, section: str) -> Outcome | None:
    """Unknown, when the oldest and the newest release were not measured on one and the same machine."""
    records = [release[section].results.record for release in releases.values() if section in release]
    if records and records[0].machine_for_speed != records[-1].machine_for_speed:
        return Outcome("unknown", f"measured on {records[0].machine_text} and on {records[-1].machine_text}")
    return None


def _headline_table(results: Results, releases: Releases, floors: Mapping[str, Value]) -> Table:
    columns = {release: [] for release in releases}
    for headline in HEADLINES:
        cells = {release: cell(releases, release, headline) for release in releases}
        base = next((release for release in releases if cells[release].value is not None), None)
        for release, found in cells.items():
            moved = None
            if base not in (None, release):
                moved = change(results, f"{_name(headline)}_{release}", cells[base], found)
            noise = floors[headline.unit]
            columns[release].append(marked(moved, noise, headline.column, cells.get(base, found), found))
    frame = pd.DataFrame({f"Newton {release}": found for release, found in columns.items()}, dtype=object)
    frame["noise"] = [Markup("{}").format(floors[headline.unit]) for headline in HEADLINES]
    frame.index = pd.Index([headline.label for headline in HEADLINES], name="")
    return Table(frame, "Marked is what differs from the oldest release by more than noise and rounding.")


def _name(headline: Headline) -> str:
    return f"{headline.section}_{headline.case}_{headline.column}"


def _speed_table(results: Results, releases: Releases) -> Table:
    columns = {f"Newton {release}": [] for release in releases}
    for headline in SPEEDS:
        differ = _machines_differ(releases, headline.section)
        base = cell(releases, next(iter(releases)), headline)
        for release in releases:
            found = cell(releases, release, headline)
            edges = [cell(releases, release, _edge(headline, end)) for end in EDGES]
            name = f"{_name(headline)}_{release}"
            spread = results.value(f"{name}_spread", "95th less 5th percentile", lambda a, b: b - a, *edges, unit="ms")
            moved = None if found is base or differ else change(results, name, base, found)
            columns[f"Newton {release}"].append(marked(moved, spread, headline.column, base, found))
    frame = pd.DataFrame(columns, dtype=object)
    frame.index = pd.Index([headline.label for headline in SPEEDS], name="")
    return Table(frame, "Median times of a frame; marked where the machine is the same and frames spread over less.")


def _live_table(releases: Releases) -> Table:
    columns = {
        f"Newton {release}": [
            Markup("{}").format(cell(releases, release, Headline("", "upgrade", SHIPPED, column, unit)))
            for column, (_, unit) in LIVE.items()
        ]
        for release in releases
    }
    index = pd.Index([label for label, _ in LIVE.values()], name="")
    return Table(
        pd.DataFrame(columns, index=index, dtype=object), "What a loaded contact has in the middle of the shake."
    )


def _tried_table(releases: Releases) -> Table:
    columns = {
        f"Newton {release}": [cell(releases, release, Headline("", "upgrade", case, "slip_mm", "mm")) for case in TRIED]
        for release in releases
    }
    index = pd.Index(TRIED.values(), name="")
    return Table(
        pd.DataFrame(columns, index=index, dtype=object),
        "The slip with the friction rows' own time constant as it is, taken away, given and switched.",
    )


def _option_table(releases: Releases) -> Table:
    """Solver options and defaults that the releases do not have alike."""
    found: dict[str, dict[str, Quantity | str]] = {}
    for release, sections in releases.items():
        rows = sections["upgrade"].results.rows if "upgrade" in sections else []
        for row in rows:
            if row.kind in SETTINGS:
                found.setdefault(f"{SETTINGS[row.kind]} {row.name}", {})[release] = row["value"]
    measured = [release for release, sections in releases.items() if "upgrade" in sections]
    differing = {
        name: values
        for name, values in found.items()
        if len({getattr(values.get(release), "value", values.get(release)) for release in measured}) > 1
    }
    columns = {
        f"Newton {release}": [Markup("{}").format(values.get(release, "–")) for values in differing.values()] or [""]
        for release in measured
    }
    index = pd.Index(list(differing) or ["none"], name="")
    return Table(pd.DataFrame(columns, index=index, dtype=object), "Options of the solver and defaults that differ.")


def _draw_slips(releases: Releases) -> Drawing:
    drawing, axes = new_figure(7.2, 3.4)
    places = range(len(releases))
    for headline in HEADLINES[:1] + HEADLINES[2:6]:
        cells = [cell(releases, release, headline).value for release in releases]
        there = [(place, value) for place, value in zip(places, cells, strict=True) if value is not None]
        if there:
            axes.plot(*zip(*there, strict=True), label=headline.label.removeprefix("slip "), markevery=1)
    axes.set_yscale("log")
    axes.set_xticks(list(places), list(releases))
    axes.set_xlim(-0.3, len(releases) - 0.7)
    axes.set_xlabel("Newton release")
    axes.set_ylabel("slip [mm]")
    drawing.legend(loc="outside upper left", ncols=3, fontsize=9)
    return drawing
