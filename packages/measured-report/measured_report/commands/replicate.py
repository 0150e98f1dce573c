"""Measure an edition again, or import another person's measurement, as a replica."""

import shutil
from collections import Counter
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.status import print_damage_of
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, records_of, states_of
from measured_report.files.atomic import write_file
from measured_report.files.errors import ReportError, UsageError
from measured_report.findings.replicas import reasons_text, refused, replicas_text
from measured_report.measuring.machine import (
    lacks,
    machine_of,
    measuring_device,
    needs_device,
)
from measured_report.measuring.measure import measure
from measured_report.records.replicas import FOLDER, Records, archive_of, read_replica

# The folder below `results` for sections that are being measured again.
ASIDE = "replicate"
FILE = {
    "default": "",
    "help": "replica of another person, a .tgz file (default: measure here)",
}
OPTIONS = {"file": FILE, **shared("edition", "device", "cluster")}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.spec)
    if arguments.file:
        _keep(project, read_replica(Path(arguments.file)), arguments.file)
        return int(print_damage_of(project))
    device = measuring_device(arguments.device, project.profile, arguments.cluster)
    names = [
        state.section
        for state in states_of(project)
        if state.kind == Kind.FRESH
        and (device or not needs_device(state.section, project))
    ]
    if not names:
        raise UsageError(lacks())
    repeated = replace(project.of(project.release), aside=ASIDE)
    # Sections that an interrupted command has measured are not measured again.
    lacking = [name for name in names if not repeated.record_path(name).exists()]
    if lacking:
        device = device or "cpu"
        repeated = measure(
            repeated, arguments.release, lacking, device, cluster=arguments.cluster
        )
    records = {record.section: record for record in records_of(repeated)}
    _keep(project, records, "this measurement")
    shutil.rmtree(repeated.results)
    return int(print_damage_of(project))


def _keep(project: Project, records: Records, source: str) -> None:
    """Write a replica with the records of the same code and packages as this edition.

    ``source`` is the name of the records in messages.
    """
    try:
        left_out = refused(project, records)
    except ReportError as error:
        raise ReportError(
            f"{source} cannot be kept as a replica of {project.release}: {error}"
        ) from None
    accepted = [record for name, record in records.items() if name not in left_out]
    content = archive_of(accepted)
    [(machine, _)] = Counter(map(machine_of, accepted)).most_common(1)
    day = min(record.measured["date"] for record in accepted)[:10]
    name = f"{machine}-{day}-{sha256(content).hexdigest()[:8]}"
    path = project.results / FOLDER / f"{name}.tgz"
    write_file(path, content)
    print(
        f"{len(accepted)} sections of {project.release}, measured on {machine} "
        f"on {day}: {path.relative_to(project.root)}"
    )
    if left_out:
        print(f"left out: {reasons_text(left_out)}")
    print(next(line for line in replicas_text(project) if name in line))
