"""A scene inside a notebook, for where the browser reaches no server of the kernel's: `inline_page`.

The page is that of recordings (recording/page.py): one HTML text with player and data, which asks nobody for anything.
It stays in the notebook's file, so its size is bounded, and what is beyond is sampled or simplified.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..notebook_output import MOST_PAGE_BYTES as MOST_BYTES
from ..notebook_output import MOST_WIDTH, page_output, still_output
from ..render.geometries import Named, parts_of
from ..render.scene import Scene
from .stills import as_entry, write_geometries

VARIABLE = "POINTLOOM_INLINE"
FIRST_POINTS = 200_000  # of a first try: about 16 bytes each, once they are packed
SMALLER, TRIES = 0.9, 4  # how far below the share that would just fit, and how often

# What tells that the browser is not on the kernel's machine, or shows no frame of its ports.
PLACES = (
    ("COLAB_RELEASE_TAG", "Colab"),
    ("KAGGLE_KERNEL_RUN_TYPE", "Kaggle"),
    ("DATABRICKS_RUNTIME_VERSION", "Databricks"),
    ("BINDER_SERVICE_HOST", "Binder"),
    ("JUPYTERHUB_SERVICE_PREFIX", "JupyterHub"),
    ("VSCODE_PID", "VS Code"),
    ("CODESPACES", "Codespaces"),
    ("SSH_CONNECTION", "a kernel that is reached over SSH"),
)


class InlinePage:
    """What `draw` gives a notebook inline: a scene that can be turned wherever the notebook is read, without a server.

    Attributes:
        html: The page; None where none fits into the bound, and the picture is all.
        picture: Shape [h, w, 3], uint8: the view that the page begins with.
        notes: What is said below it: why it is inline, its size, and what was sampled or simplified.
    """

    def __init__(self, html: str | None, picture: NDArray[np.uint8], notes: list[str], height: int):
        self.html, self.picture, self.notes, self._height = html, picture, notes, height

    def __repr__(self) -> str:
        return f"InlinePage({'; '.join(self.notes)})"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """The page in a frame, over the picture for what shows no frames."""
        if self.html is None:
            return still_output(repr(self), self.notes, self.picture)
        return page_output(repr(self), self.html, self.notes, self.picture, self._height)


def wants_inline(inline: bool | None, *, notebook: bool) -> str | None:
    """Why a scene is to be shown inline; None where it is not.

    Args:
        inline: As of `draw`.
        notebook: Whether there is a notebook that would show it.

    Raises:
        ValueError: POINTLOOM_INLINE is neither 0 nor 1.
    """
    if inline is not None:
        return "inline, as asked for" if inline else None
    wish = os.environ.get(VARIABLE, "")
    if wish not in ("", "0", "1"):
        raise ValueError(f"{VARIABLE}: expected 0 or 1, got {wish!r}")
    if not notebook or wish == "0":
        return None
    if wish:
        return f"inline, as {VARIABLE} says"
    place = place_of_kernel()
    return None if place is None else f"inline: this is {place}, where no server is reached; live by inline=False"


def place_of_kernel() -> str | None:
    """Where a kernel runs whose servers the browser does not reach; None for this machine, as far as can be known."""
    if "google.colab" in sys.modules:
        return "Colab"
    return next((place for variable, place in PLACES if os.environ.get(variable)), None)


def inline_page(
    named: list[Named], view: dict[str, Any], size: tuple[int, int], max_points: int, reason: str
) -> InlinePage:
    """The scene as a page of at most 4 MB, with the picture that it begins with.

    Args:
        named: Names, geometries and styles.
        view: Open3D's view parameters by name; None each for what shows all.
        size: Width and height as of `draw` [px].
        max_points: Of all clouds and meshes together.
        reason: Why it is inline; said below it.
    """
    from ..render.render import device_of, render, resolve_view

    width = min(size[0], MOST_WIDTH)
    still = (width, max(1, round(size[1] * width / size[0])))
    place = device_of(named, None)
    scene = Scene([part for _, geometry, style in named for part in parts_of(geometry, style, place)], place)
    camera = resolve_view({name: value for name, value in view.items() if value is not None} or None, scene, *still)
    picture = render([as_entry(one) for one in named], camera=camera, size=still)
    page, counts = _bounded_page(named, camera, max_points)
    notes = [reason]
    if page is None:
        notes.append(f"no page of {MOST_BYTES / 2**20:g} MB holds this scene; here is its picture")
    else:
        thinned = [f"{name}: {drawn:,} of {total:,} points" for name, (drawn, total) in counts.items() if drawn < total]
        notes.append("; ".join([f"{len(page) / 2**20:.1f} MB of this notebook", *thinned]))
    return InlinePage(page, np.asarray(picture), notes, size[1] * 2 // 3)


def _bounded_page(named: list[Named], view: Any, max_points: int) -> tuple[str | None, dict[str, tuple[int, int]]]:
    """The page, sampled and simplified until it fits, and of each name how many points of how many it has."""
    most = min(max_points, FIRST_POINTS)
    with tempfile.TemporaryDirectory(prefix="pointloom-page-") as folder:
        path = Path(folder) / "page.html"
        for _ in range(TRIES):
            counts = write_geometries(path, named, most, view=view)
            size = path.stat().st_size
            if size <= MOST_BYTES:
                return path.read_text(encoding="utf-8"), counts
            drawn = sum(count for count, _ in counts.values())
            most = max(1, int(min(drawn, most) * SMALLER * MOST_BYTES / size))
    return None, {}
