"""Test whether repeated runs are identical with each setting that promises this."""

from report.shared import (
    Claim,
    Outcome,
    Results,
    Row,
    RowsBy,
    Section,
    cell_or_absent,
    decided,
    greater,
    resolution,
    table_of,
)

order = 172
page = "error"
label = "identical runs"

SETTINGS = {
    "default": "default",
    "contacts": "sorted contacts",
    "engine": "sorted contacts, option of MuJoCo Warp",
    "solver": "sorted contacts, option of SolverMuJoCo",
}
WORLDS = 1
ENGINE_CLAIMS = ("engine_repeats", "engine_costs")


def derive(results: Results) -> Section:
    """Derive the section. Releases without an option lack the claims about it."""
    timed = RowsBy(results, results.rows, "setting", "worlds")
    settings = [name for name in SETTINGS if name in results.row]
    rows = [results.row[name] for name in settings]
    columns: dict[str, list] = {
        "runs equal to the first": [row.identical_count for row in rows],
        "range of the slip": [row.slip_range_mm for row in rows],
    }
    timed_rows = [timed[name, WORLDS] for name in settings]
    columns["time of a frame"] = [
        row.frame_ratio if row else None for row in timed_rows
    ]
    names = [SETTINGS[name] for name in settings]
    default, contacts = results.row["default"], results.row["contacts"]
    table = table_of(
        "setting",
        names,
        columns,
        runs=default.run_count,
        resolution=resolution(results, "resolution", timed.values()),
    )
    claims = [
        Claim(
            "runs_differ",
            _repeats(default, expected=False),
            {"runs": default.run_count},
        ),
        Claim("contacts_repeat", _repeats(contacts), {"runs": contacts.run_count}),
    ]
    if "engine" in settings:
        engine, cost = results.row["engine"], timed["engine", WORLDS].frame_ratio
        slower = greater(cost, 1.0, "the time by default")
        claims += [
            Claim("engine_repeats", _repeats(engine), {"runs": engine.run_count}),
            Claim("engine_costs", slower, {"ratio": cost}),
        ]
    if "solver" in settings:
        solver = results.row["solver"]
        count = cell_or_absent(default, "identical_count")
        has_run = solver.plain.get("identical_count") is not None
        reason = _sentences(solver.plain.get("identical_count_reason") or "")
        claims.append(
            Claim("option_works", decided(has_run, count), {"reason": reason})
        )
    missing = [] if "engine" in settings else [*ENGINE_CLAIMS]
    missing += [] if "solver" in settings else ["option_works"]
    return Section({"settings": table}, claims=claims, unmeasured=missing)


def _repeats(row: Row, *, expected: bool = True) -> Outcome:
    """Test whether all runs of a row equal the first one, or whether some differ."""
    is_equal = row.plain.get("identical_count") == row.plain.get("run_count", 0) - 1
    return decided(is_equal is expected, row.identical_count, row.run_count)


def _sentences(reason: str) -> str:
    """Return a reason without its last full stop, or up to the last whole sentence."""
    return reason.removesuffix(".") if reason[-1:] == "." else reason.rpartition(".")[0]
