"""The lint as a program: ``python -m experiments.lint TARGET``, or ``newton-lint`` where that is installed.

See docs/lint.md.
"""

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, NoReturn

import newton
import warp as wp

from experiments.linting.contacts import CONES
from experiments.linting.findings import Finding, lines
from experiments.linting.prediction import Load, Prediction, predictions, said
from experiments.linting.rules import Engine, lint
from experiments.linting.target import TargetError, model_of

SCHEMA = 1
CLEAN, FOUND, UNFIT = 0, 1, 2
"""Exit status."""
INSTALLED = "newton-lint"
PROGRAM = INSTALLED if Path(sys.argv[0]).stem == INSTALLED else "python -m experiments.lint"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        """What was asked for can't be: one line, as for a target that can't be read."""
        self.exit(UNFIT, f"{message}; {PROGRAM} --help says what there is\n")


def main(arguments: Sequence[str] | None = None) -> int:
    given = _parser().parse_args(arguments)
    wp.config.log_level = wp.LOG_WARNING
    engine = Engine(given.dt, contacts=given.contacts, cone=given.cone, impratio=given.impratio)
    load = Load(given.acceleration, given.load)
    try:
        model = model_of(given.target)
        findings, creep = lint(model, engine), predictions(model, engine, load)
    except TargetError as error:
        print(error, file=sys.stderr)
        return UNFIT
    if given.json:
        print(json.dumps(report_of(given.target, engine, load, findings, creep), indent=1, ensure_ascii=False))
    else:
        print_text(given.target, load, findings, creep)
    return FOUND if findings else CLEAN


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog=PROGRAM, description="Contact parameters of a scene that MuJoCo's engines take otherwise.")
    parser.add_argument("target", metavar="TARGET", help="FILE.xml, FILE.urdf, FILE.usd, or module:function")
    parser.add_argument("--dt", type=_positive, default=0.002, metavar="S", help="the solver's step; default: 0.002")
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


def report_of(
    target: str, engine: Engine, load: Load, findings: Sequence[Finding], creep: Sequence[Prediction]
) -> dict[str, Any]:
    """What ``--json`` prints; docs/lint.md is its schema."""
    return {
        "schema": SCHEMA,
        "target": target,
        "newton": newton.__version__,
        "dt_s": engine.substep_dt,
        "findings": [asdict(finding) for finding in findings],
        "creep": [_creep_of(prediction, load) for prediction in creep],
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


def print_text(target: str, load: Load, findings: Sequence[Finding], creep: Sequence[Prediction]) -> None:
    found = lines(findings)
    print(f"{target}: {len(found)} findings" if found else f"{target}: nothing found")
    for line in found:
        print(f"  {line}")
    if creep:
        print("predicted creep, which is no finding:")
    for prediction in creep:
        print(f"  {said(prediction, load)}")
