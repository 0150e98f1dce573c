"""Find inert numbers: numbers in the words of a claim or a passage that could have any
value without a change of the words.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import count, product
from typing import Any

from current_columns import column_of
from markupsafe import Markup

from measured_report.files.errors import ReportError
from measured_report.pages.passages import is_met, needs_of
from measured_report.parts.claim import Claim
from measured_report.parts.section import Section
from measured_report.values.quantities import VALUES_FILE, Pointer, Quantity, Value
from tests.perturbed import FACTORS, Perturbation

SOURCE = re.compile('data-src="([^"]*)"')
PASSAGE = re.compile(
    'class="passage" data-needs="([^"]*)" data-outcome="holds"[^>]*>(.*?)</(?:div|span)>',
    re.DOTALL,
)
NUMBER = re.compile("<data[^>]*>[^<]*</data>(&nbsp;[^ .,;)<]+)?")
"""Number in its printed form, with its unit."""
LEAVES_TRIED = 4
"""Number of sources that are changed one at a time.

If a value has more sources, this many are chosen, spread over all of them, and all of
them are changed together.
"""


def named_pointers(thing: Any) -> Iterator[str]:
    """Return pointers to all numbers that are passed to a wording."""
    if isinstance(thing, Quantity):
        yield from [thing.source] if thing.source else []
    elif isinstance(thing, Markup):
        yield from SOURCE.findall(thing)
    elif isinstance(thing, Mapping | list | tuple):
        for part in thing.values() if isinstance(thing, Mapping) else thing:
            yield from named_pointers(part)


def named_in(claim: Claim) -> Iterator[str]:
    """Return the names of the numbers that some words of a claim need."""
    for name in sorted(claim.numbers):
        others = {key: each for key, each in claim.numbers.items() if key != name}
        try:
            for text in claim.wording.values():
                text(others)
        except ReportError:
            yield name


def measured(values: Mapping[str, Value], pointer: str) -> list[str]:
    """Return the measured numbers and traces behind a number. A chosen number has none."""
    roots = values[pointer].reads if pointer in values else {pointer}
    return sorted(
        root
        for root in roots
        if VALUES_FILE not in root and not column_of(root.rpartition("/")[2]).is_setting
    )


def changes(leaves: Sequence[str]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield the changes to try for the sources of a number: which of them are changed,
    and how.
    """
    single = [(leaf,) for leaf in leaves[:: -(-len(leaves) // LEAVES_TRIED)]]
    yield from product([tuple(leaves), *single] if len(leaves) > 1 else single, FACTORS)


@dataclass(frozen=True)
class Survey:
    """Compares the numbers that the words of one section of one release name with the
    numbers that its tests use. Each result has the form ``section.claim name``.
    """

    perturbation: Perturbation
    release: str
    section: str
    values: Mapping[str, Value]
    """Return every derived value by its pointer."""

    def numbers(self) -> Iterator[tuple[Claim, str, str]]:
        """Yield claim, name and pointer of every measured number that the words of a
        claim name.
        """
        for claim in self.perturbation.releases[self.release][
            self.section
        ].section.claims:
            lacks_number = any(
                isinstance(each, Quantity) and each.value is None
                for each in claim.numbers.values()
            )
            if (
                lacks_number and claim.outcome.answer == "cannot tell"
            ):  # it then has only this text
                continue
            for name in named_in(claim):
                for pointer in dict.fromkeys(named_pointers(claim.numbers[name])):
                    if measured(self.values, pointer):
                        yield claim, name, pointer

    def unread(self) -> set[str]:
        """Return the names of numbers in words that the test of their claim has not
        read, neither directly nor by all of their sources.
        """
        return {
            f"{self.section}.{claim.name} {name}"
            for claim, name, pointer in self.numbers()
            if not (
                {pointer} <= claim.outcome.reads
                or set(measured(self.values, pointer)) <= claim.outcome.reads
            )
        }

    def inert(self) -> set[str]:
        """Return numbers that do not affect the outcome and the words of their claim.

        Every factor of ``FACTORS`` is applied to their sources. If claims read no numbers
        of each other, numbers of all of them are changed at once.
        """
        waiting = {
            (claim.name, name, pointer): (
                claim,
                list(changes(measured(self.values, pointer))),
            )
            for claim, name, pointer in self.numbers()
            if not self.perturbation.says_before(self.release, self.section, claim)
        }
        for step in count():
            tried = {
                key: (claim, *tries[step])
                for key, (claim, tries) in waiting.items()
                if step < len(tries)
            }
            if not tried:
                return {f"{self.section}.{claim} {name}" for claim, name, _ in waiting}
            for group in _independent(tried):
                leaves, change = (
                    {leaf for key in group for leaf in tried[key][1]},
                    tried[group[0]][2],
                )
                after = _claims(
                    self.perturbation.of(
                        self.release, self.section, map(Pointer, sorted(leaves)), change
                    )
                )
                for key, before in [(key, waiting[key][0]) for key in group]:
                    claim = after.get(before.name)
                    if not claim or _shape(before) != _shape(
                        replace(claim, wording=before.wording)
                    ):
                        del waiting[key]


def _independent(
    tried: Mapping[Any, tuple[Claim, tuple[str, ...], str]],
) -> list[list[Any]]:
    """Group numbers whose claims do not read the sources of another number in the
    group.
    """

    def are_apart(key: Any, other: Any) -> bool:
        (claim, leaves, _), (other_claim, other_leaves, _) = tried[key], tried[other]
        reads = claim.outcome.reads, other_claim.outcome.reads
        return leaves == other_leaves or (
            reads[0].isdisjoint(other_leaves) and reads[1].isdisjoint(leaves)
        )

    groups: list[list[Any]] = []
    for key in tried:
        group = next(
            (
                group
                for group in groups
                if all(are_apart(key, other) for other in group)
            ),
            None,
        )
        if group is None:
            groups.append(group := [])
        group.append(key)
    return groups


def _claims(section: Section) -> dict[str, Claim]:
    return {claim.name: claim for claim in section.claims}


def _shape(claim: Claim) -> tuple[str, str]:
    """Return the outcome and the words of a claim, with a placeholder for each number."""
    return claim.outcome.answer, NUMBER.sub("#", str(claim.sentence))


def inert_passages(perturbation: Perturbation, release: str) -> set[str]:
    """Return numbers of a release's passages that do not decide whether the passages
    are shown, in the order of the claims that these need.
    """
    values, told = _values(perturbation), list(perturbation.pages).index(release)

    @cache
    def outcomes(
        section: str, leaves: tuple[str, ...], change: str
    ) -> dict[str, Claim]:
        return _claims(perturbation.of(release, section, map(Pointer, leaves), change))

    def falls(needs: str, leaves: tuple[str, ...], change: str) -> bool:
        return not all(
            is_met(need, outcomes(need[0], leaves, change).get(need[1]))
            for need in needs_of(needs)
        )

    said_before = {
        needs
        for page in list(perturbation.pages.values())[:told]
        for needs, _ in PASSAGE.findall(page)
    }
    return {
        f"{needs} {pointer.partition('/')[2]}"
        for needs, said in PASSAGE.findall(perturbation.pages[release])
        if needs not in said_before
        for pointer in SOURCE.findall(said)
        if (leaves := measured(values, pointer))
        and not any(falls(needs, *change) for change in changes(leaves))
    }


def _values(perturbation: Perturbation) -> dict[str, Value]:
    """Return every derived value by its pointer."""
    results = [
        chapter.results
        for chapters in perturbation.releases.values()
        for chapter in chapters.values()
    ]
    return {value.source: value for each in results for value in each.derived.values()}


def surveys(perturbation: Perturbation) -> list[Survey]:
    """Yield one object for every section of every release."""
    releases, values = perturbation.releases, _values(perturbation)
    return [
        Survey(perturbation, release, section, values)
        for release in releases
        for section in releases[release]
    ]
