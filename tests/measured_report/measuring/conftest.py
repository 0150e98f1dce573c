"""The log of the batches without physics."""

from pathlib import Path

import pytest


@pytest.fixture
def log(tmp_path) -> Path:
    path = tmp_path / "log"
    path.touch()
    return path
