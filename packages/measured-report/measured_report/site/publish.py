"""Publishing: a checked copy of the site goes to a folder, to a branch of a git repository, or over rsync.

A reader never gets half a site; of rsync that holds but for the moment in which all files take their places.
"""

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from measured_report.files.atomic import RecordError, locked
from measured_report.files.errors import ReportError, UsageError
from measured_report.site.check import check_site
from measured_report.site.sums import copy_whole
from measured_report.site.targets import MARK, TARGETS, without_password

DEFAULT = "git:origin"
QUICK = '<meta name="profile" content="quick">'  # of a page of small grids and short runs


def publish(site: Path, target: str) -> str:
    """Put a checked copy of ``site`` at ``target`` and return where it lies; what can't be put there leaves nothing.

    A target is ``dir:PATH``, ``rsync:HOST:PATH`` or ``git:REMOTE#BRANCH``; empty: the branch gh-pages of origin.
    """
    scheme, _, place = (target or DEFAULT).partition(":")
    told = f"TARGET={without_password(target)}"
    if scheme not in TARGETS or not place or place.startswith("-") or "\0" in place:
        places = "dir:PATH, rsync:HOST:PATH or git:REMOTE"
        raise UsageError(f"{told!r} is no place to publish to; use TARGET={places}")
    try:
        with _checked_copy(site) as copy:
            return without_password(TARGETS[scheme](copy, place, site))
    except RecordError as error:  # of a file that is none
        raise ReportError(f"not published: {error}") from None
    except UsageError as error:
        raise UsageError(without_password(str(error))) from None
    except shutil.Error as error:  # of each file that could not be copied: source, target and reason
        raise UsageError(f"{told}: {error.args[0][0][2]}") from None
    except OSError as error:
        raise UsageError(f"{told}: {error.strerror}") from None


@contextmanager
def _checked_copy(site: Path) -> Iterator[Path]:
    """A copy of the site in which nothing is wrong, and that anyone may read whatever the umask is."""
    with tempfile.TemporaryDirectory(prefix="publish-") as folder:
        copy = Path(folder) / "site"
        with locked(site.parent, alone=False):  # not while it is being put in place
            index = site / "index.html"
            if not index.is_file():
                raise UsageError(f"{site.name}/ holds no report; make report builds it")
            copy_whole(site, copy)
        if QUICK in (copy / index.name).read_text(encoding="utf-8"):
            raise UsageError(f"{site.name}/ holds a quick look, not the report; make report builds that")
        if problems := check_site(copy):
            raise ReportError(f"not published, problems found: {len(problems)}; the first: {problems[0]}")
        (copy / MARK).write_text("what make publish made; it removes what else is here\n", encoding="utf-8")
        copy.chmod(0o755)
        for path in copy.rglob("*"):
            path.chmod(0o755 if path.is_dir() else 0o644)
        yield copy
