"""The viewer in a notebook: a frame with the page, and a still picture for where it cannot be reached."""

from __future__ import annotations

import base64
import html
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...files.pictures.image_files import encode_png

_STILL = "the picture as it was when this cell ran"


def in_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, which shows what a cell ends with."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell" or getattr(shell, "kernel", None) is not None


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


class StillPicture:
    """What `draw` gives a notebook where no server can run: the picture that the viewer would begin with.

    Attributes:
        picture: Shape [h, w, 3], uint8.
        reason: Why there is no viewer.
    """

    def __init__(self, picture: NDArray[np.uint8], reason: str):
        self.picture, self.reason = picture, reason

    def __repr__(self) -> str:
        return f"StillPicture({self.picture.shape[1]} x {self.picture.shape[0]}; {self.reason})"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        note = f"<p><small>{html.escape(self.reason)}</small></p>"
        encoded = base64.b64encode(encode_png(self.picture)).decode()
        return {"text/plain": repr(self), "image/png": encoded, "text/html": _image(self.picture) + note}
