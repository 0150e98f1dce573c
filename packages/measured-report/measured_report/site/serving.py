"""Serving the site here: what changes is built again, and pages reload; those that are published know nothing of it."""

import mimetypes
import re
import sys
import threading
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote, urlsplit

from measured_report.files.errors import UsageError

SCRIPT, BUILD = "/.reload.js", "/.build"
"""Addresses, beside those of the site, of the script and of the number of the build."""
RELOAD = """let shown = "";
setInterval(async () => {
  const built = await fetch("/.build").then((answer) => answer.text(), () => shown);
  if (shown && built !== shown) location.reload();
  shown = built;
}, 500);
"""
POLICY = {b"default-src 'none'": b"default-src 'none'; connect-src 'self'", b"script-src ": b"script-src 'self' "}
"""What a page may do besides as it is served: ask for the number of the build, and run the script."""
HOSTS = {"127.0.0.1", "localhost", "[::1]"}
"""What a browser may call this machine: a page from elsewhere, whose name leads here, is not to read what is served."""
RANGE = re.compile(r"bytes=(\d{0,18})-(\d{0,18})")


class _Handler(BaseHTTPRequestHandler):
    """Answers with the files of the site, and with the pages' reloading."""

    server: "Server"

    def __init__(self, *arguments, folder: Path):
        self.folder = folder
        super().__init__(*arguments)

    def do_GET(self) -> None:
        self._answer()

    def do_HEAD(self) -> None:
        self._answer()

    def _answer(self) -> None:
        host = re.sub(r":\d*$", "", self.headers.get("Host", "")).lower()
        path = unquote(urlsplit(self.path).path, errors="replace")
        file = self._file(path)
        if host not in HOSTS:
            self._send(HTTPStatus.MISDIRECTED_REQUEST, b"This is served to this machine alone.\n", "text/plain")
        elif path == SCRIPT:
            self._send(HTTPStatus.OK, RELOAD.encode(), "text/javascript")
        elif path == BUILD:
            self._send(HTTPStatus.OK, str(self.server.build_count).encode(), "text/plain")
        elif file is None:
            page = self._file("/404.html")
            self._send(HTTPStatus.NOT_FOUND, page.read_bytes() if page else b"", "text/html; charset=utf-8")
        elif file.is_dir():
            self._send(HTTPStatus.MOVED_PERMANENTLY, b"", "text/plain", {"Location": f"/{path.strip('/')}/"})
        elif file.suffix == ".html":
            self._send(HTTPStatus.OK, reloading(file.read_bytes()), "text/html; charset=utf-8")
        else:
            kind = mimetypes.guess_type(file.name)[0] or "application/octet-stream"
            self._send_part(file.read_bytes(), kind)

    def _file(self, path: str) -> Path | None:
        """What lies at a path below the folder, without a link on the way there; None for nothing."""
        with suppress(OSError, ValueError):  # of a name that no file can have
            root = self.folder.resolve()
            place = root / path.strip("/") / ("index.html" if path.endswith("/") else "")
            if place.resolve() == place and place.is_relative_to(root) and (place.is_file() or place.is_dir()):
                return place
        return None

    def _send_part(self, content: bytes, kind: str) -> None:
        """All of it, or the part that was asked for, as players ask for one."""
        first, last = 0, len(content) - 1
        asked = RANGE.fullmatch(self.headers.get("Range", ""))
        if asked and (asked[1] or asked[2]):
            first = int(asked[1]) if asked[1] else max(0, len(content) - int(asked[2]))
            last = min(last, int(asked[2])) if asked[1] and asked[2] else last
            if first > last:
                size = {"Content-Range": f"bytes */{len(content)}"}
                self._send(HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE, b"", kind, size)
                return
            part = {"Content-Range": f"bytes {first}-{last}/{len(content)}"}
            self._send(HTTPStatus.PARTIAL_CONTENT, content[first : last + 1], kind, part)
        else:
            self._send(HTTPStatus.OK, content, kind, {"Accept-Ranges": "bytes"})

    def _send(self, status: HTTPStatus, content: bytes, kind: str, more: dict[str, str] | None = None) -> None:
        self.send_response(status)
        own = {"Content-Type": kind, "Content-Length": str(len(content)), "Cache-Control": "no-store"}
        for name, value in {**own, **(more or {})}.items():
            self.send_header(name, value)
        self.end_headers()
        if self.command != "HEAD":
            self.wfile.write(content)

    def log_message(self, format: str, *args) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """Serves a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        self.build_count = 0
        try:
            super().__init__(("127.0.0.1", port), partial(_Handler, folder=folder))
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
