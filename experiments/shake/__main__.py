"""The shake test as a Newton example.

python -m experiments.shake --viewer gl
python -m experiments.shake --viewer null --pad-ke 2.5e5 --pad-kd 1e3 --test --json summary.json
python -m experiments.shake --viewer gl --replay results/newton-1.4.0/poses.as-shipped.csv.gz
"""

import importlib.util
import json
import os
import sys
from dataclasses import replace
from pathlib import Path

import newton.examples
import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, Case, CaseError
from experiments.facts.trace import Trace
from experiments.media.replay import Replay, load_poses
from experiments.simulation.measurement import summarize
from experiments.simulation.simulation import Simulation

SLIP_LIMIT_MM = 20.0
"""Half the cube's edge: with more slip the pads no longer cover the cube's centre."""


LARGEST = {"world_count": 65536, "substeps": 4096, "num_frames": 1_000_000}
"""More would be at work for days before anything is seen."""


class TestFailed(ValueError):
    """The scene's own test failed; the message is one line."""


class Example:
    """What ``newton.examples.run`` drives: one frame a step, drawn after it, judged at the end."""

    def __init__(self, viewer, args):
        self.viewer = viewer
        self.case = case_of(args)
        device = wp.get_device("cpu") if self.case.backend == "mujoco" else wp.get_device()
        self.simulation = Simulation([self.case] * args.world_count, device)
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

    def summaries(self) -> list[dict[str, object]]:
        """The measured summary of each world so far."""
        frame_count = min(self.frame_count, self.case.frame_count)
        traces = self.simulation.recorder.traces(self.simulation.frame_dt, frame_count, wall_s=0.0)
        return [summary_of(self.case, trace) for trace in traces]

    def test_final(self) -> None:
        """The cube must still be in the grasp, in every world; TestFailed when it is not."""
        for world, summary in enumerate(self.summaries()):
            if summary["failure"]:
                raise TestFailed(f"world {world}: {summary['failure']}")
            if summary["slip_mm"] is None:
                raise TestFailed(f"world {world}: {summary['slip_mm_reason']} in {self.frame_count} frames")
            if summary["dropped"] or summary["slip_mm"] > SLIP_LIMIT_MM:
                raise TestFailed(f"world {world}: the cube left the grasp (slip {summary['slip_mm']:.2f} mm)")


def summary_of(case: Case, trace: Trace) -> dict[str, object]:
    """The row of a trace, in which a cube that was not shaken, and perhaps not grasped yet, is not called dropped."""
    row = summarize(case, trace)
    del row["wall_s"]  # nothing is timed here
    reason = row.get("slip_mm_reason")
    return row | ({"dropped": None, "dropped_reason": reason} if reason else {})


def create_parser():
    """Newton's example arguments and the scene's own."""
    parser = newton.examples.create_parser()
    newton.examples.add_world_count_arg(parser)
    parser.set_defaults(num_frames=AS_SHIPPED.frame_count)
    parser.add_argument("--asset", choices=("own", "upstream"), default="own", help="robot description")
    parser.add_argument("--shake-amplitude", type=float, default=AS_SHIPPED.shake_amplitude_m, help="[m]")
    parser.add_argument("--shake-frequency", type=float, default=AS_SHIPPED.shake_frequency_hz, help="[Hz]")
    parser.add_argument("--pad-ke", type=float, default=AS_SHIPPED.pad_ke, help="authored pad stiffness")
    parser.add_argument("--pad-kd", type=float, default=AS_SHIPPED.pad_kd, help="authored pad damping")
    parser.add_argument("--pad-mu", type=float, default=AS_SHIPPED.pad_mu, help="pad friction")
    parser.add_argument("--cube-gap", type=float, default=AS_SHIPPED.cube_gap_m, help="contact gap of the cube [m]")
    parser.add_argument("--substeps", type=int, default=AS_SHIPPED.substeps, help="solver steps per frame")
    parser.add_argument(
        "--backend", choices=("warp", "mujoco"), default="warp", help="MuJoCo Warp or MuJoCo's C engine"
    )
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the measured summary there")
    parser.add_argument(
        "--replay", type=Path, metavar="FILE", help="show the kept poses of a run, and simulate nothing"
    )
    return parser


def case_of(args) -> Case:
    """The case that the command line describes; CaseError when a value makes no sense."""
    if args.backend == "mujoco" and args.world_count != 1:
        raise CaseError(f"--world-count must be 1 with --backend mujoco, got {args.world_count}")
    for name, largest in LARGEST.items():
        if not 1 <= getattr(args, name) <= largest:
            option = f"--{name.replace('_', '-')}"
            raise CaseError(f"{option} must be from 1 to {largest}, got {getattr(args, name)}")
    return replace(
        AS_SHIPPED,
        name="shake",
        asset="upstream" if args.asset == "upstream" else AS_SHIPPED.asset,
        shake_amplitude_m=args.shake_amplitude,
        shake_frequency_hz=args.shake_frequency,
        pad_ke=args.pad_ke,
        pad_kd=args.pad_kd,
        pad_mu=args.pad_mu,
        cube_gap_m=args.cube_gap,
        substeps=args.substeps,
        backend=args.backend,
        frame_count=args.num_frames,
    )


def check_device(name: str | None) -> None:
    """CaseError when warp has no such device."""
    try:
        wp.get_device(name)
    except (ValueError, RuntimeError):
        known = ", ".join(device.alias for device in wp.get_devices())
        raise CaseError(f"--device {name} is not there; this machine has {known}") from None


def check_viewer(name: str) -> None:
    """CaseError when the viewer can't open a window."""
    if name == "gl" and importlib.util.find_spec("pyglet") is None:
        raise CaseError("--viewer gl needs pyglet, which comes with newton[examples]; --viewer null opens no window")


def check_json(path: Path | None) -> None:
    """CaseError when no file can be written there, which would be found out only at the end."""
    if path and (
        (path.exists() and not path.is_file()) or not os.access(path if path.exists() else path.parent, os.W_OK)
    ):
        raise CaseError(f"--json {path} is no file in a folder that is there, and that can be written")


def main() -> int:
    try:
        return run(create_parser())
    except CaseError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stopped; nothing was written", file=sys.stderr)
        return 130
    except OSError as error:
        print(f"{error.filename or 'the output cannot be written'}: {error.strerror or error}", file=sys.stderr)
        return 1


def refuse(message: str) -> None:
    """CaseError with what the command line can't be."""
    raise CaseError(" ".join(message.split()))


def run(parser) -> int:
    """Run the scene as the command line says; the exit status."""
    parser.error = refuse
    args = parser.parse_args()
    case_of(args)
    check_device(args.device)
    check_viewer(args.viewer)
    check_json(args.json)
    poses = load_poses(args.replay) if args.replay else None
    try:
        viewer, args = newton.examples.init(parser)
    except (ImportError, ValueError, RuntimeError) as error:
        raise CaseError(f"--viewer {args.viewer}: {' '.join(str(error).split())}") from None
    if poses is not None:
        newton.examples.run(Replay(viewer, poses), args)
        return 0
    example = Example(viewer, args)
    status = 0
    try:
        newton.examples.run(example, args)
    except TestFailed as failure:
        print(f"the test failed: {failure}", file=sys.stderr)
        status = 1
    summary = plain(example.summaries()[0])
    if args.json:
        args.json.write_text(json.dumps(summary, indent=1) + "\n", encoding="utf-8")
    print(headline(summary), flush=True)
    return status


def headline(summary: dict[str, object]) -> str:
    """The summary in a line."""
    if summary["slip_mm"] is None:
        return f"no slip: {summary['slip_mm_reason']}"
    return f"slip {summary['slip_mm']:.3g} mm, drift {summary['drift_mm_s']:.3g} mm/s"


def plain(row: dict[str, object]) -> dict[str, object]:
    """The row with numpy's scalars turned into Python's."""
    return {name: value.item() if isinstance(value, np.generic) else value for name, value in row.items()}


if __name__ == "__main__":
    sys.exit(main())
