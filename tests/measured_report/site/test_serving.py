"""Serving: what changes is built again, and only pages that are served know of it."""

import re
import threading
import time
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
