"""MuJoCo Warp, which is asked where it is installed: what it refuses, and whether it has the noslip pass."""

import contextlib
import importlib
import os
from collections.abc import Iterator

import mujoco

from newton_lint.target import TargetError


@contextlib.contextmanager
def muted_standard_error() -> Iterator[None]:
    """Mute Warp's library: of a machine without a GPU it warns, and the lint takes none."""
    terminal = os.dup(2)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)  # the descriptor: a library in C knows no sys.stderr
    try:
        yield
    finally:
        os.dup2(terminal, 2)
        os.close(terminal)
        os.close(nowhere)


def refusal(model: mujoco.MjModel) -> str:
    """Return why ``put_model`` refuses a model, empty where it takes it; TargetError without MuJoCo Warp."""
    try:
        with muted_standard_error():
            warp = importlib.import_module("warp")
            engine = importlib.import_module("mujoco_warp")
            warp.config.quiet = True
            warp.init()
    except ImportError as error:
        raise TargetError(
            f"--engine warp takes MuJoCo Warp: pip install mujoco-warp ({error})"
        ) from error
    try:
        with (
            muted_standard_error(),
            warp.ScopedDevice("cpu"),
        ):  # a machine without a GPU is to answer too
            engine.put_model(model)
    except Exception as error:  # of several kinds, and all are its words
        return " ".join(str(error).split()) or type(error).__name__
    return ""


def has_noslip() -> bool:
    """Tell whether the installed release has the noslip pass."""
    with contextlib.suppress(ImportError), muted_standard_error():
        return hasattr(
            importlib.import_module("mujoco_warp").Option, "noslip_iterations"
        )
    return False
