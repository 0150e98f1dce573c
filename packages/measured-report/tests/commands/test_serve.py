"""Test that the server rebuilds changed files and answers requests."""

import os
import shutil
import threading
import time
from http.client import HTTPConnection
from http.server import ThreadingHTTPServer

import pytest
from toys import TEMPLATE

from measured_report.commands.serve import follow, server_of, stamp
from measured_report.editions.project import INPUTS


def test_what_changes_is_built_again(toy):
    server, built = server_of(toy.project.site, 0), []

    def build() -> None:
        toy.build()
        built.append(toy.page)

    folders = [toy.project.root / name for name in INPUTS]
    arguments = (server, folders, build)
    threading.Thread(target=follow, args=arguments, daemon=True).start()
    while (
        not built
    ):  # there is no time limit here, because the test must not depend on speed
        time.sleep(0.05)
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace("Stiff", "Stiffer"))
    while len(built) < 2:
        time.sleep(0.05)
    assert "Stiff is" in built[0] and "Stiffer is" in built[1]
    server.shutdown()
    server.server_close()


def test_a_change_of_a_single_file_is_seen(toy):
    citation = toy.project.root / "CITATION.cff"
    before = stamp([citation])
    citation.write_text("title: Another toy\n")
    assert before != stamp([citation])
    citation.unlink()
    assert stamp([citation]) == {}


def test_a_folder_that_vanishes_while_it_is_looked_at_ends_nothing(toy, monkeypatch):
    scan = os.scandir

    def vanish(place):
        if str(place).endswith("templates/sections"):
            shutil.rmtree(place, ignore_errors=True)
        return scan(place)

    monkeypatch.setattr(os, "scandir", vanish)
    assert (
        stamp(toy.project.root / name for name in INPUTS)
        and not (toy.project.root / "templates/sections").exists()
    )


def test_serving_answers_with_files_of_the_site_alone(toy, capfd, tmp_path):
    toy.build()
    (tmp_path / "secret").write_text("secret")
    (toy.project.site / "link").symlink_to(tmp_path / "secret")
    (toy.project.site / "all").symlink_to(tmp_path)
    with server_of(toy.project.site, 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        for path in ("/link", "/all/secret", "/all/"):
            assert answered(server, path) == 404
        for host, status in {
            "localhost:1": 200,
            "elsewhere.example": 421,
            "": 421,
        }.items():
            assert answered(server, "/", Host=host) == status
        for path, status in {
            "/": 200,
            "/nothing": 404,
            "/../secret": 404,
            "/%2e%2e/secret": 404,
            "/%00": 404,
        }.items():
            assert answered(server, path) == status, path
        server.shutdown()
    assert capfd.readouterr().err == ""


LINKED = {
    "a file": "index.html",
    "the index of a folder": "figures/index.html",
    "a folder": "all",
    "a file of a folder": "figures/more.svg",
    "a file within the site": "again.html",
}


@pytest.mark.parametrize("name", LINKED.values(), ids=LINKED)
@pytest.mark.parametrize("end", ["a link", "a pipe", "a link to a pipe"])
def test_nothing_is_sent_that_is_a_link_or_a_pipe(built, tmp_path, name, end):
    """Test that a file is served neither by its own name nor as the index of its
    folder, and that a pipe does not block the server.
    """
    site = built.project.site
    (tmp_path / "secret").mkdir()
    (tmp_path / "secret/index.html").write_text("secret")
    path = site / name
    path.unlink(missing_ok=True)
    target = site / "cause.html" if "again" in name else tmp_path / "secret/index.html"
    if "link" in end:
        target = tmp_path / "secret" if name == "all" else target
        path.symlink_to(tmp_path / "pipe" if "pipe" in end else target)
    if "pipe" in end:
        os.mkfifo(path if end == "a pipe" else tmp_path / "pipe")
    with server_of(site, 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        folder = name.rpartition("/")[0]
        for asked in (name, name.removesuffix("index.html"), f"{folder}/.//{name}"):
            if asked.rpartition("/")[2] or name.endswith("index.html"):
                assert answered(server, f"/{asked}") == 404, asked
        assert answered(server, "/style.css") == 200
        server.shutdown()


def test_a_folder_is_answered_with_its_index_alone(built):
    """Test that the names of files in a folder without an index are not listed."""
    inner = built.project.site / "newton-1.8.0"
    inner.mkdir()
    (inner / "index.html").write_text("inner")
    with server_of(built.project.site, 0) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        statuses = {"/newton-1.8.0/": 200, "/newton-1.8.0": 301, "/figures/": 404}
        for path, status in statuses.items():
            assert answered(server, path) == status, path
        server.shutdown()


def answered(server: ThreadingHTTPServer, path: str, **headers: str) -> int:
    connection = HTTPConnection("127.0.0.1", server.server_port)
    connection.request("GET", path, headers=headers)
    return connection.getresponse().status
