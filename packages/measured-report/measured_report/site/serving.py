"""Serving the site here: what changes is built again."""

import os
import re
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
from urllib.parse import unquote

from measured_report.files.errors import UsageError

HOSTS = {"127.0.0.1", "localhost", "[::1]"}
"""Names of this machine: a page from elsewhere, whose name leads here, is not to read what is served."""


class _Handler(SimpleHTTPRequestHandler):
    """Answer with the files of the site, and list no folder."""

    def send_head(self) -> Any:
        is_own = re.sub(r":\d*$", "", self.headers.get("Host", "")).lower() in HOSTS
        if not is_own or "\0" in unquote(self.path):  # a name that no file can have
            self.send_error(HTTPStatus.NOT_FOUND if is_own else HTTPStatus.MISDIRECTED_REQUEST)
            return None
        return super().send_head()

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def list_directory(self, path) -> None:
        self.send_error(HTTPStatus.NOT_FOUND)

    def log_message(self, format: str, *args) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """Serve a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        try:
            super().__init__(("127.0.0.1", port), partial(_Handler, directory=str(folder)))
        except (OSError, OverflowError) as error:
            raise UsageError(f"PORT={port} can't be served at: {error}; PORT=8001 may be free") from None

    def handle_error(self, request, client_address) -> None:
        """Say nothing: whoever asked has gone."""

    def follow(self, folders: Iterable[Path], build: Callable[[], object]) -> None:
        """Serve until Ctrl-C, and build first, and again whenever something in these folders has changed."""
        threading.Thread(target=self.serve_forever, daemon=True).start()
        before = None
        while True:
            now = stamp(folders)
            if now != before:
                before = now  # as it was when the build began: what changes meanwhile is seen the next time
                build()
            time.sleep(0.5)


def stamp(folders: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """Return when each file in some folders was changed, and its size."""
    found = {}
    walked = (place for folder in folders for place in os.walk(folder))  # which passes over what vanishes meanwhile
    for path in (Path(place, name) for place, *names in walked for name in chain(*names)):
        if "__pycache__" not in path.parts:
            with suppress(OSError):  # it was removed just now
                found[path] = path.stat().st_mtime_ns, path.stat().st_size
    return found
