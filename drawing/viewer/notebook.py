"""The viewer in a notebook: a frame with the page, and a still picture for where it cannot be reached."""

from __future__ import annotations

import base64
import html
import sys

import numpy as np
from numpy.typing import NDArray

from ...files.pictures.image_files import encode_png

_STILL = "the picture as it was when this cell ran"


def in_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, which shows what a cell ends with."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell" or getattr(shell, "kernel", None) is not None


def page_frame_html(page: str, notes: list[str], picture: NDArray[np.uint8], height: int) -> str:
    """A frame that holds a whole page, what is to be said of it below, and a still picture of it.

    The page is sealed off from the notebook: it may run its own script and nothing else.
    """
    words = "".join(f"<p><small>{html.escape(note)}</small></p>" for note in notes)
    return (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" sandbox="allow-scripts" width="100%" '
        f'height="{int(height)}" style="border:0" allow="fullscreen"></iframe>'
        f"{words}<details><summary>{_STILL}</summary>{_image(picture)}</details>"
    )


def still_html(picture: NDArray[np.uint8], notes: list[str]) -> str:
    """A picture, and what is to be said of it below."""
    return _image(picture) + "".join(f"<p><small>{html.escape(note)}</small></p>" for note in notes)


def frame_html(url: str, ssh_line: str, picture: NDArray[np.uint8] | None, height: int) -> str:
    """A frame with the page at `url`, and below it how to reach it from elsewhere and what it showed."""
    still = "" if picture is None else f"<details><summary>{_STILL}</summary>{_image(picture)}</details>"
    return (
        f'<iframe src="{html.escape(url, quote=True)}" width="100%" height="{int(height)}" '
        'style="border:0" allow="fullscreen"></iframe>'
        f"<p><small>{html.escape(url)} &middot; from another machine first: "
        f"<code>{html.escape(ssh_line)}</code></small></p>{still}"
    )


def _image(picture: NDArray[np.uint8]) -> str:
    data = base64.b64encode(encode_png(picture)).decode()
    return f'<img alt="" style="max-width:100%" src="data:image/png;base64,{data}">'
