"""Cards: numbers before and after the change, side by side on the front page."""

from markupsafe import Markup

from measured_report.deriving.chapters import Chapters, stale_mark
from report.story.found import Found

CARD = Markup("<div><dt>{}</dt><dd><span>{}</span> → <strong>{}</strong> <small>{}{}</small></dd></div>")


def cards_of(chapters: Chapters) -> Markup:
    """Show slip, grip, sink depth and speed, with shipped pads and with stiff ones.

    The labels are a list of terms, so that they read well without a style.
    """
    found = Found(chapters)
    slips = [found.cell("reproduction", case, "slip_mm", "mm") for case in ("as-shipped", "stiff-pads")]
    grips = [found.value("contacts", f"grip_used_{pads}", "%") for pads in ("shipped", "stiff")]
    depths = [found.cell("stiffness", case, "penetration_mm", "mm") for case in ("pad-ke-2.5e3", "pad-ke-2.5e5")]
    frames = [found.cell("speed", case, "frame_ms", "ms") for case in ("as-shipped", "stiff-pads-only")]
    noise, spread = found.value("noise", "slip_floor", "mm"), found.value("speed", "stiff_pads_only_spread", "ms")
    cards = [
        ("slip in the shake", slips, Markup("runs may differ by {}").format(noise)),
        ("friction used", grips, "of what a contact has, at most"),
        ("pads sink in", depths, "mean of the loaded contacts"),
        ("time of a frame", frames, Markup("frames spread over {}").format(spread)),
    ]
    shown = [
        CARD.format(label, before, after, note, stale_mark(chapters.values(), before.reads))
        for label, (before, after), note in cards
        if before.value is not None
    ]
    return Markup('<figure class="cards"><dl>\n{}\n</dl></figure>').format(Markup("\n").join(shown))
