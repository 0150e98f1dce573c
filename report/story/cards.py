"""Cards: numbers before and after the change, side by side on the front page."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from markupsafe import Markup

from measured_report.deriving.chapters import Chapters, stale_mark
from measured_report.values.quantities import Quantity
from report.story.found import Found


@dataclass(frozen=True)
class Card:
    """One number before and after the change."""

    label: str
    values: Sequence[Quantity]
    """Before and after."""
    note: Markup

    def __html__(self) -> Markup:
        return Markup("<div><dt>{}</dt><dd><span>{}</span> → <strong>{}</strong> <small>{}</small></dd></div>").format(
            self.label, *self.values, self.note
        )


@dataclass(frozen=True)
class Cards:
    """Cards side by side; the labels are a list of terms, so that they read well without a style."""

    cards: Sequence[Card]

    def __html__(self) -> Markup:
        return Markup('<figure class="cards"><dl>\n{}\n</dl></figure>').format(
            Markup("\n").join(Markup("{}").format(card) for card in self.cards)
        )


def cards_of(chapters: Chapters) -> Cards:
    """Slip, grip, sink depth and speed, with shipped pads and with stiff ones."""
    found = Found(chapters)
    slips = [found.cell("reproduction", case, "slip_mm", "mm") for case in ("as-shipped", "stiff-pads")]
    grips = [found.value("contacts", f"grip_used_{pads}", "%") for pads in ("shipped", "stiff")]
    depths = [found.cell("stiffness", case, "penetration_mm", "mm") for case in ("pad-ke-2.5e3", "pad-ke-2.5e5")]
    frames = [found.cell("speed", case, "frame_ms", "ms") for case in ("as-shipped", "stiff-pads-only")]
    noise, spread = found.value("noise", "slip_floor", "mm"), found.value("speed", "stiff_pads_only_spread", "ms")
    cards = [
        Card("slip in the shake", slips, Markup("runs may differ by {}").format(noise)),
        Card("friction used", grips, Markup("of what a contact has, at most")),
        Card("pads sink in", depths, Markup("mean of the loaded contacts")),
        Card("time of a frame", frames, Markup("frames spread over {}").format(spread)),
    ]
    there = [card for card in cards if card.values[0].value is not None]
    return Cards(
        [replace(card, note=card.note + stale_mark(chapters.values(), card.values[0].reads)) for card in there]
    )
