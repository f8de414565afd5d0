"""What is written over a picture: labels, a legend, a colour bar and a scale bar, and the room that they want."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_color, check_list, check_name, check_shape
from ...core.units import LengthUnit
from ...kernels.arrays.select import gather_rows
from ...kernels.arrays.subsets import step_rows
from ...kernels.memory import download
from .canvas import BLACK, WHITE, Canvas
from .coloring import Coloring
from .legends import color_bar_size, draw_color_bar, draw_labels, draw_legend, legend_size
from .parts import Lines, Part, Triple
from .scale_bars import draw_scale_bar
from .view import Insets, View

SAMPLE = 10_000  # colours that the mean of a legend comes from, and up to twice as many


@dataclasses.dataclass(frozen=True, eq=False)
class Overlays:
    """What is written over a picture.

    Attributes:
        labels: Texts and the places [m] that they belong to.
        entries: Names and colours of a legend.
        coloring: What a colour bar shows, or None.
        scale_bar: Whether there is one.
        unit: Of the lengths.
        is_dark: Whether letters stand before a dark background.
    """

    labels: Sequence[tuple[str, NDArray[np.float64]]] = ()
    entries: Sequence[tuple[str, Triple]] = ()
    coloring: Coloring | None = None
    scale_bar: bool = False
    unit: LengthUnit | None = None
    is_dark: bool = False

    def __bool__(self) -> bool:
        return bool(self.labels or self.entries or self.scale_bar or self.coloring is not None)

    def rooms(self, width: int, height: int) -> list[Insets]:
        """The bands [px] at the edges of a picture that legend and colour bar may have to themselves.

        Panels in the upper corners lie beside what is drawn or above it: the fit takes what leaves it more.
        """
        kinds: list[list[Insets]] = []
        if self.entries:
            wide, high = legend_size(self.entries, width, height)
            kinds.append([(wide, 0, 0, 0), (0, high, 0, 0)])
        if self.coloring is not None:
            wide, high, is_tall = color_bar_size(self.coloring, width, height)
            kinds.append([(0, 0, wide, 0)] if is_tall else [(0, 0, wide, 0), (0, high, 0, 0)])
        return [_united(bands) for bands in itertools.product(*kinds)]

    def write(self, canvas: Canvas, view: View, middle: NDArray[np.float64]) -> None:
        """Write them; `middle` is that of the scene [m], which the scale bar is for."""
        ink: dict[str, Any] = {"color": WHITE, "halo": BLACK} if self.is_dark else {"color": BLACK, "halo": WHITE}
        draw_labels(canvas, _project(self.labels, view), **ink)
        draw_legend(canvas, self.entries)
        if self.coloring is not None:
            draw_color_bar(canvas, self.coloring)
        if self.scale_bar:
            draw_scale_bar(canvas, view, middle, self.unit, **ink)


def check_labels(labels: Any) -> list[tuple[str, NDArray[np.float64]]]:
    """Texts with places."""
    found = []
    for entry in check_list("labels", [] if labels is None else labels, "texts with places"):
        text, place = _pair("labels", entry, "a text and a place")
        found.append((check_name("labels", text), check_shape("labels", place, (3,))))
    return found


def check_legend(legend: Any) -> Any:
    """Names with colours, or whether there is a legend at all."""
    if legend is None or legend is False or legend is True:
        return legend
    found = []
    for entry in check_list("legend", legend, "names with colours"):
        name, color = _pair("legend", entry, "a name and a colour")
        red, green, blue = check_color("legend", color).tolist()
        found.append((check_name("legend", name), (red, green, blue)))
    return found


def check_bar(color_bar: Any, parts: Sequence[Part]) -> Coloring | None:
    """What a colour bar shows."""
    if color_bar is None or color_bar is False or isinstance(color_bar, Coloring):
        return color_bar or None
    if color_bar is not True:
        raise TypeError(f"color_bar: expected True or a Coloring, got {type(color_bar).__name__}")
    colorings = [part.coloring for part in parts if not isinstance(part, Lines) and part.coloring is not None]
    if not colorings:
        raise ValueError('color_bar: no cloud or mesh has "color_by"; pass {"geometry": cloud, "color_by": "height"}')
    return colorings[0]


def color_of(parts: Sequence[Part]) -> Triple:
    """The colour by which a legend shows a geometry: its own, or the mean of its points' or vertices'."""
    part = parts[0]
    if not part.colors.size:
        return part.plain
    count, device = part.colors.size, part.colors.device
    some = gather_rows(part.colors, step_rows(count, max(1, count // SAMPLE), device))
    red, green, blue = np.clip(np.nanmean(download(some), axis=0), 0, 1)  # sync
    return float(red), float(green), float(blue)


def _pair(name: str, entry: Any, of: str) -> tuple[Any, Any]:
    try:
        first, second = entry
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected {of} each, got {str(entry)[:60]}") from error
    return first, second


def _project(labels: Sequence[tuple[str, NDArray[np.float64]]], view: View) -> list[tuple[str, float, float]]:
    """Labels with their places in the picture [px], of those before the camera."""
    camera, T, found = view.intrinsic, view.T_world_camera, []
    for text, place in labels:
        x, y, z = ((place - T[:3, 3]) @ T[:3, :3]).tolist()
        if z > 0:
            found.append((text, camera.fx * x / z + camera.cx, camera.fy * y / z + camera.cy))
    return found


def _united(bands: Sequence[Insets]) -> Insets:
    """The widest of several bands at each edge."""
    left, top, right, bottom = np.max([(0, 0, 0, 0), *bands], axis=0).tolist()
    return left, top, right, bottom
