"""Batches: the parts of a section that can be measured apart, by any process of any host, in any order.

A section that has batches measures with a generator. It yields the batches that can run now and is sent what they
return, in the order in which it has named them; what needs others' results is yielded after them::

    def measure(conditions: Conditions) -> Plan:
        points, cells = yield [Batch("points", measure_points, (conditions,)), Batch("map", measure_map, (conditions,))]
        [alone] = yield [Batch("alone", time_cell, (conditions, cells[0]), exclusive=True)]
        return Measurement([*points, *cells, alone])

The generator itself runs where the records are kept, which may have no GPU: what takes a device or long is a batch. A
section whose ``measure`` is no generator is one batch, which measures no times.
"""

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from measured_report.measuring.measurement import Measurement


@dataclass(frozen=True)
class Batch:
    """A call that a process of its own can make."""

    name: str
    """Once in its section: lower-case words, numbers and hyphens."""
    function: Callable[..., Any]
    """Found by its name in a module. It and what it returns travel as bytes."""
    arguments: tuple = ()
    exclusive: bool = False
    """Measures times, so that nothing else is measured on its GPU meanwhile, nor, without one, on its host."""


Plan: TypeAlias = Generator[Sequence[Batch], Sequence[Any], Measurement]
