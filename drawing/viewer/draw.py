"""Geometries in a window of the browser: `draw`, as Open3D's `draw_geometries`."""

from __future__ import annotations

import dataclasses
import os
import sys
import threading
import weakref
import webbrowser
from typing import Any, NamedTuple

from ...core.checks import check_count, check_positive
from ...core.errors import PointloomError
from ...core.standard_streams import write_to_stderr
from ...core.told_arguments import told_arguments
from ..notebook_output import in_notebook, ipython_shell
from ..render.geometries import Named, named_geometries
from ..render.picture import Picture
from .inline import InlinePage, inline_page, wants_inline
from .presence import LINGER
from .server import ViewerError
from .viewer import MOST_POINTS, Viewer

MOST_OPEN = 16  # viewers of a kernel's cells: fewer than the ports that are tried


@told_arguments
def draw(
    geometries: Any,
    width: int = 1280,
    height: int = 960,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = False,
    lookat: Any = None,
    up: Any = None,
    front: Any = None,
    zoom: float | None = None,
    field_of_view: float | None = None,
    *,
    port: int = 8080,
    host: str = "127.0.0.1",
    max_points: int = MOST_POINTS,
    block: bool | None = None,
    open_browser: bool = True,
    inline: bool | None = None,
    linger: float = LINGER,
) -> Viewer | InlinePage | Picture:
    """Show geometries in the browser, on this machine or over SSH on another one, or in a notebook.

    From a script it says on stderr where the page is, opens a browser where there is a display, and returns when the
    last page has been closed for a minute (`linger`), or with Ctrl-C. In a notebook it returns at once and the cell
    shows the page: live where the browser can reach a server of this machine, else as a page of its own inside the
    notebook.

    Where the environment variable POINTLOOM_DRAW is "picture", so that a script runs unattended, nothing is opened and
    nothing waits: what would wait returns the picture that the page would begin with.

    Args:
        geometries: One, a list, a mapping of names to geometries, or dictionaries as Open3D's `draw` takes; all that
            `loom.render` draws.
        width, height: Of pictures, and the height of the frame in a notebook [px]; a page is as large as its window.
        point_show_normal: Begin with normals; N in the page.
        mesh_show_wireframe: Begin with edges; W in the page.
        mesh_show_back_face: Draw faces that look away.
        lookat, up, front, zoom, field_of_view: Where from, as in Open3D; none of them: what shows all.
        port, host: Of the server; see `Viewer`.
        max_points: Of all clouds together in a page.
        block: Whether to wait; None waits but in a notebook.
        open_browser: Open a browser where there is a display.
        inline: Put the scene itself into the notebook, in at most 4 MB (clouds sampled, meshes simplified; what is
            shown says so), and start no server: it can be turned and zoomed wherever the notebook is read. None does
            that in a notebook on Colab, Kaggle, JupyterHub, Binder, Databricks, in VS Code or reached over SSH, unless
            the environment variable POINTLOOM_INLINE says 1 (always) or 0 (never).
        linger: How long the pages may be gone before the wait ends [s]; stderr says when the last one goes.

    Returns:
        The viewer, closed where `draw` waited. Inline, and in a notebook where no server can run, an `InlinePage`.
        Unattended, the picture.

    Raises:
        TypeError: A geometry of no known kind; says what is accepted.
        ValueError: A parameter out of range.
        PointloomError: The extra is not installed (but in a notebook and inline), with the line that installs it.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        >>> viewer = loom.draw([cloud], port=0, block=False, open_browser=False)
        >>> viewer.close()
    """
    named = _with_back_faces(named_geometries(geometries), mesh_show_back_face)
    size = (check_count("width", width), check_count("height", height))
    linger = check_positive("linger", linger, allow_zero=True, allow_infinite=True)
    view = {"zoom": zoom, "front": front, "lookat": lookat, "up": up, "field_of_view": field_of_view}
    notebook = in_notebook()
    reason = wants_inline(inline, notebook=notebook and not block)
    if reason is not None:
        return inline_page(named, view, size, max_points, reason)
    if unattended() and (block or (block is None and not notebook)):
        return _picture(named, view, size, point_show_normal, mesh_show_wireframe)
    options: dict[str, Any] = {"host": host, "max_points": max_points, "size": size}
    try:
        viewer = _open_in_cell(port, **options) if notebook and not block else Viewer(port=port, **options)
    except PointloomError as error:
        if not notebook:
            raise
        return inline_page(named, view, size, max_points, str(error))
    try:
        if any(value is not None for value in view.values()):
            viewer.set_view({name: value for name, value in view.items() if value is not None})
        with viewer.lock:  # a page may load meanwhile, and comes in when all is there
            if not notebook or block:
                announce(viewer)
                if open_browser and not unattended():
                    open_page(viewer)
            viewer.add_named(named)
            viewer.show_normals(point_show_normal)
            viewer.show_wireframe(mesh_show_wireframe)
        if notebook and not block:
            return viewer
        if block is None or block:
            wait_for_pages(viewer, linger)
    except BaseException:
        viewer.close()
        raise
    return viewer


draw_geometries = draw  # for those who come from Open3D


def unattended() -> bool:
    """Whether the environment says that nobody is there to look: POINTLOOM_DRAW=picture.

    Raises:
        ValueError: The variable is neither "page" nor "picture".
    """
    mode = os.environ.get("POINTLOOM_DRAW") or "page"
    if mode not in ("page", "picture"):
        raise ValueError(f"POINTLOOM_DRAW: expected 'page' or 'picture', got {mode!r}")
    return mode == "picture"


def wait_for_pages(viewer: Viewer, linger: float = LINGER) -> None:
    """Wait as `Viewer.wait` does, then close; Ctrl-C ends the wait as closing a window would."""
    try:
        viewer.wait(linger=linger)
    except KeyboardInterrupt:
        pass
    finally:
        viewer.close()


def announce(viewer: Viewer) -> None:
    """Say on stderr where the page is, and over SSH how to reach it."""
    lines = []
    if viewer.server.moved_from is not None:
        lines.append(f"port {viewer.server.moved_from} is taken; the next free one is {viewer.server.port}")
    lines.append(f"viewer: {viewer.url} (Ctrl-C ends it)")
    if viewer.server.exposed:
        lines.append(f"listening on {viewer.server.host}: whoever has this address with its token sees the scene")
    if "SSH_CONNECTION" in os.environ:
        lines.append(f"from your own machine first: {viewer.ssh_line}")
    write_to_stderr("\n".join(lines))


def open_page(viewer: Viewer) -> bool:
    """Open the page in a browser where there is a display to show it; whether one was found."""
    windows = sys.platform in ("darwin", "win32") or any(os.environ.get(k) for k in ("DISPLAY", "WAYLAND_DISPLAY"))
    if not windows or "SSH_CONNECTION" in os.environ:
        return False
    try:
        return webbrowser.open(viewer.url)
    except webbrowser.Error:
        return False


def _open_in_cell(port: int, **options: Any) -> Viewer:
    """A viewer in place of what this cell opened before; under any port where those asked for are taken."""
    make_room()
    try:
        viewer = Viewer(port=port, **options)
    except ViewerError:
        viewer = Viewer(port=0, **options)
    keep(viewer)
    return viewer


def _with_back_faces(named: list[Named], shown: bool) -> list[Named]:
    return [
        (name, geometry, style if style.back_faces is not None else dataclasses.replace(style, back_faces=shown))
        for name, geometry, style in named
    ]


def _picture(
    named: list[Named], view: dict[str, Any], size: tuple[int, int], normals: bool, wireframe: bool
) -> Picture:
    """The picture that the viewer would have begun with."""
    from ..render.render import render
    from .stills import as_entry

    camera = {name: value for name, value in view.items() if value is not None} or None
    entries = [as_entry(one) for one in named]
    return render(entries, camera=camera, size=size, point_show_normal=normals, mesh_show_wireframe=wireframe)


class _Run(NamedTuple):
    """A cell, and which of its runs."""

    cell: str
    number: str


_opened: list[tuple[_Run, weakref.ref[Viewer]]] = []  # the earliest first
_lock = threading.Lock()


def make_room() -> None:
    """Close what earlier runs of this cell opened, and the earliest of all where 16 are open."""
    run = _this_run()
    with _lock:
        alive = [(by, viewer) for by, ref in _opened if (viewer := ref()) is not None and not viewer.closed]
        again = [viewer for by, viewer in alive if run is not None and by.cell == run.cell and by.number != run.number]
        others = [(by, viewer) for by, viewer in alive if viewer not in again]
        surplus = others[: max(0, len(others) - MOST_OPEN + 1)]
        _opened[:] = [(by, weakref.ref(viewer)) for by, viewer in others[len(surplus) :]]
    for viewer in again:
        viewer.close()
    for _, viewer in surplus:
        viewer._close(f"{MOST_OPEN} viewers of this notebook stay open, and this was the oldest: run its cell again.")


def keep(viewer: Viewer) -> None:
    """Count a viewer as opened by the cell that runs."""
    with _lock:
        _opened.append((_this_run() or _Run("", ""), weakref.ref(viewer)))


def _this_run() -> _Run | None:
    """The cell that runs, by the name that the notebook gives it, else by its text; None where there is none.

    JupyterLab and VS Code tell the name of a cell with each request; where it is missing, cells of the same text count
    as one.
    """
    get_parent = getattr(ipython_shell(), "get_parent", None)
    if get_parent is None:
        return None
    request: Any = get_parent()
    try:
        named = request["metadata"].get("cellId") or request["metadata"].get("cell_id")
        return _Run(str(named or request["content"]["code"]), str(request["header"]["msg_id"]))
    except (AttributeError, KeyError, TypeError):  # another protocol's request
        return None
