"""Test that releases are sorted by number and not by letter, and how an index describes
them.
"""

import io
import json

from measured_report.editions import release
from measured_report.editions.release import (
    full_version,
    read_label,
    release_date,
    releases_between,
    releases_of,
)


def test_versions_are_ordered_by_number_and_what_is_not_out_yet_stands_before_what_is():
    labels = [
        "1.9.0.dev1",
        "1.9.0a1",
        "1.9.0rc1",
        "1.9.0rc2",
        "1.9.0",
        "1.9.0.post1",
        "1.9.1",
        "1.10.0",
        "2.0.0",
    ]
    found = sorted(map(read_label, reversed(labels)), key=lambda each: each.order)
    assert [*map(str, found)] == labels and read_label("1.9").order == read_label(
        "1.9.0@cpu"
    ).order
    versions = {
        "1": "1.0.0",
        "1.8": "1.8.0",
        "1.8.0": "1.8.0",
        "1.8.0.1": "1.8.0.1",
        "1.8rc1": "1.8.0rc1",
    }
    assert {version: full_version(version) for version in versions} == versions
    assert full_version("1.8.dev3") == "1.8.0.dev3"


def test_releases_between_two_are_neither_of_them_and_no_candidates(monkeypatch):
    names = [
        f"newton-{version}-py3-none-any.whl"
        for version in ("1.10.0", "1.9", "1.9.0rc1", "1.2.0", "1.11.0")
    ]
    files = [
        {"filename": name, "upload-time": "2026-11-11T12:00:00Z"}
        for name in (*names, "newton-1.7.0.tar.gz")
    ]
    files += [{"filename": "newton-1.8.0-py3-none-any.whl", "yanked": "broken"}]
    answers = [json.dumps({"files": files}).encode()] * 4 + [b"<html>"]
    monkeypatch.setattr(
        "urllib.request.urlopen", lambda *_, **__: io.BytesIO(answers.pop(0))
    )
    monkeypatch.setattr(release, "_index_dates", release._index_dates.__wrapped__)
    assert [*map(str, releases_of("newton"))] == ["1.2.0", "1.9.0", "1.10.0", "1.11.0"]
    assert [*map(str, releases_between(read_label("1.2"), read_label("1.11")))] == [
        "1.9.0",
        "1.10.0",
    ]
    assert (
        release_date(read_label("1.9"))
        == "2026-11-11"
        != release_date(read_label("1.8"))
    )
    assert releases_of("newton") == []


def test_what_is_installed_is_a_release_where_its_pins_are_there_as_well():
    installed = {"newton": "1.8.0", "warp-lang": "1.19.0", "mujoco": "3.10.0"}
    labels = {
        "1.8": True,
        "1.8+warp-1.19.0": True,
        "1.8+warp-1.18.0": False,
        "1.8.1": False,
        "1.8.0+g1a2b3c4": False,
    }
    assert {
        label: read_label(label).is_installed_with(installed) for label in labels
    } == labels
