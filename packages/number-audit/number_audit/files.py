"""Reads whole files, and replaces them without ever leaving an incomplete one."""

import os
import shutil
import stat
import tempfile
from pathlib import Path

BYTE_LIMIT = 256 << 20


class AuditError(Exception):
    """An error in the audited files; its message is a single line."""


def read_file(path: Path) -> bytes:
    """Return the bytes of a regular file.

    Raises:
        AuditError: It is not a regular file, it has more than ``BYTE_LIMIT`` bytes, or
            it cannot be read.
    """
    name = "/".join(path.parts[-2:])
    try:
        info = path.lstat()
        if not stat.S_ISREG(info.st_mode):
            raise AuditError(f"{name} is not a regular file")
        if info.st_size > BYTE_LIMIT:
            raise AuditError(f"{name} is larger than {BYTE_LIMIT >> 20} MiB")
        return path.read_bytes()
    except FileNotFoundError:
        raise AuditError(f"{name} does not exist") from None
    except OSError as error:
        raise AuditError(f"{name} cannot be read: {error.strerror}") from None


def replace_file(path: Path, old: bytes, new: bytes) -> None:
    """Replace the bytes ``old`` of a file with the bytes ``new``.

    Raises:
        AuditError: The file contains other bytes, is read-only or cannot be written. It
            is left unchanged.
    """
    if not path.stat().st_mode & stat.S_IWUSR:
        raise AuditError("the file is read-only and was left unchanged")
    try:
        # In the same folder, because a file cannot be moved atomically between disks.
        descriptor, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        temporary = Path(name)
        try:
            with os.fdopen(descriptor, "wb") as file:
                file.write(new)
                file.flush()
                os.fsync(file.fileno())
            # mkstemp creates files that only their owner can read.
            shutil.copymode(path, temporary)
            if path.read_bytes() != old:
                raise AuditError(
                    "the file was modified in the meantime and was left unchanged: run the command again"
                )
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as error:
        message = f"the file cannot be written and was left unchanged: {error.strerror}"
        raise AuditError(message) from None
