"""Labels that are painted onto a cloud of a viewer: `begin_painting`, `show_painting`, `painted_labels`."""

from __future__ import annotations

import logging
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .tools.filters import column_of
from .tools.labels import Painting

if TYPE_CHECKING:
    from .items import Item
    from .viewer import Viewer


log = logging.getLogger("pointloom.viewer")


def begin_painting(viewer: Viewer, name: str, attribute: str) -> Painting:
    """The labels of a cloud, to be painted: those that are painted already, else those that it has, else zeros.

    Raises:
        ValueError: There is no cloud of that name, an attribute without a name, labels that no byte holds, or labels
            under another name that are not saved yet.
    """
    with viewer.lock:
        item = viewer.shown.get(name)
        if item is None or item.cloud is None:
            raise ValueError(f"{name} is no cloud any more")
        known = item.painting
        if known is not None and known.attribute == attribute:
            return known
        if known is not None and known.unsaved:
            raise ValueError(f"{known.unsaved} changes of {known.attribute} are not saved yet: save them, or undo them")
        item.painting = Painting(attribute, len(item.cloud), column_of(item.cloud, attribute))
        _put(item)
        viewer.panel.put_item(item)
        return item.painting


def show_painting(viewer: Viewer, name: str) -> None:
    """Have the cloud hold the labels as they are now, and all pages show them."""
    with viewer.lock:
        item = viewer.shown.get(name)
        if item is None or item.painting is None:
            return
        _put(item)
        item.recolor(viewer.coloring.of(item))
        for session in viewer.sessions.values():
            with session.as_it_lasts():
                if name in session.streams and not session.closed:
                    session.streams[name].set_colors(item.colors_of)
                session.refresh_tools()
        viewer.panel.show_legend()


def painted_labels(item: Item) -> NDArray[np.uint8] | None:
    """A copy of the labels that were painted, which count as saved then; None where nothing was."""
    if item.painting is None:
        return None
    item.painting.unsaved = 0
    return item.painting.labels.copy()


def unsaved_labels(items: Iterable[Item]) -> str:
    """What was painted and neither saved nor asked for by the program, in words; "" where nothing was."""
    found = [(item.name, item.painting.unsaved) for item in items if item.painting is not None]
    return ", ".join(f"{count} change{'s' * (count != 1)} of {name}" for name, count in found if count)


def warn_of_unsaved(items: Iterable[Item]) -> None:
    """Say what goes as the viewer is closed."""
    told = unsaved_labels(tuple(items))
    if told:
        log.warning("painted labels go that nobody saved: %s", told)


def _put(item: Item) -> None:
    """The item's cloud is another one with the labels; the program's own stays as it is."""
    assert item.cloud is not None and item.painting is not None
    item.relabel(item.painting.on(item.cloud))
