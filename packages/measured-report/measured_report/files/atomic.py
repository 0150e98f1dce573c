"""Files: read only as what they should be, and written whole; folders are held by one process at a time."""

import fcntl
import os
import shutil
import stat
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from typing import Any

from measured_report.files.errors import UNPRINTABLE, ReportError

WHOLE, NEW, ASIDE = ".whole", "-new", ".damaged"  # ends of folders that wait for their place, are written, are refused


class RecordError(ReportError):
    """Names a record or trace that can't be trusted, in one line, with its release and file."""


def short_path(path: Path) -> str:
    """Write the path of a record or a trace as messages have it: its edition's folder and its name."""
    return UNPRINTABLE.sub("?", "/".join(path.parts[-2:]))


def read_own_file(path: Path, byte_limit: int) -> bytes:
    """Read the regular file at ``path``; RecordError for a link, a pipe or a device, and for too much."""
    name = short_path(path)
    try:
        info = path.lstat()
        if not stat.S_ISREG(info.st_mode):
            raise RecordError(f"{name} is no regular file")
        if info.st_size > byte_limit:
            raise RecordError(f"{name} has more than {byte_limit >> 20} MiB")
        return path.read_bytes()
    except FileNotFoundError:
        raise RecordError(f"there is no {name}") from None
    except OSError as error:
        raise RecordError(f"{name} can't be read: {error.strerror}") from None


@contextmanager
def locked(folder: Path, *, alone: bool = True) -> Iterator[None]:
    """Hold ``folder``, if it is there, alone or with others that only read; whoever has to wait for it says so."""
    if not folder.is_dir():
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    mode = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
    try:
        try:
            fcntl.flock(descriptor, mode | fcntl.LOCK_NB)
        except BlockingIOError:
            whose = _holder(os.fstat(descriptor).st_ino)
            print(f"waiting for {whose} that is at work in {folder.name}/", file=sys.stderr, flush=True)
            fcntl.flock(descriptor, mode)
        yield
    finally:
        os.close(descriptor)


def _holder(inode: int) -> str:
    """Name the process that holds a lock, as far as Linux tells."""
    with suppress(OSError):
        for fields in map(str.split, Path("/proc/locks").read_text(encoding="utf-8").splitlines()):
            if fields[1] == "FLOCK" and fields[5].endswith(f":{inode}"):
                command = Path(f"/proc/{fields[4]}/cmdline").read_text(encoding="utf-8").replace("\0", " ")
                return f"process {fields[4]} ({UNPRINTABLE.sub('?', command).strip():.80})"
    return "another process"


def put_record(record: Path, files: Mapping[str, bytes]) -> None:
    """Put a record and its traces, contents by name, at ``record``, all or none: after a kill ``recover`` goes on."""
    record.parent.mkdir(parents=True, exist_ok=True)
    whole = record.with_name(f".{record.stem}{WHOLE}")
    with locked(record.parent.parent), staging_folder(record.with_suffix("")) as new:
        shutil.rmtree(whole, ignore_errors=True)  # of a process that was killed
        for name, content in files.items():
            with atomic_file(new / name) as temporary:
                temporary.write_bytes(content)
        os.rename(new, whole)
        _put_in_place(whole, list(files))


def recover(results: Path, load: Callable[[Path], Any]) -> list[str]:
    """Finish what killed processes were putting in place; set aside, and say, what ``load`` finds no whole record."""
    messages = []
    for remnant in results.glob(f"*/.*{NEW}"):
        with locked(results):
            shutil.rmtree(remnant, ignore_errors=True)
    for whole in sorted(results.glob(f"*/.*{WHOLE}")):
        section = whole.name[1 : -len(WHOLE)]
        with locked(results), suppress(OSError):  # a copy that can only be read stays as it is
            try:
                traces = load(whole / f"{section}.json").traces
                names = [*(f"{section}.{case}.csv.gz" for case in traces), f"{section}.json"]
                if whole.is_symlink() or {path.name for path in whole.iterdir()} != {*names}:
                    raise RecordError(f"{short_path(whole)} is not what was written there")
            except RecordError as error:
                aside = whole.with_suffix(ASIDE)
                shutil.rmtree(aside, ignore_errors=True)
                os.rename(whole, aside)
                messages.append(f"damaged: {error}; it was not put in place, and is at {short_path(aside)}")
            else:
                _put_in_place(whole, names)
    return messages


def _put_in_place(whole: Path, names: Sequence[str]) -> None:
    """Copy files to where they belong, the last of them last; they wait until all are there."""
    for name in names:
        with atomic_file(whole.with_name(name)) as temporary:
            shutil.copyfile(whole / name, temporary)
    used = whole.with_name(whole.stem + NEW)
    os.rename(whole, used)
    shutil.rmtree(used)


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Name a path to write to, which takes the place of ``path`` once the block has ended well."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.part")
    temporary.unlink(missing_ok=True)  # of a process that was killed, or a link that leads elsewhere
    try:
        yield temporary
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def staging_folder(folder: Path) -> Iterator[Path]:
    """Name a staging folder for what is to take the place of ``folder``; what is left there is removed."""
    with locked(folder.parent):
        fresh = folder.with_name(f".{folder.name}{NEW}")
        shutil.rmtree(fresh, ignore_errors=True)
        try:
            yield fresh
        finally:
            shutil.rmtree(fresh, ignore_errors=True)


def sums(digests: Mapping[str, str]) -> str:
    """Write the digests of files, by name, as ``sha256sum --check`` reads them."""
    return "".join(f"{digest}  {name}\n" for name, digest in sorted(digests.items()))


def digests_below(folder: Path) -> dict[str, str]:
    """Digest the files below a folder, by their names there; a link, and what else is no file, has none."""
    digests = {}
    for path in (path for path in folder.rglob("*") if path.is_symlink() or not path.is_dir()):
        is_file = stat.S_ISREG(path.lstat().st_mode)
        digests[path.relative_to(folder).as_posix()] = sha256(path.read_bytes()).hexdigest() if is_file else ""
    return digests


def replace(folder: Path, fresh: Path) -> None:
    """Let ``fresh`` take the place of ``folder``, or of what that leads to; what was there is removed."""
    folder, before = folder.resolve(), fresh.with_name(f"{fresh.name}-before")
    shutil.rmtree(before, ignore_errors=True)
    if folder.exists():
        os.rename(folder, before)
    os.rename(fresh, folder)
    shutil.rmtree(before, ignore_errors=True)
