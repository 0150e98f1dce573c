"""The examples that Newton ships, each built as far as its solver: its model, and what the solver is given.

``python -m experiments.survey.examples`` builds and lints them all, each in a process of its own, and prints a line
of JSON for each; section survey keeps them.
"""

import contextlib
import importlib
import json
import multiprocessing
import os
import resource
import signal
import sys
import time
import warnings
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest import mock

import newton
import newton.examples
import newton.viewer
import warp as wp
from newton.solvers import SolverBase, SolverMuJoCo

from newton_lint.findings import tally
from newton_lint.newton_models.rules import Engine, findings_of, read

TIME_LIMIT_S = 120
"""Of a processor, for one example: what takes longer is a row without findings."""
MUJOCO = "mujoco"
DOWNLOADS = "newton._src.utils.download_assets.download_git_folder"
"""What all of Newton's downloads go through."""


class Unbuilt(Exception):
    """Why an example is not linted, in a few words."""


@dataclass(frozen=True)
class Example:
    """An example, or one with ``--solver mujoco`` where it offers that besides its own."""

    name: str
    module: str
    solver: str = ""

    @property
    def case(self) -> str:
        return f"{self.name}-{self.solver}" if self.solver else self.name


@dataclass(frozen=True)
class Built:
    """What an example hands its solver."""

    model: newton.Model
    solver: str
    engine: Engine


class _Reached(BaseException):
    """The example makes its solver; BaseException, so that no example takes it for a failure of its own."""

    def __init__(self, solver: SolverBase, model: newton.Model, options: dict[str, Any]):
        super().__init__()
        self.solver, self.model, self.options = solver, model, options


def examples() -> list[Example]:
    """All that the installed release has, by name; those that offer MuJoCo besides another solver twice."""
    found = []
    for name, module in sorted(newton.examples.get_examples().items()):
        found.append(Example(name, module))
        with contextlib.suppress(Exception):  # what does not import says so when it is built
            if _offers_mujoco(module):
                found.append(Example(name, module, MUJOCO))
    return found


def _offers_mujoco(module: str) -> bool:
    """Whether it has ``--solver`` with MuJoCo among the choices, and another one where nothing is said."""
    options = _parser(importlib.import_module(module))._actions
    choices = [option for option in options if option.dest == "solver" and MUJOCO in (option.choices or ())]
    return any(option.default != MUJOCO for option in choices)


def _parser(module):
    return getattr(module.Example, "create_parser", newton.examples.create_parser)()


def build(example: Example) -> Built:
    """Build an example as far as its first solver, which is not made.

    Raises:
        Unbuilt: It needs what is not installed, or a download, or it has no solver.
    """
    try:
        module = importlib.import_module(example.module)
        if not hasattr(module, "Example"):
            raise Unbuilt("has no class Example")
        given = newton.examples.default_args(_parser(module))
        if example.solver:
            given.solver = example.solver
        scene = module.Example.__new__(module.Example)
        with _stopped_at_the_solver(), mock.patch(DOWNLOADS, _refuse_download):
            scene.__init__(newton.viewer.ViewerNull(), given)
    except _Reached as reached:
        return _built(reached, scene)
    except Unbuilt:
        raise
    except ModuleNotFoundError as error:
        raise Unbuilt(f"needs the package {error.name}") from error
    except (Exception, SystemExit) as error:  # the code is Newton's, and may fail in any way
        said = " ".join(str(error).split())
        reason = "needs the package pxr" if "usd-core" in said else f"{type(error).__name__}: {said:.120}"
        raise Unbuilt(reason) from error
    raise Unbuilt("makes no solver")


@contextlib.contextmanager
def _stopped_at_the_solver() -> Iterator[None]:
    def reach(solver: SolverBase, /, *arguments, **options) -> None:
        raise _Reached(solver, arguments[0] if arguments else options["model"], options)

    with mock.patch.object(SolverBase, "__init__", reach), mock.patch.object(SolverMuJoCo, "__init__", reach):
        yield


def _refuse_download(*_, **__) -> None:
    raise Unbuilt("needs a download")


def _built(reached: _Reached, scene: Any) -> Built:
    options = reached.options
    cone, is_mujoco = options.get("cone"), isinstance(reached.solver, SolverMuJoCo)
    step = getattr(scene, "sim_dt", None)
    engine = Engine(
        substep_dt=step or 1.0,
        refsafe=bool(step),  # of a step that nobody knows no timeconst is too short
        contacts=MUJOCO if is_mujoco and options.get("use_mujoco_contacts", True) else "newton",
        cone=cone if isinstance(cone, str) else None,
        impratio=options.get("impratio"),
    )
    return Built(reached.model, type(reached.solver).__name__, engine)


def row_of(example: Example) -> dict[str, object]:
    """An example as a row: its solver, shapes and findings, or why there are none."""
    row = _place(example)
    try:
        built = build(example)
    except Unbuilt as error:
        return row | {"unbuilt": str(error)}
    scene = read(built.model, built.engine) if built.model.shape_count else None
    return row | {
        "unbuilt": "",
        "solver": built.solver,
        "shape_count": built.model.shape_count,
        "pair_count": len(scene.contacts.first) if scene else 0,
        "findings": tally(findings_of(scene)) if scene else [],
    }


def _place(example: Example) -> dict[str, object]:
    return {"case": example.case, "folder": example.module.split(".")[2]}


def rows_of_all(count: int | None = None) -> Iterator[dict[str, object]]:
    """The rows of all examples, on so many processors, in the order of ``examples``."""
    with ThreadPoolExecutor(count or os.cpu_count()) as pool:
        yield from pool.map(_row_apart, examples())


def _row_apart(example: Example) -> dict[str, object]:
    """The row of an example in a process of its own, which has a time limit and may die."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_send, args=(example, sender), daemon=True)
    process.start()
    sender.close()
    try:
        return receiver.recv()
    except EOFError:
        process.join()
        return _place(example) | {"unbuilt": _end_of(process.exitcode or 0)}
    finally:
        process.kill()
        process.join()


def _end_of(exit_code: int) -> str:
    if exit_code == -signal.SIGXCPU:
        return f"takes over {TIME_LIMIT_S} s"
    by = f"is killed by {signal.Signals(-exit_code).name}" if exit_code < 0 else f"ends with status {exit_code}"
    return f"{by} while it is built"


def _send(example: Example, sender: Any) -> None:
    # No hard limit beside it: a machine that stands still for a moment may reach both at once, and then kills.
    resource.setrlimit(resource.RLIMIT_CPU, (TIME_LIMIT_S, resource.RLIM_INFINITY))
    with Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        sender.send(row_of(example))


def main() -> int:
    wp.config.log_level = wp.LOG_WARNING
    wp.set_device("cpu")
    warnings.simplefilter("ignore")  # the examples' own
    start, count = time.perf_counter(), 0
    for row in rows_of_all():
        print(json.dumps(row), flush=True)
        count += 1
    used = sum(resource.getrusage(who).ru_utime for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    print(f"{count} examples in {time.perf_counter() - start:.0f} s, {used:.0f} s of processors", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
