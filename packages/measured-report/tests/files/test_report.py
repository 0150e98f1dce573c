"""Test that each of several reports finds its own packages, even with equal names."""

import sys

from measured_report.editions.project import Project
from measured_report.files.config import report, report_in


def test_a_report_is_current_within_its_block_alone(tmp_path):
    (tmp_path / "report.toml").write_text('edition = "numpy"\nunits = { mj = "mJ" }\n')
    outside, path, root = report().settings, [*sys.path], report().root
    with report_in(tmp_path) as other, report_in(root), other:
        assert (
            report().settings is other.settings and report().settings.option == "NUMPY"
        )
        assert (
            "report" not in sys.modules
            and sys.path[0] == str(tmp_path)
            and str(root) not in sys.path
        )
        assert Project("2.4.6").root == tmp_path
    assert (
        report().settings is outside
        and sys.path == path
        and Project("1.4.0").root == root
    )
