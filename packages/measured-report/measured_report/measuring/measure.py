"""Measure sections in another process, which loads the simulator."""

import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

from measured_report.editions.environment import python_of
from measured_report.editions.project import (
    Manifest,
    Project,
    read_manifest,
    write_manifest,
)
from measured_report.editions.release import Release, release_date
from measured_report.editions.status import expected_packages, records_of
from measured_report.files.atomic import locked
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.processes import end_with_parent
from measured_report.measuring.machine import machine_name, machine_of, needs_device
from measured_report.records.identity import sections as all_sections

MODULE = "measured_report.measuring.run"
FAILED = 1
UNFIT = 2
"""Exit status of a measurement that failed, and of one that could not begin.

In both cases the other process has printed the reason.
"""


def measure(
    project: Project,
    release: Release,
    sections: Sequence[str],
    device: str,
    cluster: str | None = None,
) -> Project:
    """Measure sections and return the project that contains them.

    Results of another machine are kept in a separate project.
    """
    edition, is_done = measure_available(
        project, release, sections, device, cluster=cluster
    )
    if not is_done:
        raise ReportError("")
    return edition


def measure_available(
    project: Project,
    release: Release,
    sections: Sequence[str],
    device: str,
    cluster: str | None = None,
) -> tuple[Project, bool]:
    """Measure sections and print the reasons if some cannot be measured.

    Return the project that contains them, and whether all could be measured.
    """
    python = python_of(release, expected_packages(project), project.root)
    options = ["--profile", project.profile, "--aside", project.aside]
    machine = machine_name(device, project.report)
    if cluster:
        options += ["--cluster", cluster]
        try:
            from measured_report.measuring.cluster import card_of
        except ImportError as error:
            raise UsageError(
                f"CLUSTER={cluster} needs the package {error.name}: install it with "
                "uv pip install distributed"
            ) from None
        if device != "cpu":
            machine = card_of(cluster)
    has_device_sections = any(needs_device(name, project) for name in sections)
    edition = project_of(project, machine) if has_device_sections else project
    options += ["--edition", edition.release]
    edition.results.mkdir(parents=True, exist_ok=True)
    if not os.access(edition.results, os.W_OK):
        raise ReportError(
            f"cannot write results to {edition.results}: make the folder writable"
        )
    try:
        with running(edition, python, MODULE, device, *sections, *options):
            pass
    except UsageError:
        raise
    except ReportError as error:
        # The text is empty if the other process has printed the reason.
        if str(error):
            print(error, file=sys.stderr)
        return edition, False
    finally:
        _note_measured(edition, release)
        with suppress(OSError):
            edition.results.rmdir()  # the folder is empty if no section was measured
    return edition, True


@contextmanager
def running(
    project: Project, python: Path, module: str, device: str, *options: str
) -> Iterator[None]:
    """Run a module that measures in another process, and wait for it after the block."""
    # The log then has one line for each section instead of a progress bar.
    env = {**os.environ, "TQDM_DISABLE": "1"}
    if device == "cpu":
        env |= project.report.accelerator.NONE
    process = subprocess.Popen(
        [str(python), "-m", module, "--device", device, *options],
        cwd=project.root,
        env=env,
        preexec_fn=end_with_parent,
        start_new_session=True,
    )
    try:
        yield
        status = process.wait()
    except BaseException:
        process.kill()
        raise
    if status == UNFIT:
        raise UsageError("")
    if status == FAILED:
        raise ReportError("")
    if status:
        raise ReportError(
            f"measuring ended with exit status {status}: run it again (existing "
            "records are kept)"
        )


def project_of(project: Project, machine: str) -> Project:
    """Return the project that keeps the results of ``machine``.

    It is a separate project if other machines have results of this edition.
    """
    release = project.named
    option = f"{project.settings.option}={project.release}"
    if release.machine not in ("", machine):
        raise UsageError(
            f"{option} has the results of {release.machine}, and this machine is "
            f"{machine}: name the edition without the machine"
        )
    machines = dict.fromkeys(other_machines(project, machine))
    if release.machine or not machines:
        return project
    edition = project.of(str(replace(release, machine=machine)))
    print(
        f"{option} has results of {', '.join(machines)}; the results of this "
        f"machine are kept as {edition.release}"
    )
    return edition


def other_machines(project: Project, machine: str) -> Iterator[str]:
    """Yield the machines other than ``machine`` that have results in a project."""
    for record in records_of(project):
        if needs_device(record.section, project) and machine_of(record) != machine:
            yield machine_of(record)


def _note_measured(project: Project, release: Release) -> None:
    """Add the measured sections to the manifest, so that a lost record is noticed."""
    with locked(project.results.parent):
        # This raises an error if the manifest is damaged, so that it is not
        # overwritten.
        manifest = read_manifest(project.results)
        names = {*manifest.sections} if manifest else set()
        names |= {
            section
            for section in all_sections(project.root)
            if project.record_path(section).exists()
        }
        if names:
            day = manifest.date if manifest else release_date(release)
            manifest = Manifest(release.spec, day, tuple(sorted(names)))
            write_manifest(project.results, manifest)
