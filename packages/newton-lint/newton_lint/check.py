"""Lets programs lint a scene: ``from newton_lint.check import check``."""

from dataclasses import replace
from typing import Any

from newton_lint.findings import Finding, sentence
from newton_lint.output import Detail, printable, text_of
from newton_lint.report import Request, report_of
from newton_lint.target import target_of


def check(
    scene: Any, request: Request | None = None, *, show: bool = True
) -> tuple[Finding, ...]:
    """Lint a scene, print its findings and return them.

    Args:
        scene: A ``newton.ModelBuilder`` or ``newton.Model``, a ``mujoco.MjModel`` or
            ``MjSpec``, a tuple of a model and its ``MjData``, or the path of a file.
        request: Options of the command line, such as ``Request(step=False)``.
        show: Whether to print the findings; notes are returned but not printed.

    Raises:
        TargetError: The scene cannot be linted.
    """
    report = report_of(target_of(scene), request or Request())
    if show:
        print("\n".join(map(printable, text_of(report, Detail()))))
    return tuple(
        replace(finding, message=sentence([finding])) for finding in report.findings
    )
