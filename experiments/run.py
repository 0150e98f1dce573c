"""Measure sections and keep their records: ``python -m experiments.run SECTION [SECTION …]``."""

import argparse
import importlib.util
import io
import re
import sys
import threading
import time
import traceback
from collections.abc import Iterator, Sequence
from concurrent.futures import as_completed
from contextlib import contextmanager
from dataclasses import replace
from datetime import datetime, timezone
from types import ModuleType

import warp as wp
from tqdm import tqdm

from experiments.case import AS_SHIPPED
from experiments.compat import release
from experiments.kernels import compile_for
from experiments.machine import commit, device_kind, machine
from experiments.measurement import Conditions
from experiments.scene import build_scene
from experiments.simulation import Simulation
from experiments.worlds import WORLDS_BUILT
from report import ReportError
from report.records.columns import UNBELIEVED, is_number, number_problem, units_of
from report.records.devices import NO_CUDA
from report.records.files import refuse_unwritable
from report.records.identity import identity_of, package_versions, sections
from report.records.label import read_label
from report.records.processes import workers
from report.records.project import Project, own_release
from report.records.record import Record, write_record
from report.records.sources import EDITED
from report.records.traces import packed

OLDEST = (1, 4, 0)
"""The oldest release that can run the scene."""
TIMED = ("cure_cost", "error_runtime", "leave_out", "scaling", "speed")
"""Sections that are about time, beside which nothing may run."""
OUT_OF_MEMORY = re.compile("out of memory|failed to allocate|cannot allocate|bad_alloc", re.IGNORECASE)
NOT_COMPILED = re.compile("kernel build failed|nvrtc", re.IGNORECASE)
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
        for section in arguments.section:
            section_module(section)
        project = Project(edition_of(arguments.edition), arguments.profile, own_release=own_release())
        refuse_unwritable(project.results)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    tqdm.write("Kernels that this machine has not compiled yet come first, for a minute or so.")
    if reason := too_old(device) or compile_first(device):
        version, oldest = package_versions()["newton"], ".".join(map(str, OLDEST))
        print(f"newton {version} cannot run the scene: {reason}; {oldest} is the oldest that can", file=sys.stderr)
        return 2
    return measure_all(project, arguments.section, device, arguments.processes, arguments.seconds)


def measure_all(project: Project, names: Sequence[str], device: wp.Device, count: int, seconds: float) -> int:
    """Measure the sections, those that may be up to ``count`` at once, a line each, and return the exit status.

    Processes are forks of this one, so that they have the kernels that it has loaded.
    """
    plain = [section for section in names if section not in TIMED]
    together = plain if min(count, len(plain)) > 1 else []
    failures = 0
    try:
        with workers(count, "fork") as pool:
            if together:
                tqdm.write(f"[1–{len(together)}/{len(names)}] {', '.join(together)}, {count} at a time")
            running = [pool.submit(measure_named, project, section, device.alias, count) for section in together]
            with progress(seconds):
                for ended in as_completed(running):
                    failures += ended.result()
                alone = [section for section in names if section not in together]
                for number, section in enumerate(alone, start=len(together) + 1):
                    tqdm.write(f"[{number}/{len(names)}] {section}")
                    failures += measure_named(project, section, device.alias)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("stopped; what was there is kept", file=sys.stderr)
        return 130
    return 1 if failures else 0


def measure_named(project: Project, section: str, alias: str, count: int = 1) -> bool:
    """Measure a section beside ``count`` less one others, and say how it went; whether it failed."""
    try:
        measure_section(project, section, section_module(section), wp.get_device(alias), count)
    except Exception as error:  # one section's fault must not cost the others
        print(f"{section}: measuring failed; what was there is kept: {reason_of(error)}", file=sys.stderr, flush=True)
        return True
    return False


def reason_of(error: Exception) -> str:
    """Why measuring failed, in one line, with what to do; an error of the code itself has its trace as well."""
    said = " ".join(str(error).split())
    if isinstance(error, MemoryError) or OUT_OF_MEMORY.search(said):
        return f"the memory is too small ({said:.200}); free some of it, or PROFILE=quick measures small grids"
    if DEVICE_LOST.search(said):
        return f"the device does not answer ({said:.200}); nvidia-smi says whether it is there"
    if NOT_COMPILED.search(said):  # Warp has printed what the compiler says
        return f"its kernels can't be compiled by Warp {wp.__version__} ({said:.200})"
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


def too_old(device: wp.Device) -> str:
    """Why a release that is older than the oldest can't build the scene, before minutes go into its kernels."""
    try:
        if release() < OLDEST:
            build_scene([AS_SHIPPED] * (WORLDS_BUILT + 1), device)
    except Exception as error:  # each of them for a reason of its own
        return " ".join(str(error).split())[:200]
    return ""


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
    parser.add_argument("--processes", type=int, default=1, help="sections at once, on a CPU, but for those about time")
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


def measure_section(project: Project, section: str, module: ModuleType, device: wp.Device, count: int) -> None:
    """Let the section's module measure, beside ``count`` less one others, and write its record and traces."""
    profile = project.profile
    started, start = now(), time.perf_counter()
    measurement = module.measure(Conditions(device=device.alias, quick=profile == "quick"))
    record = Record(
        section=section,
        identity=identity_of(section, profile),
        machine=machine(device) | ({"sections_at_once": count} if count > 1 else {}),
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


if __name__ == "__main__":
    sys.exit(main())
