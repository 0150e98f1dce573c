"""Write a line for each function of a folder that a program calls, in all of its Python processes.

Python imports this file as ``sitecustomize``, before anything else. A function is named as its code object is: by file,
first line and name. It is written when it is first called, because a process of a pool may end by a signal.
"""

import os
import sys
import threading
from types import CodeType, FrameType

VARIABLE = "MEASURED_REPORT_EXECUTED"  # holds the file to write to and the folder, separated as in PATH


def follow(log: str, folder: str) -> None:
    descriptor = os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
    known: dict[int, CodeType] = {}  # each is kept, so that no other one gets its id

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
