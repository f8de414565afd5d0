"""How a viewer draws what is in it, and pictures of that: `Looks`."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_name
from .scene import Scene, check_color, check_size


class Looks(Scene):
    """Sizes, colours and edges of a scene, the same for all pages; changes in one message; stills."""

    @contextlib.contextmanager
    def batch(self) -> Iterator[None]:
        """Have pages take many changes as one, which they show in one picture.

        Within another it is part of that one. While one is open, what other threads change waits for its end as well,
        but no longer than a second. What raises within it ends it, and what was changed until then is shown.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     with viewer.batch():
            ...         for k in range(100):
            ...             viewer.add(f"boxes/{k}", loom.AxisAlignedBoundingBox([k, 0, 0], [k + 0.5, 1, 1]))
            ...     len(viewer.items)
            100
        """
        with self.server.pages.atomic():
            yield

    def tell_progress(self, text: str, share: float | None = None) -> None:
        """Say in the pages what the program is doing.

        Args:
            text: In a few words; "" once it is done.
            share: How much of it is done, 0 to 1; None where nobody knows.

        Raises:
            TypeError, ValueError: No text, or no share.
        """
        with self.lock:
            self._check_open()
            self.server.pages.set_progress(check_name("text", text), share)

    def screenshot(self, path: str | os.PathLike[str] | None = None, *, client: int | None = None) -> NDArray[np.uint8]:
        """A picture of the scene as a page shows it, drawn here: no page needs to be open.

        Args:
            path: A .png file to write; None writes none.
            client: The page whose view it is, as of `get_view`.

        Returns:
            Shape [h, w, 3], uint8.

        Raises:
            FileError: The place cannot be written.
        """
        from .stills import draw_scene

        with self.lock:
            viewer: Any = self  # a Viewer
            return draw_scene(viewer, viewer.get_view(client), path, self._clip_of(client))

    def save_html(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the scene as one page that needs neither server nor network, with at most `max_points` points.

        Raises:
            FileError: The place cannot be written.
        """
        from .stills import write_scene

        with self.lock:
            write_scene(self, path, overwrite=overwrite)  # type: ignore[arg-type]  # a Viewer

    @property
    def point_size(self) -> float:
        """Diameter of points without one of their own [px]; others grow and shrink alike. Assign another."""
        return self._point_size

    @point_size.setter
    def point_size(self, size: float) -> None:
        with self.lock:
            self._point_size, self.has_own_point_size = check_size(size), True
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.resize_points()
            self.panel.show_state()

    @property
    def background(self) -> NDArray[np.float64]:
        """Red, green and blue, 0 to 1; assign another."""
        return self._background.copy()

    @background.setter
    def background(self, color: Any) -> None:
        with self.lock:
            self._background, self._has_own_background = check_color(color), True
            self._paint_background()
            self.panel.show_state()

    def color_by(self, by: str | None, *, colormap: str | None = None, limits: Any = None) -> None:
        """Colour the clouds by what is known of their points.

        Args:
            by: "rgb", "height", "normal", "label" or an attribute; None for their own colours. Clouds that have no such
                thing keep theirs.
            colormap, limits: Of values, as of `loom.render`.

        Raises:
            ValueError: No cloud has such a thing, or values out of range.
        """
        with self.lock, self.batch():
            for name, value in {"by": by, "colormap": colormap}.items():
                check_name(name, "" if value is None else value)
            self.coloring = self.coloring.checked(by, colormap, limits, self.shown.values())
            for item in self.shown.values():
                self._color(item)
                for session in self._open_sessions():
                    with session.as_it_lasts():
                        session.set_colors(item)
            self.panel.show_legend()

    def show_wireframe(self, shown: bool) -> None:
        """Show the edges of all surfaces."""
        with self.lock:
            self.wireframe = bool(shown)
            with self.batch():
                for nodes in self._nodes.values():
                    nodes.set_wireframe(self.wireframe)
            self.panel.show_state()

    def show_normals(self, shown: bool) -> None:
        """Show the normals of all clouds that have them, as lines; of more than 10,000 points, of some."""
        with self.lock:
            self.normals = bool(shown)
            with self.batch():
                for nodes in self._nodes.values():
                    nodes.set_normals(self._normal_length())
            self.panel.show_state()
