"""MuJoCo Warp, which is asked where it is installed: what it refuses, and whether it has the noslip pass."""

import contextlib
import importlib
import os
import warnings
from collections.abc import Iterator, Sequence

import mujoco


@contextlib.contextmanager
def muted_standard_error() -> Iterator[None]:
    """Return what Warp's library writes goes nowhere: of a machine without a GPU it warns, and the lint takes none."""
    kept, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)


def asked(model: mujoco.MjModel) -> tuple[str, Sequence[str]] | None:
    """Give a model to ``put_model``; None where MuJoCo Warp is not installed.

    Returns:
        Why it refuses the model, empty where it takes it, and what it warns of.
    """
    try:
        warp = importlib.import_module("warp")
        warp.config.quiet = True
        with muted_standard_error():
            warp.init()
            engine = importlib.import_module("mujoco_warp")
    except ImportError:
        return None
    with warnings.catch_warnings(record=True) as told, muted_standard_error(), warp.ScopedDevice("cpu"):
        warnings.simplefilter("always")
        try:
            engine.put_model(model)
            refused = ""
        except Exception as error:  # of several kinds, and all are its words
            refused = " ".join(str(error).split()) or type(error).__name__
    return refused, [" ".join(str(each.message).split()) for each in told if "mujoco_warp" in each.filename]


def has_noslip() -> bool:
    """Tell whether the installed release has the noslip pass."""
    with contextlib.suppress(ImportError), muted_standard_error():
        return hasattr(importlib.import_module("mujoco_warp").Option, "noslip_iterations")
    return False
