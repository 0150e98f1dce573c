"""Test that each mistake in report.toml is reported in one line with a remedy, wherever
it is detected.
"""

import subprocess
import sys

import pytest
from current_columns import parameters, units

from measured_report.commands.new import SKELETON
from measured_report.files.config import Report, module_named, report
from measured_report.files.errors import ReportError


def accelerator():
    return report().accelerator


def host():
    return report().host


def plugins():
    return module_named("plugins", report().settings.plugins)


TEXT = (SKELETON / "report.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "title =",
            "titel =",
            "unknown setting titel: use a setting of REFERENCE.md \\(similar: title",
        ),
        (
            "better =",
            "beter =",
            "unknown setting columns.beter: use a setting of REFERENCE.md \\(similar: better",
        ),
        (
            "[changes.thresholds]",
            "[changes.tresholds]",
            "unknown setting changes.tresholds: use a setting of REFERENCE.md \\(similar: thresholds",
        ),
        (
            'better = "less"',
            'better = "fewer"',
            r"Invalid enum value 'fewer' - at `\$.columns\[1\].better`",
        ),
        (
            'edition = "',
            'edition = 3 # "',
            r"Expected `str`, got `int` - at `\$.edition`",
        ),
        (
            "pages = [",
            'pages = ["x",',
            r"Expected `object`, got `str` - at `\$.pages\[0\]`",
        ),
        ("title =", "title", "Expected '=' after a key"),
        (
            'names = ["duration_s"]',
            "",
            "a table of columns has neither names nor a pattern",
        ),
        (
            'name = "results"',
            'name = "index"',
            "pages is empty or contains a name twice",
        ),
        ('better = "less"', "resolution = -1.0", "Expected `float` >= 0.0"),
        (
            'mj" = 0.05',
            'mj" = -0.05',
            "the threshold of pendulum.euler.energy_error_mj is -0.05, but a share is",
        ),
        (
            'mj" = 0.05',
            'mj" = 5',
            "the threshold of pendulum.euler.energy_error_mj is 5, .* write 0.05 for 5 %",
        ),
        (
            "[changes.thresholds]",
            "[changes]\ncost_threshold = 20\n[changes.thresholds]",
            "the threshold of cost_threshold is 20, .* write 0.05 for 5 %",
        ),
        ("title =", 'repository = "nowhere"\ntitle =', "Expected `str` matching regex"),
    ],
)
def test_a_slip_is_one_line_with_what_is_near(tmp_path, old, new, said):
    (tmp_path / "report.toml").write_text(TEXT.replace(old, new, 1))
    with pytest.raises(ReportError, match=f"^report.toml: {said}") as error:
        _ = Report(tmp_path).settings
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("line", "ask", "said"),
    [
        ('host = "nosuch"', host, "host = 'nosuch': No module named 'nosuch'"),
        (
            'accelerator = "nosuch"',
            accelerator,
            "accelerator = 'nosuch': No module named 'nosuch'",
        ),
        ('plugins = "nosuch"', plugins, "plugins = 'nosuch': No module named 'nosuch'"),
        (
            'case = "shutil:Nope"',
            parameters,
            "case = 'shutil:Nope' does not exist or is not a dataclass",
        ),
        (
            'units = { mj = "" }',
            units,
            "units has mj without a unit",
        ),
        ('units = { mm = "m" }', units, "units has mm, which already means mm"),
    ],
)
def test_what_a_setting_names_and_is_not_there_is_one_line_when_it_is_asked_for(
    tmp_path, line, ask, said
):
    (tmp_path / "report.toml").write_text(line)
    with Report(tmp_path), pytest.raises(ReportError, match=f"^report.toml: {said}"):
        ask()


def test_a_command_says_it_in_that_line_and_no_traceback(tmp_path):
    (tmp_path / "report.toml").write_text(TEXT.replace("title =", "ttle ="))
    (tmp_path / "build.py").write_text((SKELETON / "build.py").read_text())
    done = subprocess.run(
        [sys.executable, "build.py", "help"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert (done.stdout, done.stderr) == (
        "",
        "report.toml: unknown setting ttle: use a setting of REFERENCE.md (similar: title, text_modules)\n",
    )
    assert done.returncode == 1


EVERY_MODULE = """
import contextlib, importlib, pkgutil, measured_report
for module in pkgutil.walk_packages(measured_report.__path__, "measured_report."):
    with contextlib.suppress(ModuleNotFoundError):  # a cluster's packages are an extra
        importlib.import_module(module.name)
print(module.name)
"""


def test_no_module_reads_it_while_it_is_imported(tmp_path):
    """Test that no module reads report.toml during its import, so that a process can
    change its report.
    """
    (tmp_path / "report.toml").write_text("no TOML")
    done = subprocess.run(
        [sys.executable, "-c", EVERY_MODULE],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert (done.stdout, done.stderr) == ("measured_report.values.scatter\n", "")
