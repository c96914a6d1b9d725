"""The one exception of this package."""

from __future__ import annotations

import json
from typing import Any


class BladewrightError(Exception):
    """What went wrong, in the words of the command line.

    ``str()`` of it is the whole sentence with the advice.
    """

    message: str
    """What, where, and which limit."""
    stage: str
    """Where it arose: ``job``, ``model``, ``path``, ``channel`` and so on."""
    kind: str
    """``Usage``, ``Infeasible``, ``InputOutput``, ``Findings``, ``Cancelled``, or ``Fault``."""
    exit_code: int
    """What the command would have ended with."""
    advice: str | None
    """What to do about it."""
    data: dict[str, Any] | None
    """What stands in the way of a plan, where ``kind`` is ``Infeasible``."""

    def __init__(
        self,
        message: str,
        stage: str,
        kind: str,
        exit_code: int,
        advice: str | None = None,
        data: str | None = None,
    ) -> None:
        # All of them, so that pickling makes the same again.
        super().__init__(message, stage, kind, exit_code, advice, data)
        self.message = message
        self.stage = stage
        self.kind = kind
        self.exit_code = exit_code
        self.advice = advice
        self.data = json.loads(data) if data is not None else None

    def __str__(self) -> str:
        advice = f" ({self.advice})" if self.advice else ""
        return f"{self.stage}: {self.message}{advice}"
