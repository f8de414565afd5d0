"""The tools that look at clicked points: `PointTool` shows one, `MeasureTool` measures between several."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from ...render.view import View
from .measuring import length_text, measurements
from .picking import Pick, coordinate_text, describe_row
from .stage import Tool, check_room

NOTHING = "Nothing there: click nearer to a point."


class PointTool(Tool):
    """Shows what is known of the point that is clicked on."""

    label = "Pick a point"
    key = "I"
    hint = "Click on a point or a surface. Escape ends."

    def click(self, view: View, x: float, y: float) -> None:
        """Show the point's index, coordinates and attributes."""
        stage, found = self.stage, self.stage.pick(view, x, y)
        stage.clear()
        if found is None:
            stage.show([])
            stage.say(NOTHING)
            return
        rows = [("in", found.name)]
        if found.index is None:
            rows += [("triangle", f"{found.triangle:,}")]
            rows += [(axis, coordinate_text(value, 1e-6)) for axis, value in zip("xyz", found.point, strict=True)]
        else:
            rows += describe_row(stage.cloud(found.name)[0].select([found.index]), found.index, found.point)
        stage.mark(view, found.point, "" if found.index is None else f"{found.index}")
        stage.show(rows)
        stage.say(self.hint)

    def undo(self) -> None:
        """Forget the point."""
        self.stage.clear()
        self.stage.show([])


class MeasureTool(Tool):
    """Measures along a path of clicks."""

    label = "Measure"
    key = "M"
    hint = "Click on points or surfaces: two give a distance, more a path and angles. Backspace takes one back."

    def __init__(self, stage: Any):
        super().__init__(stage)
        self._picks: list[Pick] = []

    def click(self, view: View, x: float, y: float) -> None:
        """Add a point to the path."""
        found = self.stage.pick(view, x, y)
        if found is None:
            self.stage.say(NOTHING)
            return
        check_room(self._picks)
        self._show([*self._picks, found], view)

    def undo(self) -> None:
        """Remove the last point."""
        if self._picks:
            self._show(self._picks[:-1], self.stage.view())

    def finish(self) -> None:
        """Begin a new path."""
        if self._picks:
            self._show([], self.stage.view())

    def _show(self, picks: list[Pick], view: View) -> None:
        """Take these points, and show them, their distances and angles."""
        self._picks = picks
        stage, places = self.stage, np.array([found.point for found in picks]).reshape(-1, 3)
        stage.clear()
        for place in places:
            stage.mark(view, place)
        stage.lines(places)
        stage.show([])
        stage.say(self.hint)
        unit = stage.unit(found.name for found in picks)
        for a, b in itertools.pairwise(places if unit is None or unit.metres is not None else []):
            stage.label((a + b) / 2, length_text(float(np.linalg.norm(b - a)), unit))
        stage.show(measurements(places, unit))
