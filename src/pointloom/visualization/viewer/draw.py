"""Display geometries in a browser window (`draw`, compatible with Open3D's `draw_geometries`) or inline in a notebook.

`inline_page` makes a self-contained HTML page of bounded size, for notebooks whose kernel the browser cannot reach.
"""

from __future__ import annotations

import dataclasses
import itertools
import os
import sys
import tempfile
import threading
import weakref
import webbrowser
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_count, check_positive
from ...core.errors import FileError, PointloomError
from ...core.escaped_text import escaped
from ...core.standard_streams import write_to_stderr
from ...kernels.language.environment import setting
from ..notebook_output import MAX_PAGE_BYTES as MAX_BYTES
from ..notebook_output import MAX_WIDTH, in_notebook, ipython_shell, page_output, still_output
from ..render.geometries import Named, named_geometries, parts_of
from ..render.picture import Picture
from ..render.picture_files import write_image
from ..render.scene import Scene
from ..render.up_axis import look_of
from .client_presence import KEEP_ALIVE
from .screenshots import as_entry, write_geometries
from .server import ViewerError
from .viewer import MAX_POINTS, Viewer

DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER")  # variables, one of which is set where a browser can open
LOOPBACK = "127.0.0.1"
MAX_OPEN = 16  # viewers per kernel: fewer than the ports that are tried


@explain_argument_errors
def draw(
    geometries: object,
    width: int = 1280,
    height: int = 960,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = False,
    lookat: ArrayLike | None = None,
    up: ArrayLike | None = None,
    front: ArrayLike | None = None,
    zoom: float | None = None,
    field_of_view: float | None = None,
    *,
    port: int = 8080,
    host: str = LOOPBACK,
    max_points: int = MAX_POINTS,
    block: bool | None = None,
    open_browser: bool = True,
    inline: bool | None = None,
    keep_alive: float = KEEP_ALIVE,
) -> Viewer | InlinePage | Picture:
    """Show geometries in the browser, on this machine or over SSH, or in a notebook.

    In a script, the address is printed on stderr, a browser is opened if there is a display, and the call returns
    `keep_alive` seconds after the last page was closed, or at Ctrl-C. In a notebook it returns at once and the cell
    shows the page: live if the browser can reach this machine, else as a self-contained page.

    Without a display or browser, a call that would wait writes the initial image to pointloom-1.png (or the next free
    number) in the working directory, prints the path on stderr, and returns the image. This does not apply over SSH,
    or if `open_browser` is False or `host` is given: the page is then served. The environment variable POINTLOOM_DRAW
    overrides this: "page" always serves the page, "picture" returns the image without a file.

    Args:
        geometries: One, a list, a mapping of names to geometries, or dictionaries as in Open3D's `draw`. All types that
            `loom.render` draws.
        width, height: Size of images, and height of the frame in a notebook [px].
        point_show_normal: Show normals at first. Key N.
        mesh_show_wireframe: Show edges at first. Key W.
        mesh_show_back_face: Draw back faces.
        lookat, up, front, zoom, field_of_view: Camera as in Open3D. If none is given, the complete scene is visible.
        port, host: See `Viewer`.
        max_points: Maximum number of points of all clouds in a page.
        block: Wait for the pages. If None, wait except in a notebook.
        open_browser: Open a browser if there is a display.
        inline: Embed the scene in the notebook without a server, in at most 4 MB (clouds are sampled, meshes
            simplified, with a notice). If None: embed on Colab, Kaggle, JupyterHub, Binder, Databricks, in VS Code and
            over SSH, unless the environment variable POINTLOOM_INLINE is 1 (always) or 0 (never).
        keep_alive: Time without a page after which the wait ends [s].

    Returns:
        The viewer, closed if `draw` waited. An `InlinePage` if inline or if no server can run in a notebook. An image
        without a display, or if POINTLOOM_DRAW is "picture".

    Raises:
        TypeError: Unsupported geometry.
        ValueError: A parameter is out of range.
        PointloomError: No port is free.
        FileError: The image cannot be written.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        >>> viewer = loom.draw([cloud], port=0, block=False, open_browser=False)
        >>> viewer.close()
    """
    named = _with_back_faces(named_geometries(geometries), mesh_show_back_face)
    size = (check_count("width", width), check_count("height", height))
    keep_alive = check_positive("keep_alive", keep_alive, allow_zero=True, allow_infinite=True)
    view = {"zoom": zoom, "front": front, "lookat": lookat, "up": up, "field_of_view": field_of_view}
    notebook = in_notebook()
    reason = wants_inline(inline, notebook=notebook and not block)
    if reason is not None:
        return inline_page(named, view, size, max_points, reason)
    mode, waits = draw_mode(), block or (block is None and not notebook)
    if waits and (mode == "picture" or (mode == "file" and open_browser and host == LOOPBACK)):
        picture = _picture(named, view, size, point_show_normal, mesh_show_wireframe)
        return save_numbered(picture) if mode == "file" else picture
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
        with viewer.lock:  # a page that loads meanwhile is updated once everything is added
            if not notebook or block:
                announce(viewer)
                if open_browser and mode == "page":
                    open_page(viewer)
            viewer.add_named(named)
            viewer.show_normals(point_show_normal)
            viewer.show_wireframe(mesh_show_wireframe)
        if notebook and not block:
            return viewer
        if block is None or block:
            wait_for_pages(viewer, keep_alive)
    except BaseException:
        viewer.close()
        raise
    return viewer


draw_geometries = draw  # Open3D's name


def draw_mode() -> str:
    """The value of POINTLOOM_DRAW, "page" or "picture". If unset: "page" if a browser can show it, else "file".

    Raises ValueError for another value.
    """
    if mode := setting("POINTLOOM_DRAW"):
        return mode
    return "page" if "SSH_CONNECTION" in os.environ or _has_browser() else "file"


def save_numbered(picture: Picture) -> Picture:
    """Write an image to the first free pointloom-N.png of the working directory and print the path on stderr."""
    for number in itertools.count(1):
        path = Path.cwd() / f"pointloom-{number}.png"
        if path.exists():
            continue
        try:
            write_image(path, picture, overwrite=False)
        except FileError:
            if path.exists():  # another process was faster
                continue
            raise
        write_to_stderr(f"no display: image written to {escaped(path)} (POINTLOOM_DRAW=page serves a page instead)")
        break
    return picture


def wait_for_pages(viewer: Viewer, keep_alive: float = KEEP_ALIVE) -> None:
    """Wait as `Viewer.wait`, then close. Ctrl-C ends the wait without an error."""
    try:
        viewer.wait(keep_alive=keep_alive)
    except KeyboardInterrupt:
        pass
    finally:
        viewer.close()


def announce(viewer: Viewer) -> None:
    """Print the address of the page on stderr, and the SSH command if needed."""
    lines = []
    if viewer.server.moved_from is not None:
        lines.append(f"port {viewer.server.moved_from} is in use; using the next free one, {viewer.server.port}")
    lines.append(f"viewer: {viewer.url} (Ctrl-C ends it)")
    if viewer.server.exposed:
        lines.append(f"listening on {viewer.server.host}: anyone with this address and its token can see the scene")
    if "SSH_CONNECTION" in os.environ:
        lines.append(f"from another machine, run this first: {viewer.ssh_line}")
    write_to_stderr("\n".join(lines))


def open_page(viewer: Viewer) -> bool:
    """Open the page in a browser if there is a display. True if a browser was started."""
    if "SSH_CONNECTION" in os.environ or not _has_browser():
        return False
    try:
        return webbrowser.open(viewer.url)
    except webbrowser.Error:
        return False


def _has_browser() -> bool:
    """True if there is a display, or a browser in BROWSER (as in remote editors). Never true in a CI job."""
    if os.environ.get("CI"):
        return False
    if sys.platform not in ("darwin", "win32") and not any(os.environ.get(name) for name in DISPLAYS):
        return False
    try:
        webbrowser.get()
    except webbrowser.Error:
        return False
    return True


def _open_in_cell(port: int, **options: Any) -> Viewer:
    """Replace the viewers of earlier runs of this cell. Use any port if the preferred ones are in use."""
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
    from ..render.render import render
    from .screenshots import as_entry

    camera = {name: value for name, value in view.items() if value is not None} or None
    entries = [as_entry(one) for one in named]
    return render(entries, camera=camera, size=size, point_show_normal=normals, mesh_show_wireframe=wireframe)


class _Run(NamedTuple):
    """A notebook cell and the number of its run."""

    cell: str
    number: str


_opened: list[tuple[_Run, weakref.ref[Viewer]]] = []  # oldest first
_lock = threading.Lock()


def make_room() -> None:
    """Close the viewers of earlier runs of this cell, and the oldest one if 16 are open."""
    run = _this_run()
    with _lock:
        alive = [(by, viewer) for by, ref in _opened if (viewer := ref()) is not None and not viewer.closed]
        again = [viewer for by, viewer in alive if run is not None and by.cell == run.cell and by.number != run.number]
        others = [(by, viewer) for by, viewer in alive if viewer not in again]
        surplus = others[: max(0, len(others) - MAX_OPEN + 1)]
        _opened[:] = [(by, weakref.ref(viewer)) for by, viewer in others[len(surplus) :]]
    for viewer in again:
        viewer.close()
    for _, viewer in surplus:
        viewer.closing_notice = (
            f"At most {MAX_OPEN} viewers of a notebook stay open, and this was the oldest: run its cell again."
        )
        viewer.close()


def keep(viewer: Viewer) -> None:
    with _lock:
        _opened.append((_this_run() or _Run("", ""), weakref.ref(viewer)))


def _this_run() -> _Run | None:
    """The running cell, identified by the name in the request (JupyterLab, VS Code), else by its text; or None."""
    get_parent = getattr(ipython_shell(), "get_parent", None)
    if get_parent is None:
        return None
    request: Any = get_parent()
    try:
        named = request["metadata"].get("cellId") or request["metadata"].get("cell_id")
        return _Run(str(named or request["content"]["code"]), str(request["header"]["msg_id"]))
    except (AttributeError, KeyError, TypeError):  # a request of another protocol
        return None


VARIABLE = "POINTLOOM_INLINE"
FIRST_POINTS = 200_000  # of the first attempt: about 16 B each, packed
SIZE_REDUCTION, MAX_ATTEMPTS = 0.9, 4  # safety factor of the next fraction, and maximum number of attempts

# Signs that the browser is not on the kernel's machine, or does not show frames of its ports.
HOSTED_NOTEBOOKS = (
    ("COLAB_RELEASE_TAG", "Colab"),
    ("KAGGLE_KERNEL_RUN_TYPE", "Kaggle"),
    ("DATABRICKS_RUNTIME_VERSION", "Databricks"),
    ("BINDER_SERVICE_HOST", "Binder"),
    ("JUPYTERHUB_SERVICE_PREFIX", "JupyterHub"),
    ("VSCODE_PID", "VS Code"),
    ("CODESPACES", "Codespaces"),
    ("SSH_CONNECTION", "a kernel reached over SSH"),
)


class InlinePage:
    """A self-contained scene for a notebook, without a server.

    Attributes:
        html: The page. None if it does not fit into the size limit.
        picture: Initial image, shape (h, w, 3), uint8.
        notes: Notes below the page: why it is inline, its size, and what was sampled or simplified.
    """

    def __init__(self, html: str | None, picture: NDArray[np.uint8], notes: list[str], height: int):
        self.html, self.picture, self.notes, self._height = html, picture, notes, height

    def __repr__(self) -> str:
        return f"InlinePage({'; '.join(self.notes)})"

    def _repr_mimebundle_(
        self, include: Iterable[str] | None = None, exclude: Iterable[str] | None = None
    ) -> dict[str, Any]:
        """The page in a frame, with the image as fallback."""
        if self.html is None:
            return still_output(repr(self), self.notes, self.picture)
        return page_output(repr(self), self.html, self.notes, self.picture, self._height)


def wants_inline(inline: bool | None, *, notebook: bool) -> str | None:
    """The reason to embed a scene, or None. Raises ValueError if POINTLOOM_INLINE is neither 0 nor 1."""
    if inline is not None:
        return "inline, as requested" if inline else None
    wanted = setting(VARIABLE)
    if not notebook or wanted == "0":
        return None
    if wanted:
        return f"inline, as {VARIABLE} specifies"
    host = hosted_notebook()
    return (
        None
        if host is None
        else f"inline: the browser cannot reach a server on {host}; pass inline=False for a live page"
    )


def hosted_notebook() -> str | None:
    """Name of a remote environment whose servers the browser cannot reach. None for this machine."""
    if "google.colab" in sys.modules:
        return "Colab"
    return next((name for variable, name in HOSTED_NOTEBOOKS if os.environ.get(variable)), None)


def inline_page(
    named: list[Named], view: dict[str, Any], size: tuple[int, int], max_points: int, reason: str
) -> InlinePage:
    """Make a page of at most 4 MB with its initial image; `reason` is shown below it."""
    from ..render.render import device_of, render, resolve_view

    width = min(size[0], MAX_WIDTH)
    still = (width, max(1, round(size[1] * width / size[0])))
    device = device_of(named, None)
    scene = Scene([part for _, geometry, style in named for part in parts_of(geometry, style, device)], device)
    given = {name: value for name, value in view.items() if value is not None}
    look = look_of((geometry, style.pose) for _, geometry, style in named)
    camera = resolve_view(given or None, scene, *still, look=look)
    picture = render([as_entry(one) for one in named], camera=camera, size=still)
    page, counts = _bounded_page(named, camera, max_points)
    notes = [reason]
    if page is None:
        notes.append(f"the scene does not fit into a page of {MAX_BYTES / 2**20:g} MB; this is its image")
    else:
        thinned = [f"{name}: {drawn:,} of {total:,} points" for name, (drawn, total) in counts.items() if drawn < total]
        notes.append("; ".join([f"{len(page) / 2**20:.1f} MB of this notebook", *thinned]))
    return InlinePage(page, np.asarray(picture), notes, size[1] * 2 // 3)


def _bounded_page(named: list[Named], view: Any, max_points: int) -> tuple[str | None, dict[str, tuple[int, int]]]:
    """The page, sampled until it fits, and the displayed and total number of points of each name."""
    point_limit = min(max_points, FIRST_POINTS)
    with tempfile.TemporaryDirectory(prefix="pointloom-page-") as folder:
        path = Path(folder) / "page.html"
        for _ in range(MAX_ATTEMPTS):
            counts = write_geometries(path, named, point_limit, view=view)
            size = path.stat().st_size
            if size <= MAX_BYTES:
                return path.read_text(encoding="utf-8"), counts
            drawn = sum(count for count, _ in counts.values())
            point_limit = max(1, int(min(drawn, point_limit) * SIZE_REDUCTION * MAX_BYTES / size))
    return None, {}
