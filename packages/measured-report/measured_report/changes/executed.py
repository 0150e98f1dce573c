"""Write a line for each function in a folder that a program calls.

Python imports this file as ``sitecustomize`` before anything else, in all processes of
the program. A line contains the file, first line and name of the code object. It is
written at the first call, because a process of a pool may end by a signal.
"""

import os
import sys
import threading
from types import CodeType, FrameType

# The log file and the folder, separated as in PATH.
VARIABLE = "MEASURED_REPORT_EXECUTED"


def follow(log: str, folder: str) -> None:
    descriptor = os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
    known: dict[int, CodeType] = {}  # keeps the objects, so that no id is used twice

    def called(frame: FrameType, event: str, argument: object) -> None:
        code = frame.f_code
        if id(code) not in known:
            known[id(code)] = code
            if code.co_filename.startswith(folder):
                line = f"{code.co_filename}\t{code.co_firstlineno}\t{code.co_name}\n"
                os.write(descriptor, line.encode())

    threading.settrace(called)
    sys.settrace(called)


if __name__ == "sitecustomize" and VARIABLE in os.environ:
    follow(*os.environ[VARIABLE].split(os.pathsep))
