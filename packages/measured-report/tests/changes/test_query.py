"""Names in report.toml: one of nothing is refused in one line, before anything is built."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from measured_report.changes import query
from measured_report.files.config import Changes, Columns, Config
from measured_report.files.errors import ReportError

RULES = Config(
    noise_section="toy",
    columns=[Columns(names=["slip_mm"], grows_with="dropped")],
    changes=Changes(
        deciding=["toy"], thresholds={"toy.soft.slip_mm": 0.05}, headlines={"gain": "toy.gain"}, cause="toy.helps"
    ),
)


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({}, ""),
        ({"noise_section": "tay"}, "noise_section names tay, which is no section here; near it: toy"),
        ({"columns": [Columns(names=["slap_mm"])]}, "columns names slap_mm, which is no column here; near it: slip_mm"),
        ({"deciding": ["noise"]}, "changes.deciding names noise, which is no section"),
        (
            {"thresholds": {"toy.saft.slip_mm": 1.0}},
            "toy.saft.slip_mm, which is no value here; near it: toy.soft.slip_mm",
        ),
        ({"cause": "toy.help"}, "changes.cause names toy.help, which is no value here; near it: toy.helps"),
    ],
)
def test_a_name_of_nothing_stops_the_build(toy, monkeypatch, wrong, said):
    changes = {name: wrong.pop(name) for name in [*wrong] if name in vars(Changes())}
    rules = replace(RULES, **wrong, changes=replace(RULES.changes, **changes))
    monkeypatch.setattr(query, "report", lambda: SimpleNamespace(root=toy.project.root))
    monkeypatch.setattr(query, "config", lambda: rules)
    if not said:
        toy.build()
        return
    with pytest.raises(ReportError, match=f"^report.toml: .*{said}"):
        toy.build()
