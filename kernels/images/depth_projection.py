"""Points seen by a pinhole camera: a depth image of them, and their colours.

Two launches: a thread a point offers its depth to a pixel, then a thread a pixel reads what won. The nearest point wins
by an atomic minimum of one word of 64 bits, the bits of the depth above the index (raster.py), so the image is the same
whatever the order of the threads; equal depths go to the lower index. 12 B read a point, 8 B written and read a pixel,
some 30 operations a point in float64: a pixel's own point comes back to its pixel.
"""

from ..algebra.transform import widen
from ..arrays.packed_keys import key_index, key_number
from ..lang import (
    array,
    float32,
    float64,
    floor,
    func,
    int64,
    isfinite,
    kernel,
    launch,
    mat33d,
    tid,
    uint8,
    vec3,
    vec3d,
    vec4d,
)
from ..memory import empty, full
from .raster import EMPTY, offer_cell


@kernel
def project_points_kernel(
    points: array(dtype=vec3),
    R: mat33d,
    t: vec3d,
    camera: vec4d,
    width: int,
    height: int,
    farthest: float,
    words: array(dtype=int64),
):
    """Offer the depth of R p + t to the pixel whose centre is nearest; camera: fx fy cx cy."""
    i = tid()
    p = points[i]
    if isfinite(p):
        q = R @ widen(p) + t
        z = float(q[2])
        if z > 0.0 and z <= farthest:
            u = floor(camera[0] * q[0] / q[2] + camera[2] + float64(0.5))
            v = floor(camera[1] * q[1] / q[2] + camera[3] + float64(0.5))
            if u >= float64(0.0) and v >= float64(0.0) and u < float64(width) and v < float64(height):
                offer_cell(words, int(v) * width + int(u), z, i)


@kernel
def read_depth_kernel(words: array(dtype=int64), scale: float64, depth: array(dtype=float32)):
    """The depth that won a pixel, times the scale; 0 where nothing is seen."""
    i = tid()
    word = words[i]
    d = float(0.0)
    if word < int64(EMPTY):
        d = float(float64(key_number(word)) * scale)
    depth[i] = d


@func
def to_byte(value: float) -> int:
    """0..1 to 0..255, rounded; what lies outside is cut off."""
    return int(floor(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@kernel
def read_colors_kernel(words: array(dtype=int64), colors: array(dtype=vec3), pixels: array(dtype=uint8, ndim=2)):
    """The 8-bit colour of the point that won a pixel; black where nothing is seen."""
    i = tid()
    word = words[i]
    c = vec3(0.0, 0.0, 0.0)
    if word < int64(EMPTY):
        c = colors[key_index(word)]
    for channel in range(3):
        pixels[i, channel] = uint8(to_byte(c[channel]))


def project_points(points, T_camera_points, camera, width, height, farthest):
    """What each pixel of a camera sees: words for `read_depth` and `read_colors`.

    Args:
        points: Device array of vec3, shape [n].
        T_camera_points: float64 [4, 4].
        camera: (fx, fy, cx, cy).
        farthest: Largest depth that is seen [m].
    """
    words = full(width * height, EMPTY, int64, points.device)
    R, t = mat33d(*T_camera_points[:3, :3].ravel()), vec3d(*T_camera_points[:3, 3])
    arguments = [points, R, t, vec4d(*camera), width, height, float(farthest), words]
    launch(project_points_kernel, points.size, arguments)
    return words


def read_depth(words, scale=1.0):
    """Depth [m] times `scale`, float32 [pixels]; 0 where nothing is seen."""
    depth = empty(words.size, float32, words.device)
    launch(read_depth_kernel, words.size, [words, float(scale), depth])
    return depth


def read_colors(words, colors):
    """8-bit colours, uint8 [pixels, 3]; 0 where nothing is seen."""
    pixels = empty((words.size, 3), uint8, words.device)
    launch(read_colors_kernel, words.size, [words, colors, pixels])
    return pixels
