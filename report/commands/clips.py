"""Render the clips from the stored poses; this takes minutes on a GPU."""

import argparse
import subprocess
import sys

from experiments.facts.clip_record import clips_state as state  # noqa: F401, read by make status
from measured_report.commands.options import shared
from measured_report.editions.environment import add_group
from measured_report.editions.project import Project

OPTIONS = shared("edition", "device", "profile")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Run the renderer in a separate process and return its exit status."""
    add_group("clips", project.root)
    options = [f"--newton={project.release}", f"--profile={project.profile}"]
    options += [f"--device={arguments.device}"] if arguments.device else []
    command = [sys.executable, "-m", "experiments.media.render", *options]
    return subprocess.run(command, cwd=project.root, check=False).returncode
