"""``newton-lint page``: one page of the scenes of a collection, what is found in each and what to change."""

from collections.abc import Sequence
from html import escape
from pathlib import Path

from newton_lint.command import CLEAN, Parser, add_work, asked_of
from newton_lint.output import shown, summary, text_of
from newton_lint.report import report_of
from newton_lint.target import TargetError, found_in, read_target

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<style>:root {{ color-scheme: light dark }} body {{ max-width: 60rem; margin: auto; font-family: sans-serif }}
pre {{ white-space: pre-wrap }}</style></head>
<body><h1>{title}</h1><pre>{summary}</pre>{scenes}</body></html>
"""


def main(arguments: Sequence[str]) -> int:
    made = Parser(prog="newton-lint page", description="Write a page of scenes: what is found, and what to change.")
    made.add_argument("target", metavar="TARGET", nargs="+", help="FILE.xml, a folder, or FILE.py:function")
    made.add_argument("-o", "--out", type=Path, default=Path("page"), metavar="FOLDER", help="default: page")
    add_work(made)
    made.set_defaults(ignore=None, acceleration=0.0, load=1.0, press=0.0, no_step=False)
    given = made.parse_args(arguments)
    asked, reports, scenes = asked_of(given, {}), [], []
    for target in found_in(given.target):
        try:
            reports.append(report_of(read_target(target), asked))
            text = "\n".join(map(shown, text_of(reports[-1])))
            opened = " open" if reports[-1].worst() > 0 else ""
        except TargetError as error:
            text, opened = shown(str(error)), " open"
        scenes.append(f"<details{opened}><summary>{escape(shown(target))}</summary><pre>{escape(text)}</pre></details>")
    told = escape("\n".join(map(shown, summary(reports))))
    title = escape(shown(", ".join(given.target)))
    given.out.mkdir(parents=True, exist_ok=True)
    place = given.out / "index.html"
    place.write_text(PAGE.format(title=title, summary=told, scenes="\n".join(scenes)), encoding="utf-8")
    print(place)
    return CLEAN
