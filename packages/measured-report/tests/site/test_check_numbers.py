"""Test that the numbers on a page agree with their sources to the printed digits."""

import json

import pytest

from measured_report.files.config import report
from measured_report.site.check import PageReader
from measured_report.site.check_numbers import Data, check_number

VALUES = {
    "gain": (6.3617, 0.0048),
    "large": (123456.9, 0.01),
    "rough": (123456.9, 0.15),
    "none": (None, None),
}


def number(
    shown: str, name: str = "gain", value: str = "6.3617", more: str = ""
) -> str:
    return f'<data value="{value}" data-src="values.json#/{name}"{more}>{shown}</data>'


MOST, LEAST, ODD = (f' data-as="{each}"' for each in ("most", "least", "odd"))
RIGHT = [
    number("6.36"),
    number("6.367", more=MOST),
    number("6.356", more=LEAST),
    number("n/a", "none", ""),
]
RIGHT += [
    f"<code>{number('6.3617')}</code>",
    f"<code>{number('123457', 'rough', '123456.9')}</code>",
]
WRONG = {
    number("6.362"): "is 6.3617, but the page shows 6.362 (6.3617)",
    number("6.36", more=MOST): "the page shows 6.36 (6.3617)",
}
WRONG |= {
    number("6.36", value="6.36"): "but the page shows 6.36 (6.36)",
    number("6.36", more=ODD): "does not point to a number",
}
WRONG |= {
    number("6.36", "gone"): "gone does not point to a number",
}


@pytest.mark.parametrize(
    ("html", "said"), [*((html, "") for html in RIGHT), *WRONG.items()]
)
def test_a_number_is_written_as_its_source_and_noise_have_it(tmp_path, html, said):
    values = {
        name: {"value": value, "noise": noise}
        for name, (value, noise) in VALUES.items()
    }
    (tmp_path / "values.json").write_text(json.dumps(values))
    (number,) = PageReader(html).numbers
    found = [*check_number(number, Data(tmp_path, report()))]
    assert bool(found) == bool(said) and said in "".join(found), found


@pytest.mark.parametrize(
    ("noise", "right"),
    [(None, "0.31"), (0.004, "0.312"), (0.1, "0.3"), (0.0, "0.3124")],
)
def test_a_cell_is_written_as_its_noise_has_it(toy, noise, right):
    """Test that the noise comes from all measurements and is stored with the values."""
    data = Data(toy.record_path.parents[1], report())
    source = "newton-1.4.0/toy.json#/rows/1/slip_mm"
    (data.folder / "newton-1.4.0/noise.json").write_text(json.dumps({source: noise}))

    def is_right(shown: str) -> bool:
        html = f'<data value="0.3124" data-src="{source}">{shown}</data>'
        (number,) = PageReader(html).numbers
        return not [*check_number(number, data)]

    shown = ("0.3", "0.31", "0.312", "0.3124", "0.313", "0.310", "3.12")
    assert [each for each in shown if is_right(each)] == [right]


def test_what_no_row_has_is_read_as_its_record_has_it(toy):
    data = Data(toy.record_path.parents[1], report())
    assert data.number("newton-1.4.0/toy.json#/measured/seconds") == (1.5, None)
    toy.measure([{"case": "soft", "slip_mm": 6.0, "dropped": True}])
    again = Data(data.folder, report())
    source = "newton-1.4.0/toy.json#/rows/0/slip_mm"
    (data.folder / "newton-1.4.0/noise.json").write_text(json.dumps({source: None}))
    assert again.number(source)[0] is None
