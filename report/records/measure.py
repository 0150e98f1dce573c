"""Measuring, which another process does: nothing here knows the simulator."""

import json
import os
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from report import ReportError, UsageError
from report.records.devices import machine_name, machine_of
from report.records.environment import python_of
from report.records.files import refuse_unwritable
from report.records.identity import sections as all_sections
from report.records.manifest import Manifest, write_manifest
from report.records.processes import end_with
from report.records.project import Project
from report.records.stack import Stack, release_date
from report.records.status import expected_packages, records_of

UNFIT = 2
"""Exit status of a measurement that could not begin, because of what was asked for."""


def measure(project: Project, stack: Stack, sections: Sequence[str], device: str) -> Project:
    """Measure the sections in one process, which loads the simulator's kernels once; ReportError if any failed.

    Returns the report that has the results: they are kept apart when those that are there are of another machine.
    """
    kept = kept_by(project, device)
    refuse_unwritable(kept.results)
    try:
        seconds, count = seconds_known(project, device, sections), _sections_at_once(project, device)
        options = {"profile": project.profile, "edition": kept.release, "seconds": seconds, "processes": count}
        told = (f"--{name}={value}" for name, value in options.items())
        _run(kept, stack, "experiments.run", device, *sections, *told)
    finally:
        _note_measured(kept, stack)
    return kept


def seconds_known(project: Project, device: str, sections: Sequence[str]) -> float:
    """How long these sections will take [s], by the last time on such a device and in this profile; 0 unless all are
    known."""
    found = {
        record.section: record.measured["seconds"]
        for release in project.releases
        for record in records_of(project.of(release))
        if record.machine.get("device") == device
    }
    known = [found[section] for section in sections if section in found]
    if len(known) < len(sections):
        return 0.0
    return max(max(known), sum(known) / _sections_at_once(project, device))


def _sections_at_once(project: Project, device: str) -> int:
    """How many sections are measured at once: one, but for quick runs on a CPU, of which each takes one core."""
    return (os.cpu_count() or 1) if device == "cpu" and project.profile == "quick" else 1


def measure_headline(project: Project, stack: Stack, device: str) -> Mapping[str, Any]:
    """Measure the headline and keep nothing of it; what ``experiments.headline`` writes: machine, rows and seconds."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "headline.json"
        _run(project, stack, "experiments.headline", device, "--json", str(path))
        return json.loads(path.read_text(encoding="utf-8"))


def _run(project: Project, stack: Stack, module: str, device: str, *options: str) -> None:
    """Run a module of the experiments with a stack, on a device; ReportError when it fails.

    What is not installed here is measured by the Python of its own environment.
    """
    python = python_of(stack, expected_packages(project), project.root)
    # It ends with this process: nobody would know of it otherwise.
    beginning = partial(end_with, os.getpid())
    command = [str(python), "-m", module, "--device", device, *options]
    settings = {**os.environ, "TQDM_DISABLE": "1"}  # a log has a line for each section, a terminal one bar for all
    if device == "cpu":
        settings["CUDA_VISIBLE_DEVICES"] = ""  # a process that has begun with CUDA must not be forked
    status = subprocess.run(command, cwd=project.root, check=False, preexec_fn=beginning, env=settings).returncode
    if status == UNFIT:
        raise UsageError("")  # it has said why
    if status:
        raise ReportError(f"measuring ended with exit status {status}; what was there is kept")


def kept_by(project: Project, device: str) -> Project:
    """The report that the results of this machine belong to: one of its own where others' are kept already."""
    label, machine = project.label, machine_name(device)
    if label.machine not in ("", machine):
        raise UsageError(f"NEWTON={project.release} has the results of {label.machine}, and this is {machine}")
    others = {machine_of(record) for record in records_of(project)} - {machine}
    if not others or label.machine:
        return project
    found = project.of(str(replace(label, machine=machine)))
    print(f"NEWTON={project.release} has results of {', '.join(others)}; those of this machine are {found.release}")
    return found


def _note_measured(project: Project, stack: Stack) -> None:
    """Note which sections have been measured, so that one that goes is missed."""
    there = {section for section in all_sections(project.root) if project.record_path(section).exists()}
    manifest = project.manifest
    known = {*there, *(manifest.sections if manifest else ())}
    day = manifest.date if manifest else release_date(stack)
    if known:
        write_manifest(project.results, Manifest(stack.asked, day, tuple(sorted(known))))
