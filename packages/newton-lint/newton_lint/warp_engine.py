"""Asks MuJoCo Warp, if it is installed, which models and options it supports."""

import contextlib
import importlib
import os
from collections.abc import Iterator

import mujoco

from newton_lint.target import TargetError


@contextlib.contextmanager
def muted_standard_error() -> Iterator[None]:
    """Suppress standard error, where Warp warns about a missing GPU."""
    terminal = os.dup(2)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    # A library in C writes to the descriptor, not to sys.stderr.
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(terminal, 2)
        os.close(terminal)
        os.close(nowhere)


def refusal(model: mujoco.MjModel) -> str:
    """Return why ``put_model`` refuses a model, or an empty string if it does not.

    Raises:
        TargetError: MuJoCo Warp is not installed.
    """
    try:
        with muted_standard_error():
            warp = importlib.import_module("warp")
            engine = importlib.import_module("mujoco_warp")
            warp.config.quiet = True
            warp.init()
    except ImportError as error:
        raise TargetError(
            f"--engine warp needs MuJoCo Warp: pip install mujoco-warp ({error})"
        ) from error
    try:
        # The CPU also works on a machine without a GPU.
        with muted_standard_error(), warp.ScopedDevice("cpu"):
            engine.put_model(model)
    except Exception as error:  # put_model raises errors of several kinds.
        return " ".join(str(error).split()) or type(error).__name__
    return ""
