"""Does the same run come out the same twice, to the last bit, and with what?"""

from collections.abc import Mapping

from markupsafe import Markup

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section
from measured_report.values.results import Results, Row
from report.shared.arithmetic import extreme

order = 21
page = "evidence"
label = "to the last bit"

WAYS = {
    "plain": "as shipped",
    "sorted": "Newton's contacts sorted",
    "ordered": "MuJoCo Warp asked to order its contacts and rows",
    "all": "MuJoCo Warp asked to order its sums as well",
}
SO = {"sorted": WAYS["sorted"], "ordered": f"{WAYS['sorted']} and {WAYS['ordered']}", "all": "all that both offer"}
"""The same in a sentence."""


def derive(results: Results) -> Section:
    rows = {way: results.row[way] for way in WAYS}
    return Section(claims=[_plain_differs(rows["plain"]), _some_way_repeats(results, rows)])


def _plain_differs(plain: Row) -> Claim:
    differing, spread = plain.differing_world_count, plain.run_spread_mm
    is_seen = at_least(spread, 1e-6, why="to be seen in the slip")
    outcome = all_of(at_least(differing, 1, why="one of them is enough"), is_seen)
    return Claim("plain_differs", outcome, {"differing": differing, "worlds": plain.worlds, "spread": spread})


def _some_way_repeats(results: Results, rows: Mapping[str, Row]) -> Claim:
    exact = next((way for way in SO if rows[way].differing_world_count.value == 0), "")
    tried = [rows[way].differing_world_count for way in SO]
    least = extreme(results, "differing_least", "least number of worlds that differ, of all ways", min, tried)
    ways = [words for way, words in WAYS.items() if way in SO and rows[way].differing_world_count.value is not None]
    numbers = {"way": SO.get(exact, ""), "tried": Markup("; ").join(ways), "worlds": rows["plain"].worlds}
    return Claim("some_way_repeats", at_most(least, 0, why="the same to the last bit"), numbers | {"least": least})
