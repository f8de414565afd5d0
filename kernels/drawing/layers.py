"""Layers of a picture, for what is seen through: depth peeling (Everitt, "Interactive order-independent transparency",
NVIDIA 2001).

A layer is a z-buffer of what is seen first behind the layer before it and before all that is solid. Words of a z-buffer
are a strict order of depth and index, so no element is seen in two layers, none is lost among those of equal depth, and
layers are the same in any order of the threads. One more pass over the triangles a layer; 24 B a cell.
A cell on the edge of two triangles is drawn in one of them (triangles.py).

Points of a cloud overlap, so its discs are no layers of their own: it is drawn once into a buffer of its own, of which
each layer takes what lies there.

A picture without a background is found from the same one before black and before white (Smith and Blinn, "Blue screen
matting", SIGGRAPH 1996, section 5: triangulation), so that letters, drawn later, are in it.
"""

from ..array_types import Array1, Bytes
from ..lang import array, atomic_max, int32, int64, kernel, launch, tid, uint8
from ..memory import clone, download, empty, full, zeros
from .z_buffer import DepthBuffer

LAYERS = 16  # what lies behind that many is left out: at 20 % it would add 3 % of the light


@kernel
def take_words_kernel(own: DepthBuffer, layer: DepthBuffer):
    """Keep the nearer of a layer's content and what is in another buffer, if that lies behind the layer before."""
    i = tid()
    word = own.words[i]
    if word > layer.behind[i] and word < layer.words[i]:
        layer.words[i] = word


@kernel
def find_more_kernel(layer: DepthBuffer, solid: DepthBuffer, found: array(dtype=int32)):
    """Whether a layer holds anything before what is solid."""
    i = tid()
    if layer.words[i] != solid.words[i]:
        # whichever comes first, it is found
        atomic_max(found, 0, 1)


@kernel
def join_mattes_kernel(on_black: array(dtype=uint8), on_white: array(dtype=uint8), picture: array(dtype=uint8)):
    """Colours and opacity of a pixel that is seen before black and before white."""
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
    """Words that lie before every other: what the first layer is behind."""
    return full(solid.width * solid.height, -1, int64, solid.words.device)


def start_layer(solid: DepthBuffer, behind: Array1[int64]) -> DepthBuffer:
    """A layer to draw into, before what is solid and behind the words of another layer."""
    return DepthBuffer(solid.width, solid.height, solid.words.device, words=clone(solid.words), behind=behind)


def take_words(own: DepthBuffer, layer: DepthBuffer) -> None:
    """Draw what another buffer holds into a layer."""
    launch(take_words_kernel, layer.words.size, [own, layer])


def has_more(layer: DepthBuffer, solid: DepthBuffer) -> bool:
    """Whether a layer holds anything."""
    found = zeros(1, int32, layer.words.device)
    launch(find_more_kernel, layer.words.size, [layer, solid, found])
    return bool(download(found)[0])  # sync


def join_mattes(on_black: Bytes, on_white: Bytes) -> Bytes:
    """A picture without a background, uint8 [4 * pixels]; its colours are not multiplied by its opacity."""
    picture = empty(on_black.size // 3 * 4, uint8, on_black.device)
    launch(join_mattes_kernel, on_black.size // 3, [on_black, on_white, picture])
    return picture
