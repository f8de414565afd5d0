"""Labels, legend, color bar and scale bar on an image, and the space they need."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_color, check_list, check_name, check_shape
from ...core.units import LengthUnit, symbol_of
from ...kernels.arrays.select import gather_rows
from ...kernels.arrays.subsets import step_rows
from ...kernels.memory import download
from .canvas import DARK_COLOR, LIGHT_COLOR, Canvas, Color
from .coloring import Coloring
from .legends import color_bar_size, draw_color_bar, draw_labels, draw_legend, legend_size, letter_size
from .parts import Lines, Part, Triple
from .view import Insets, View

MAX_COLOR_SAMPLES = 10_000  # approximate number of colors for the mean in a legend


@dataclasses.dataclass(frozen=True, eq=False)
class Overlays:
    """Labels at positions [m], legend `entries` (names and colors), color bar and scale bar, in a length unit."""

    labels: Sequence[tuple[str, NDArray[np.float64]]] = ()
    entries: Sequence[tuple[str, Triple]] = ()
    coloring: Coloring | None = None
    scale_bar: bool = False
    unit: LengthUnit | None = None
    is_dark: bool = False

    def __bool__(self) -> bool:
        return bool(self.labels or self.entries or self.scale_bar or self.coloring is not None)

    def inset_choices(self, width: int, height: int) -> list[Insets]:
        """Alternative insets [px] for legend and color bar: beside or above the scene."""
        kinds: list[list[Insets]] = []
        if self.entries:
            wide, high = legend_size(self.entries, width, height)
            kinds.append([(wide, 0, 0, 0), (0, high, 0, 0)])
        if self.coloring is not None:
            wide, high, is_tall = color_bar_size(self.coloring, width, height)
            kinds.append([(0, 0, wide, 0)] if is_tall else [(0, 0, wide, 0), (0, high, 0, 0)])
        return [_united(bands) for bands in itertools.product(*kinds)]

    def write(self, canvas: Canvas, view: View, middle: NDArray[np.float64]) -> None:
        """Draw them. The scale bar is for the depth of `middle`, the scene's center [m]."""
        ink: dict[str, Any] = (
            {"color": LIGHT_COLOR, "halo": DARK_COLOR} if self.is_dark else {"color": DARK_COLOR, "halo": LIGHT_COLOR}
        )
        draw_labels(canvas, _project(self.labels, view), **ink)
        draw_legend(canvas, self.entries)
        if self.coloring is not None:
            draw_color_bar(canvas, self.coloring)
        if self.scale_bar:
            draw_scale_bar(canvas, view, middle, self.unit, **ink)


def check_labels(labels: object) -> list[tuple[str, NDArray[np.float64]]]:
    checked = []
    for entry in check_list("labels", [] if labels is None else labels, "texts with positions"):
        text, position = _pair("labels", entry, "a text and a position")
        checked.append((check_name("labels", text), check_shape("labels", position, (3,))))
    return checked


def check_legend(legend: object) -> Any:
    """Names with colors, or whether there is a legend."""
    if legend is None or legend is False or legend is True:
        return legend
    checked = []
    for entry in check_list("legend", legend, "names with colors"):
        name, color = _pair("legend", entry, "a name and a color")
        red, green, blue = check_color("legend", color).tolist()
        checked.append((check_name("legend", name), (red, green, blue)))
    return checked


def check_bar(color_bar: object, parts: Sequence[Part]) -> Coloring | None:
    if color_bar is None or color_bar is False or isinstance(color_bar, Coloring):
        return color_bar or None
    if color_bar is not True:
        raise TypeError(f"color_bar: expected True or a Coloring, got {type(color_bar).__name__}")
    colorings = [part.coloring for part in parts if not isinstance(part, Lines) and part.coloring is not None]
    if not colorings:
        raise ValueError('color_bar: no cloud or mesh has "color_by"; pass {"geometry": cloud, "color_by": "height"}')
    return colorings[0]


def color_of(parts: Sequence[Part]) -> Triple:
    """Legend color of a geometry: its own, or the mean of its points or vertices."""
    part = parts[0]
    if not part.colors.size:
        return part.plain
    count, device = part.colors.size, part.colors.device
    some = gather_rows(part.colors, step_rows(count, max(1, count // MAX_COLOR_SAMPLES), device))
    red, green, blue = np.clip(np.nanmean(download(some), axis=0), 0, 1)  # sync
    return float(red), float(green), float(blue)


def _pair(name: str, entry: Any, of: str) -> tuple[Any, Any]:
    try:
        first, second = entry
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected {of} each, got {str(entry)[:60]}") from error
    return first, second


def _project(labels: Sequence[tuple[str, NDArray[np.float64]]], view: View) -> list[tuple[str, float, float]]:
    """Labels in front of the camera, with image positions [px]."""
    camera, T, projected = view.intrinsic, view.T_world_camera, []
    for text, position in labels:
        x, y, z = ((position - T[:3, 3]) @ T[:3, :3]).tolist()
        if z > 0:
            projected.append((text, camera.fx * x / z + camera.cx, camera.fy * y / z + camera.cy))
    return projected


def _united(bands: Sequence[Insets]) -> Insets:
    left, top, right, bottom = np.max([(0, 0, 0, 0), *bands], axis=0).tolist()
    return left, top, right, bottom


MAX_FRACTION = 0.25  # maximum of the image width
_BAR_END_HEIGHT = 0.35  # half height of the bar's ends over the font size


def round_length(max_length: float) -> float:
    """The largest of 1, 2 and 5 times a power of 10 up to a length.

    Example:
        >>> round_length(3.7), round_length(0.19)
        (2.0, 0.1)
    """
    power = math.floor(math.log10(max_length))
    for factor, exponent in ((10, power), (5, power), (2, power), (1, power), (5, power - 1)):
        length = factor * 10.0**exponent if exponent >= 0 else factor / 10.0**-exponent
        if length <= max_length * (1 + 1e-12):
            return float(length)
    return max_length


def draw_scale_bar(
    canvas: Canvas,
    view: View,
    middle: NDArray[np.float64],
    unit: LengthUnit | None,
    *,
    color: Color = DARK_COLOR,
    halo: Color = LIGHT_COLOR,
) -> None:
    """Draw a horizontal bar of a round length, correct at the depth of the scene's center `middle` [m].

    Nothing is drawn if the center is not in front of the camera. Without a unit, meters are assumed.
    """
    depth = float((middle - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, 2])
    if not 0 < depth < math.inf:
        return
    per_unit = view.intrinsic.fx / depth  # [px]
    length = round_length(MAX_FRACTION * canvas.width / per_unit)
    size = letter_size(canvas)
    pad, wide, end = round(1.2 * size), length * per_unit, max(3, round(_BAR_END_HEIGHT * size))
    left, row = pad, canvas.height - pad - end
    thick = max(2, size // 7)
    strokes = np.array([[0, 0, wide, 0], [0, -end, 0, end], [wide, -end, wide, end]], float)
    ends = strokes + np.array([left, row, left, row])
    canvas.segments(ends, color=halo, width=thick + 3, opacity=0.85)
    canvas.segments(ends, color=color, width=thick)
    text = f"{_plain(length)} {symbol_of(unit)}"
    middle_of_text = max(left + wide / 2, left + canvas.text_width(text, size) / 2)
    text_row = row - end - round(0.35 * size)
    canvas.text(text, middle_of_text, text_row, size=size, color=color, anchor="lower center", halo=halo)


def _plain(length: float) -> str:
    return f"{length:,.0f}" if 1 <= length < 1e7 else f"{length:g}"
