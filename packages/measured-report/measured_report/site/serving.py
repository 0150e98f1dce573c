"""Serving the site here: what changes is built again, and pages reload; those that are published know nothing of it."""

import io
import threading
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import partial
from http import HTTPStatus
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from measured_report import UsageError

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


class _Handler(SimpleHTTPRequestHandler):
    """Answers with the files of the site, and with the pages' reloading."""

    server: "Server"

    def send_head(self):
        path = self.path.partition("?")[0]
        file = Path(self.translate_path(path))
        file = file / "index.html" if path.endswith("/") else file
        if path == SCRIPT:
            content, kind = RELOAD.encode(), "text/javascript"
        elif path == BUILD:
            content, kind = str(self.server.build_count).encode(), "text/plain"
        elif file.suffix == ".html" and file.is_file():
            content, kind = reloading(file.read_bytes()), "text/html; charset=utf-8"
        else:
            return super().send_head()
        self.send_response(HTTPStatus.OK)
        for name, value in {"Content-Type": kind, "Content-Length": len(content), "Cache-Control": "no-store"}.items():
            self.send_header(name, str(value))
        self.end_headers()
        return io.BytesIO(content)

    def log_message(self, format: str, *args) -> None:
        """Say nothing of what was asked for: what was built again would be lost in it."""


class Server(ThreadingHTTPServer):
    """Serves a folder at a port of this machine; UsageError where the port can't be had."""

    def __init__(self, folder: Path, port: int):
        self.build_count = 0
        try:
            super().__init__(("127.0.0.1", port), partial(_Handler, directory=folder))
        except OSError as error:
            raise UsageError(f"PORT={port} can't be served at: {error.strerror}; PORT=8001 may be free") from None

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
