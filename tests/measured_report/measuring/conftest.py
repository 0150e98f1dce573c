"""A report without a host of its own: its processes load no simulator, which takes seconds each."""

import gc
import re
from pathlib import Path

import pytest
from conftest import SOURCES, link

from measured_report.files.root import ROOT
from measured_report.measuring import batch, host, machine, pool


@pytest.fixture(scope="session")
def plain(tmp_path_factory) -> Path:
    """The folder of the project as such a report."""
    folder = tmp_path_factory.mktemp("project")
    link(folder, *(name for name in SOURCES if name != "report.toml"))
    text = (ROOT / "report.toml").read_text(encoding="utf-8")
    assert len(re.findall("^host = ", text, re.MULTILINE)) == 1
    (folder / "report.toml").write_text(re.sub("^host = .*", "", text, flags=re.MULTILINE), encoding="utf-8")
    return folder


@pytest.fixture(autouse=True)
def plain_host(monkeypatch, tmp_path):
    """This process, and its forks, as of such a report; whoever measures on this machine is not waited for."""
    monkeypatch.setattr(batch, "LOCK", tmp_path / "lock")
    for module in (batch, machine, pool):
        monkeypatch.setattr(module, "host", lambda: host)
    machine.machine.cache_clear()
    gc.freeze()  # or each fork looks through all that this process has
    yield
    machine.machine.cache_clear()
