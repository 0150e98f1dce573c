"""Measure sections and keep their records: ``python -m experiments.run SECTION [SECTION …]``."""

import argparse
import hashlib
import importlib.util
import io
import os
import platform
import re
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from datetime import datetime, timezone
from pathlib import Path
from types import ModuleType

import warp as wp
from tqdm import tqdm

from experiments.case import AS_SHIPPED
from experiments.kernels import compile_for
from experiments.measurement import Conditions
from experiments.simulation import Simulation
from report import ROOT, ReportError
from report.records.columns import UNBELIEVED, is_number, number_problem, units_of
from report.records.devices import NO_CUDA, needs_gpu
from report.records.files import refuse_unwritable
from report.records.identity import identity_of, package_versions, sections
from report.records.label import read_label
from report.records.project import Project, own_release
from report.records.record import Record, write_record
from report.records.sources import EDITED
from report.records.traces import packed

# 1.3.0 is built and compiled, with the packages of its day, and is not finite from frame 1 on.
OLDEST = "1.4.0 is the oldest release that can"
OUT_OF_MEMORY = re.compile("out of memory|failed to allocate|cannot allocate|bad_alloc", re.IGNORECASE)
DEVICE_LOST = re.compile(
    "cuda error|cudaerror|device-side|driver|unspecified launch failure|graph capture", re.IGNORECASE
)


def main() -> int:
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # the output may know ASCII alone
    arguments = parse_arguments()
    try:
        device = measuring_device(arguments.device)
        modules = {section: section_module(section) for section in arguments.section}
        project = Project(edition_of(arguments.edition), arguments.profile, own_release=own_release())
        refuse_unwritable(project.results)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    with progress(arguments.seconds):
        return measure_all(project, modules, device)


def measure_all(project: Project, modules: Mapping[str, ModuleType], device: wp.Device) -> int:
    """Measure the sections, one line each, and return the exit status."""
    failures = 0
    tqdm.write("Kernels that this machine has not compiled yet come first, for a minute or so.")
    if reason := compile_first(device):
        print(f"newton {package_versions()['newton']} cannot run the scene: {reason}; {OLDEST}", file=sys.stderr)
        return 2
    for number, (section, module) in enumerate(modules.items(), start=1):
        tqdm.write(f"[{number}/{len(modules)}] {section}")
        try:
            measure_section(project, section, module, device)
        except Exception as error:  # one section's fault must not cost the others
            print(f"{section}: measuring failed; what was there is kept: {reason_of(error)}", file=sys.stderr)
            failures += 1
        except KeyboardInterrupt:
            print(f"{section}: stopped; what was there is kept", file=sys.stderr)
            return 130
    return 1 if failures else 0


def reason_of(error: Exception) -> str:
    """Why measuring failed, in one line, with what to do; an error of the code itself has its trace as well."""
    said = " ".join(str(error).split())
    if isinstance(error, MemoryError) or OUT_OF_MEMORY.search(said):
        return f"the memory is too small ({said:.200}); free some of it, or PROFILE=quick measures small grids"
    if DEVICE_LOST.search(said):
        return f"the device does not answer ({said:.200}); nvidia-smi says whether it is there"
    if isinstance(error, OSError):
        return f"{error.filename or 'a file'}: {error.strerror}"
    if not isinstance(error, ReportError):
        traceback.print_exc()
    return said or type(error).__name__


@contextmanager
def progress(seconds: float) -> Iterator[None]:
    """One bar for all that is measured, by the time that it took before; none where nobody looks, as in a log."""
    form = "{percentage:3.0f} %|{bar}| {elapsed} of about {total_time}" if seconds else "{elapsed}"
    form = form.replace("{total_time}", f"{seconds / 60:.0f} min")
    done = threading.Event()
    with tqdm(total=max(seconds, 1.0), bar_format=form, disable=not sys.stderr.isatty()) as bar:

        def tick() -> None:
            while not done.wait(1.0):
                bar.update(min(1.0, bar.total - bar.n))
                bar.refresh()

        threading.Thread(target=tick, daemon=True).start()
        try:
            yield
        finally:
            done.set()


def compile_first(device: wp.Device) -> str:
    """Compile what all sections need on all cores; why the scene can't be run at all, where it can't.

    What else goes wrong here is said, and left to the measurement.
    """
    start = time.perf_counter()
    try:
        count = compile_for(device)
    except Exception as error:  # a new release may build its kernels in another way
        try:
            Simulation([replace(AS_SHIPPED, frame_count=1)], device)
        except (AttributeError, ImportError, TypeError) as missing:
            return " ".join(str(missing).split())[:200]
        print(f"kernels are compiled as they are met: {' '.join(str(error).split())[:200]}", file=sys.stderr)
        return ""
    tqdm.write(f"{count} modules of kernels are ready after {time.perf_counter() - start:.0f} s")
    return ""


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m experiments.run", description=__doc__.split(":")[0])
    parser.add_argument("section", nargs="+", metavar="SECTION", help=", ".join(sections()))
    parser.add_argument("--device", choices=("cuda", "cpu"), help="default: cuda where there is one")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument("--seconds", type=float, default=0.0, help="how long it took before, for the bar")
    parser.add_argument("--edition", metavar="LABEL", help="what the results are kept as; default: what is installed")
    return parser.parse_args()


def measuring_device(name: str | None) -> wp.Device:
    """The device to measure on; ReportError when it is not there."""
    if hasattr(wp, "LOG_WARNING"):  # Warp of old releases has none, and they are told what else they lack
        wp.config.log_level = wp.LOG_WARNING
    wp.init()
    if name is None:
        name = "cuda" if wp.is_cuda_available() else "cpu"
    if name == "cuda" and not wp.is_cuda_available():
        raise ReportError(f"DEVICE=cuda: {NO_CUDA}")
    return wp.get_device("cuda:0" if name == "cuda" else "cpu")


def section_module(section: str) -> ModuleType:
    """The module that measures a section; ReportError when there is none."""
    if section.isidentifier() and importlib.util.find_spec(f"experiments.{section}"):
        module = importlib.import_module(f"experiments.{section}")
        if hasattr(module, "measure"):
            return module
    raise ReportError(f"SECTION={section} is no section; use one of: {', '.join(sections())}")


def edition_of(asked: str | None) -> str:
    """The label that results of what is installed here are kept under; ReportError when another one was asked for."""
    installed = package_versions()
    newton, edits, _ = installed["newton"].partition(f"{EDITED}.")
    newton += EDITED if edits else ""
    label = read_label(asked or newton)
    if label is None or label.newton != newton or not dict(label.pins).items() <= installed.items():
        have = ", ".join(f"{package} {version}" for package, version in installed.items())
        raise ReportError(f"NEWTON={asked or newton} is not what is installed here ({have})")
    return str(label)


def measure_section(project: Project, section: str, module: ModuleType, device: wp.Device) -> None:
    """Let the section's module measure, and write its record and traces."""
    profile = project.profile
    if not needs_gpu(section):
        device = wp.get_device("cpu")
    started, start = now(), time.perf_counter()
    measurement = module.measure(Conditions(device=device.alias, quick=profile == "quick"))
    record = Record(
        section=section,
        identity=identity_of(section, profile),
        machine=machine(device),
        measured={
            "date": now(),
            "started": started,
            "ended": now(),
            "commit": commit(),
            "command": project.rerun(section, device_kind(device)),
            "seconds": round(time.perf_counter() - start, 1),
        },
        units=units_of(measurement.rows),
        rows=[believable(row) for row in measurement.rows],
    )
    path = project.record_path(section)
    write_record(path, record, {case: packed(path, case, table) for case, table in measurement.traces.items()})
    tqdm.write(f"{section}: {len(record.rows)} rows in {record.measured['seconds']:.0f} s → {path}")


def now() -> str:
    return datetime.now(timezone.utc).isoformat(timespec="seconds")


def believable(row: dict[str, object]) -> dict[str, object]:
    """The row with None, and the reason, for each number that no record may hold: one must not cost the others."""
    lost = [name for name, value in row.items() if is_number(value) and number_problem(name, value)]
    return row | dict.fromkeys(lost) | {f"{name}_reason": f"{UNBELIEVED}{row[name]}" for name in lost}


def device_kind(device: wp.Device) -> str:
    return "cuda" if device.is_cuda else "cpu"


def machine(device: wp.Device) -> dict[str, str | None]:
    """The machine that measures, as far as a reader needs it to judge a number.

    With the host's digest, the GPU's UUID and the times of two records anyone can tell whether they ran side by side.
    """
    gpu = driver = None
    if device.is_cuda:
        gpu = device.name
        driver = _said("nvidia-smi", "--query-gpu=driver_version", "--format=csv,noheader").split("\n")[0] or None
    return {
        "device": device_kind(device),
        "gpu": gpu,
        "driver": driver,
        "cpu": cpu_name(),
        "cores": str(os.cpu_count()),
        "python": platform.python_version(),
        "host": hashlib.sha256(platform.node().encode()).hexdigest()[:12],
        "gpu_uuid": device.uuid if device.is_cuda else None,
        "system": f"{platform.system()} {platform.machine()}",
    }


def cpu_name() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def commit() -> str | None:
    """The commit that is checked out, with a mark when the working tree differs from it.

    Where only a copy of the tree is, as on a GPU host, the environment's GIT_COMMIT says it; None when nothing does.
    """
    if told := os.environ.get("GIT_COMMIT"):
        return told
    found = _said("git", "describe", "--always", "--abbrev=12", "--exclude=*", "--dirty")
    untracked = _said("git", "ls-files", "--others", "--exclude-standard", "experiments", "assets")
    return f"{found.removesuffix('-dirty')}-dirty" if found and untracked else found or None


def _said(*command: str) -> str:
    """What a command prints; nothing when it fails or is not there."""
    try:
        return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip()
    except OSError:
        return ""


if __name__ == "__main__":
    sys.exit(main())
