"""What a cell of a notebook shows: a frame over a still picture, so that something is seen wherever it is read.

A cell's output is kept in the notebook's file and read where the program is long gone, where frames are left out
(GitHub, a notebook that is not trusted), or where scripts do not run. So the still is always there, in sight, and a
frame covers it where it has something to show: a page inside the notebook (`page_output`) at once, a live one
(`live_output`) when it has said that it is there, since a browser shows a page of its own for a server that is gone.
"""

from __future__ import annotations

import base64
import html
import io
import sys
import uuid
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

QUALITY, MOST_WIDTH, MOST_BYTES = 85, 960, 200_000  # of a still: JPEG's own scale, pixels, bytes
MOST_PAGE_BYTES = 4 * 2**20  # of a page, an animation or a video that lies in a notebook
SMALLER = 0.8  # by which its sides shrink until it fits
READY = "pointloom"  # what a live page says to the page around it

_FRAME = "position:absolute;top:0;left:0;width:100%;height:100%;border:0"
# A live frame opens when its page speaks, which it does while it loads. Loaded without a word it is shut: what the
# browser shows for a server that is gone would cover the still.
_COVER = """<script>
for (const frame of document.querySelectorAll('iframe[name="%(name)s"]')) {
  let spoke = false;
  const open = () => { frame.style.visibility = spoke ? "visible" : "hidden"; };
  addEventListener("message", (event) => {
    if (event.source === frame.contentWindow && event.data === "%(ready)s") { spoke = true; open(); }
  });
  frame.addEventListener("load", () => { open(); spoke = false; });
  frame.src = frame.dataset.src;
}
</script>"""


def ipython_shell() -> Any:
    """IPython's shell that this runs in; None where there is none."""
    return getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()


def in_notebook() -> bool:
    """Whether this runs in the kernel of a notebook, which shows what a cell ends with."""
    shell = ipython_shell()
    return type(shell).__name__ == "ZMQInteractiveShell" or getattr(shell, "kernel", None) is not None


def still_jpeg(picture: NDArray[np.uint8]) -> bytes:
    """A picture [h, w, 3] as JPEG of at most 200 kB and 960 pixels across; one of [h, w, 4] over white."""
    image, most = Image.fromarray(np.ascontiguousarray(picture)), MOST_WIDTH
    if image.mode == "RGBA":
        image = Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")
    while True:
        if image.width > most:
            image = image.resize((most, max(1, round(image.height * most / image.width))), Image.Resampling.LANCZOS)
        file = io.BytesIO()
        image.save(file, "JPEG", quality=QUALITY, optimize=True)
        if file.tell() <= MOST_BYTES or image.width < 2:
            return file.getvalue()
        most = max(1, int(image.width * SMALLER))


def live_output(text: str, url: str, ssh_line: str, picture: NDArray[np.uint8], height: int) -> dict[str, Any]:
    """The page at `url` in a frame, over what it showed when the cell ran, for IPython by kinds of content.

    Args:
        text: For terminals.
        url: Of the page.
        ssh_line: What brings it to another machine.
        picture: Shape [h, w, 3], uint8.
        height: Of the frame [px].
    """
    name = f"pointloom-{uuid.uuid4().hex[:12]}"
    frame = (
        f'<iframe name="{name}" data-src="{html.escape(url, quote=True)}" style="{_FRAME};visibility:hidden" '
        'allow="fullscreen"></iframe>'
    )
    words = (
        f"<small>Live while the kernel runs and {html.escape(url)} is reached, from another machine after "
        f"<code>{html.escape(ssh_line)}</code>; else a picture of when this cell ran</small>"
    )
    still = _encoded(picture)
    shown = _over_still(frame, still, height) + f"<p>{words}</p>" + _COVER % {"name": name, "ready": READY}
    return _bundle(text, shown, still)


def page_output(text: str, page: str, notes: list[str], picture: NDArray[np.uint8], height: int) -> dict[str, Any]:
    """A whole page in a frame over a still of it, for IPython by kinds of content.

    The page is sealed off from the notebook: it may run its own script and nothing else.

    Args:
        text: For terminals.
        page: HTML that asks nobody for anything.
        notes: What is to be said below.
        picture: Shape [h, w, 3], uint8.
        height: Of the frame [px].
    """
    frame = (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" sandbox="allow-scripts" style="{_FRAME}" '
        'allow="fullscreen"></iframe>'
    )
    still = _encoded(picture)
    return _bundle(text, _over_still(frame, still, height) + _small(notes), still)


def media_output(text: str, kind: str, data: bytes, notes: list[str], picture: NDArray[np.uint8]) -> dict[str, Any]:
    """An animation or a video that notebooks play by themselves, for IPython by kinds of content.

    Args:
        text: For terminals.
        kind: "image/gif" or "video/mp4".
        data: The file.
        notes: What is to be said below.
        picture: Of one frame, shape [h, w, 3], uint8.
    """
    source = f'src="data:{kind};base64,{base64.b64encode(data).decode()}" style="max-width:100%"'
    shown = f"<video controls loop {source}></video>" if kind.startswith("video") else f'<img alt="" {source}>'
    return _bundle(text, shown + _small(notes), _encoded(picture))


def still_output(text: str, notes: list[str], picture: NDArray[np.uint8]) -> dict[str, Any]:
    """A still alone, and what is to be said of it, for IPython by kinds of content."""
    still = _encoded(picture)
    return _bundle(text, _image(still) + _small(notes), still)


def _encoded(picture: NDArray[np.uint8]) -> str:
    return base64.b64encode(still_jpeg(picture)).decode()


def _bundle(text: str, shown: str, still: str) -> dict[str, Any]:
    return {"text/plain": text, "text/html": shown, "image/jpeg": still}


def _over_still(frame: str, still: str, height: int) -> str:
    box = f'style="position:relative;height:{int(height)}px;overflow:hidden"'
    return f"<div {box}>{_image(still, ';display:block;margin:auto;max-height:100%')}{frame}</div>"


def _image(still: str, style: str = "") -> str:
    return f'<img alt="" style="max-width:100%{style}" src="data:image/jpeg;base64,{still}">'


def _small(notes: list[str]) -> str:
    return "".join(f"<p><small>{html.escape(note)}</small></p>" for note in notes)
