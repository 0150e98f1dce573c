"""Test the options that the scene refuses as a Newton example, and the files that it
writes.
"""

import json
import math

import pytest

from experiments import shake

CONTRACT = ("slip_mm", "drift_mm_s", "cube_height_m", "dropped")


def run(monkeypatch, *arguments: str) -> int:
    monkeypatch.setattr(
        "sys.argv",
        ["shake", "--viewer", "null", "--quiet", "--backend", "mujoco", *arguments],
    )
    return shake.main()


def test_every_option_of_the_contract_is_there():
    named = "--viewer null --num-frames 9 --device cpu --test --shake-amplitude 0.02 --shake-frequency 2 --pad-ke 1e4"
    named += " --pad-kd 10 --pad-mu 0.5 --cube-gap 0.01 --substeps 4 --backend mujoco --json summary.json"
    case = shake.case_of(shake.create_parser().parse_args(named.split()))
    assert (
        case.shake_amplitude_m,
        case.shake_frequency_hz,
        case.substeps,
        case.frame_count,
    ) == (0.02, 2.0, 4, 9)
    assert (case.pad_ke, case.pad_kd, case.pad_mu, case.cube_gap_m, case.backend) == (
        1e4,
        10.0,
        0.5,
        0.01,
        "mujoco",
    )


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--pad-ke", "-1"], "pad_ke"),
        (["--shake-frequency", "nan"], "shake_frequency_hz"),
        (["--substeps", "0"], "substeps"),
        (["--num-frames", "0"], "--num-frames"),
        (["--viewer", "usd"], "--viewer usd"),
        (["--viewer", "file"], "argument --viewer"),
        (["--device", "cuda:99"], "cuda:99"),
        (["--viewer", "gl"], "pyglet"),
        (["--json", "/no/where/summary.json"], "/no/where/summary.json"),
    ],
)
def test_bad_input_gets_one_line_and_status_2(monkeypatch, capsys, arguments, message):
    assert run(monkeypatch, *arguments) == 2
    said = capsys.readouterr().err
    assert message in said and len(said.splitlines()) == 1


def test_a_run_writes_its_summary(monkeypatch, tmp_path):
    assert (
        run(
            monkeypatch, "--num-frames", "220", "--json", str(tmp_path / "summary.json")
        )
        == 0
    )
    found = json.loads((tmp_path / "summary.json").read_text())
    assert all(math.isfinite(found[name]) for name in CONTRACT)
    assert found["cube_height_m"] > 0.2 and found["dropped"] is False


def test_a_run_that_ends_before_the_shake_says_so_and_fails_its_test_in_one_line(
    monkeypatch, capsys, tmp_path
):
    path = tmp_path / "summary.json"
    assert run(monkeypatch, "--num-frames", "2", "--test", "--json", str(path)) == 1
    said = capsys.readouterr().err
    assert (
        "the shake was never reached in 2 frames" in said
        and len(said.splitlines()) == 1
    )
    found = json.loads(path.read_text())
    for name in CONTRACT:
        assert (found[name], found[f"{name}_reason"]) == (
            None,
            "the shake was never reached",
        )
