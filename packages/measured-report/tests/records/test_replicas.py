"""Test that a sealed file of replicas is accepted only if it is complete and has the
same code and packages.
"""

import bz2
import gzip
import tarfile
import tracemalloc
from dataclasses import replace
from hashlib import sha256

import pytest
from toys import BY_HAND

from measured_report.commands import replicate
from measured_report.editions.project import Project
from measured_report.files.atomic import RecordError
from measured_report.files.errors import ReportError
from measured_report.findings.replicas import (
    alike,
    read_replicas,
    refused,
)
from measured_report.records.record import load_record, write_record
from measured_report.records.replicas import FOLDER, archive_of, read_replica

LABEL = "1.4.0"
SECTIONS = ("gap", "frames")
GPU = {**BY_HAND["machine"], "device": "cuda", "gpu": "A GPU"}


@pytest.fixture
def project(toy):
    """Return a project with records of some sections."""
    rows = [
        {"case": f"run-{n}", "slip_mm": 1 + n / 7, "dropped": False} for n in range(333)
    ]
    for section in SECTIONS:
        toy.write(f"report/sections/{section}.py", "def derive(results): ...\n")
        write_record(
            toy.project.record_path(section),
            toy.record(rows, section=section, machine=GPU),
        )
    return toy.project


def again(project: Project, section: str, by: float = 1e-4, **identity):
    """Return a section as if another host had measured it."""
    record = load_record(project.record_path(section))
    rows = [
        {name: _moved(cell, by) for name, cell in row.items()} for row in record.rows
    ]
    measured = {**record.measured, "started": "2025-11-27T01:00:00+00:00"}
    machine = {**record.machine, "host": "elsewhere"}
    return replace(
        record,
        rows=rows,
        measured=measured,
        machine=machine,
        identity=replace(record.identity, **identity),
    )


def _moved(cell, by):
    return cell * (1 + by) if isinstance(cell, float) else cell


def kept(project: Project, *records):
    path = project.root / "sent.tgz"
    path.write_bytes(archive_of(records))
    replicate._keep(project, read_replica(path), "sent.tgz")
    tracked = {
        section: load_record(project.record_path(section)) for section in SECTIONS
    }
    replicas, _ = read_replicas(project)
    return {name: alike(tracked, records) for name, records in replicas.items()}


def test_a_copy_of_a_replica_is_named_and_not_counted(project):
    folder = project.results / FOLDER
    folder.mkdir(parents=True)
    for name, by in (("a", 1e-4), ("b", 2e-4), ("c", 1e-4)):
        content = archive_of([again(project, "gap", by)])
        (folder / f"{name}.tgz").write_bytes(content)
    replicas, messages = read_replicas(project)
    assert [*replicas] == ["a", "b"]
    [message] = messages
    assert message.endswith("c.tgz is a copy of another: remove it")


def test_a_replica_is_read_as_it_was_packed(project):
    records = [again(project, section) for section in SECTIONS]
    assert archive_of(records) == archive_of(records)
    (fresh,) = kept(project, *records).values()
    for record in records:
        assert _floats(fresh[record.section]) == [
            float(f"{cell:.9g}") for cell in _floats(record)
        ]


def _floats(record) -> list[float]:
    return [
        cell for row in record.rows for cell in row.values() if isinstance(cell, float)
    ]


def test_sections_of_other_code_are_left_out_and_named(project, capsys):
    other = again(project, "gap", code=sha256(b"other").hexdigest())
    (fresh,) = kept(project, other, again(project, "frames")).values()
    assert list(fresh) == ["frames"]
    assert "left out: other code (gap)" in capsys.readouterr().out


@pytest.mark.parametrize("kind", ["code", "packages"])
def test_one_of_other_code_or_packages_is_refused_in_a_line(project, kind):
    packages = load_record(project.record_path("gap")).identity.packages
    other = {
        "code": sha256(b"other").hexdigest(),
        "packages": {**packages, "mujoco": "9.9"},
    }[kind]
    with pytest.raises(
        ReportError,
        match=f"its sections do not belong to this edition: other {kind} \\(gap\\)",
    ) as error:
        kept(project, again(project, "gap", **{kind: other}))
    assert "\n" not in str(error.value)
    assert not (project.results / FOLDER).exists()


def test_taking_in_a_replica_twice_keeps_it_once(project):
    sent = again(project, "gap")
    assert kept(project, sent).keys() == kept(project, sent).keys()


DAMAGES = {
    "altered": lambda text: text.replace(b'"dropped":false', b'"dropped":true ', 1),
    "cut": lambda text: text[:-20_000],
    "nothing": lambda text: b"",
    "empty": lambda text: gzip.decompress(archive_of([])),
    "packed in another way, which may hold anything": bz2.compress,
    "a name that is no UTF-8": lambda text: headed(name=b"\xff") + text,
    "a few bytes that say they are an exabyte": lambda text: (
        headed(size=b"\x80\0\0\0\x10" + bytes(7)) + text
    ),
    "a header before one, which says it is of 3 GB": lambda text: (
        extended(size="3000000000", map="0,0") + text
    ),
    "a few bytes that are read as a gigabyte": lambda text: (
        headed(kind=b"S", real_size=b"10000000000") + text
    ),
}


def headed(
    name: bytes = b"x", size: bytes = b"0", kind: bytes = b"0", real_size: bytes = b""
) -> bytes:
    """Return a tar header for a file without content."""
    header = bytearray(tarfile.TarInfo("x").tobuf())
    header[156:157] = kind
    for start, field in (
        (0, name),
        (124, size),
        (257, b"ustar  "),
        (483, real_size),
        (148, b" " * 8),
    ):
        header[start : start + len(field)] = field
    header[148:155] = b"%06o\0" % sum(header)
    return bytes(header)


def extended(**fields: str) -> bytes:
    """Return a plain file with a PAX header before its own header."""
    file = tarfile.TarInfo("x")
    file.pax_headers = {f"GNU.sparse.{name}": text for name, text in fields.items()}
    return file.tobuf(tarfile.PAX_FORMAT)


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_one_that_is_not_as_it_was_sealed_is_damaged_and_costs_no_memory(
    project, damage
):
    path = project.root / "sent.tgz"
    path.write_bytes(
        gzip.compress(damage(gzip.decompress(archive_of([again(project, "gap")]))))
    )
    tracemalloc.start()
    with pytest.raises(
        RecordError, match=r"^[^\n]*sent\.tgz (is not|was changed)[^\n]*$"
    ):
        read_replica(path)
    assert tracemalloc.get_traced_memory()[1] < 200 << 20
    tracemalloc.stop()


def test_a_damaged_one_is_named_without_what_turns_text_round(project):
    (project.results / FOLDER).mkdir()
    (project.results / FOLDER / "\u202e.tgz").write_bytes(b"")
    [fault] = read_replicas(project)[1]
    assert fault == "replicas/?.tgz was changed after it was sealed"


def test_what_could_not_be_measured_there_is_left_out(project):
    sent = again(project, "gap")
    lost = [
        {name: cell for name, cell in row.items() if not isinstance(cell, float)}
        for row in sent.rows
    ]
    words = refused(
        project, {"gap": replace(sent, rows=lost), "frames": again(project, "frames")}
    )
    assert words == {"gap": "too many of its numbers are missing"}
