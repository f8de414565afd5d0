"""Tools that look at a row of clicked places: `PathTool`, and the length of a path."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.units import LengthUnit
from ...render.view import View
from ..history import Change
from .measuring import length_text, measurements
from .picking import Pick
from .stage import Tool, check_room


class PathTool(Tool):
    """Keeps the places that are clicked on, marks them, and tells of them what a tool finds.

    Attributes:
        closed: Whether a line leads from the last place back to the first one.
    """

    closed = False

    def __init__(self, stage: Any):
        super().__init__(stage)
        self._picks: list[Pick] = []
        self._has_stopped = False

    @property
    def places(self) -> NDArray[np.float64]:
        """Where was clicked in the world, float64 [n, 3]."""
        return np.array([found.point for found in self._picks]).reshape(-1, 3)

    @property
    def names(self) -> list[str]:
        """What was clicked on, each once."""
        return list(dict.fromkeys(found.name for found in self._picks))

    def click(self, view: View, x: float, y: float) -> None:
        """One place more."""
        found = self.stage.pick(view, x, y)
        if found is None:
            self.stage.say("Nothing there: click nearer to a point.")
            return
        check_room(self._picks)
        self._take([*self._picks, found], "Mark a place", view)

    def undo(self) -> None:
        """One place less."""
        if self._picks:
            self._take(self._picks[:-1], "Take a place back")

    def finish(self) -> None:
        """Begin anew."""
        if self._picks:
            self._take([], "Delete the marks")

    def stop(self) -> None:
        """What is taken back after this cannot bring marks back."""
        self._has_stopped = True

    def tell(self, unit: LengthUnit | None) -> None:
        """Show what is known of the places."""

    def _take(self, picks: list[Pick], label: str, view: View | None = None) -> None:
        """Other places from now on; the page's history can go back."""
        before, after = self._picks, picks
        self._show(picks, view)
        change = Change(f"{label} ({self.label})", self._goes_to(before), self._goes_to(after))
        self.stage.history.add(change)

    def _goes_to(self, picks: list[Pick]) -> Callable[[], None]:
        def go() -> None:
            if self._has_stopped:
                raise ValueError(f"the tool {self.label} has ended, and its marks with it")
            self._show(picks)

        return go

    def _show(self, picks: list[Pick], view: View | None = None) -> None:
        self._picks = picks
        stage, places, seen = self.stage, self.places, self.stage.view() if view is None else view
        stage.clear()
        for place in places:
            stage.mark(seen, place)
        stage.lines(places, closed=self.closed and len(places) > 2)
        stage.show([])
        stage.say(self.hint)
        self.tell(stage.unit(self.names))


class MeasureTool(PathTool):
    """Measures along a path of clicks."""

    label = "Measure"
    key = "M"
    hint = "Click on points or surfaces: two give a distance, more a path and angles. Backspace takes one back."

    def tell(self, unit: LengthUnit | None) -> None:
        """Lengths and angles."""
        places = self.places
        for a, b in itertools.pairwise(places if unit is None or unit.metres is not None else []):
            self.stage.label((a + b) / 2, length_text(float(np.linalg.norm(b - a)), unit))
        self.stage.show(measurements(places, unit))
