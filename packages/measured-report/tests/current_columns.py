"""Provide the columns of the current report to tests."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from measured_report.files.columns import *  # noqa: F403
from measured_report.files.columns import SYMBOL, Column
from measured_report.files.config import report


def units() -> Mapping[str, str]:
    return report().columns.units


def column_of(name: str) -> Column:
    return report().columns[name]


def parameters() -> Mapping[str, Any]:
    return report().columns.parameters


def is_cost(column: str) -> bool:
    return report().columns[column].is_cost


def is_unit(text: str) -> bool:
    is_known = all(SYMBOL.fullmatch(factor) for factor in re.split("[/·]", text))
    return is_known or report().columns.is_unit(
        text
    )  # constants are made while modules are imported


def changed_parameters(row: Mapping[str, Any]) -> dict[str, Any]:
    return report().columns.changed_parameters(row)


def number_of(column: str, row: Mapping[str, Any]) -> Any:
    return report().columns.number_of(column, row)


def units_of(rows: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    return report().columns.units_of(rows)


def number_problem(name: str, value: int | float) -> str:
    return report().columns.number_problem(name, value)


def refuse_mixed(rows: Sequence[Mapping[str, Any]], noted: Mapping[str, str]) -> None:
    report().columns.refuse_mixed(rows, noted)
