"""Serve site/ at http://127.0.0.1:8000 and rebuild it after every change."""

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
from measured_report.site.build import OTHER_INPUTS

PORT = {"type": int, "default": 8000, "help": "port to serve at (default: 8000)"}
OPTIONS = {"port": PORT, **shared("edition", "profile")}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.spec)
    server = server_of(project.site, arguments.port)
    print(
        f"serving {project.site.name}/ at http://127.0.0.1:{arguments.port}", flush=True
    )
    # Each build is a new process, because the change may be in the generator itself.
    command = [sys.executable, "build.py", "page", "--profile", project.profile]
    command += [f"--{project.settings.flag}", arguments.release.spec]
    build = partial(subprocess.run, command, cwd=project.root, check=False)
    follow(server, [project.root / name for name in (*INPUTS, *OTHER_INPUTS)], build)
    return 0


class _Handler(SimpleHTTPRequestHandler):
    def send_head(self) -> Any:
        """Return the requested file, if the request names this machine by a local name."""
        host = self.headers.get("Host", "").partition(":")[0]
        if host not in ("127.0.0.1", "localhost"):
            # A foreign page whose host name resolves to this machine sent the request.
            return self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
        return super().send_head()

    def translate_path(self, path: str) -> str:
        """Return the file that is sent for a path, with the index of a folder.

        Return an empty string for anything other than a regular file or a folder of the
        site, and if there is a link on the way.
        """
        name = super().translate_path(path)
        name += "index.html" if name.endswith("/") else ""
        below = os.path.relpath(name, self.directory)
        # Equal only if no part of the path below the site is a link.
        expected = os.path.normpath(f"{os.path.realpath(self.directory)}/{below}")
        file = Path(name)
        # Opening a pipe would wait for somebody to write to it.
        is_sent = "\0" not in name and os.path.realpath(file) == expected
        is_sent = is_sent and (file.is_file() or file.is_dir())
        return name if is_sent else ""

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, format: str, *args: Any) -> None:
        """Print nothing, so that the output of the builds stays readable."""


def server_of(folder: Path, port: int) -> ThreadingHTTPServer:
    """Return a server for a folder at a local port."""
    handler = partial(_Handler, directory=str(folder))
    try:
        return ThreadingHTTPServer(("127.0.0.1", port), handler)
    except (OSError, OverflowError) as error:
        raise UsageError(
            f"cannot serve at PORT={port} ({error}): try another port, such as "
            "PORT=8001"
        ) from None


def follow(
    server: ThreadingHTTPServer, sources: Sequence[Path], build: Callable[[], object]
) -> None:
    """Serve until Ctrl-C; build at the start and after each change of the sources.

    Sources are files and folders.
    """
    threading.Thread(target=server.serve_forever, daemon=True).start()
    before = None
    while True:
        # Take the stamp before the build, so that a change during the build causes
        # another one.
        current = stamp(sources)
        if current != before:
            before = current
            build()
        time.sleep(0.5)


def stamp(sources: Iterable[Path]) -> dict[str, tuple[int, int]]:
    """Return the modification time and the size of each source file."""
    paths = []
    for source in sources:
        paths.append(str(source))
        for parent, _, names in os.walk(source):
            # os.path is faster than Path.
            paths += [os.path.join(parent, name) for name in names]  # noqa: PTH118
    stamps = {}
    for path in paths:
        with suppress(OSError):  # the file was just removed
            info = os.stat(path)  # noqa: PTH116
            stamps[path] = info.st_mtime_ns, info.st_size
    return stamps
