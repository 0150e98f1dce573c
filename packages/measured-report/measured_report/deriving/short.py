"""Short runs: which claims of quick results come out otherwise in full ones, and a mark where they are said."""

import re
from collections.abc import Mapping
from dataclasses import replace

from markupsafe import Markup

from measured_report.claims.claims import Claim
from measured_report.deriving.chapters import Chapter, Chapters, Releases

CLAIM = re.compile('<span class="claim" data-claim="([^"]*)"')
MARK = Markup('<span class="badge" title="Newton {} in full runs: {}">{} in full runs</span> ')


def marked(quick: Releases, full: Releases) -> dict[str, dict[str, Chapter]]:
    """The chapters of quick results, by edition, with a mark at each claim that is another one in full runs.

    That is so where the edition has full results as well, and may be so where another one has both.
    """
    differing = {release: _differing(quick[release], full[release]) for release in quick if release in full}
    found = {}
    for release, chapters in quick.items():
        others = (each for each in differing if each != release and release not in full)
        known = [(release, "otherwise"), *((each, "perhaps otherwise") for each in others)]
        marks = {
            name: MARK.format(place, said, word)
            for place, word in reversed(known)
            for name, said in differing.get(place, {}).items()
        }
        found[release] = {name: _with_marks(chapter, marks) for name, chapter in chapters.items()}
    return found


def _differing(quick: Chapters, full: Chapters) -> dict[str, str]:
    """What full runs say to each claim, by ``section.claim``, that has another outcome in short ones."""
    short, long = _claims(quick), _claims(full)
    return {
        name: claim.text
        for name, claim in long.items()
        if name in short and short[name].outcome.name != claim.outcome.name
    }


def _claims(chapters: Chapters) -> dict[str, Claim]:
    told = (chapter for chapter in chapters.values() if not chapter.compares)
    return {f"{chapter.name}.{claim.name}": claim for chapter in told for claim in chapter.section.claims}


def _with_marks(chapter: Chapter, marks: Mapping[str, Markup]) -> Chapter:
    def mark(claim: re.Match) -> str:
        return str(marks.get(claim[1], "")) + claim[0]

    if chapter.prose is None:
        return chapter
    printed = [Markup(CLAIM.sub(mark, thing)) if isinstance(thing, str) else thing for thing in chapter.prose.printed]
    return replace(chapter, prose=replace(chapter.prose, printed=printed))
