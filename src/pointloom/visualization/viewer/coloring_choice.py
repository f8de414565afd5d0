"""Coloring of the clouds of a viewer: `ColoringChoice`."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection
from typing import Any

from ...pcd.cloud import PointCloud
from ..render.coloring import Coloring, color_cloud
from ..render.colormaps import COLORMAPS as COLORMAPS
from ..render.colormaps import check_colormap
from .items import Item


@dataclasses.dataclass(frozen=True)
class ColoringChoice:
    """One coloring for all clouds: property (None: original colors), colormap, and limits (None: per cloud)."""

    by: str | None = None
    colormap: str | None = None
    limits: tuple[float, float] | None = None

    def of(self, item: Item) -> Coloring | None:
        """Coloring of a cloud. None for its original colors, also if it lacks the property."""
        if item.cloud is None:
            return None
        if self.by is not None and self.by in choices_of(item.cloud):
            return _color(item, self.by, self.colormap, self.limits)
        style = item.style
        if style.color_by is not None:
            return _color(item, style.color_by, style.colormap, style.limits)
        return None

    def checked(self, by: str | None, colormap: str | None, limits: Any, items: Collection[Item]) -> ColoringChoice:
        """Another choice, validated. Raises ValueError if no cloud has the property or values are out of range."""
        if colormap is not None:
            check_colormap(colormap)
        if by is not None:
            clouds = [item.cloud for item in items if item.cloud is not None]
            known = list(dict.fromkeys(name for cloud in clouds for name in choices_of(cloud)))
            if by not in known:
                raise ValueError(f"by: no cloud has {by!r}; available: {', '.join(known) or 'no clouds'}")
        choice = ColoringChoice(by, colormap, limits)
        for item in items:  # limits are checked on use
            choice.of(item)
        return choice


def _color(item: Item, by: Any, colormap: str | None, limits: Any) -> Coloring:
    """Coloring of an item's cloud. For a cloud read in parts, with a function for the other points."""
    assert item.cloud is not None
    coloring = color_cloud(item.cloud, by, colormap=colormap, limits=limits)
    if not item.is_in_parts or not isinstance(by, str):
        return coloring
    same: dict[str, Any] = {"colormap": coloring.colormap, "limits": coloring.limits}
    return dataclasses.replace(coloring, paint=lambda cloud: color_cloud(cloud, by, **same).colors)


class Choices:
    """Available properties of a scene in order of appearance, updated per cloud."""

    def __init__(self) -> None:
        self._of: dict[str, tuple[str, ...]] = {}  # by item
        self._counts: dict[str, int] = {}

    def put(self, item: Item) -> None:
        names = () if item.cloud is None else tuple(choices_of(item.cloud))
        if names != self._of.get(item.name, ()):
            for name in names:
                self._counts[name] = self._counts.get(name, 0) + 1
            self.drop(item.name)
            self._of[item.name] = names

    def drop(self, name: str) -> None:
        for choice in self._of.pop(name, ()):
            self._counts[choice] -= 1
            if not self._counts[choice]:
                del self._counts[choice]

    def names(self) -> tuple[str, ...]:
        return tuple(self._counts)


def choices_of(cloud: PointCloud) -> list[str]:
    given = ["rgb"] * bool(cloud.has_colors) + ["normal"] * bool(cloud.has_normals)
    columns = [name for name in cloud.attributes if len(cloud.arrays[name].shape) == 1]
    return [*given, "height", "x", "y", *columns]


def shown_coloring(items: Collection[Item]) -> Coloring | None:
    """Coloring for the legend: of the first visible cloud with values or labels."""
    for item in items:
        if item.visible and has_meaning(item):
            return item.coloring
    return None


def has_meaning(item: Item) -> bool:
    """True if the colors of an item represent values or labels."""
    return item.coloring is not None and item.coloring.kind != "rgb"
