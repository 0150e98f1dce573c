"""Implements ``newton-lint page``: writes an HTML page of the findings on scenes."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from newton_lint.command import CLEAN, Parser, add_work, request_of
from newton_lint.output import Detail, printable, summary, text_of
from newton_lint.report import report_of
from newton_lint.target import TargetError, read_target, targets_of

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<style>:root {{ color-scheme: light dark }}
body {{ max-width: 60rem; margin: auto; font-family: sans-serif }}
pre {{ white-space: pre-wrap }}</style></head>
<body><h1>{title}</h1><pre>{summary}</pre>{scenes}</body></html>
"""


def main(arguments: Sequence[str]) -> int:
    parser = Parser(
        prog="newton-lint page",
        description="Write an HTML page with the findings on scenes and the advice.",
    )
    parser.add_argument(
        "target",
        metavar="TARGET",
        nargs="+",
        help="FILE.xml, a folder, or FILE.py:function",
    )
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        default=Path("page"),
        metavar="FOLDER",
        help="folder to write; default: page",
    )
    add_work(parser)
    parser.set_defaults(ignore=None, acceleration=0.0, load=1.0, no_step=False)
    options = parser.parse_args(arguments)
    request = request_of(options, {})
    reports = []
    scenes = []
    for target in targets_of(options.target):
        try:
            reports.append(report_of(read_target(target), request))
            text = "\n".join(map(printable, text_of(reports[-1], Detail(notes=True))))
            opened = " open" if reports[-1].worst() > 0 else ""
        except TargetError as error:
            text = printable(str(error))
            opened = " open"
        title = escape(printable(target))
        scenes.append(
            f"<details{opened}><summary>{title}</summary>"
            f"<pre>{escape(text)}</pre></details>"
        )
    title = escape(printable(", ".join(options.target)))
    options.out.mkdir(parents=True, exist_ok=True)
    page = options.out / "index.html"
    page.write_text(
        PAGE.format(
            title=title,
            summary=escape("\n".join(map(printable, summary(reports)))),
            scenes="\n".join(scenes),
        ),
        encoding="utf-8",
    )
    print(page)
    return CLEAN
