"""Serve site/ at http://127.0.0.1:8000, rebuilt on every change."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import INPUTS, Project
from measured_report.files.errors import UsageError

PORT = {"type": int, "default": 8000, "help": "where to serve, 8000 if not given"}
OPTIONS = {"port": PORT, **shared("edition", "profile")}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.asked)
    server = server_of(project.site, arguments.port)
    print(
        f"serving {project.site.name}/ at http://127.0.0.1:{arguments.port}", flush=True
    )
    # A program of its own builds, since what changes may be the program.
    command = [sys.executable, "build.py", "page", "--profile", project.profile]
    command += [f"--{project.settings.flag}", arguments.release.asked]
    build = partial(subprocess.run, command, cwd=project.root, check=False)
    follow(server, [project.root / name for name in INPUTS], build)
    return 0


class _Handler(SimpleHTTPRequestHandler):
    def send_head(self) -> Any:
        """Answer whoever asks for this machine by its own name, with files of the site that no link leads out of."""
        host = self.headers.get("Host", "").partition(":")[0]
        if host not in ("127.0.0.1", "localhost"):
            # A page from elsewhere asks, whose name leads here.
            return self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
        name = self.translate_path(self.path)
        below = os.path.relpath(name, self.directory)
        expected = os.path.normpath(f"{os.path.realpath(self.directory)}/{below}")
        if "\0" in name or os.path.realpath(name) != expected:
            return self.send_error(HTTPStatus.NOT_FOUND)
        return super().send_head()

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Print nothing, since the output of builds would be lost in it."""


def server_of(folder: Path, port: int) -> ThreadingHTTPServer:
    """Return a server of a folder at a port of this machine."""
    handler = partial(_Handler, directory=str(folder))
    try:
        return ThreadingHTTPServer(("127.0.0.1", port), handler)
    except (OSError, OverflowError) as error:
        raise UsageError(
            f"PORT={port} can't be served at: {error}; PORT=8001 may be free"
        ) from None


def follow(
    server: ThreadingHTTPServer, folders: Sequence[Path], build: Callable[[], object]
) -> None:
    """Serve until Ctrl-C; build first, and again whenever something in these folders has changed."""
    threading.Thread(target=server.serve_forever, daemon=True).start()
    before = None
    while True:
        # As it was when the build began: what changes meanwhile is seen the next time.
        now = stamp(folders)
        if now != before:
            before = now
            build()
        time.sleep(0.5)


def stamp(folders: Iterable[Path]) -> dict[str, tuple[int, int]]:
    """Return when each file in some folders was changed, and its size."""
    stamps = {}
    for folder in folders:
        for parent, _, names in os.walk(folder):
            for name in names:
                path = os.path.join(parent, name)  # noqa: PTH118 # quicker
                with suppress(OSError):  # it was removed just now
                    info = os.stat(path)  # noqa: PTH116
                    stamps[path] = info.st_mtime_ns, info.st_size
    return stamps
