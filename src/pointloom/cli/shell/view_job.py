"""Implementation of `pointloom view`: `ViewJob`."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...core.atomic import check_writable
from ...core.errors import FileError
from ...core.paths import is_recording
from ...core.progress import ReportProgress, ignore_progress
from ...core.reports import Assessed, Fields, Report
from ...core.timing import Clock
from ...core.up_axis import check_up
from ...core.wording import plain
from ...io.points.by_extension import columns_of
from ...pcd.cloud import PointCloud
from ...visualization.render.geometries import Named
from ...visualization.render.open3d_views import read_view
from ...visualization.render.picture_files import check_picture, write_image
from ...visualization.viewer.coloring_choice import choices_of
from ...visualization.viewer.items import make_item
from ...visualization.viewer.screenshots import as_entry, with_colors, write_geometries
from ...visualization.viewer.view_files import first_looks, read_scene
from .answer import answer_with
from .console import Progress, print_json
from .pipes import INPUT, Ends

IMAGE_SIZE = (1280, 960)  # [px]
FIRST_LOOK = 250_000  # points of a large file shown while it is being read


def check_outputs(screenshot: Path | None, page: Path | None, *, force: bool) -> None:
    if screenshot is not None:
        check_picture(screenshot, overwrite=force)
    if page is not None:
        if page.suffix.lower() not in (".html", ".htm"):
            raise FileError(page, "pages are written as .html", remedy="Pass a name that ends in .html")
        check_writable(page, overwrite=force)


@dataclasses.dataclass(frozen=True, kw_only=True)
class ViewOptions:
    """Options of `pointloom view`. Clouds of a recording's `topic` are transformed into `frame`."""

    color_by: str | None
    colormap: str | None
    view_file: Path | None
    point_size: float | None
    up: str | None
    max_points: int
    force: bool
    port: int
    host: str
    no_open: bool
    keep_alive: float
    topic: str | None = None
    frame: str | None = None
    columns: Sequence[str] | None = None


class ViewJob:
    """Files to show or render. `ends` are the files, with names for pipes. Raises FileError or ValueError."""

    def __init__(self, ends: Ends, options: ViewOptions):
        self.files, self._ends, self.given = ends.sources, ends, options
        self.title = ", ".join(INPUT if str(path) in ends.names else path.name for path in self.files)
        self.up = None if options.up is None else check_up(options.up)
        topic, frame, view_file = options.topic, options.frame, options.view_file
        self._columns = columns_of(self.files, options.columns)
        self.clock = Clock()
        self.view = None if view_file is None else read_view(view_file, width=IMAGE_SIZE[0], height=IMAGE_SIZE[1])
        for path in self.files:
            if not path.exists():
                raise FileError(path, "does not exist")
        if (topic or frame) and not any(is_recording(path) for path in self.files):
            given = "--topic" if topic else "--frame"
            raise FileError(self.files[0], f"is not a recording, which {given} requires", remedy=f"Leave {given} out")
        self.named: list[Named] = []
        self.trees: dict[str, Any] = {}  # DetailTree, CopcTree

    def read(self, notify: ReportProgress = ignore_progress, *, in_parts: bool = False) -> None:
        """Read the files with progress. With `in_parts`, only the coarse levels of large COPC files."""
        given = self.given
        style = {"point_size": given.point_size} if given.point_size is not None else {}
        with Progress() as progress:

            def report(stage: str, done: int, total: int) -> None:
                progress(stage, done, total)
                notify(stage, done, total)

            options: dict[str, Any] = {"max_points": given.max_points, "color_by": given.color_by, "progress": report}
            options |= {"in_parts": in_parts, "columns": self._columns, "topic": given.topic, "frame": given.frame}
            named, trees = read_scene(list(self.files), style, **options)
        names = {
            name: INPUT for path, (name, _, _) in zip(self.files, named, strict=True) if str(path) in self._ends.names
        }
        self.named = [(names.get(name, name), geometry, style) for name, geometry, style in named]
        self.trees = {names.get(name, name): tree for name, tree in trees.items()}
        self._check_color()
        self.clock.stop("read")

    def write(self, screenshot: Path | None, page: Path | None, as_json: bool) -> int:
        self.read()
        named, written = self._colored(), []
        if screenshot is not None:
            self._draw(named, screenshot)
            written.append(screenshot)
            self.clock.stop("draw")
        if page is not None:
            how: dict[str, Any] = {"view": self.view, "title": self.title, "overwrite": self.given.force, "up": self.up}
            write_geometries(page, named, self.given.max_points, **how)
            written.append(page)
            self.clock.stop("write page")
        report = dataclasses.replace(self._report(), files=tuple(map(str, written)), seconds=self.clock.seconds)
        title = ", ".join(self._ends.rename([str(path) for path in self.files]))
        return answer_with(self._ends.rename(report), title, as_json)

    def serve(self, as_json: bool) -> int:
        """Show the files in the browser until the last page closes. Ctrl-C is raised."""
        from ...visualization.viewer.draw import announce, open_page
        from ...visualization.viewer.viewer import Viewer

        sizes: dict[str, Any] = {} if self.given.point_size is None else {"point_size": self.given.point_size}
        port, host = self.given.port, self.given.host

        def open_up() -> None:
            announce(viewer)
            if not self.given.no_open:
                open_page(viewer)

        with Viewer(port=port, host=host, title=self.title, max_points=self.given.max_points, **sizes) as viewer:
            viewer.up = self.up
            if self.view is not None:
                viewer.set_view(self.view)
            first: list[Named] = []
            if not self._ends.names and not any(self._columns):  # waits for a pipe
                first = first_looks(
                    self.files, min(self.given.max_points, FIRST_LOOK), larger_than=self.given.max_points
                )
            if first:
                viewer.add_named(first)
                open_up()

            def show_progress(stage: str, done: int, total: int) -> None:
                fraction = min(done / total, 1.0) if total > 0 else None
                viewer.tell_progress(f"preview of {self.title}; {stage}", fraction)

            self.read(show_progress, in_parts=True)  # after checking that a server can run
            viewer.tell_progress("")
            viewer.add_named(self.named, self.trees)
            for name, _, _ in first:
                viewer.remove(name)
            if self.given.color_by is not None:
                viewer.color_by(self.given.color_by, colormap=self.given.colormap)
            if not first:
                open_up()
            if as_json:
                print_json(self._ends.rename(self._report()).to_dict() | {"url": viewer.url, "ssh": viewer.ssh_line})
            viewer.wait(keep_alive=self.given.keep_alive)
        return 0

    def _draw(self, named: list[Named], path: Path) -> None:
        from ...visualization.render.render import render

        entries = [as_entry(one) for one in named]
        picture = render(
            entries, camera=self.view, size=IMAGE_SIZE, color_bar=self.given.color_by is not None, up=self.up
        )
        write_image(path, picture, overwrite=self.given.force)

    def _colored(self) -> list[Named]:
        colored: list[Named] = []
        for name, geometry, style in self.named:
            if name in self.trees:
                geometry = with_colors(make_item(name, 0, geometry, style, self.trees[name]))
            if isinstance(geometry, PointCloud) and self.given.color_by in choices_of(geometry):
                style = dataclasses.replace(
                    style, color_by=self.given.color_by, colormap=self.given.colormap, color=None
                )
            colored.append((name, geometry, style))
        return colored

    def _check_color(self) -> None:
        if self.given.color_by is None:
            return
        known: list[str] = []
        for name, geometry, _ in self.named:
            if isinstance(geometry, PointCloud):
                known += [choice for choice in choices_of(geometry) if choice not in known]
                if name in self.trees and self.trees[name].colors_of(np.zeros(0, np.int64)) is not None:
                    known.append("rgb")
        if self.given.color_by not in known:
            there = f"there are {', '.join(known)}" if known else "there are no clouds"
            raise ValueError(f"--color-by: no cloud here has {self.given.color_by!r}; {there}")

    def _report(self) -> ViewReport:
        shown = []
        for name, geometry, _ in self.named:
            count = len(geometry) if isinstance(geometry, PointCloud) else None
            if count is not None and name in self.trees:
                count = self.trees[name].count
            shown.append(Shown(name, type(geometry).__name__, count))
        return ViewReport(tuple(str(path) for path in self.files), tuple(shown))


@dataclasses.dataclass(frozen=True)
class Shown:
    """A displayed geometry: name, type, and number of points of a cloud."""

    name: str
    kind: str
    points: int | None

    def to_dict(self) -> dict[str, Any]:
        count = {} if self.points is None else {"points": self.points}
        return {"name": self.name, "kind": self.kind, **count}


@dataclasses.dataclass(frozen=True)
class ViewReport(Report, Assessed):
    """Report of `pointloom view`; `files` and `seconds` are None if the page was served."""

    inputs: tuple[str, ...]
    geometries: tuple[Shown, ...]
    files: tuple[str, ...] | None = None
    seconds: dict[str, float] | None = None

    @property
    def warnings(self) -> tuple[str, ...]:
        return ()

    def to_dict(self) -> dict[str, Any]:
        shown = {"command": "view", "inputs": self.inputs, "geometries": [one.to_dict() for one in self.geometries]}
        written = {} if self.files is None else {"files": self.files, "seconds": self.seconds}
        return plain(shown | written)

    def fields(self) -> Fields:
        shown = [
            f"{one.name}: {one.kind}" + ("" if one.points is None else f", {one.points:,} points")
            for one in self.geometries
        ]
        seconds = ", ".join(f"{stage} {value:.2f}" for stage, value in (self.seconds or {}).items())
        return [("shown", "\n".join(shown)), ("seconds", seconds), ("files", ", ".join(self.files or ()))]
