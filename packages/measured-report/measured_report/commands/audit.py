"""Audit texts: are their numbers and words, by the marks behind them, still what the results say?"""

import argparse
import csv
import json
import re
import sys
from collections import Counter, namedtuple
from collections.abc import Callable, Iterator, Mapping
from decimal import ROUND_HALF_UP, Decimal
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

from measured_report.files.atomic import atomic_file, read_own_file
from measured_report.files.config import report
from measured_report.files.errors import UNPRINTABLE, ReportError, suggestion
from measured_report.records.columns import PLAIN, is_number
from measured_report.site.check_numbers import UNRESOLVED, Data
from measured_report.values.format import DIGITS, MINUS, undusted
from measured_report.values.noise import SURE, Z, sampled_noise, t_quantile
from measured_report.values.quantities import Quantity

PREFIXES = {"": 1.0, "n": 1e-9, "µ": 1e-6, "μ": 1e-6, "u": 1e-6, "m": 1e-3, "c": 1e-2, "k": 1e3, "K": 1e3, "M": 1e6}
PREFIXES |= {"G": 1e9, "T": 1e12} | {f"{letter}i": 1024.0**power for power, letter in enumerate("KMGT", 1)}
BASES = "m s g N J W V A B bit Pa Hz rad"
UNITS = {f"{prefix}{base}": (factor, base) for prefix, factor in PREFIXES.items() for base in BASES.split()}
UNITS |= {"min": (60.0, "s"), "seconds": (1.0, "s"), "sec": (1.0, "s"), "bytes": (1.0, "B")}
NAMES = ("name", "case", "command", "benchmark", "operation", "label", "id")  # keys whose text names a thing of a list
SAMPLES = ("times", "data", "samples")
SECONDS = ("mean", "median", "min", "max", "stddev", "iqr", "q1", "q3", "total", "user", "system", "times", "data")
SCATTER = {"mean": 1.0, "median": 1.2533}  # of many samples, in standard errors of the mean
CELL = re.compile(r"[-+]?\d{1,20}(\.\d{0,20})?(e[-+]?\d{1,3})?", re.IGNORECASE)
data_of = cache(lambda folder: Data(folder, report()))
BYTE_LIMIT = 256 << 20
PRINTED = {"text": "{file}:{line}: {kind}: {text}", "github": "::{level} file={file},line={line}::{kind}: {text}"}
COMMENT = r"<!--(?:(?P<comment>(?s:.*?))-->|(?s:.*)\Z)"
ROLE = r"(?::audit:`|\\audited\{)(?P<of>[^`<{}]{1,200})(?:<|\}\{)(?P<role>[^`{}]{1,600})(?:>`|\})"
CODE = r"(?<!`)(?P<ticks>`{1,8})(?!`)(?:(?!\n\s*\n)(?s:.)){1,200}?(?<!`)(?P=ticks)(?!`)|`+"
FENCE = r"^[ >]*(?P<fence>`{3,20}|~{3,20}).*\n(?:.*\n)*?(?:[ >]*(?P=fence)[`~]*[ \t\r]*$|\Z)"
CODES = {".html": (), ".htm": (), ".tex": (), ".rst": (CODE,)}
FORMS = {".rst": ":audit:`{} <= {}>`", ".tex": r"\audited{{{}}}{{= {}}}"}
OF_NUMBER = re.compile(
    r"(?:(?P<name>[^\W\d_]\w*)\s*)?=\s*(?=[\w(./])(?P<source>.+?(?<=[\w)\]]))(?:\s+(?P<unit>[^\W\d_]\S{0,20}))?"
    r"(?:\s+digits\s+(?P<digits>\d{1,2}))?(?:\s*±\s*(?P<tolerance>\d[\d.]{0,9})\s*%)?"
)
OF_WORD = re.compile(r"(?P<yes>.+?) if (?P<left>[^<>]+?)\s*(?P<sign>[<>])\s*(?P<right>[^<>]+?) else (?P<no>.+)")
NO_ARITHMETIC = re.compile(r"[^\w\s.+*/()-]|\*\s*\*|/\s*/|(?<!\d)\.|\.(?!\d)|[\w)]\s*\(|\b_")
NUMBER = (
    r"(?<![^\W_])(?<![.,])(?<!\d[ \xa0\u2009\u202f])(?<!\^)(?<!\^\{)(?<!<sup>)(?P<digits>[−-]?(?:"
    r"\d{1,3}(?P<group>[,_'\u202f\u2009\xa0])\d{3}(?:(?P=group)\d{3})*(?!\d)|\d+)(?:\.\d+)?)"
    r"(?:(?P<ten>[eE]|\s?[×·x]\s?10(?=[⁻⁰¹²³⁴-⁹]))(?P<power>[+-]?\d{1,3}|[⁻⁰¹²³⁴-⁹]+))?"
)
UNIT = r"(?P<unit>[^\W\d_]*[%×°]?(?:/[^\W\d_]+)?)"
CLOSING = r"(?:[\s*_`~)\]}$,;]|\\[,; ]|&\w{1,9};|</?\w[^<>\n]{0,80}>){0,20}"
BEFORE = re.compile(rf"{NUMBER}{CLOSING}{UNIT}{CLOSING}\Z")
UNMARKED = re.compile(rf"(?<![\w./#-]){NUMBER}(?:(?:[ \xa0\u2009\u202f~]|\\,)?{UNIT})?(?![\w/-]|\.\w)")
MARKED = re.compile(rf"{CLOSING}<!--")
Finding = namedtuple("Finding", ("line", "kind", "text", "start", "end", "replacement"), defaults=(0, 0, ""))


def scale_of(unit: str) -> tuple[float, str]:
    """Split a unit into a factor and a unit whose first part has no prefix; of what is no unit that is empty."""
    symbol, slash, below = unit.partition("/")
    return (UNITS[symbol][0], UNITS[symbol][1] + slash + below) if symbol in UNITS else (1.0, "")


def in_unit(quantity: Quantity, unit: str) -> Quantity | None:
    """Convert a number, which stays as it is where it or ``unit`` has none; None where they are of two kinds."""
    (factor, base), (own_factor, own_base) = scale_of(unit), scale_of(quantity.unit)
    if not (base and own_base) or base != own_base:
        return None if base and own_base else quantity
    noise = quantity.noise and quantity.noise * own_factor / factor
    return Quantity(undusted(quantity.number * own_factor / factor), unit, "", noise=noise)


class Source:
    """Reads results; an error, ReportError or one of ``UNRESOLVED``, tells that they are none."""

    def __init__(self, path: Path, read: Callable[[Path], bytes]):
        self._path, text = path, read(path).decode("utf-8-sig")
        lines = csv.reader(text.splitlines(), delimiter=max(",;", key=text.partition("\n")[0].count))
        header, *rows = lines if path.suffix == ".csv" else [[]]
        self._data: Any = [dict(zip(("name", *header[1:]), row, strict=False)) for row in rows] or json.loads(text)
        self.places = dict(_places(self._data, ""))

    def quantity(self, pointer: str) -> Quantity:
        """Return a number, without a unit where its source does not say."""
        if (place := unquote(pointer)) not in self.places:
            near = [way for way, (name, *_) in self.places.items() if name == place.rpartition("/")[2]]
            raise LookupError(f"there is no number at {place:.120}{suggestion(place, near[:99])}")
        name, value, beside = self.places[place]
        if "identity" in self._data and place.startswith("/rows/"):  # a record
            row, file = self._data["rows"].index(beside), f"{self._path.parent.name}/{self._path.name}"
            value, noise = data_of(self._path.parents[1]).number(f"{file}#/rows/{row}/{name}")
        elif isinstance(value, list):
            noise, value = sampled_noise(value), sum(value) / len(value)
        else:
            value, noise = float(value), _noise(name, beside)
        return Quantity(value, self._unit(name, beside), pointer, noise=noise)

    def _unit(self, name: str, beside: Mapping[str, Any]) -> str:
        data, (stem, _, end) = self._data if isinstance(self._data, Mapping) else {}, name.rpartition("_")
        units = data["units"] if isinstance(data.get("units"), Mapping) else {}
        if name in SECONDS and ("machine_info" in data or "command" in beside):  # pytest-benchmark, hyperfine
            return "s"
        if name in ("real_time", "cpu_time", "point_estimate"):  # google-benchmark, criterion
            return str(beside.get("time_unit", "ns"))
        by_end = end if end in UNITS and stem and not stem.endswith("per") else PLAIN
        return str(beside.get("unit", PLAIN) if name == "value" else units.get(name, by_end))


def _places(node: Any, way: str, name: str = "", beside: Mapping[str, Any] | None = None) -> Iterator[tuple[str, Any]]:
    """Yield each number, or samples of one, by the names that lead there, with its own and what stands beside it."""
    if isinstance(node, Mapping):
        for key, child in node.items():
            yield from _places(child, f"{way}/{key}", key, node)
    elif isinstance(node, list) and not (name in SAMPLES and len(node) > 1 and all(map(is_number, node))):
        tables = [thing if isinstance(thing, Mapping) else {} for thing in node]
        names = [next((table[key] for key in NAMES if isinstance(table.get(key), str)), "") for table in tables]
        counts = Counter(names) | {"": 2}
        for index, child in enumerate(node):
            yield from _places(child, f"{way}/{index if counts[names[index]] > 1 else names[index]}")
    elif isinstance(node, list) or (CELL.fullmatch(node) if isinstance(node, str) else is_number(node)):
        yield way, (name, node, beside or {})


def _noise(name: str, beside: Mapping[str, Any]) -> float | None:
    """Bound how far a number may be from the truth; None where its source does not say."""
    noise, error, deviation = (beside.get(key) for key in ("noise", "standard_error", "stddev"))
    count = next((len(n) if isinstance(n, list) else n for n in map(beside.get, ("rounds", "runs", "times")) if n), 0)
    if name == "point_estimate" and is_number(error):
        return Z * error
    if not (name in SCATTER and is_number(deviation) and is_number(count) and count > 1):
        return noise if name == "value" and is_number(noise) else None
    return SCATTER[name] * t_quantile(SURE, count - 1) * deviation / count**0.5


def value_of(match: re.Match[str]) -> Decimal:
    """Read a number that NUMBER matched; its last digit is worth ten to the decimal's exponent."""
    digits, power = re.sub(r"[^\d.-]", "", match["digits"].replace(MINUS, "-")), match["power"] or "0"
    return Decimal(digits).scaleb(int(power.translate(DIGITS)))


class Audit:
    """Compares the numbers and words of a text with the sources that their marks name."""

    def __init__(self, path: Path, source: Callable[[str], Source]):
        self._path, self._source, self._quantity = path, source, cache(self._evaluated)
        # Bytes that are no UTF-8 are written back as they were read.
        self.text = read_own_file(path, BYTE_LIMIT).decode("utf-8", "surrogateescape")
        self._syntax = re.compile("|".join((COMMENT, ROLE, *CODES.get(path.suffix, (FENCE, CODE)))), re.MULTILINE)
        self._marks = list(self._read_marks())
        self._named = {mark["name"]: (mark["source"], mark["unit"]) for *_, mark in self._marks if mark.get("name")}

    def _read_marks(self) -> Iterator[tuple[int, int, str, dict[str, str]]]:
        line, end = 1, 0
        for match in self._syntax.finditer(self.text):
            (comment, of, role), start = (match[name] or "" for name in ("comment", "of", "role")), match.start()
            text = re.sub(r"\\([#%_&])", r"\1", " ".join((comment or role).split()))
            line, before = line + self.text.count("\n", end, start), of or self.text[max(end, start - 200) : start]
            if len(text) <= 600 and (groups := OF_NUMBER.fullmatch(text) or OF_WORD.fullmatch(text)):
                yield line, match.start("of") if of else start - len(before), before, groups.groupdict("")
            line, end = line + match[0].count("\n"), match.end()

    def findings(self) -> Iterator[Finding]:
        """Yield what came of each mark: fresh, unclear, stale, false or missing, and what is to be replaced."""
        for line, start, before, mark in self._marks:
            try:
                yield (self._of_word if "yes" in mark else self._of_number)(line, start, before, mark)
            except (*UNRESOLVED, ReportError, SyntaxError, ArithmeticError, RecursionError) as error:
                yield Finding(line, "missing", " ".join(str(error).strip("'").split()))

    def _of_number(self, line: int, start: int, before: str, mark: dict[str, str]) -> Finding:
        source, name = mark["source"], mark["name"]
        if name and self._named[name] != (source, mark["unit"]):
            raise ReportError(f"another mark is called {name}, too")
        if not (match := BEFORE.search(before)):
            raise ReportError(f"no number stands right before = {source}, or one as 1 000 or 1,5")
        quantity = self._quantity(source, mark["unit"])
        unit = match["unit"] if scale_of(match["unit"])[1] else mark["unit"]
        if not (measured := in_unit(quantity, unit)):
            raise ReportError(f"{unit} is printed, and the source is in {quantity.unit}")
        printed, value, noise = value_of(match), float(measured.number), measured.noise or 0
        exact, digits = Decimal(repr(value)), int(mark["digits"] or 0)
        step = exact.adjusted() + 1 - digits if digits and value else int(printed.as_tuple().exponent)
        limit = max(0.5000001 * 10.0**step, 2**0.5 * noise, float(mark["tolerance"] or 0) * abs(value) / 100)
        label = f"{f' ± {noise:.2g}' * bool(noise)} {measured.unit.replace(PLAIN, '')}".rstrip()
        text = f"{match[0].strip()} is {value:.6g}{label} by {source}"
        if abs(float(printed) - value) <= limit:
            return Finding(line, "fresh", text)
        rounded = f"{exact.quantize(Decimal(1).scaleb(step), ROUND_HALF_UP):{',' * bool(match['group'])}f}"
        new = rounded.translate({44: match["group"], 45: MINUS if MINUS in match[0] else "-"}) * (not match["ten"])
        return Finding(line, "stale", text, start + match.start("digits"), start + match.end("digits"), new)

    def _of_word(self, line: int, start: int, before: str, mark: dict[str, str]) -> Finding:
        yes, no, left, sign, right = (mark[name] for name in ("yes", "no", "left", "sign", "right"))
        before = re.sub(rf"{CLOSING}\Z", "", before)
        if not (words := [word for word in (yes, no) if re.search(rf"(?<!\w){re.escape(word)}\Z", before)]):
            raise ReportError(f"neither {yes} nor {no} stands right before the mark")
        word, difference = max(words, key=len), self._quantity(f"( {left} ) - ( {right} )", "")
        holds = difference.number < 0 if sign == "<" else difference.number > 0
        is_clear, end = abs(difference.number) > (difference.noise or 0), start + len(before)
        kind = "fresh" if holds == (word == yes) else "false" if is_clear else "unclear"
        text = f"{word}, and {left} {sign} {right} {'holds' if holds else 'is not so'}{'' if is_clear else ' by noise'}"
        return Finding(line, kind, text, end - len(word), end, (yes if holds else no) if kind == "false" else "")

    def _evaluated(self, expression: str, unit: str) -> Quantity:
        """Return what an expression comes to, in ``unit`` if nothing says in which."""
        operands: dict[str, Quantity] = {}

        def operand(match: re.Match[str]) -> str:
            file, is_place, place = match[0].partition("#")
            if not is_place and file not in self._named:
                raise ReportError(f"{file} is the name of no mark")
            name = f"q{len(operands)}"
            operands[name] = self._source(file).quantity(place) if is_place else self._quantity(*self._named[file])
            return name

        code = re.sub(r"[^\s(]+#/\S+|\b[^\W\d_]\w*", operand, expression)
        if NO_ARITHMETIC.search(code):
            raise ReportError(f"{expression:.60} is no FILE#/PLACE, and no arithmetic of such and of names")
        if code not in operands:
            operands = {name: in_unit(number, scale_of(number.unit)[1]) or number for name, number in operands.items()}
        # It has nothing but names of operands, numbers, signs and brackets in it.
        result = eval(code, {"__builtins__": {}}, operands)
        if not isinstance(result, Quantity) or result.value is None:
            raise ReportError(getattr(result, "reason", "") or f"{expression} is no number")
        return result if scale_of(result.unit)[1] or not unit else Quantity(result.value, unit, "", noise=result.noise)

    def suggestions(self, file: str) -> Iterator[Finding]:
        """Yield a mark for each number without one that is a single number of the results; others have a choice."""
        source, form = self._source(file), FORMS.get(self._path.suffix, "{}<!-- = {} -->")
        ways = [quote(place, "/~!$&()*+,:;=@[]|") for place, (name, *_) in source.places.items() if name not in SAMPLES]
        numbers = [(f"{file}#{way}", source.quantity(way)) for way in ways]
        in_units = cache(lambda unit: [(way, n.number) for way, number in numbers if (n := in_unit(number, unit))])
        hidden = self._syntax.sub(lambda mark: "\0" * len(mark[0]), self.text)
        for match in UNMARKED.finditer(hidden):
            printed, unit = value_of(match), match["unit"] or ""
            step, count = int(printed.as_tuple().exponent), len(printed.as_tuple().digits)
            near = [way for way, value in in_units(unit) if abs(value - float(printed)) <= 0.5000001 * 10.0**step]
            # A number such as 2 or 10 is in any results by chance.
            if near and count > (1 if step < 0 else 2) and not MARKED.match(self.text, match.end()):
                start, end = match.start(), match.end() if scale_of(unit)[1] or unit in "×%°" else match.start("unit")
                text, line = self.text[start:end].rstrip(), self.text.count("\n", 0, start) + 1
                mark = form.format(text, re.sub(r"(?=[#%_&])", r"\\" * (self._path.suffix == ".tex"), near[0]))
                mark = mark if len(near) == 1 else ""
                label = mark or f"{text} is {' or '.join(near[:9])}"
                yield Finding(line, "fresh" if mark else "unclear", label, start, start + len(text), mark)


def main() -> int:
    """Print what came of each mark of the files; 1 where a number is stale, a word false or a source missing."""
    parser = argparse.ArgumentParser(prog="measured-report audit", description=__doc__, allow_abbrev=False)
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="Markdown, HTML, LaTeX, reStructuredText")
    parser.add_argument("--fix", action="store_true", help="write what is right for stale numbers and false words")
    parser.add_argument("--check", action="store_true", help="print nothing of what is fresh")
    parser.add_argument("--suggest", metavar="RESULTS", help="mark the numbers that are one number of these results")
    parser.add_argument("--allow", metavar="FOLDER", type=Path, action="append", default=[], help="outside the project")
    parser.add_argument("--format", choices=("json", *PRINTED), default="text", help="github: annotations")
    arguments, is_wrong = parser.parse_args(sys.argv[2:]), False
    for path in arguments.files:
        for finding in _findings(path, arguments):
            level = "notice" if finding.kind in ("fresh", "unclear") else "error"
            is_wrong |= level == "error"
            row = finding._asdict() | {"file": str(path), "text": UNPRINTABLE.sub("?", finding.text), "level": level}
            if not (arguments.check and finding.kind == "fresh"):
                print(json.dumps(row) if arguments.format == "json" else PRINTED[arguments.format].format_map(row))
    return int(is_wrong)


def _findings(path: Path, arguments: argparse.Namespace) -> list[Finding]:
    project = next((folder for folder in path.absolute().parents if (folder / ".git").exists()), Path.cwd())

    def read(file: Path) -> bytes:
        if not any(file.resolve().is_relative_to(folder.resolve()) for folder in (project, *arguments.allow)):
            raise ReportError(f"{file.name} is outside {project.name}/, where --allow FOLDER lets it be read")
        return read_own_file(file.resolve(), BYTE_LIMIT)

    try:
        audit = Audit(path, source := cache(lambda name: Source((path.parent / name).absolute(), read)))
        findings = list(audit.suggestions(arguments.suggest) if arguments.suggest else audit.findings())
        text = audit.text
        for finding in reversed(findings if arguments.fix or arguments.suggest else ()):
            if finding.replacement:
                text = text[: finding.start] + finding.replacement + text[finding.end :]
        if text == audit.text:
            return findings
        with atomic_file(path) as temporary:
            temporary.write_bytes(text.encode("utf-8", "surrogateescape"))
            temporary.chmod(path.stat().st_mode)
        return findings if arguments.suggest else list(Audit(path, source).findings())
    except (*UNRESOLVED, ReportError, RecursionError) as error:
        return [Finding(1, "missing", " ".join(str(error).split()))]
