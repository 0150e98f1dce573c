"""Test the commit that records name."""

from toys import git

from measured_report.measuring.machine import commit


def test_a_commit_is_dirty_if_code_changed_but_not_by_new_results(toy, monkeypatch):
    monkeypatch.delenv("GIT_COMMIT", raising=False)
    monkeypatch.setattr(
        "measured_report.measuring.machine.current", lambda: toy.project.report
    )
    toy.measure()
    git(toy.project.root, "init", "--quiet")
    git(toy.project.root, "add", "--all")
    git(toy.project.root, "commit", "--quiet", "--message=x")
    clean = git(toy.project.root, "rev-parse", "--short=12", "HEAD").strip()
    assert commit() == clean
    toy.measure(end_mm=0.4)
    assert git(toy.project.root, "status", "--porcelain")
    assert commit() == clean
    toy.write("report.toml", (toy.project.root / "report.toml").read_text() + "\n# x\n")
    assert commit() == f"{clean}-dirty"
    git(toy.project.root, "checkout", "--", "report.toml")
    toy.write("experiments/new.py", "X = 1\n")
    assert commit() == f"{clean}-dirty"
