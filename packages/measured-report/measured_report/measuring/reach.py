"""Reach: run a module as a program, and note which instructions of some code it executed.

``python -P reach.py SPANS FOLDER MODULE …``: SPANS is a JSON file with the first and last lines of definitions by file.
Each process writes into FOLDER what it executed of these: the section, ``""`` for importing it, whether times were
measured meanwhile, file, line, last line, column and last column. Of batches that measure times it writes a digest of
the work that the host notes. It imports nothing of the program that it follows. A Python that this program starts
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

BOUNDS = MEASURING, LEADING, WORKING = "measure_batch", "advance", "_process_worker"
"""Functions that measure a `batch`, of which times are `exclusive`, that lead a section, `self`, to its record, and in
which a process of a pool is until the pool ends: it runs no exit handlers."""
monitoring: Any = getattr(sys, "monitoring", None)  # none before Python 3.12
HOST = "measured_report.measuring.host"
SETTING = "MEASURED_REPORT_REACH"  # of what is started: the arguments of its `Follower`


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

    def follow(self) -> None:
        atexit.register(self.write)
        if not monitoring:
            sys.settrace(self._called)
            return
        events, tool = monitoring.events, monitoring.COVERAGE_ID
        monitoring.use_tool_id(tool, __name__)
        monitoring.register_callback(tool, events.PY_START, self._started)
        monitoring.register_callback(tool, events.PY_RETURN, lambda code, *_: self._ended(sys._getframe(1)))
        monitoring.register_callback(tool, events.INSTRUCTION, self._executed)
        monitoring.set_events(tool, events.PY_START)

    def _started(self, code: CodeType, _: int) -> Any:
        """Note of a function that begins which instructions it executes, each once."""
        if code.co_name in BOUNDS:
            monitoring.set_local_events(monitoring.COVERAGE_ID, code, monitoring.events.PY_RETURN)
            self._begin(sys._getframe(1))
            return None
        if self._is_followed(code):
            monitoring.set_local_events(monitoring.COVERAGE_ID, code, monitoring.events.INSTRUCTION)
        return monitoring.DISABLE

    def _executed(self, code: CodeType, offset: int) -> Any:
        self._offsets(code).add(offset)
        return monitoring.DISABLE

    def _called(self, frame: FrameType, event: str, _: Any) -> Any:
        """Do as `_started` where Python has no monitoring, which tells each instruction each time."""
        frame.f_trace_lines = False
        if frame.f_code.co_name in BOUNDS:
            self._begin(frame)
            return self._left
        if not self._is_followed(frame.f_code):
            return None
        frame.f_trace_opcodes = True
        offsets = self._offsets(frame.f_code)

        def executed(frame: FrameType, event: str, _: Any) -> Any:
            if event == "opcode":
                offsets.add(frame.f_lasti)
            return executed

        return executed

    def _left(self, frame: FrameType, event: str, _: Any) -> Any:
        if event == "return":
            self._ended(frame)
        return self._left

    def _is_followed(self, code: CodeType) -> bool:
        lines, first_line = self.spans.get(code.co_filename, ()), code.co_firstlineno
        return bool(lines) and (code.co_name == "<module>" or any(a <= first_line <= b for a, b in lines))

    def _offsets(self, code: CodeType) -> set[int]:
        return self.executed.setdefault((id(code), self.section, self.is_timed), (code, set()))[1]

    def measure(self, section: str, is_timed: bool = False) -> None:
        """Note what is executed from now on, here and in what is started, as that of a section."""
        self.section, self.is_timed = section, is_timed
        os.environ[SETTING] = json.dumps([*self.arguments, section, is_timed])
        if monitoring:
            monitoring.restart_events()

    def _begin(self, frame: FrameType) -> None:
        if frame.f_code.co_name == LEADING:
            self.measure(str(getattr(frame.f_locals.get("self"), "name", "")))
        elif frame.f_code.co_name == MEASURING:
            batch = frame.f_locals["batch"]
            # One of no section's own module counts for none.
            self.measure(f"{batch.function.__module__}..".split(".")[1], batch.exclusive)
            self.work = sha256()
            if self.is_timed and not self.is_noted and hasattr(sys.modules[HOST].host(), "note_work"):
                sys.modules[HOST].host().note_work(lambda text: self.work.update(f"{text}\n".encode()))
                self.is_noted = True

    def _ended(self, frame: FrameType) -> None:
        if self.is_timed and self.is_noted:
            self.works[self.section][frame.f_locals["batch"].name] = self.work.hexdigest()
        if frame.f_code.co_name != LEADING:  # the process may be killed once its batch is done
            self.write()
        if frame.f_code.co_name != WORKING:
            self.measure("")

    def write(self) -> None:
        executed = []
        for (_, section, is_timed), (code, offsets) in list(self.executed.items()):
            positions = list(code.co_positions())
            executed += [[section, is_timed, code.co_filename, *positions[offset // 2]] for offset in offsets]
        path = self.folder / f"{os.getpid()}-{next(self.numbers)}.json"
        path.write_text(json.dumps({"executed": executed, "work": self.works}), encoding="utf-8")


def main() -> None:
    spans_file, folder, module, *arguments = sys.argv[1:]
    started = Path(folder) / "started"
    with suppress(FileExistsError):  # of an earlier run
        started.mkdir()
        (started / "sitecustomize.py").symlink_to(__file__)
    os.environ["PYTHONPATH"] = os.pathsep.join([str(started), os.environ.get("PYTHONPATH", "")])
    sys.path.insert(0, str(Path.cwd()))
    sys.argv = [module, *arguments]
    Follower(spans_file, folder, "", False).follow()
    runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
elif __name__ == "sitecustomize":
    Follower(*json.loads(os.environ[SETTING])).follow()
