"""A lock on this host's GPUs and cores: shared by all batches, but for those that measure times.

Other processes of this user hold it too, so that two runs of ``make`` on one host spoil no times of each other.
"""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from measured_report.files.atomic import locked

FOLDER = Path(tempfile.gettempdir()) / f"measured-report-{os.getuid()}"


@contextmanager
def gpu_lock(*, exclusive: bool) -> Iterator[None]:
    """Measure beside others or, ``exclusive``, alone; whoever has to wait for it says so."""
    FOLDER.mkdir(mode=0o700, exist_ok=True)
    with locked(FOLDER, alone=exclusive):
        yield
