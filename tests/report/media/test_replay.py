"""Test replay.html: its single script and the packed runs."""

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from toys import link

from measured_report.editions.project import Project
from measured_report.files.root import ROOT
from measured_report.findings.editions import derive_edition
from measured_report.pages.prose import Templates
from measured_report.pages.wording import give_words
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.media.packed import packed_runs
from report.media.replay import SHAKES, replay_page
from report.plugins import Plugins

pytestmark = pytest.mark.usefixtures("unchanged")
SOURCES = ROOT / "assets/replay"
MOST_BYTES = 200_000


@pytest.fixture(scope="module")
def project(poses_path) -> Project:
    root = poses_path.parents[2]
    link(root, "experiments", "report", "assets", "templates", "pyproject.toml")
    return Project(poses_path.parent.name.removeprefix("newton-"), root=root)


@pytest.fixture(scope="module")
def page(project) -> str:
    templates = Templates(project.templates)
    edition = derive_edition(project)
    give_words({edition.project.release: edition}, templates)
    return replay_page(
        project, edition.chapters["poses"], Plugins(edition).replay, None, templates, ""
    )


def test_the_page_runs_its_one_script_fetches_nothing_else_and_says_without_it_what_was_measured(
    page, poses_path
):
    assert len(page.encode()) <= MOST_BYTES
    assert page.count("<script") == 1
    assert '<script src="replay.js"></script>' in page
    policy = page.partition('http-equiv="Content-Security-Policy" content="')[
        2
    ].partition('"')[0]
    assert "default-src 'none'" in policy and "script-src 'self' file:;" in policy
    still = page.partition("<script")[0]
    for row in load_record(poses_path).rows:
        assert (
            ">lost</td>" if row["dropped"] else f'value="{json.dumps(row["slip_mm"])}"'
        ) in still


@pytest.mark.skipif(not shutil.which("node"), reason="node is not there")
def test_the_script_reads_what_was_kept(poses_path, tmp_path):
    results = Results(load_record(poses_path), poses_path)
    (tmp_path / "runs.json").write_text(json.dumps(packed_runs(results)))
    (tmp_path / "read.mjs").write_text(
        f"""
        import {{ readFileSync }} from "node:fs";
        import {{ readShakes }} from "{SOURCES.as_uri()}/src/runs.js";
        const {{ shakes }} = readShakes(readFileSync("{tmp_path}/runs.json", "utf8"));
        console.log(JSON.stringify(shakes.map(({{ runs }}) => runs.map((run) => [run.end_s, run.at(run.end_s)]))));
        """
    )
    printed = subprocess.run(
        ["node", tmp_path / "read.mjs"], capture_output=True, text=True, check=True
    ).stdout
    rows = {row["case"]: row for row in results.record.rows}
    cases = [list(runs) for runs in SHAKES.values()]
    for members, found in zip(cases, json.loads(printed), strict=True):
        for case, (end_s, state) in zip(members, found, strict=True):
            poses = results.trace(case).value.iloc[-1]
            assert end_s == pytest.approx(rows[case]["shake_duration_s"])
            assert state["slip_mm"] == pytest.approx(rows[case]["slip_mm"], abs=0.005)
            assert state["penetration_mm"] == pytest.approx(
                poses["penetration_mm"], abs=0.005
            )
            np.testing.assert_allclose(
                state["joints"], poses.iloc[2:11].astype(float), atol=1e-4
            )


@pytest.mark.skipif(not shutil.which("npm"), reason="npm is not there")
def test_the_script_is_what_its_sources_give(tmp_path):
    assets = tmp_path / "assets"
    shutil.copytree(
        ROOT / "assets",
        assets,
        ignore=shutil.ignore_patterns("node_modules", "replay.js"),
    )
    folder = assets / "replay"
    install = subprocess.run(
        ["npm", "ci", "--ignore-scripts"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    if install.returncode:
        pytest.skip(
            f"npm cannot install: {(install.stderr.splitlines() or ['no reason given'])[-1]}"
        )
    subprocess.run(
        ["npm", "run", "--silent", "build"], cwd=folder, capture_output=True, check=True
    )
    assert (
        Path(folder / "replay.js").read_bytes() == (SOURCES / "replay.js").read_bytes()
    )
