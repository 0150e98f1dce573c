"""Repeatable to the last bit: which way of running gives the same twice, what it costs, and what is lost for it."""

from collections.abc import Mapping

import pandas as pd
from markupsafe import Markup

from measured_report.claims.claims import Claim, Outcome, all_of, at_least, at_most, decided
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import worlds_name
from report.shared.arithmetic import extreme

order = 21
page = "evidence"
label = "to the last bit"

WAYS = {
    "plain": "as shipped",
    "sorted": "Newton's contacts sorted",
    "ordered": "and MuJoCo Warp asked to order contacts and rows",
    "all": "and its sums",
}
SO = {
    "sorted": "Newton's contacts sorted",
    "ordered": "Newton's contacts sorted, and MuJoCo Warp asked to order contacts and rows",
    "all": "all that both offer",
}
"""The same in a sentence."""
WORLD_COUNTS = (1, 4096)
NO_WAY = "no way gives the same twice"


def derive(results: Results) -> Section:
    rows = {way: results.row[way] for way in WAYS}
    times = {row.case: row for row in results.rows if row.kind == "time"}
    exact = next((way for way in list(WAYS)[1:] if rows[way].differing_world_count.value == 0), "")
    return Section(
        tables={"ways": _table(rows, times)},
        claims=[
            _plain_differs(results, rows["plain"]),
            _some_way_repeats(results, rows, exact),
            _cost(results, times, exact),
            _loses_no_contact(results, rows, exact),
        ],
    )


def _plain_differs(results: Results, plain: Row) -> Claim:
    bound = results.chosen("differing_bound", "one of them is enough", 1)
    numbers = {"differing": plain.differing_world_count, "worlds": plain.worlds, "spread": plain.run_spread_mm}
    seen = results.chosen("spread_bound", "to be seen in the slip", 1e-6, unit="mm")
    outcome = all_of(at_least(plain.differing_world_count, bound), at_least(plain.run_spread_mm, seen))
    return Claim("plain_differs", outcome, numbers=numbers)


def _some_way_repeats(results: Results, rows: Mapping[str, Row], exact: str) -> Claim:
    tried = [row.differing_world_count for way, row in rows.items() if way != "plain"]
    least = extreme(results, "differing_least", "least number of worlds that differ, of all ways", min, tried)
    none = results.chosen("exact_bound", "the same to the last bit", 0)
    spread = rows[exact].world_spread_mm if exact else absent("mm", "no way is exact")
    lacking = Markup("; ").join(
        WAYS[way].removeprefix("and ") for way, row in rows.items() if row.differing_world_count.value is None
    )
    numbers = {"way": SO.get(exact, ""), "least": least, "worlds": rows["plain"].worlds, "lacking": lacking}
    return Claim("some_way_repeats", at_most(least, none), numbers=numbers | {"has_spread": exact, "spread": spread})


def _cost(results: Results, times: Mapping[str, Row], exact: str) -> Claim:
    extra = {count: _extra(results, times, exact, count) for count in WORLD_COUNTS}
    largest = extreme(results, "cost_most", "larger of these", max, list(extra.values()))
    bound = results.chosen("cost_bound", "next to nothing", 3.0, unit="%")
    outcome = at_most(largest, bound) if exact else Outcome("unknown", NO_WAY)
    one, many = extra.values()
    return Claim("is_cheap", outcome, numbers={"one": one, "many": many, "bound": bound})


def _extra(results: Results, times: Mapping[str, Row], way: str, count: int) -> Value:
    return results.value(
        f"extra_{count}",
        "time of a frame in the first way that gives the same twice, over that as shipped, less one",
        lambda with_it, without: 100 * (with_it / without - 1),
        *(_time(times, name, count) for name in (way, "plain")),
        unit="%",
    )


def _time(times: Mapping[str, Row], way: str, count: int) -> Quantity:
    row = times.get(f"{way}-time-{count}")
    return row.frame_ms if row else absent("ms", f"{worlds_name(count)} were not timed so")


def _loses_no_contact(results: Results, rows: Mapping[str, Row], exact: str) -> Claim:
    before = rows["plain"].peak_contact_count
    after = rows[exact].peak_contact_count if exact else absent("contacts", NO_WAY)
    kept = decided(None not in (before.value, after.value) and after.value >= before.value, before, after)
    outcome = kept if exact else Outcome("unknown", NO_WAY)
    return Claim("loses_no_contact", outcome, numbers={"before": before, "after": after})


def _table(rows: Mapping[str, Row], times: Mapping[str, Row]) -> Table:
    columns = {
        "worlds that differ": [row.differing_world_count for row in rows.values()],
        "run against run": [row.run_spread_mm for row in rows.values()],
        "all worlds": [row.world_spread_mm for row in rows.values()],
        "most contacts": [row.peak_contact_count for row in rows.values()],
    }
    columns |= {f"frame, {worlds_name(count)}": [_time(times, way, count) for way in rows] for count in WORLD_COUNTS}
    return Table(pd.DataFrame(columns, index=pd.Index([WAYS[way] for way in rows], name="what is done")))
