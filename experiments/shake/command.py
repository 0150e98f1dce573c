"""The command line of the example: its options, what it refuses, and what it writes."""

import importlib.util
import json
import os
import sys
from dataclasses import replace
from pathlib import Path

import newton.examples
import warp as wp

from experiments.facts.case import AS_SHIPPED, Case, CaseError
from experiments.shake.example import Example, TestFailed, headline, plain

LARGEST = {"world_count": 65536, "substeps": 4096, "num_frames": 1_000_000}
"""More would be at work for days before anything is seen."""


def create_parser():
    """Return Newton's example arguments and the scene's own."""
    parser = newton.examples.create_parser()
    newton.examples.add_world_count_arg(parser)
    parser.set_defaults(num_frames=AS_SHIPPED.frame_count)
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
    return parser


def case_of(args) -> Case:
    """Return the case that the command line describes; CaseError when a value makes no sense."""
    if args.backend == "mujoco" and args.world_count != 1:
        raise CaseError(f"--world-count must be 1 with --backend mujoco, got {args.world_count}")
    for name, largest in LARGEST.items():
        if not 1 <= getattr(args, name) <= largest:
            option = f"--{name.replace('_', '-')}"
            raise CaseError(f"{option} must be from 1 to {largest}, got {getattr(args, name)}")
    return replace(
        AS_SHIPPED,
        name="shake",
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
    """Raise CaseError when warp has no such device."""
    try:
        wp.get_device(name)
    except (ValueError, RuntimeError):
        known = ", ".join(device.alias for device in wp.get_devices())
        raise CaseError(f"--device {name} is not there; this machine has {known}") from None


def check_viewer(name: str) -> None:
    """Raise CaseError when the viewer can't open a window."""
    if name == "gl" and importlib.util.find_spec("pyglet") is None:
        raise CaseError("--viewer gl needs pyglet, which comes with newton[examples]; --viewer null opens no window")


def check_json(path: Path | None) -> None:
    """Raise CaseError when no file can be written there, which would be found out only at the end."""
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
    """Raise CaseError with what the command line can't be."""
    raise CaseError(" ".join(message.split()))


def run(parser) -> int:
    """Run the scene as the command line says; the exit status."""
    parser.error = refuse
    args = parser.parse_args()
    case = case_of(args)
    check_device(args.device)
    check_viewer(args.viewer)
    check_json(args.json)
    try:
        viewer, args = newton.examples.init(parser)
    except (ImportError, ValueError, RuntimeError) as error:
        raise CaseError(f"--viewer {args.viewer}: {' '.join(str(error).split())}") from None
    example = Example(viewer, case, args.world_count)
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
