"""Syntax: what of a definition counts, on small sources."""

import ast

import pytest

from measured_report.records.syntax import Canonical, Reader

RUN = """
import sys
from tqdm import tqdm

LIMIT = 3


def run(cases, *others, title="", **options):
    total = 0.0
    for case in tqdm([*cases, *others], desc=title, unit="case"):
        try:
            found = [each * total for each in case if each < LIMIT]
        except ValueError as error:
            tqdm.write(f"{title}: it failed", file=sys.stderr)
            found = error.args

        def add(value):
            nonlocal total
            total += value

        class Row:
            kept = total

        add(max(found, key=lambda pair: pair[0]))
    print("done")
    return total, options, Row.kept
"""


def said_by(source: str, name: str = "run") -> tuple[str, tuple[str, ...]]:
    [found] = Reader(ast.parse(source), ("experiments",)).definitions()[name]
    return found.tree, found.names


@pytest.mark.parametrize(
    ("old", "new"),
    [(local, "renamed") for local in ("total", "found", "each", "error", "others", "add", "Row", "options")]
    + [
        ("it failed", "it broke"),
        ('    print("done")\n', ""),
        ('print("done")', 'print("all", "done", flush=True)'),
        (', desc=title, unit="case"', ', "cases", delay=3.0'),
    ],
)
def test_what_only_its_function_or_a_reader_sees_does_not_count(old, new):
    assert old in RUN
    assert said_by(RUN.replace(old, new)) == said_by(RUN)


COUNTS = (
    ("total = 0.0", "total = 1.0"),
    ("total += value", "total += LIMIT"),
    ("each * total for", "total * each for"),
    ("            nonlocal total\n", ""),
    ("            nonlocal total\n", "            global total\n"),
    ("pair[0]", "pair[1]"),
    ("kept = total", "kept = found"),
    ("kept", "left"),
    ("value", "amount"),
    ("return total, options", "return options, total"),
    ("[*cases, *others]", "cases"),
    ("title", "label"),
    ('print("done")', 'print("done", file=found)'),
    ("error.args", "total.args"),
)
OTHERS = {
    "a swapped pair": ("def run(a, b):\n    x = a\n    y = b\n    return x - y", "x - y", "y - x"),
    "a parameter that callers name": ("def run(a, b):\n    return a - b", "(a, b)", "(b, a)"),
    "a name that a comprehension hides": ("x = 1\ndef run(c):\n    return [x for x in c]", "for x", "for y"),
    "an attribute that its class reads": ("y = x = 1\nclass run:\n    x = 2\n    z = x", "z = x", "z = y"),
    "a global that is set": ("x = 1\ndef run():\n    global x\n    x = 2", "    global x\n", ""),
    "what a match binds": ("def run(a, c):\n    match a:\n        case [b]:\n            c = b", "= b", "= a"),
    "a walrus in a comprehension": ("def run(a):\n    [b := c for c in a]\n    return b", "return b", "return c"),
    "names that are asked for": ("def run(a):\n    b = a\n    return locals()", "b = a", "c = a"),
    "a name that ends in a row": ("def law(): pass\ndef run():\n    return law.__name__", "law", "rule"),
    "what a bar goes through": ("from tqdm import tqdm\ndef run():\n    return [*tqdm('ab')]", "'ab'", "'ba'"),
    "a text that is written": ("def run(a, file):\n    print('x', file=file)", "'x'", "'y'"),
    "what is called for a text": ("def run(a):\n    print(f'{a(1)}')", "a(1)", "a(2)"),
    "an operator of what is printed": ("def run(a, b):\n    print(a or b)", "a or b", "a and b"),
}


@pytest.mark.parametrize(("source", "old", "new"), [*((RUN, *pair) for pair in COUNTS), *OTHERS.values()])
def test_what_may_change_what_it_returns_counts(source, old, new):
    assert source != source.replace(old, new)
    assert said_by(source) != said_by(source.replace(old, new))


def test_the_help_of_a_program_does_not_count():
    source = "def run(parser):\n    parser.add_argument('--load', help='it bears', default=1)"
    assert said_by(source) == said_by(source.replace("it bears", "its load")) != said_by(source.replace("=1", "=2"))


def test_a_digest_does_not_depend_on_how_a_python_reads_nested_format_specifications():
    earlier, later = ast.parse('f"{name:{width}}"'), ast.parse('f"{name:{width}}"')
    specification = later.body[0].value.values[0].format_spec
    specification.values = [part for part in specification.values if isinstance(part, ast.FormattedValue)]
    without = Canonical(later.body[0], (), {}).form
    specification.values.append(ast.Constant(""))
    assert Canonical(earlier.body[0], (), {}).form == without == Canonical(later.body[0], (), {}).form
