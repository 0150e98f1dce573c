"""Log each function in a folder that a program calls.

Python imports this file as ``sitecustomize`` before any other module, in all processes of
the program. Each line of the log contains the file, first line and name of a code object.
It is written at the first call, because a signal may end a process of a pool.
"""

import os
import sys
import threading
from types import CodeType, FrameType

# The log file and the folder, separated as in PATH.
VARIABLE = "MEASURED_REPORT_EXECUTED"


def follow(log: str, folder: str) -> None:
    """Append the functions in ``folder`` that this process calls to the file ``log``."""
    descriptor = os.open(log, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
    # Keep the code objects, so that Python does not use their ids again.
    logged: dict[int, CodeType] = {}

    def log_call(frame: FrameType, event: str, argument: object) -> None:
        code = frame.f_code
        if id(code) not in logged:
            logged[id(code)] = code
            if code.co_filename.startswith(folder):
                line = f"{code.co_filename}\t{code.co_firstlineno}\t{code.co_name}\n"
                os.write(descriptor, line.encode())

    threading.settrace(log_call)
    sys.settrace(log_call)


if __name__ == "sitecustomize" and VARIABLE in os.environ:
    follow(*os.environ[VARIABLE].split(os.pathsep))
