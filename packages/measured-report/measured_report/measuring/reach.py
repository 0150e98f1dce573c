"""Reach: run a module as a program, and note which instructions of some code it executed.

``python -P reach.py SPANS FOLDER MODULE …``: SPANS is a JSON file with the first and last lines of definitions by file.
Each process writes into FOLDER what it executed of these, by section, ``""`` for importing it, and by file: line, last
line, column, last column, and whether times were measured meanwhile. Of batches that measure times it writes a digest
of the work that the host notes. It imports nothing of the program that it follows. A Python that this program starts
is followed as well: it meets this file as ``sitecustomize``, which comes before all else.
"""

import atexit
import json
import os
import runpy
import sys
from collections import defaultdict
from contextlib import suppress
from hashlib import sha256
from itertools import count
from pathlib import Path
from types import CodeType, FrameType
from typing import Any

MEASURING, LEADING = "measure_batch", "advance"
"""Functions that measure a `batch`, of which times are `exclusive`, and that lead a section, `self`, to its record."""
WORKING = "_process_worker"  # what a process of a pool does until the pool ends; it runs no other exit handlers
HOST = "measured_report.measuring.host"
SETTING = "MEASURED_REPORT_REACH"  # of what is started: the arguments of `follow`


class Follower:
    """Follow the calls of this process and its forks."""

    def __init__(self, spans_file: str, folder: str, section: str, is_timed: bool):
        self.spans: dict[str, list[list[int]]] = json.loads(Path(spans_file).read_text(encoding="utf-8"))
        self.folder, self.numbers, self.arguments = Path(folder), count(), (spans_file, folder)
        self.is_noted = False
        self.measure(section, is_timed)
        # Not by the code itself: that of another file may be equal.
        self.executed: dict[tuple[int, str, bool], tuple[CodeType, set[int]]] = {}
        self.work, self.works = sha256(), defaultdict[str, dict[str, str]](dict)

    def called(self, frame: FrameType, event: str, _: Any) -> Any:
        code = frame.f_code
        if code.co_name in (MEASURING, LEADING):
            self.begin(frame.f_locals)
            frame.f_trace_lines = False
            return self.ended
        if code.co_name == WORKING:
            frame.f_trace_lines = False
            return self.worked
        lines = self.spans.get(code.co_filename)
        is_module = code.co_name == "<module>"
        if not lines or not (is_module or any(first <= code.co_firstlineno <= last for first, last in lines)):
            return None
        frame.f_trace_opcodes, frame.f_trace_lines = True, False
        _, places = self.executed.setdefault((id(code), self.section, self.is_timed), (code, set()))

        def executed(frame: FrameType, event: str, _: Any) -> Any:
            if event == "opcode":
                places.add(frame.f_lasti)
            return executed

        return executed

    def measure(self, section: str, is_timed: bool = False) -> None:
        """Note what is executed from now on, here and in what is started, as that of a section."""
        self.section, self.is_timed = section, is_timed
        os.environ[SETTING] = json.dumps([*self.arguments, section, is_timed])

    def begin(self, variables: dict[str, Any]) -> None:
        if "batch" not in variables:
            self.measure(str(getattr(variables.get("self"), "name", "")))
            return
        batch = variables["batch"]
        # One of no section's own module counts for none.
        self.measure(f"{batch.function.__module__}..".split(".")[1], batch.exclusive)
        self.work = sha256()
        if self.is_timed and not self.is_noted and hasattr(sys.modules[HOST].host(), "note_work"):
            sys.modules[HOST].host().note_work(lambda text: self.work.update(f"{text}\n".encode()))
            self.is_noted = True

    def ended(self, frame: FrameType, event: str, _: Any) -> Any:
        if event == "return":
            if self.is_timed and self.is_noted:
                self.works[self.section][frame.f_locals["batch"].name] = self.work.hexdigest()
            if frame.f_code.co_name == MEASURING:  # the process may be killed once its batch is done
                self.write()
            self.measure("")
        return self.ended

    def worked(self, frame: FrameType, event: str, _: Any) -> Any:
        if event == "return":
            self.write()
        return self.worked

    def write(self) -> None:
        executed_by_section: defaultdict[str, defaultdict[str, list[list[Any]]]] = defaultdict(
            lambda: defaultdict(list)
        )
        for (_, section, is_timed), (code, offsets) in list(self.executed.items()):
            positions = list(code.co_positions())
            executed_by_section[section][code.co_filename] += [
                [*positions[offset // 2], is_timed] for offset in offsets
            ]
        path = self.folder / f"{os.getpid()}-{next(self.numbers)}.json"
        path.write_text(json.dumps({"executed": executed_by_section, "work": self.works}), encoding="utf-8")


def follow(*arguments: Any) -> None:
    follower = Follower(*arguments)
    atexit.register(follower.write)
    sys.settrace(follower.called)


def main() -> None:
    spans_file, folder, module, *arguments = sys.argv[1:]
    started = Path(folder) / "started"
    with suppress(FileExistsError):  # of an earlier run
        started.mkdir()
        (started / "sitecustomize.py").symlink_to(__file__)
    os.environ["PYTHONPATH"] = os.pathsep.join([str(started), os.environ.get("PYTHONPATH", "")])
    sys.path.insert(0, str(Path.cwd()))
    sys.argv = [module, *arguments]
    follow(spans_file, folder, "", False)
    runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
elif __name__ == "sitecustomize":
    follow(*json.loads(os.environ[SETTING]))
