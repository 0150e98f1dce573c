"""Test public advice on slipping grasps against the measurements of a release."""

from collections.abc import Iterable

from markupsafe import Markup

from measured_report.findings.chapters import Chapters
from report.shared import (
    Claim,
    Quantity,
    Section,
    Sections,
    Table,
    sections_of,
    table_of,
)
from report.story.public_advice import ADVICE, SOURCES
from report.story.trials import Advice, Symptom, Verdict

COMMA = Markup(", ")


def derive(chapters: Chapters) -> Section:
    """Return a table for each symptom, and a claim for each piece of advice."""
    sections = sections_of(chapters)
    bound = sections.value("advice", "cause_bound")
    verdicts = [verdict_of(advice, sections, bound) for advice in ADVICE]
    tables = {symptom.value: _table(verdicts, symptom, sections) for symptom in Symptom}
    claims = [
        Claim(
            verdict.advice.name,
            verdict.outcome,
            {
                "advice": verdict.advice.words,
                "depends": verdict.is_mixed,
                "effect": Markup("; ").join(
                    trial.effect_in_words(sections) for trial in verdict.measured
                ),
            },
            shared_wording="verdict",
        )
        for verdict in verdicts
    ]
    return Section(tables=tables, claims=claims)


def verdict_of(advice: Advice, sections: Sections, bound: Quantity) -> Verdict:
    """Test each trial of a piece of advice."""
    outcomes = {trial: trial.outcome(sections, bound) for trial in advice.trials}
    return Verdict(advice, outcomes)


def _table(verdicts: Iterable[Verdict], symptom: Symptom, sections: Sections) -> Table:
    rows = [verdict for verdict in verdicts if verdict.advice.symptom == symptom]
    rows.sort(key=lambda verdict: not verdict.measured)  # measured advice comes first
    names = [
        Markup("{}<br><small>{}</small>").format(
            verdict.advice.words, SOURCES[verdict.advice.source]
        )
        for verdict in rows
    ]
    columns = {
        "verdict": [verdict.html() for verdict in rows],
        "before → after": [
            _lines(trial.effect(sections) for trial in verdict.measured)
            for verdict in rows
        ],
        "run time": [_times(verdict.advice, sections) for verdict in rows],
    }
    bound = sections.value("advice", "cause_bound")
    return table_of("advice", names, columns, bound=bound)


def _lines(parts: Iterable[Markup]) -> Markup:
    return Markup("").join(Markup("<div>{}</div>").format(part) for part in parts)


def _times(advice: Advice, sections: Sections) -> Markup:
    """Return the run times as multiples of that of the shipped scene."""
    times = [Markup("{} ×").format(time) for time in advice.run_times(sections)]
    return Markup("<span>{}</span>").format(COMMA.join(times)) if times else Markup("")
