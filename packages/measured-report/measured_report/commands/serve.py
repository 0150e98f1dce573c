"""Serve site/ at http://127.0.0.1:8000, rebuilt on every change."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from itertools import chain
from pathlib import Path
from typing import Any

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import INPUTS, Project
from measured_report.files.errors import UsageError

PORT = {"type": int, "default": 8000, "help": "where to serve, 8000 if not given"}
OPTIONS = {"port": PORT, **shared("edition", "profile")}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.asked)
    server = Server(project.site, arguments.port)
    print(
        f"serving {project.site.name}/ at http://127.0.0.1:{arguments.port}", flush=True
    )
    options = [
        f"--{project.report.settings.flag}",
        arguments.release.asked,
        "--profile",
        project.profile,
    ]
    command = [
        sys.executable,
        "build.py",
        "page",
        *options,
    ]  # apart, since what changes may be the program
    folders = [project.root / name for name in INPUTS]
    server.follow(
        folders, partial(subprocess.run, command, cwd=project.root, check=False)
    )
    return 0


class _Handler(SimpleHTTPRequestHandler):
    def send_head(self) -> Any:
        """Answer who asks for this machine by its own name, with files of the site that are no links out of it."""
        path, folder = (
            os.path.normpath(self.translate_path(self.path)),
            os.path.realpath(self.directory),
        )
        if self.headers.get("Host", "").partition(":")[0] not in (
            "127.0.0.1",
            "localhost",
        ):
            return self.send_error(
                HTTPStatus.MISDIRECTED_REQUEST
            )  # a page from elsewhere, whose name leads here
        if "\0" in path or os.path.realpath(path) != os.path.normpath(
            folder + path.removeprefix(self.directory)
        ):
            return self.send_error(HTTPStatus.NOT_FOUND)
        return super().send_head()

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """Serve a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        try:
            super().__init__(
                ("127.0.0.1", port), partial(_Handler, directory=str(folder))
            )
        except (OSError, OverflowError) as error:
            raise UsageError(
                f"PORT={port} can't be served at: {error}; PORT=8001 may be free"
            ) from None

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing: whoever asked has gone."""

    def follow(self, folders: Iterable[Path], build: Callable[[], object]) -> None:
        """Serve until Ctrl-C, and build first, and again whenever something in these folders has changed."""
        threading.Thread(target=self.serve_forever, daemon=True).start()
        before = None
        while True:
            if (now := stamp(folders)) != before:
                before = now  # as it was when the build began: what changes meanwhile is seen the next time
                build()
            time.sleep(0.5)


def stamp(folders: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """Return when each file in some folders was changed, and its size."""
    stamps = {}
    walked = chain.from_iterable(
        map(os.walk, folders)
    )  # which passes over what vanishes meanwhile
    for path in (
        Path(folder, name) for folder, *names in walked for name in chain(*names)
    ):
        if "__pycache__" not in path.parts:
            with suppress(OSError):  # it was removed just now
                stamps[path] = path.stat().st_mtime_ns, path.stat().st_size
    return stamps
