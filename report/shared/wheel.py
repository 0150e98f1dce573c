"""A package of plain Python as a wheel, so that what a page offers can be installed from it; always the same bytes."""

import io
from base64 import urlsafe_b64encode
from functools import cache
from hashlib import sha256
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from measured_report.files.config import read_toml


@cache
def wheel(folder: Path) -> tuple[str, bytes]:
    """Return the name of the wheel of the package in a folder, and the wheel."""
    project = read_toml(folder / "pyproject.toml")["project"]
    package = project["name"].replace("-", "_")
    version = project["version"]
    paths = sorted(
        path
        for path in (folder / package).rglob("*")
        if path.is_file() and path.suffix != ".pyc"
    )
    files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}
    head = {"Metadata-Version": "2.1", "Name": project["name"], "Version": version}
    lines = [*head.items(), ("Requires-Python", project["requires-python"])]
    lines += [("Requires-Dist", needed) for needed in project["dependencies"]]
    commands = "".join(
        f"{name} = {place}\n" for name, place in project["scripts"].items()
    )
    about = {
        "METADATA": "".join(f"{name}: {value}\n" for name, value in lines),
        "WHEEL": "Wheel-Version: 1.0\nGenerator: report\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        "entry_points.txt": f"[console_scripts]\n{commands}",
    }
    files |= {
        f"{package}-{version}.dist-info/{name}": text.encode()
        for name, text in about.items()
    }
    digests = {
        name: urlsafe_b64encode(sha256(data).digest()).decode().rstrip("=")
        for name, data in files.items()
    }
    record = f"{package}-{version}.dist-info/RECORD"
    sums = "".join(
        f"{name},sha256={digests[name]},{len(data)}\n" for name, data in files.items()
    )
    files[record] = f"{sums}{record},,\n".encode()
    packed = io.BytesIO()
    with ZipFile(packed, "w", ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(ZipInfo(name), data, ZIP_DEFLATED)
    return f"{package}-{version}-py3-none-any.whl", packed.getvalue()
