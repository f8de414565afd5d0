"""The tool that asks for a point; path_tool.py measures between several."""

from __future__ import annotations

from ...render.view import View
from .picking import coordinate_text, describe_row
from .stage import Tool


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
            stage.say("Nothing there: click nearer to a point.")
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
