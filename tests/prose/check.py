"""Check that prose is plain: ``python tests/prose/check.py [FILE…]``.

The check searches docstrings, comments and messages of Python files, templates and
documents for the patterns of ``rules.toml``. With files as arguments this lists every
finding in them. Without arguments it compares each folder with its rate, lists the
findings of those that exceed it, with file, line and a better form, and exits with
status 1 if there are any.
"""

import ast
import io
import re
import sys
import tokenize
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any

from measured_report.files.settings import read_toml

ROOT = Path(__file__).resolve().parents[2]
RULES: dict[str, Any] = read_toml(Path(__file__).with_name("rules.toml"))
PATTERNS = [
    (re.compile(rule["pattern"].replace(" ", r"\s+"), re.IGNORECASE), rule["better"])
    for rule in RULES["rules"]
]
VERB = re.compile(
    rf"\b({'|'.join(RULES['verbs']['words'].split())}|\w+({'|'.join(RULES['verbs']['endings'])}))\b",
    re.IGNORECASE,
)
NOT_PROSE = re.compile(
    r"""
    ^\ *```.*?^\ *```        # a block of code between fences
    | (?<=\n\n)(\ {4}.*?\n)+(?=\n|\Z)  # and one that is indented
    | <!--.*?--> | <[^<>\n]*>  # comments and tags of HTML
    | \{\#.*?\#\} | \{%.*?%\}  # and of Jinja
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)
CODE = re.compile(r"``?[^`\n]+``?|\{\{.*?\}\}|\]\([^)]*\)")
SENTENCE = re.compile(
    r"\S.*?(?:[.?!:;][*)]*(?=\s)|(?=\n\s*\n|\n\s*- |\|)|\Z)", re.DOTALL
)
WORD = re.compile(r"[^\W\d_]+(?:['’]\w+)?")
SHORTEST = 4  # a sentence with this many words or more should have a verb


def texts_of(path: Path) -> Iterator[tuple[int, str]]:
    """Yield each text of a file that people read, with the line on which it begins."""
    source = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        yield 1, source
        return
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and " " in str(node.value):
            yield node.lineno, re.sub(r"\n +", "\n", str(node.value))
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string.lstrip("#! ")


def sentences_of(path: Path) -> Iterator[tuple[int, str]]:
    """Yield the sentences of a file with their lines; code in them is written as X."""
    for line, text in texts_of(path):
        prose = NOT_PROSE.sub(lambda match: "\n" * match[0].count("\n"), text)
        prose = CODE.sub("X", prose)
        for match in SENTENCE.finditer(prose):
            yield line + prose.count("\n", 0, match.start()), match[0]


def checked(path: Path) -> tuple[int, list[str]]:
    """Return how many words a file has, and a line for each finding."""
    count = 0
    findings = []
    for line, sentence in sentences_of(path):
        count += len(words := WORD.findall(sentence))
        if sentence.rstrip("*)").endswith("?"):
            continue
        found = [
            (match[0], line + sentence.count("\n", 0, match.start()), better)
            for rule, better in PATTERNS
            if (match := rule.search(sentence))
        ]
        is_whole = sentence[0].isupper() and sentence[-1] == "."
        if is_whole and len(words) >= SHORTEST and not VERB.search(sentence):
            found.append((sentence, line, RULES["verbs"]["better"]))
        for text, place, better in found:
            findings.append(f"{path.relative_to(ROOT)}:{place}: {text!r}: {better}")
    return count, findings


def main(names: list[str]) -> int:
    if names:
        print(*chain(*(checked(Path(name).resolve())[1] for name in names)), sep="\n")
        return 0
    failed = False
    for room, rate in RULES["rates"].items():
        counts, lists = zip(*map(checked, sorted(ROOT.glob(room))), strict=True)
        findings = list(chain(*lists))
        found_rate = 1000 * len(findings) / sum(counts)
        if found_rate > rate:
            print(*findings, sep="\n")
            print(
                f"{room}: {found_rate:.1f} findings per 1,000 words, more than {rate}"
            )
            failed = True
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
