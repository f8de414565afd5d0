"""Transparency by depth peeling (Everitt, "Interactive order-independent transparency", NVIDIA 2001).

A layer is a z-buffer of the first elements behind the previous layer and before all solid ones. Words strictly order
depth and index, so no element is lost or repeated. Point discs overlap, so a cloud is drawn once into its own buffer.
Images without background are recovered from renderings on black and white (Smith and Blinn, SIGGRAPH 1996, section 5).
"""

from ..array_types import Array1, Bytes
from ..lang import array, atomic_max, int32, int64, kernel, launch, tid, uint8
from ..memory import clone, download, empty, full, zeros
from .z_buffer import DepthBuffer

MAX_LAYERS = 16  # further layers are skipped: at 20 % opacity they would add 3 % of the light


@kernel
def take_words_kernel(own: DepthBuffer, layer: DepthBuffer):
    """Keep the nearer of a layer's content and another buffer's, if that is behind the previous layer."""
    i = tid()
    word = own.words[i]
    if word > layer.behind[i] and word < layer.words[i]:
        layer.words[i] = word


@kernel
def find_more_kernel(layer: DepthBuffer, solid: DepthBuffer, flag: array(dtype=int32)):
    """Flag a layer with any content in front of the solid one."""
    i = tid()
    if layer.words[i] != solid.words[i]:
        atomic_max(flag, 0, 1)  # all writers write 1


@kernel
def join_mattes_kernel(on_black: array(dtype=uint8), on_white: array(dtype=uint8), picture: array(dtype=uint8)):
    """Color and opacity of a pixel from renderings on black and on white."""
    i = tid()
    gap = 0
    for k in range(3):
        gap = gap + int(on_white[3 * i + k]) - int(on_black[3 * i + k])
    opacity = 255 - (gap + 1) // 3
    for k in range(3):
        value = 0
        if opacity > 0:
            value = min((int(on_black[3 * i + k]) * 255 + opacity // 2) // opacity, 255)
        picture[4 * i + k] = uint8(value)
    picture[4 * i + 3] = uint8(opacity)


def before_all(solid: DepthBuffer) -> Array1[int64]:
    """Words before every other, as the background of the first layer."""
    return full(solid.width * solid.height, -1, int64, solid.words.device)


def start_layer(solid: DepthBuffer, behind: Array1[int64]) -> DepthBuffer:
    """A layer to draw into, before what is solid and behind the words of another layer."""
    return DepthBuffer(solid.width, solid.height, solid.words.device, words=clone(solid.words), behind=behind)


def take_words(own: DepthBuffer, layer: DepthBuffer) -> None:
    launch(take_words_kernel, layer.words.size, [own, layer])


def has_more(layer: DepthBuffer, solid: DepthBuffer) -> bool:
    flag = zeros(1, int32, layer.words.device)
    launch(find_more_kernel, layer.words.size, [layer, solid, flag])
    return bool(download(flag)[0])  # sync


def join_mattes(on_black: Bytes, on_white: Bytes) -> Bytes:
    """RGBA without background, uint8 (4 pixels), not premultiplied."""
    picture = empty(on_black.size // 3 * 4, uint8, on_black.device)
    launch(join_mattes_kernel, on_black.size // 3, [on_black, on_white, picture])
    return picture
