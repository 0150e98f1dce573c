"""The shake test as a Newton example.

python -m experiments.shake --viewer gl
python -m experiments.shake --viewer null --pad-ke 2.5e5 --pad-kd 1e3 --test --json summary.json
"""

import argparse
import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, NoReturn

import newton.examples
import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, Case, CaseError
from experiments.simulation.host import compile_first
from experiments.simulation.measurement import summarize
from experiments.simulation.simulation import Simulation
from experiments.simulation.stepper_c import batches, device_of

SLIP_LIMIT_MM = 20.0  # half the cube's edge: with more slip the pads no longer cover the cube's centre
OPTIONS = {  # options, and what they are, by the parameters of a case
    "shake_amplitude_m": ("--shake-amplitude", "[m]"),
    "shake_frequency_hz": ("--shake-frequency", "[Hz]"),
    "pad_ke": ("--pad-ke", "authored pad stiffness"),
    "pad_kd": ("--pad-kd", "authored pad damping"),
    "pad_mu": ("--pad-mu", "pad friction"),
    "cube_gap_m": ("--cube-gap", "contact gap of the cube [m]"),
    "substeps": ("--substeps", "solver steps per frame"),
}


class TestFailed(ValueError):
    """The scene's own test failed; the message is one line."""


def refuse(message: str) -> NoReturn:
    """Raise CaseError with what the command line can't be."""
    raise CaseError(" ".join(message.split()))


def create_parser():
    """Return Newton's example arguments and the scene's own; bad ones are a CaseError."""
    parser = newton.examples.create_parser()
    newton.examples.add_world_count_arg(parser)
    parser.error = refuse
    parser.set_defaults(num_frames=AS_SHIPPED.frame_count)
    for name, (option, text) in OPTIONS.items():
        default = getattr(AS_SHIPPED, name)
        parser.add_argument(option, dest=name, type=type(default), default=default, help=text)
    backends = {"choices": ("warp", "mujoco"), "default": "warp", "help": "MuJoCo Warp or MuJoCo's C engine"}
    parser.add_argument("--backend", **backends)
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the measured summary there")
    return parser


def case_of(args: argparse.Namespace) -> Case:
    """Return the case that the command line describes; CaseError when a value makes no sense."""
    if args.num_frames < 1 or args.world_count < 1:
        raise CaseError("--num-frames and --world-count must be at least 1")
    parameters = {name: getattr(args, name) for name in (*OPTIONS, "backend")}
    case = replace(AS_SHIPPED, name="shake", frame_count=args.num_frames, **parameters)
    if len(batches([case] * args.world_count)) > 1:
        raise CaseError(f"--world-count must be 1 with --backend {args.backend}, which has one world")
    return case


class Example:
    """What ``newton.examples.run`` drives: one frame a step, drawn after it, judged at the end."""

    def __init__(self, viewer, case: Case, world_count: int):
        self.viewer = viewer
        self.case = case
        device = wp.get_device(device_of(case, None))
        if device.is_cuda:
            compile_first("cuda")
        self.simulation = Simulation([case] * world_count, device)
        self.model = self.simulation.model
        self.state_0 = self.simulation.state
        self.control = self.simulation.control
        self.contacts = self.simulation.contacts
        self.frame_count = 0
        viewer.set_model(self.model)

    def step(self) -> None:
        self.simulation.step()
        self.frame_count += 1

    def render(self) -> None:
        self.viewer.begin_frame(self.frame_count * self.simulation.frame_dt)
        self.viewer.log_state(self.state_0)
        self.viewer.end_frame()

    def summaries(self) -> list[dict[str, Any]]:
        """Return the row of each world so far; a cube that was not shaken is not called dropped, nothing timed."""
        rows = []
        frame_count = min(self.frame_count, self.case.frame_count)
        for trace in self.simulation.recorder.traces(frame_count=frame_count):
            row = summarize(self.case, trace)
            del row["wall_s"]
            if reason := row.get("slip_mm_reason"):
                row |= {"dropped": None, "dropped_reason": reason}
            rows.append({name: cell.item() if isinstance(cell, np.generic) else cell for name, cell in row.items()})
        return rows

    def test_final(self) -> None:
        """Raise TestFailed where the cube of any world is not in the grasp any more."""
        for world, summary in enumerate(self.summaries()):
            if summary["slip_mm"] is None:
                raise TestFailed(f"world {world}: {summary['slip_mm_reason']} in {self.frame_count} frames")
            if summary["dropped"] or summary["slip_mm"] > SLIP_LIMIT_MM:
                raise TestFailed(f"world {world}: the cube left the grasp (slip {summary['slip_mm']:.2f} mm)")


def run() -> int:
    """Run the scene as the command line says; the exit status."""
    parser = create_parser()
    args = parser.parse_args()
    case = case_of(args)
    if args.json:
        args.json.open("a").close()  # what cannot be written is said before the run
    try:
        viewer, args = newton.examples.init(parser)
    except Exception as error:  # viewers raise what they like
        raise CaseError(f"--viewer {args.viewer} --device {args.device}: {' '.join(str(error).split())}") from None
    example = Example(viewer, case, args.world_count)
    status = 0
    try:
        newton.examples.run(example, args)
    except TestFailed as failure:
        print(f"the test failed: {failure}", file=sys.stderr)
        status = 1
    summary = example.summaries()[0]
    if args.json:
        args.json.write_text(json.dumps(summary, indent=1) + "\n", encoding="utf-8")
    if summary["slip_mm"] is None:
        print(f"no slip: {summary['slip_mm_reason']}", flush=True)
    else:
        print(f"slip {summary['slip_mm']:.3g} mm, drift {summary['drift_mm_s']:.3g} mm/s", flush=True)
    return status


def main() -> int:
    try:
        return run()
    except (CaseError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
