"""Build the wheel of a pure Python package, which a page offers for installation.

The same files always give the same bytes.
"""

import io
from base64 import urlsafe_b64encode
from functools import cache
from hashlib import sha256
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from measured_report.files.config import read_toml


@cache
def wheel(folder: Path) -> tuple[str, bytes]:
    """Build the wheel of the package in a folder; return its file name and contents."""
    project = read_toml(folder / "pyproject.toml")["project"]
    package = project["name"].replace("-", "_")
    version = project["version"]
    paths = sorted(
        path
        for path in (folder / package).rglob("*")
        if path.is_file() and path.suffix != ".pyc"
    )
    files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}
    header = {"Metadata-Version": "2.1", "Name": project["name"], "Version": version}
    lines = [*header.items(), ("Requires-Python", project["requires-python"])]
    lines += [("Requires-Dist", requirement) for requirement in project["dependencies"]]
    commands = "".join(
        f"{name} = {target}\n" for name, target in project["scripts"].items()
    )
    metadata = {
        "METADATA": "".join(f"{name}: {value}\n" for name, value in lines),
        "WHEEL": "Wheel-Version: 1.0\nGenerator: report\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        "entry_points.txt": f"[console_scripts]\n{commands}",
    }
    files |= {
        f"{package}-{version}.dist-info/{name}": text.encode()
        for name, text in metadata.items()
    }
    digests = {
        name: urlsafe_b64encode(sha256(data).digest()).decode().rstrip("=")
        for name, data in files.items()
    }
    record = f"{package}-{version}.dist-info/RECORD"
    checksums = "".join(
        f"{name},sha256={digests[name]},{len(data)}\n" for name, data in files.items()
    )
    files[record] = f"{checksums}{record},,\n".encode()
    packed = io.BytesIO()
    with ZipFile(packed, "w", ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(ZipInfo(name), data, ZIP_DEFLATED)
    return f"{package}-{version}-py3-none-any.whl", packed.getvalue()
