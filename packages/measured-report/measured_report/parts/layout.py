"""Layout: what Matplotlib works out many times while it lays a figure out and draws it is worked out once.

Each axis is asked for its ticks some ten times, and each text for its size some five times, of which nearly all answers
are the same: they change when the axes are moved, and when a text is another one.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from matplotlib.axis import Axis
from matplotlib.text import Text


def _place(axis: Axis) -> tuple:
    return *axis.get_view_interval(), *axis.axes.bbox.bounds


def _look(text: Text) -> tuple:
    """All of it that may change while it is drawn."""
    words = object() if text.get_wrap() else text.get_text()  # where lines end may depend on anything
    font, turn = hash(text.get_fontproperties()), text.get_rotation()
    return words, font, turn, text.get_horizontalalignment(), text.get_verticalalignment()


ASKED: tuple[tuple[type, str, Callable[[Any], tuple]], ...] = (
    (Axis, "_update_ticks", _place),
    (Text, "_get_layout", _look),
)
"""What is asked many times, by class and method, and what the answer depends on."""


@contextmanager
def laid_out_once() -> Iterator[None]:
    """Within it a figure that is drawn keeps ticks and sizes of texts; what it draws is the same."""
    methods = [getattr(owner, name) for owner, name, _ in ASKED]
    for (owner, name, state), method in zip(ASKED, methods, strict=True):
        setattr(owner, name, _kept(method, state))
    try:
        yield
    finally:
        for (owner, name, _), method in zip(ASKED, methods, strict=True):
            setattr(owner, name, method)


def _kept(method: Callable[..., Any], state: Callable[[Any], tuple]) -> Callable[..., Any]:
    """The same method, which answers as it did before as long as the ``state`` of what it is asked of is the same."""
    name = f"_kept{method.__name__}"

    def answer(self: Any, *arguments: Any) -> Any:
        now = state(self)
        before, found = vars(self).get(name, (None, None))
        if before != now:
            found = method(self, *arguments)
            setattr(self, name, (now, found))
        return found

    return answer
