"""Checks that the patches apply, and that upstream.md states their results."""

import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).parents[1] / "upstream"
CHECKED = json.loads((FOLDER / "checked.json").read_text(encoding="utf-8"))
DOCUMENT = (FOLDER / "upstream.md").read_text(encoding="utf-8")


def test_what_was_checked_are_these_patches():
    digests = {
        patch.name: hashlib.sha256(patch.read_bytes()).hexdigest()
        for patch in FOLDER.glob("*.patch")
    }
    assert CHECKED["patches"] == digests
    assert CHECKED["own_after"] == CHECKED["own_before"] and CHECKED["same_when_off"]
    assert all(
        "failed" not in found
        for found in [CHECKED["own_after"], *CHECKED["new"].values()]
    )


def test_the_document_has_the_numbers_that_were_checked():
    new = [found["passed"] for found in CHECKED["new"].values()]
    said = [
        f"{CHECKED['own_before']['passed']} pass and {CHECKED['own_before']['skipped']} are skipped",
        "All new tests pass: {} and {} in MuJoCo Warp, and {} in".format(*new),
    ]
    walks = re.findall(
        r"flag by (\S+) mm", (FOLDER / "c/checked.txt").read_text(encoding="utf-8")
    )
    said.append(
        "the box walks by {} mm, and with a pyramidal cone by {} mm".format(*walks)
    )
    words = " ".join(DOCUMENT.split())
    assert [sentence for sentence in said if sentence not in words] == []


def test_the_program_in_the_document_shows_the_walk_that_the_document_says():
    program = re.search(r"```python\n(.*?)```", DOCUMENT, re.DOTALL).group(1)
    assert sum(map(bool, program.splitlines())) <= 20
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    plain, term = (float(line.split()[0]) for line in done.stdout.splitlines())
    assert (
        f"by {plain:.2f} mm in one second. With the term it walks by {term:.2f} mm"
        in " ".join(DOCUMENT.split())
    )
