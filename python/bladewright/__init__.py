"""Machine programs for turbine and compressor blades, straight from their CAD.

>>> import bladewright
>>> plan = bladewright.plan("blade.step", {"path.scallop_mm": 0.02})
>>> plan.cutter_locations.centre_mm.shape
(21034, 3)

Lengths are in mm and times in seconds. Points and directions are in the frame of the model.
Warnings go to the logger ``bladewright``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._errors import BladewrightError

__all__ = ["Axes", "BladewrightError", "CutterLocations", "Plan", "inspect", "plan", "verify"]

__version__ = _native.program().split()[-1]

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
AnyPath = str | PathLike[str]
Progress = Callable[[str, int, int], object]


@dataclass(frozen=True, eq=False, repr=False)
class CutterLocations:
    """Cutter locations in order, one row of each array for each; the arrays are read-only."""

    turn: Ints
    """Number of the turn, from 0."""
    turn_s_mm: Floats
    """Arc length from the beginning of the turn along the path of ball centres."""
    s_mm: Floats
    """Arc length from the beginning of the path."""
    centre_mm: Floats
    """Ball centres, (n, 3)."""
    contact_mm: Floats
    """Where the ball touches the part, or the stock that is left on it, (n, 3)."""
    normal: Floats
    """Outward unit normals at the contacts, (n, 3)."""
    axis: Floats
    """Unit tool axes from tip to spindle, (n, 3)."""
    theta_rad: Floats
    """Angles of the tool axis about the blade axis."""
    theta_min_rad: Floats
    """Least angles that the channel allows."""
    theta_max_rad: Floats
    """Greatest angles that the channel allows."""
    feed_mm_min: Floats
    """Feed of the ball centre towards each location."""

    def __len__(self) -> int:
        return len(self.s_mm)

    def __repr__(self) -> str:
        return f"<{len(self)} cutter locations>"

    def as_dict(self) -> dict[str, npt.NDArray[Any]]:
        """The arrays by name."""
        return dict(self.__dict__)


@dataclass(frozen=True, eq=False, repr=False)
class Axes:
    """Motion of the machine's axes: a row for each time and a column for each axis.

    The rows of the lead-in stand before those of the cutter locations, the rows of the lead-out
    behind them. Rotary axes are in degrees.
    """

    names: tuple[str, ...]
    """Names of the axes, in the order of the columns."""
    units: tuple[str, ...]
    """``mm`` or ``deg`` for each axis."""
    first_location: int
    """The row of the first cutter location."""
    time_s: Floats
    """Times from the beginning of the motion."""
    position: Floats
    """Positions, (m, axes)."""
    velocity: Floats
    """Velocities, per second."""
    acceleration: Floats
    """Accelerations, per second squared."""
    jerk: Floats
    """Jerks, per second cubed."""

    def __len__(self) -> int:
        return len(self.time_s)

    def __repr__(self) -> str:
        return f"<{len(self)} rows of {' '.join(self.names)}>"


class Plan:
    """A plan that was made and checked."""

    def __init__(self, native: _native.Planned) -> None:
        self._native = native

    def __repr__(self) -> str:
        state = "passed" if self.passed else "failed"
        n = self.summary["cutter_locations"]
        return f"<plan of {self.summary['name']}: {n} locations, {self.time_s:.1f} s, {state}>"

    @cached_property
    def cutter_locations(self) -> CutterLocations:
        """Where the tool goes."""
        parts = self._native.locations()
        wide = {"centre_mm", "contact_mm", "normal", "axis"}
        turn = np.frombuffer(parts.pop("turn"), dtype=np.int64)
        rest = {k: _floats(v, 3 if k in wide else None) for k, v in parts.items()}
        return CutterLocations(turn=turn, **rest)

    @cached_property
    def axes(self) -> Axes:
        """What the axes of the machine do."""
        parts = self._native.axes()
        columns = len(parts["names"])
        rows = ("position", "velocity", "acceleration", "jerk")
        return Axes(
            names=tuple(parts["names"]),
            units=tuple(parts["units"]),
            first_location=parts["first_location"],
            time_s=_floats(parts["time_s"], None),
            **{name: _floats(parts[name], columns) for name in rows},
        )

    @property
    def time_s(self) -> float:
        """Machining time along the path."""
        return self._native.time_s()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The figures of ``summary.json``; programs are in it where ``out`` was given."""
        return _object(self._native.summary())

    @cached_property
    def checks(self) -> list[dict[str, Any]]:
        """Every check with its limit and worst place, as in ``verify.json``."""
        checks: list[dict[str, Any]] = _object(self._native.report())["checks"]
        return checks

    @property
    def passed(self) -> bool:
        """Every check has passed."""
        return all(check["passed"] for check in self.checks)

    @cached_property
    def warnings(self) -> list[dict[str, Any]]:
        """What the user should know: stage, sentence, and what the sentence says as data."""
        warnings: list[dict[str, Any]] = json.loads(self._native.warnings())
        return warnings

    @cached_property
    def job(self) -> str:
        """The job with every default, as the text of a job file."""
        return self._native.job()

    @property
    def tool(self) -> str:
        """The tool in words, and why it is this one."""
        words, why = self._native.tool()
        return f"{words} ({why})"

    @property
    def files(self) -> list[Path]:
        """Files that were written; none without ``out``."""
        return [Path(file) for file in self._native.files()]

    def program(self, control: AnyPath) -> str:
        """The text of a program, read back and compared with the plan.

        ``control`` is a name such as ``siemens`` or ``linuxcnc``, or the path of a post file.
        A plan that fails its checks has no program, unless it was planned with ``force``.
        """
        return self._native.program(control)[1]


def plan(
    model: AnyPath,
    settings: Mapping[str, Any] | None = None,
    out: AnyPath | None = None,
    *,
    force: bool = False,
    progress: Progress | None = None,
    threads: int | None = None,
) -> Plan:
    """Plans a model, or a job file (TOML).

    ``settings`` are keys of a job file, as ``{"tool.radius_mm": 4.0}`` or
    ``{"tool": {"radius_mm": 4.0}}``. With ``out`` the folder of a run is written, as by the
    command ``bladewright plan``; without it nothing is written. ``progress`` is called with a
    stage and how much of its work is done, about ten times a second, and may raise to stop.
    ``threads``: one for each core where it is left out. Other Python threads run meanwhile, and
    Ctrl-C stops the plan.

    Raises `BladewrightError` where there is no plan. One that fails its checks is returned, with
    ``passed`` false; ``force`` writes its programs all the same, marked as not verified.
    """
    chosen = None if settings is None else dict(settings)
    return Plan(_native.plan(model, chosen, out, force, progress, threads))


def verify(
    run: AnyPath, *, progress: Progress | None = None, threads: int | None = None
) -> dict[str, Any]:
    """Checks the folder of a run again, as the command ``bladewright verify``.

    Writes ``verify.json`` in that folder and returns the same, with ``passed``.
    """
    report = _object(_native.verify(run, progress, threads))
    report["passed"] = all(check["passed"] for check in report["checks"])
    return report


def inspect(
    model: AnyPath, *, progress: Progress | None = None, threads: int | None = None
) -> dict[str, Any]:
    """What is in a model file: unit, size, openings, regions, whatever its state.

    ``text`` is what the command ``bladewright inspect`` prints, ``regions`` what it gives with
    ``--json``. ``problem`` says why no plan can be made, or is None.
    """
    found, text = _native.inspect(model, progress, threads)
    return {**_object(found), "text": text}


def _floats(data: bytes, columns: int | None) -> Floats:
    values = np.frombuffer(data, dtype=np.float64)
    return values if columns is None else values.reshape(-1, columns)


def _object(text: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text)
    return found
