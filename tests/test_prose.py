"""Test that the check of prose finds each phrase of its rules, and that the hook
refuses long subjects.
"""

import re
from pathlib import Path

import pytest
from prose import check

from measured_report.files.root import ROOT

HOOKS = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")


def findings(monkeypatch, path: Path, text: str) -> list[str]:
    path.write_text(text, encoding="utf-8")
    monkeypatch.setattr(check, "ROOT", path.parent)
    return check.checked(path)[1]


@pytest.mark.parametrize("rule", [*check.RULES["rules"], check.RULES["verbs"]])
def test_a_rule_finds_its_example_and_not_the_better_form(rule, tmp_path, monkeypatch):
    path = tmp_path / "a.md"
    [line] = findings(monkeypatch, path, f"# Title\n\n{rule['found']}\n")
    assert line.startswith("a.md:3: ") and line.endswith(rule["better"])
    assert findings(monkeypatch, path, f"# Title\n\n{rule['quiet']}\n") == []


def test_code_and_questions_are_not_prose(tmp_path, monkeypatch):
    text = "Use `x is no y`.\n\n    x is no y\n\n```\nx is no y\n```\n\nWhat is it?\n"
    assert findings(monkeypatch, tmp_path / "a.md", text) == []
    text = "{% holds %}<!-- what -->{{ what }} holds.\n"
    assert findings(monkeypatch, tmp_path / "a.md.j2", text) == []


def test_docstrings_messages_and_comments_are_prose(tmp_path, monkeypatch):
    code = 'def f():\n    """Return it.\n\n    It is what is.\n    """\n'
    code += '    raise ValueError(f"{x} is no y")  # what is\n'
    lines = findings(monkeypatch, tmp_path / "a.py", code)
    assert [line.split(":")[1] for line in lines] == ["4", "6", "6"]


def test_a_room_that_exceeds_its_rate_fails(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(check, "ROOT", tmp_path)
    (tmp_path / "a.md").write_text("A seal is no signature of it, as it is not one.\n")
    for rate, status in ((83.0, 1), (84.0, 0)):
        monkeypatch.setitem(check.RULES, "rates", {"*.md": rate})
        assert check.main([]) == status
        assert ("83.3 findings per 1,000 words" in capsys.readouterr().out) == status


def test_the_hook_refuses_a_long_subject():
    pattern = re.search(r"id: subject\n.*\n +entry: '(.*)'", HOOKS)[1]
    for subject, is_refused in (("a" * 72, False), ("a" * 73, True)):
        message = f"{subject}\n\n{'b' * 99}\n"
        assert bool(re.search(pattern, message, re.MULTILINE | re.DOTALL)) == is_refused
    assert "commit-msg" in HOOKS.partition("\n")[2].partition("\n")[0]
