"""Serving: what changes is built again, and only pages that are served know of it."""

import re
import socket
import struct
import threading
import time
from http.client import HTTPConnection
from urllib.request import urlopen

from conftest import TEMPLATE

from measured_report.site.check import check_site
from measured_report.site.serving import BUILD, SCRIPT, Server, stamp

POLICY = re.compile(r'http-equiv="Content-Security-Policy" content="([^"]*)"')


def test_a_served_page_reloads_and_the_published_one_does_not(toy):
    toy.build()
    with Server(toy.project.site, 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}"

        def served(path: str) -> str:
            with urlopen(address + path) as answer:
                return answer.read().decode()

        for path in ("/", "/evidence.html", "/evidence.html?a=b"):
            page = served(path)
            assert f'<script src="{SCRIPT}" defer></script>' in page
            assert "connect-src 'self'" in POLICY.search(page)[1] and "script-src 'self'" in POLICY.search(page)[1]
        assert "location.reload()" in served(SCRIPT) and BUILD in served(SCRIPT)
        assert served("/style.css") == (toy.project.site / "style.css").read_text()
        assert served(BUILD) == "0"
        server.shutdown()
    assert SCRIPT not in toy.page and "connect-src" not in toy.page
    assert check_site(toy.project.site) == []


def test_what_changes_is_built_again(toy):
    server = Server(toy.project.site, 0)
    threading.Thread(target=server.follow, args=(toy.project.inputs, toy.build), daemon=True).start()
    while server.build_count < 1:  # the test has no limit of its own: it must not be a question of time
        time.sleep(0.05)
    assert "Stiff is" in toy.page
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace("Stiff", "Stiffer"))
    while server.build_count < 2:
        time.sleep(0.05)
    assert "Stiffer is" in toy.page
    server.shutdown()
    server.server_close()


def test_a_change_is_one_of_any_file_but_compiled_ones(toy):
    before = stamp(toy.project.inputs)
    toy.write("report/__pycache__/x.pyc", "")
    assert {path for path in stamp(toy.project.inputs) if path.is_file()} == {p for p in before if p.is_file()}
    for change in (
        lambda: toy.write("templates/new.md.j2", ""),
        lambda: (toy.project.root / "assets/robot.urdf").unlink(),
        lambda: toy.measure(),
    ):
        before = stamp(toy.project.inputs)
        change()
        assert stamp(toy.project.inputs) != before


def ask(server: Server, path: str, **headers: str) -> tuple[int, dict[str, str], bytes]:
    """Ask for a path as it is, with nothing made of it on the way."""
    connection = HTTPConnection("127.0.0.1", server.server_port)
    connection.request("GET", path, headers={name.replace("_", "-"): value for name, value in headers.items()})
    answer = connection.getresponse()
    return answer.status, dict(answer.getheaders()), answer.read()


def test_finding_7_serving_answers_whatever_is_asked_and_leads_nowhere_else(toy, capfd, tmp_path):
    toy.build()
    site = toy.project.site
    (tmp_path / "secret").write_text("secret")
    with Server(site, 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        for path in ("/%00", "/nothing", "/%ff", "/../secret", "/%2e%2e/secret", "//etc/passwd"):
            assert ask(server, path)[0] == 404, path
        assert ask(server, "/data")[:2][1]["Location"] == "/data/"
        assert ask(server, "/data/")[0] == 404
        assert ask(server, "/index.html", Host="elsewhere.example")[0] == 421
        assert ask(server, "/index.html", Host=f"localhost:{server.server_port}")[0] == 200
        with socket.create_connection(("127.0.0.1", server.server_port)) as gone:
            gone.sendall(b"GET /data.zip HTTP/1.0\r\nHost: localhost\r\n\r\n")
            gone.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        time.sleep(0.2)
        server.shutdown()
    assert capfd.readouterr().err == ""
