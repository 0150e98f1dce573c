"""The lint as a program: ``newton-lint TARGET``, ``python -m newton_lint TARGET`` or, here, ``experiments.lint``.

See docs/lint.md.
"""

import argparse
import contextlib
import json
import os
import sys
import traceback
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, NoReturn

import newton
import numpy as np
import warp as wp

from newton_lint.contacts import CONES
from newton_lint.findings import Finding, lines
from newton_lint.prediction import Load, Prediction, predictions, said
from newton_lint.rules import Engine, findings_of, read
from newton_lint.target import Target, TargetError, read_target

SCHEMA = 1
CLEAN, FOUND, UNFIT, BROKEN = 0, 1, 2, 3
"""Exit status."""
COLLIDES = int(newton.ShapeFlags.COLLIDE_SHAPES)
PROGRAMS = {"newton-lint": "newton-lint", "__main__": "python -m newton_lint"}
PROGRAM = PROGRAMS.get(Path(sys.argv[0]).stem, "python -m experiments.lint")


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """What was asked for can't be: one line, as for a target that can't be read."""
        self.exit(UNFIT, f"{message}; {PROGRAM} --help says what there is\n")


@dataclass(frozen=True)
class Report:
    """What is said of a target."""

    target: str
    dt_s: float
    shape_count: int
    """Shapes that can collide."""
    pair_count: int
    load: Load
    findings: Sequence[Finding]
    creep: Sequence[Prediction]


def main(arguments: Sequence[str] | None = None) -> int:
    given = _parser().parse_args(arguments)
    try:
        return _linted(given)
    except Exception:  # a fault of the lint itself, which Python would end with the status of a finding
        traceback.print_exc()
        return BROKEN


def _linted(given: argparse.Namespace) -> int:
    wp.config.log_level = wp.LOG_WARNING
    with _muted_standard_error():
        wp.init()
    try:
        report = report_of(given, read_target(given.target))
    except TargetError as error:
        print(error, file=sys.stderr)
        return UNFIT
    with _pipe_may_close():
        print(json.dumps(as_json(report), indent=1, ensure_ascii=False) if given.json else "\n".join(as_text(report)))
    return FOUND if report.findings else CLEAN


@contextlib.contextmanager
def _muted_standard_error() -> Iterator[None]:
    """What Warp's library writes goes nowhere: of a machine without a GPU it warns, and the lint takes none."""
    kept, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)


@contextlib.contextmanager
def _pipe_may_close() -> Iterator[None]:
    """Who reads the output may stop before its end, as head does."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # Python flushes once more when it ends


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog=PROGRAM, description="Contact parameters of a scene that MuJoCo's engines take otherwise.")
    parser.add_argument(
        "target", metavar="TARGET", help="FILE.xml, FILE.urdf, FILE.usd, FILE.py:function, or module:function"
    )
    parser.add_argument(
        "--dt", type=_positive, metavar="S", help="the solver's step; default: what MJCF says, or 0.002"
    )
    parser.add_argument("--contacts", choices=("mujoco", "newton"), default="mujoco", help="whose; default: mujoco")
    parser.add_argument("--cone", choices=CONES, help="default: what the scene says")
    parser.add_argument("--impratio", type=_positive, metavar="X", help="default: what the scene says")
    parser.add_argument("--load", type=_positive, default=0.0, metavar="N", help="tangential, on each contact point")
    parser.add_argument(
        "--acceleration", type=_positive, default=0.0, metavar="M/S²", help="that contact rows leave out, as J̇·q̇"
    )
    parser.add_argument("--json", action="store_true", help="print one object, as docs/lint.md says")
    return parser


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no positive number")
    return value


def report_of(given: argparse.Namespace, target: Target) -> Report:
    model = target.model
    engine = Engine(given.dt or target.timestep_s, contacts=given.contacts, cone=given.cone, impratio=given.impratio)
    load = Load(given.acceleration, given.load)
    scene = read(model, engine) if model.shape_count else None
    return Report(
        target=given.target,
        dt_s=engine.substep_dt,
        shape_count=int(np.count_nonzero(model.shape_flags.numpy() & COLLIDES)) if scene else 0,
        pair_count=len(scene.contacts.first) if scene else 0,
        load=load,
        findings=findings_of(scene) if scene else [],
        creep=predictions(model, engine, load),
    )


def as_json(report: Report) -> dict[str, Any]:
    """What ``--json`` prints; docs/lint.md is its schema."""
    return {
        "schema": SCHEMA,
        "target": report.target,
        "newton": newton.__version__,
        "dt_s": report.dt_s,
        "shape_count": report.shape_count,
        "pair_count": report.pair_count,
        "findings": [asdict(finding) for finding in report.findings],
        "creep": [_creep_of(prediction, report.load) for prediction in report.creep],
    }


def _creep_of(prediction: Prediction, load: Load) -> dict[str, Any]:
    deep, shallow = prediction.deep, prediction.shallow
    return {
        "pairs": [list(pair) for pair in prediction.pairs],
        "timeconst_s": prediction.timeconst_s,
        "dmax": prediction.dmax,
        "response_s": deep.response_s,
        "acceleration_m_s2": load.acceleration_m_s2,
        "acceleration_mm_s": deep.acceleration_mm_s,
        "load_n": load.load_n,
        "load_deep_mm_s": deep.load_mm_s,
        "load_shallow_mm_s": shallow.load_mm_s,
    }


def as_text(report: Report) -> list[str]:
    """What is printed otherwise: what was read, what was found in it, and the creep."""
    found = lines(report.findings)
    size = f"{_counted(report.shape_count, 'shape')}, {_counted(report.pair_count, 'pair')}, dt {report.dt_s:g} s"
    text = [f"{report.target}: {size}: {_counted(len(found), 'finding') if found else 'nothing found'}"]
    text += [f"  {line}" for line in found]
    if report.creep:
        text.append("predicted creep, which is no finding:")
    return text + [f"  {said(prediction, report.load)}" for prediction in report.creep]


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
