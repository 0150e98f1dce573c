"""How far a study is, in one line, for whoever looks at a terminal; a log has a line for each section."""

import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from tqdm import tqdm


@contextmanager
def progress(status: Callable[[], str]) -> Iterator[None]:
    """Within it what ``status`` says is shown, and renewed each second."""
    done = threading.Event()
    with tqdm(bar_format="{elapsed}  {desc}", leave=False, disable=not sys.stderr.isatty()) as bar:

        def tick() -> None:
            while not done.wait(1.0):
                bar.set_description_str(status())

        threading.Thread(target=tick, daemon=True).start()
        try:
            yield
        finally:
            done.set()
