"""Quick results: which of their claims full runs answer otherwise, and the mark that these get."""

from collections.abc import Mapping

from markupsafe import Markup

from measured_report.files.config import config
from measured_report.pages.chapters import Chapters, Releases
from measured_report.parts.claim import Claim

MARK = Markup('<span class="badge" title="{} in full runs: {}">{} in full runs</span> ')


def marks_of(quick: Releases, full: Releases) -> dict[str, dict[str, Markup]]:
    """Return a mark for each claim that is, or as in another edition may be, another one in full runs.

    They are by edition and ``section.claim``.
    """
    differing = {release: _differing(quick[release], full[release]) for release in quick if release in full}
    found: dict[str, dict[str, Markup]] = {}
    for release in quick:
        others = (each for each in differing if each != release and release not in full)
        known = [(release, "otherwise"), *((each, "perhaps otherwise") for each in others)]
        found[release] = {
            name: MARK.format(config().name_of(place), said, word)
            for place, word in reversed(known)
            for name, said in differing.get(place, {}).items()
        }
    return found


def _differing(quick: Chapters, full: Chapters) -> dict[str, str]:
    """What full runs say to each claim, by ``section.claim``, that has another outcome in quick ones."""
    before, after = _claims(quick), _claims(full)
    shared = before.keys() & after.keys()
    return {name: after[name].text for name in shared if before[name].outcome.name != after[name].outcome.name}


def _claims(chapters: Chapters) -> Mapping[str, Claim]:
    told = (chapter for chapter in chapters.values() if not chapter.compares)
    return {f"{chapter.name}.{claim.name}": claim for chapter in told for claim in chapter.section.claims}
