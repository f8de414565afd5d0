"""A layer of a distance field as a picture: `draw_slice`."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_name, check_positive
from ...core.told_arguments import told_arguments
from ...meshing.volume.distance_field_views import FieldSlice
from .axes import Area, Axes, draw_head
from .canvas import Canvas, Color
from .colormaps import MISSING, check_colormap, colormap_table
from .legends import END_ROOM, letter_size, paint_bar
from .picture import Picture
from .picture_files import save_picture
from .plots import check_size
from .ticks import Ticks, choose_ticks, count_ticks, with_ends

OCCUPIED: Color = (0.1, 0.1, 0.1)
LEAST = 320, 240  # [px]
HEADING = "distance [m]"


@told_arguments
def draw_slice(
    layer: FieldSlice,
    path: str | os.PathLike[str] | None = None,
    *,
    title: str | None = None,
    colormap: str | None = None,
    limit: float | None = None,
    size: tuple[int, int] = (960, 720),
    overwrite: bool = True,
) -> Picture:
    """Draw a layer of a distance field, with axes in metres and a colour bar.

    Args:
        layer: Of `DistanceField.slice`.
        path: Where to write the picture, .png or .webp; None writes none.
        title: Above it; None says which layer it is.
        colormap: As of `render`; None takes viridis, and coolwarm where distances are negative inside.
        limit: The distance of the last colour [m]; None takes the largest that is known.
        size: Columns and rows [px].
        overwrite: Whether an existing file may be replaced.

    Returns:
        A Picture, uint8 RGB: black where voxels are occupied (of signed fields the colours of their depth), grey
        where the distance is not known.

    Raises:
        TypeError: No FieldSlice.
        ValueError: A layer without voxels, or a size, a limit or a colour map that makes no picture.
        FileError: The picture cannot be written.

    Example:
        >>> import pointloom as loom
        >>> field = loom.DistanceField.from_voxels([[0, 0, 0], [9, 3, 0]], 0.1, max_distance=1)
        >>> picture = loom.draw_slice(field.slice("z", 0.05), "slice.png", size=(480, 360))
        >>> picture.shape
        (360, 480, 3)
    """
    if not isinstance(layer, FieldSlice):
        raise TypeError(f"layer: expected a FieldSlice, got {type(layer).__name__}")
    if not layer.distances.size:
        raise ValueError("layer: has no voxels, as its field has none; give `slice` the bounds of what is to be seen")
    values, known = layer.distances, layer.is_known
    is_signed = bool((values[known] < 0).any())
    most = _limit_of(values[known]) if limit is None else check_positive("limit", limit, maximum=1e100)
    name = check_colormap(colormap or ("coolwarm" if is_signed else "viridis"))
    low = -most if is_signed else 0.0
    canvas = Canvas.blank(*check_size(size, LEAST))
    letters = letter_size(canvas)
    entries = [("occupied", OCCUPIED)] * (not is_signed and bool((values[known] == 0).any()))
    beyond = "not known" if layer.max_distance is None else f"at least {layer.max_distance:g} m"
    entries += [(beyond, MISSING)] * bool((~known).any())
    heading = f"{layer.axis} = {layer.position:g} m" if title is None else check_name("title", title)
    area = draw_head(canvas, Area(0, 0, canvas.width, canvas.height), heading, "", entries, letters)
    ticks = choose_ticks(low, most, count_ticks(area.height, letters))
    ticks = with_ends(ticks, min(END_ROOM * letters / max(area.height - 6 * letters, letters), 0.5))
    bar = round(3.5 * letters) + max(canvas.text_width(text, letters) for text in ticks.texts)
    bar = max(bar, canvas.text_width(HEADING, letters) + letters)
    plan = Area(area.left, area.top, area.width - bar, area.height)
    (x0, y0), (x1, y1) = layer.extent.tolist()
    titles = f"{layer.axes[0]} [m]", f"{layer.axes[1]} [m]"
    axes = Axes(canvas, plan, (x0, x1), (y0, y1), titles=titles, size=letters, equal=True)
    _paint(canvas, axes, layer, _colors(values, known, (low, most), name, is_signed))
    _draw_bar(canvas, axes, name, ticks, letters)
    picture = Picture(canvas.to_numpy())
    if path is not None:
        save_picture(path, picture, overwrite=overwrite)
    return picture


def _limit_of(known: NDArray[np.float32]) -> float:
    """The largest distance either way; 1 where there is none."""
    finite = np.abs(known[np.isfinite(known)])
    return float(finite.max(initial=0.0)) or 1.0


def _colors(
    values: NDArray[np.float32], known: NDArray[np.bool_], limits: tuple[float, float], colormap: str, is_signed: bool
) -> NDArray[np.uint8]:
    """The colour of each voxel, uint8 [h, w, 3]."""
    table = np.floor(colormap_table(colormap) * 255 + 0.5).astype(np.uint8)
    low, high = limits
    shares = (np.where(known & np.isfinite(values), values, low).astype(np.float64) - low) / (high - low)
    colors = table[np.floor(np.clip(shares, 0, 1) * (len(table) - 1) + 0.5).astype(np.int64)]
    if not is_signed:
        colors[known & (values == 0)] = _bytes(OCCUPIED)
    colors[~known] = _bytes(MISSING)
    return colors


def _bytes(color: Color) -> NDArray[np.uint8]:
    return np.floor(np.array(color) * 255 + 0.5).astype(np.uint8)


def _paint(canvas: Canvas, axes: Axes, layer: FieldSlice, colors: NDArray[np.uint8]) -> None:
    """Fill the frame: each pixel takes the voxel that its middle lies in."""
    (x0, y0), (x1, y1) = layer.extent.tolist()
    left, right = (round(float(c)) for c in axes.columns([x0, x1]))
    bottom, top = (round(float(r)) for r in axes.rows([y0, y1]))
    rows, columns = layer.distances.shape
    across, down = max(right - left, 1), max(bottom - top, 1)
    which_column = np.minimum((np.arange(across) + 0.5) / across * columns, columns - 1).astype(np.int64)
    which_row = np.minimum((np.arange(down)[::-1] + 0.5) / down * rows, rows - 1).astype(np.int64)
    canvas.image(np.ascontiguousarray(colors[which_row][:, which_column]), left, top)
    canvas.rectangle(left, top, across, down, outline=(0.45, 0.45, 0.45))


def _draw_bar(canvas: Canvas, axes: Axes, colormap: str, ticks: Ticks, letters: int) -> None:
    left = axes.right + letters
    canvas.text(ticks.title(HEADING), left, axes.top, size=letters, anchor="upper left")
    height = axes.bottom - axes.top + 1 - 2 * letters
    paint_bar(canvas, left, axes.top + 2 * letters, round(1.2 * letters), max(height, 2), colormap, ticks, letters)
