"""Serving the site here: what changes is built again, and pages reload; those that are published know nothing of it."""

import io
import re
import sys
import threading
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import BinaryIO

from measured_report.files.errors import UsageError

SCRIPT, BUILD = "/.reload.js", "/.build"
"""Addresses, beside those of the site, of the script and of the number of the build."""
RELOAD = b"""let shown = "";
setInterval(async () => {
  const built = await fetch("/.build").then((answer) => answer.text(), () => shown);
  if (shown && built !== shown) location.reload();
  shown = built;
}, 500);
"""
HOSTS = {"127.0.0.1", "localhost", "[::1]"}
"""Names of this machine: a page from elsewhere, whose name leads here, is not to read what is served."""


class _Handler(SimpleHTTPRequestHandler):
    """A handler that answers with the files of the site, and with the pages' reloading."""

    server: "Server"

    def send_head(self) -> io.BytesIO | BinaryIO | None:
        if re.sub(r":\d*$", "", self.headers.get("Host", "")).lower() not in HOSTS:
            self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
            return None
        if self.path == SCRIPT:
            return self._answer(RELOAD, "text/javascript")
        if self.path == BUILD:
            return self._answer(str(self.server.build_count).encode(), "text/plain")
        path = Path(self.translate_path(f"{self.path}index.html" if self.path.endswith("/") else self.path))
        if path.suffix == ".html" and path.is_file():
            return self._answer(reloading(path.read_bytes()), "text/html")
        try:
            return super().send_head()
        except ValueError:  # a name that no file can have
            self.send_error(HTTPStatus.NOT_FOUND)
            return None

    def _answer(self, content: bytes, kind: str) -> io.BytesIO:
        self.send_response(HTTPStatus.OK)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        return io.BytesIO(content)

    def end_headers(self) -> None:
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def list_directory(self, path) -> None:
        self.send_error(HTTPStatus.NOT_FOUND)

    def log_message(self, format: str, *args) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """A server of a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        self.build_count = 0
        try:
            super().__init__(("127.0.0.1", port), partial(_Handler, directory=str(folder)))
        except (OSError, OverflowError) as error:
            raise UsageError(f"PORT={port} can't be served at: {error}; PORT=8001 may be free") from None

    def handle_error(self, request, client_address) -> None:
        """Say in one line what went wrong, unless it is that whoever asked has gone."""
        error = sys.exc_info()[1]
        if not isinstance(error, ConnectionError | TimeoutError):
            print(f"could not be served: {' '.join(str(error).split())}", file=sys.stderr)

    def follow(self, folders: Iterable[Path], build: Callable[[], object]) -> None:
        """Serve until Ctrl-C, and build first, and again whenever something in these folders has changed."""
        threading.Thread(target=self.serve_forever, daemon=True).start()
        before = None
        while True:
            now = stamp(folders)
            if now != before:
                before = now  # as it was when the build began: what changes meanwhile is seen the next time
                build()
                self.build_count += 1
            time.sleep(0.5)


def reloading(page: bytes) -> bytes:
    """Return a page as it is served: it may also run the script, and ask for the number of the build."""
    page = page.replace(b"default-src 'none'", b"default-src 'none'; connect-src 'self'", 1)
    page = page.replace(b"script-src ", b"script-src 'self' ", 1)
    return page.replace(b"</head>", b'<script src="%s" defer></script>\n</head>' % SCRIPT.encode(), 1)


def stamp(folders: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """Return when each file in some folders was changed, and its size."""
    found = {}
    for path in (path for folder in folders for path in folder.rglob("*") if "__pycache__" not in path.parts):
        with suppress(OSError):  # it was removed just now
            found[path] = path.stat().st_mtime_ns, path.stat().st_size
    return found
