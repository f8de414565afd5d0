"""Output of notebook cells: a frame over a static image.

The output is stored in the notebook and may be read after the program has ended, where frames (GitHub, untrusted
notebooks) or scripts are disabled. So the image is always visible and a frame covers it only if it has content: an
embedded page (`page_output`) at once, a live page (`live_output`) after it has reported that it is loaded.
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

JPEG_QUALITY, MAX_WIDTH, MAX_BYTES = 85, 960, 200_000  # of an image: JPEG quality, [px], bytes
MAX_PAGE_BYTES = 4 * 2**20  # of a page, an animation or a video in a notebook
SIZE_REDUCTION = 0.8  # factor of the image size per attempt
READY = "pointloom"  # message of a live page to the surrounding page

_FRAME = "position:absolute;top:0;left:0;width:100%;height:100%;border:0"
# A live frame opens when its page sends a message while loading. If it loads without one, it stays closed:
# the browser's error page would cover the image.
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
    """The active IPython shell, or None."""
    return getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()


def in_notebook() -> bool:
    """True in the kernel of a notebook."""
    shell = ipython_shell()
    return type(shell).__name__ == "ZMQInteractiveShell" or getattr(shell, "kernel", None) is not None


def still_jpeg(picture: NDArray[np.uint8]) -> bytes:
    """JPEG of an image, at most 200 kB and 960 pixels wide. RGBA is composited over white."""
    image, max_width = Image.fromarray(np.ascontiguousarray(picture)), MAX_WIDTH
    if image.mode == "RGBA":
        image = Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")
    while True:
        if image.width > max_width:
            image = image.resize(
                (max_width, max(1, round(image.height * max_width / image.width))), Image.Resampling.LANCZOS
            )
        file = io.BytesIO()
        image.save(file, "JPEG", quality=JPEG_QUALITY, optimize=True)
        if file.tell() <= MAX_BYTES or image.width < 2:
            return file.getvalue()
        max_width = max(1, int(image.width * SIZE_REDUCTION))


def live_output(text: str, url: str, ssh_line: str, picture: NDArray[np.uint8], height: int) -> dict[str, Any]:
    """MIME bundle of the page at `url` in a frame over its image (h, w, 3); `text` for terminals, `height` in [px]."""
    name = f"pointloom-{uuid.uuid4().hex[:12]}"
    frame = (
        f'<iframe name="{name}" data-src="{html.escape(url, quote=True)}" style="{_FRAME};visibility:hidden" '
        'allow="fullscreen"></iframe>'
    )
    words = (
        f"<small>Live while the kernel runs and {html.escape(url)} is reachable, from another machine after "
        f"<code>{html.escape(ssh_line)}</code>; otherwise an image from the time when this cell ran</small>"
    )
    still = _encoded(picture)
    shown = _over_still(frame, still, height) + f"<p>{words}</p>" + _COVER % {"name": name, "ready": READY}
    return _bundle(text, shown, still)


def page_output(text: str, page: str, notes: list[str], picture: NDArray[np.uint8], height: int) -> dict[str, Any]:
    """MIME bundle of a self-contained page in a sandboxed frame over an image, with notes below."""
    frame = (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" sandbox="allow-scripts" style="{_FRAME}" '
        'allow="fullscreen"></iframe>'
    )
    still = _encoded(picture)
    return _bundle(text, _over_still(frame, still, height) + _small(notes), still)


def media_output(text: str, kind: str, data: bytes, notes: list[str], picture: NDArray[np.uint8]) -> dict[str, Any]:
    """MIME bundle of an animation or video ("image/gif" or "video/mp4"), with an image of one frame as fallback."""
    source = f'src="data:{kind};base64,{base64.b64encode(data).decode()}" style="max-width:100%"'
    shown = f"<video controls loop {source}></video>" if kind.startswith("video") else f'<img alt="" {source}>'
    return _bundle(text, shown + _small(notes), _encoded(picture))


def still_output(text: str, notes: list[str], picture: NDArray[np.uint8]) -> dict[str, Any]:
    """MIME bundle of an image with notes."""
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
