"""Run the shake test as a Newton example.

python -m experiments.shake --viewer gl
python -m experiments.shake --viewer null --pad-ke 2.5e5 --pad-kd 1e3 --test --json
summary.json
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
from experiments.simulation.measurement import absent, summarize
from experiments.simulation.simulation import Simulation
from experiments.simulation.stepper_c import device_of

# Half the cube's edge. With more slip, the pads no longer cover the cube's centre.
SLIP_LIMIT_MM = 20.0
OPTIONS = {  # the option and its description for each parameter of a case
    "shake_amplitude_m": ("--shake-amplitude", "[m]"),
    "shake_frequency_hz": ("--shake-frequency", "[Hz]"),
    "pad_ke": ("--pad-ke", "authored pad stiffness"),
    "pad_kd": ("--pad-kd", "authored pad damping"),
    "pad_mu": ("--pad-mu", "pad friction"),
    "cube_gap_m": ("--cube-gap", "contact gap of the cube [m]"),
    "substeps": ("--substeps", "solver steps per frame"),
}


class TestFailed(ValueError):
    """Signal that the scene's own test failed; the message is one line."""


def refuse(message: str) -> NoReturn:
    """Raise CaseError with an error of the command line."""
    raise CaseError(" ".join(message.split()))


def create_parser():
    """Return a parser with the arguments of Newton's examples and of this scene.

    It raises CaseError for invalid arguments.
    """
    parser = newton.examples.create_parser()
    parser.error = refuse
    parser.set_defaults(num_frames=AS_SHIPPED.frame_count)
    for name, (option, text) in OPTIONS.items():
        default = getattr(AS_SHIPPED, name)
        parser.add_argument(
            option, dest=name, type=type(default), default=default, help=text
        )
    backends = {
        "choices": ("warp", "mujoco"),
        "default": "warp",
        "help": "MuJoCo Warp or MuJoCo's C engine",
    }
    parser.add_argument("--backend", **backends)
    parser.add_argument(
        "--json", type=Path, metavar="FILE", help="write the measured summary there"
    )
    return parser


def case_of(args: argparse.Namespace) -> Case:
    """Return the case that the command line describes.

    Raise CaseError if a value is invalid.
    """
    if args.num_frames < 1:
        raise CaseError("--num-frames must be at least 1")
    parameters = {name: getattr(args, name) for name in (*OPTIONS, "backend")}
    return replace(AS_SHIPPED, name="shake", frame_count=args.num_frames, **parameters)


class Example:
    """Provide the scene to ``newton.examples.run``.

    Each step runs a frame, which is then drawn. A test at the end checks whether the
    cube is still in the grasp.
    """

    def __init__(self, viewer, case: Case):
        self.viewer = viewer
        self.case = case
        device = wp.get_device(device_of(case, None))
        if device.is_cuda:
            compile_first("cuda")
        self.simulation = Simulation([case], device)
        self.model = self.simulation.model
        self.state_0 = self.simulation.state
        self.frame_count = 0
        viewer.set_model(self.model)

    def step(self) -> None:
        self.simulation.step()
        self.frame_count += 1

    def render(self) -> None:
        self.viewer.begin_frame(self.frame_count * self.simulation.frame_dt)
        self.viewer.log_state(self.state_0)
        self.viewer.end_frame()

    def summary(self) -> dict[str, Any]:
        """Return the row of the frames so far, without their wall time.

        ``dropped`` is None unless the cube was shaken.
        """
        frame_count = min(self.frame_count, self.case.frame_count)
        [trace] = self.simulation.recorder.traces(frame_count=frame_count)
        row = summarize(self.case, trace)
        del row["wall_s"]
        if row["slip_mm"] is None:
            row |= absent(["dropped"], row["slip_mm_reason"])
        return row

    def test_final(self) -> None:
        """Raise TestFailed if the cube has left the grasp."""
        summary = self.summary()
        if summary["slip_mm"] is None:
            raise TestFailed(
                f"{summary['slip_mm_reason']} in {self.frame_count} frames"
            )
        if summary["dropped"] or summary["slip_mm"] > SLIP_LIMIT_MM:
            raise TestFailed(
                f"the cube left the grasp (slip {summary['slip_mm']:.2f} mm)"
            )


def run() -> int:
    """Run the scene with the options of the command line and return the exit status."""
    parser = create_parser()
    args = parser.parse_args()
    case = case_of(args)
    if args.json:
        # report a file that cannot be written before the run
        args.json.open("a").close()
    try:
        viewer, args = newton.examples.init(parser)
    # Viewers can raise any exception.
    except Exception as error:
        raise CaseError(
            f"--viewer {args.viewer} --device {args.device}: {' '.join(str(error).split())}"
        ) from None
    example = Example(viewer, case)
    status = 0
    try:
        newton.examples.run(example, args)
    except TestFailed as failure:
        print(f"the test failed: {failure}", file=sys.stderr)
        status = 1
    summary = example.summary()
    if args.json:
        args.json.write_text(
            json.dumps(summary, indent=1, default=np.generic.item) + "\n",
            encoding="utf-8",
        )
    if summary["slip_mm"] is None:
        print(f"no slip: {summary['slip_mm_reason']}", flush=True)
    else:
        print(
            f"slip {summary['slip_mm']:.3g} mm, drift {summary['drift_mm_s']:.3g} mm/s",
            flush=True,
        )
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
