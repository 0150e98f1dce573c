"""Repeatable to the last bit: which way of running gives the same twice, what it costs, and what is lost for it."""

from collections.abc import Mapping

from markupsafe import Markup

from measured_report.claims.claim import Claim, Outcome, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row
from report.names import worlds_name
from report.shared.arithmetic import Column, excess, extreme, table_of

order = 21
page = "evidence"
label = "to the last bit"

WAYS = {
    "plain": "as shipped",
    "sorted": "Newton's contacts sorted",
    "ordered": "and MuJoCo Warp asked to order contacts and rows",
    "all": "and its sums",
}
SO = {"sorted": WAYS["sorted"], "ordered": f"{WAYS['sorted']}, {WAYS['ordered']}", "all": "all that both offer"}
"""The same in a sentence."""
WORLD_COUNTS = (1, 4096)
NO_WAY = "no way gives the same twice"


def derive(results: Results) -> Section:
    rows = {way: results.row[way] for way in WAYS}
    times = {row.case: row for row in results.rows if row.kind == "time"}
    exact = next((way for way in SO if rows[way].differing_world_count.value == 0), "")
    columns: dict[str, Column] = {
        "worlds that differ": "differing_world_count",
        "run against run": "run_spread_mm",
        "all worlds": "world_spread_mm",
        "most contacts": "peak_contact_count",
    }
    columns |= {f"frame, {worlds_name(count)}": [_time(times, way, count) for way in rows] for count in WORLD_COUNTS}
    return Section(
        tables={"ways": table_of("what is done", WAYS.values(), columns, rows.values())},
        claims=[
            _plain_differs(rows["plain"]),
            _some_way_repeats(results, rows, exact),
            _cost(results, times, exact),
            _loses_no_contact(rows, exact),
        ],
    )


def _plain_differs(plain: Row) -> Claim:
    differing, spread = plain.differing_world_count, plain.run_spread_mm
    is_seen = at_least(spread, 1e-6, why="to be seen in the slip")
    outcome = all_of(at_least(differing, 1, why="one of them is enough"), is_seen)
    return Claim("plain_differs", outcome, {"differing": differing, "worlds": plain.worlds, "spread": spread})


def _some_way_repeats(results: Results, rows: Mapping[str, Row], exact: str) -> Claim:
    tried = [rows[way].differing_world_count for way in SO]
    least = extreme(results, "differing_least", "least number of worlds that differ, of all ways", min, tried)
    spread = rows[exact].world_spread_mm if exact else absent("mm", "no way is exact")
    lost = [words for way, words in WAYS.items() if rows[way].differing_world_count.value is None]
    lacking = Markup("; ").join(words.removeprefix("and ") for words in lost)
    numbers = {"way": SO.get(exact, ""), "least": least, "worlds": rows["plain"].worlds, "lacking": lacking}
    outcome = at_most(least, 0, why="the same to the last bit")
    return Claim("some_way_repeats", outcome, {**numbers, "has_spread": exact, "spread": spread})


def _cost(results: Results, times: Mapping[str, Row], exact: str) -> Claim:
    formula = "time of a frame in the first way that gives the same twice, over that as shipped, less one"
    one, many = (
        excess(results, f"extra_{count}", formula, *(_time(times, way, count) for way in (exact, "plain")))
        for count in WORLD_COUNTS
    )
    largest = extreme(results, "cost_most", "larger of these", max, [one, many])
    bound = results.chosen("cost_bound", "next to nothing", 3.0, unit="%")
    outcome = at_most(largest, bound) if exact else Outcome("unknown", NO_WAY)
    return Claim("is_cheap", outcome, {"one": one, "many": many, "bound": bound})


def _time(times: Mapping[str, Row], way: str, count: int) -> Quantity:
    row = times.get(f"{way}-time-{count}")
    return row.frame_ms if row else absent("ms", f"{worlds_name(count)} were not timed so")


def _loses_no_contact(rows: Mapping[str, Row], exact: str) -> Claim:
    before = rows["plain"].peak_contact_count
    after = rows[exact].peak_contact_count if exact else absent("contacts", NO_WAY)
    outcome = at_least(after, before) if exact else Outcome("unknown", NO_WAY)
    return Claim("loses_no_contact", outcome, {"before": before, "after": after})
