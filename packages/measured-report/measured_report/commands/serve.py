"""Serve site/ at http://127.0.0.1:8000, rebuilt on every change."""

import argparse
import subprocess
import sys
from functools import partial

from measured_report.commands.options import EDITION, refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.site.serving import Server

OPTIONS = {
    "port": {"type": int, "default": 8000, "help": "where to serve, 8000 if not given"},
    **shared("edition", "profile"),
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Serve the site until Ctrl-C, and build it again whenever something changes."""
    refuse_unmeasured(project, arguments.release.asked)
    server = Server(project.site, arguments.port)
    print(f"serving {project.site} at http://127.0.0.1:{arguments.port}", flush=True)
    options = [f"--{EDITION}", arguments.release.asked, "--profile", project.profile]
    command = [sys.executable, "build.py", "page", *options]  # apart, since what changes may be the program
    server.follow(project.inputs, partial(subprocess.run, command, cwd=project.root, check=False))
    return 0
