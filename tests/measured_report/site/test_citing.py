"""How a report is cited, and where its sources lie."""

import subprocess

import pytest

from measured_report.site.citing import sources, web_address


@pytest.mark.parametrize(
    "remote, address",
    [
        ("https://github.com/a/b.git", "https://github.com/a/b"),
        ("https://someone:ghp_secret@github.com/a/b", "https://github.com/a/b"),
        ("https://github.com/a/b?token=secret#secret", "https://github.com/a/b"),
        ("git@github.com:a/b.git", "https://github.com/a/b"),
        ("ssh://git@github.com:22/a/b.git/", "https://github.com/a/b"),
        ("/srv/git/b.git", ""),
        ("../b", ""),
        ("file:///srv/b.git", ""),
        ("C:\\b", ""),
        ("", ""),
    ],
)
def test_a_remote_leads_to_its_page_and_never_with_what_opens_it(remote, address):
    assert web_address(remote) == address


def test_a_report_inside_another_repository_has_not_its_origin(tmp_path):
    for command in (["init", "--quiet"], ["remote", "add", "origin", "https://example.org/a/b.git"]):
        subprocess.run(["git", *command], cwd=tmp_path, check=True)
    (tmp_path / "inner").mkdir()
    assert sources(tmp_path) == "https://example.org/a/b"
    assert sources(tmp_path / "inner") == ""
