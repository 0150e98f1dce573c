"""Measure an edition again, or take in a measurement by somebody else, and keep it as a replica."""

import shutil
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.report import device_of
from measured_report.editions.project import Project
from measured_report.editions.status import records_of, states_of
from measured_report.files.atomic import write_file
from measured_report.files.errors import ReportError, UsageError
from measured_report.findings.replicas import reasons_text, refused, replicas_text
from measured_report.measuring.accelerator import lacks
from measured_report.measuring.machine import machine_of, needs_device
from measured_report.measuring.measure import measure
from measured_report.records.replicas import FOLDER, Records, archive_of, read_replica

ASIDE = "replicate"  # the folder below `results` of what is being measured again: what is there is not measured twice
FILE = {
    "default": "",
    "help": "somebody else's replica, a .tgz; without one it is measured here",
}
OPTIONS = {"file": FILE, **shared("edition", "device", "cluster")}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.asked)
    if arguments.file:
        _keep(project, read_replica(Path(arguments.file)), arguments.file)
        return 0
    device = device_of(project, arguments)
    fresh = [state.section for state in states_of(project) if state.kind == "fresh"]
    if not (
        measurable := [
            section for section in fresh if device or not needs_device(section, project)
        ]
    ):
        raise UsageError(lacks(project.report))
    again = replace(project.of(project.release), aside=ASIDE)
    if lacking := [
        section for section in measurable if not again.record_path(section).exists()
    ]:
        again = measure(
            again, arguments.release, lacking, device or "cpu", arguments.cluster
        )
    _keep(
        project,
        {record.section: record for record in records_of(again)},
        "what was measured",
    )
    shutil.rmtree(again.results)
    return 0


def _keep(project: Project, records: Records, source: str) -> None:
    try:
        left_out = refused(project, records)
    except ReportError as error:
        raise ReportError(
            f"{source} is no replica of {project.release}: {error}"
        ) from None
    accepted = [record for name, record in records.items() if name not in left_out]
    content = archive_of(accepted)
    machine = max(map(machine_of, accepted), key=[*map(machine_of, accepted)].count)
    day = min(record.measured["date"] for record in accepted)[:10]
    path = (
        project.results
        / FOLDER
        / f"{machine}-{day}-{sha256(content).hexdigest()[:8]}.tgz"
    )
    write_file(path, content)
    name = path.relative_to(project.root)
    print(
        f"{len(accepted)} sections of {project.release}, measured on {machine} on {day}: {name}"
    )
    if left_out:
        print(f"left out: {reasons_text(left_out)}")
    print(next(line for line in replicas_text(project) if path.stem in line))
