"""Print a claim or a value in all editions, or all headline values."""

from measured_report.changes.query import Query, history
from measured_report.commands.options import Arguments, shared
from measured_report.commands.status import print_left_out
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError, suggestion
from measured_report.findings.editions import editions_of

OPTIONS = shared("claim", "value", "profile")


def run(project: Project, arguments: Arguments) -> int:
    """Print the history, and return 1 if a record cannot be read or shown."""
    editions = editions_of(project)
    is_damaged = print_left_out(editions)
    releases = {release: edition.chapters for release, edition in editions.items()}
    if not (arguments.claim or arguments.value):
        headlines = project.report.settings.changes.headlines.values()
        print("\n\n".join(history(releases, Query(value)) for value in headlines))
        return int(is_damaged)
    query = query_of(arguments)
    if not is_damaged and not any(
        query.answer(chapters) is not None or query.text in query.names(chapters)
        for chapters in releases.values()
    ):
        similar = suggestion(query.text, query.names(releases[project.release]))
        raise UsageError(f"no edition has {query.text}{similar}: use SECTION.NAME")
    print(history(releases, query))
    return int(is_damaged)


def query_of(arguments: Arguments) -> Query:
    if bool(arguments.claim) == bool(arguments.value):
        raise UsageError(
            "CLAIM= and VALUE= are both given or both missing: use exactly one of "
            "CLAIM=SECTION.NAME and VALUE=SECTION.NAME"
        )
    return Query(arguments.claim or arguments.value, bool(arguments.claim))
