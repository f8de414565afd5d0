"""What a page changes for all pages, remembered so that it can be taken back: `remembered`."""

from __future__ import annotations

import contextlib
import dataclasses
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from .coloring_choice import ColoringChoice
from .history import Change

if TYPE_CHECKING:
    from .sessions import Session
    from .viewer import Viewer


@dataclasses.dataclass(frozen=True)
class Look:
    """How a viewer shows its scene.

    Attributes:
        visible: Of each geometry, whether it is shown.
        values: The other things: coloring, point size, background, edges, normals.
    """

    visible: dict[str, bool]
    values: dict[str, Any]


def look_of(viewer: Viewer) -> Look:
    """As it is now; the viewer's lock is held."""
    values = {
        "coloring": viewer.coloring,
        "point size": viewer.point_size,
        "background": tuple(viewer.background.tolist()),
        "edges": viewer.wireframe,
        "normals": viewer.normals,
    }
    return Look({name: item.visible for name, item in viewer.shown.items()}, values)


@contextlib.contextmanager
def remembered(viewer: Viewer, session: Session | None) -> Iterator[None]:
    """What is changed within can be taken back in the page that asked for it.

    Only what it changed goes back: what another page has changed meanwhile stays.
    """
    history = None if session is None or viewer.closed else session.history
    if history is None or history.is_watched:  # one action of another
        yield
        return
    with viewer.lock:
        before = look_of(viewer)
    history.is_watched = True
    try:
        yield
    finally:
        history.is_watched = False
        with viewer.lock:
            after = look_of(viewer)
        change = change_between(viewer, before, after)
        if change is not None:
            history.add(change)


def change_between(viewer: Viewer, before: Look, after: Look) -> Change | None:
    """The way from one look to another and back; None where they are the same, geometries that came or went aside."""
    names = [name for name, seen in before.visible.items() if after.visible.get(name, seen) != seen]
    keys = [key for key, value in before.values.items() if after.values[key] != value]
    if not names and not keys:
        return None

    def goes_to(look: Look) -> Any:
        return lambda: put_look(viewer, {n: look.visible[n] for n in names}, {k: look.values[k] for k in keys})

    is_slider = keys in (["point size"], ["background"], ["coloring"])
    by = after.values["coloring"].by if keys == ["coloring"] else ""
    key = f"{keys[0]} {by}" if is_slider and not names else None
    return Change(_in_words(after, names, keys), goes_to(before), goes_to(after), key)


def put_look(viewer: Viewer, visible: dict[str, bool], values: dict[str, Any]) -> None:
    """Show some things as they were.

    Raises:
        ValueError: None of the geometries is there any more.
    """
    there = {name: seen for name, seen in visible.items() if name in viewer.shown}
    if visible and not there and not values:
        raise ValueError(f"{next(iter(visible))} is no longer in the scene")
    with viewer.lock:
        for name, seen in there.items():
            viewer.set_visible(name, seen)
        for key, value in values.items():
            if key == "coloring":
                choice: ColoringChoice = value
                viewer.color_by(choice.by, colormap=choice.colormap, limits=choice.limits)
            elif key == "point size":
                viewer.point_size = value
            elif key == "background":
                viewer.background = value
            elif key == "edges":
                viewer.show_wireframe(value)
            else:
                viewer.show_normals(value)


def _in_words(after: Look, names: list[str], keys: list[str]) -> str:
    if len(names) == 1:
        return f"{'Show' if after.visible[names[0]] else 'Hide'} {names[0]}"
    if names:
        return f"Show or hide {len(names):,} things"
    value = after.values[keys[0]]
    match keys[0]:
        case "coloring":
            return f"Colour by {value.by or 'own colours'}"
        case "point size":
            return f"Points of {value:.3g} px"
        case "background":
            return "Another background"
    return f"{'Show' if value else 'Hide'} {keys[0]}"
