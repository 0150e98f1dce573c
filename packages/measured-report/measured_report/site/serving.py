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
POLICY = {b"default-src 'none'": b"default-src 'none'; connect-src 'self'", b"script-src ": b"script-src 'self' "}
"""Rights of a page besides as it is served: ask for the number of the build, and run the script."""
HOSTS = {"127.0.0.1", "localhost", "[::1]"}
"""Names of this machine: a page from elsewhere, whose name leads here, is not to read what is served."""
RANGE = re.compile(r"bytes=(\d{1,18})-(\d{0,18})")


class _Handler(SimpleHTTPRequestHandler):
    """A handler that answers with the files of the site, and with the pages' reloading."""

    server: "Server"

    def send_head(self) -> BinaryIO | None:
        if re.sub(r":\d*$", "", self.headers.get("Host", "")).lower() not in HOSTS:
            self.send_error(HTTPStatus.MISDIRECTED_REQUEST)
            return None
        if self.path == SCRIPT:
            return self._answer(RELOAD, "text/javascript")
        if self.path == BUILD:
            return self._answer(str(self.server.build_count).encode(), "text/plain")
        path = Path(self.translate_path(self.path))
        with suppress(OSError, ValueError):  # of a name that no file can have
            if path.is_dir() and self.path.endswith("/"):
                path = path / "index.html"
            if path.is_file():
                content, kind = path.read_bytes(), self.guess_type(path)
                return self._answer(reloading(content) if path.suffix == ".html" else content, kind)
            if path.is_dir():
                return super().send_head()  # to the same with a slash at its end
        self.send_error(HTTPStatus.NOT_FOUND)
        return None

    def _answer(self, content: bytes, kind: str) -> io.BytesIO:
        """Begin an answer with some content, or with the part that was asked for, as players of clips do."""
        first, last = 0, len(content) - 1
        if asked := RANGE.fullmatch(self.headers.get("Range", "")):
            first, last = int(asked[1]), min(int(asked[2] or last), last)
        is_part = bool(asked) and first <= last
        part = content[first : last + 1] if is_part else content
        self.send_response(HTTPStatus.PARTIAL_CONTENT if is_part else HTTPStatus.OK)
        if is_part:
            self.send_header("Content-Range", f"bytes {first}-{last}/{len(content)}")
        for name, value in {"Content-Type": kind, "Content-Length": len(part), "Accept-Ranges": "bytes"}.items():
            self.send_header(name, str(value))
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        return io.BytesIO(part)

    def log_message(self, format: str, *args) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """A server of a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        self.build_count = 0
        try:
            super().__init__(("127.0.0.1", port), partial(_Handler, directory=str(folder)))
        except OSError as error:
            raise UsageError(f"PORT={port} can't be served at: {error.strerror}; PORT=8001 may be free") from None

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
    """Return a page as it is served."""
    for strict, loose in POLICY.items():
        page = page.replace(strict, loose, 1)
    return page.replace(b"</head>", b'<script src="%s" defer></script>\n</head>' % SCRIPT.encode(), 1)


def stamp(folders: Iterable[Path]) -> dict[Path, tuple[int, int]]:
    """Return when each file in some folders was changed, and its size."""
    found = {}
    for path in (path for folder in folders for path in folder.rglob("*") if "__pycache__" not in path.parts):
        with suppress(OSError):  # it was removed just now
            found[path] = path.stat().st_mtime_ns, path.stat().st_size
    return found
