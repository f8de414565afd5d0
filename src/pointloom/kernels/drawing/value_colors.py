"""Colors of points from scalar values, labels or directions. Table positions in float64, mixing in float32 without
fused products: bitwise identical on every device. Non-finite values get their own color and set a flag.
"""

import numpy as np

from ..array_types import AnyArray, Device, Doubles, Integers, Points, Scalars, Vectors
from ..lang import (
    array,
    atomic_max,
    compute,
    float32,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    vec3,
)
from ..memory import download, empty, upload, zeros

MAX_LABELS = 4096  # labels from -1 recorded individually: more than any legend has


@struct
class Ramp:
    """Color map: position (value - `low`) * `factor` + `start` in `table`; `missing` color, `flag` of non-finite."""

    table: array(dtype=vec3)
    last: int
    low: float64
    factor: float64
    start: float64
    missing: vec3
    flag: array(dtype=int32)

    def __init__(
        self, table: np.ndarray, limits: tuple[float, float], missing: tuple[float, float, float], device: Device
    ) -> None:
        """From colors (k, 3) and limits (low, high); equal limits give the middle color."""
        low, high = limits
        half = high / 2 - low / 2  # the difference itself may overflow float64
        self.table, self.last = upload(table, vec3, device), len(table) - 1
        self.low, self.factor, self.start = low, 0.5 / half if half > 0 else 0.0, 0.0 if half > 0 else 0.5
        self.missing, self.flag = vec3(*missing), zeros(1, int32, device)


@func
def coordinate(p: vec3, axis: int) -> float:
    """One coordinate by conditions: a computed index would put the vector into local memory."""
    value = p[0]
    if axis == 1:
        value = p[1]
    if axis == 2:
        value = p[2]
    return value


@func
def raise_flag(flag: array(dtype=int32)):
    if flag[0] == 0:
        atomic_max(flag, 0, 1)  # all writers write 1


@func
def ramp_color(value: float64, ramp: Ramp) -> vec3:
    color = ramp.missing
    if isfinite(value):
        fraction = min(max((value - ramp.low) * ramp.factor + ramp.start, 0.0), 1.0)
        position = float32(fraction) * float(ramp.last)
        k = min(int(position), ramp.last - 1)
        rest = position - float(k)
        color = ramp.table[k] * (1.0 - rest) + ramp.table[k + 1] * rest
    else:
        raise_flag(ramp.flag)
    return color


@kernel
def color_values_kernel(values: array(dtype=float32), ramp: Ramp, colors: array(dtype=vec3)):
    i = tid()
    colors[i] = ramp_color(float64(values[i]), ramp)


@kernel
def color_wide_values_kernel(values: array(dtype=float64), ramp: Ramp, colors: array(dtype=vec3)):
    i = tid()
    colors[i] = ramp_color(values[i], ramp)


@kernel
def color_coordinates_kernel(points: array(dtype=vec3), axis: int, ramp: Ramp, colors: array(dtype=vec3)):
    i = tid()
    colors[i] = ramp_color(float64(coordinate(points[i], axis)), ramp)


@func
def note_label(label: int, present: array(dtype=int32)):
    if present[label] == 0:
        atomic_max(present, label, 1)  # all writers write 1


@func
def label_color(
    label: int64, palette: array(dtype=vec3), palette_size: int, noise: vec3, present: array(dtype=int32)
) -> vec3:
    """Color of a label, which is recorded. Negative is noise, and the palette repeats."""
    color = noise
    if label >= 0:
        color = palette[int(label % int64(palette_size))]
    note_label(int(min(max(label, -1), int64(MAX_LABELS - 2))) + 1, present)
    return color


@kernel
def color_labels_kernel(
    labels: array(dtype=int32),
    palette: array(dtype=vec3),
    palette_size: int,
    noise: vec3,
    present: array(dtype=int32),
    colors: array(dtype=vec3),
):
    i = tid()
    colors[i] = label_color(int64(labels[i]), palette, palette_size, noise, present)


@kernel
def color_wide_labels_kernel(
    labels: array(dtype=int64),
    palette: array(dtype=vec3),
    palette_size: int,
    noise: vec3,
    present: array(dtype=int32),
    colors: array(dtype=vec3),
):
    i = tid()
    colors[i] = label_color(labels[i], palette, palette_size, noise, present)


@kernel
def color_normals_kernel(
    normals: array(dtype=vec3), missing: vec3, flag: array(dtype=int32), colors: array(dtype=vec3)
):
    """Colors of directions: coordinates -1..1 as red, green and blue."""
    i = tid()
    n = normals[i]
    color = missing
    if isfinite(n):
        for k in range(3):
            color[k] = min(max((n[k] + 1.0) * 0.5, 0.0), 1.0)
    else:
        raise_flag(flag)
    colors[i] = color


@kernel
def take_every_kernel(values: array(dtype=float32), stride: int, out: array(dtype=float32)):
    i = tid()
    out[i] = values[i * stride]


@kernel
def take_every_wide_kernel(values: array(dtype=float64), stride: int, out: array(dtype=float64)):
    i = tid()
    out[i] = values[i * stride]


def color_values(values: Scalars | Doubles, ramp: Ramp) -> Vectors:
    colors = empty(values.size, vec3, values.device)
    launch(
        color_values_kernel if values.dtype == float32 else color_wide_values_kernel,
        values.size,
        [values, ramp, colors],
    )
    return colors


def color_coordinates(points: Points, axis: int, ramp: Ramp) -> Vectors:
    return compute(color_coordinates_kernel, points.size, [points, axis, ramp], vec3, points.device)


def color_labels(labels: AnyArray, palette: np.ndarray, noise: tuple[float, float, float]) -> tuple[Vectors, list[int]]:
    """(colors, labels present on the host): negatives as -1, those >= MAX_LABELS - 2 as that number. One sync."""
    device = labels.device
    colors, present = empty(labels.size, vec3, device), zeros(MAX_LABELS, int32, device)
    table = upload(palette, vec3, device)
    chosen = color_labels_kernel if labels.dtype == int32 else color_wide_labels_kernel
    launch(chosen, labels.size, [labels, table, len(palette), vec3(*noise), present, colors])
    return colors, (download(present).nonzero()[0] - 1).tolist()  # sync


def color_normals(normals: Vectors, missing: tuple[float, float, float]) -> tuple[Vectors, Integers]:
    """Colors of directions, and int32 (1): 1 if one was not finite."""
    colors, flag = empty(normals.size, vec3, normals.device), zeros(1, int32, normals.device)
    launch(color_normals_kernel, normals.size, [normals, vec3(*missing), flag, colors])
    return colors, flag


def sample_evenly(values: AnyArray, max_count: int) -> np.ndarray:
    """At most `max_count` evenly spaced values of a float32 or float64 device array, with the first. One sync."""
    stride = max(1, -(-values.size // max_count))
    count = -(-values.size // stride)
    out = empty(count, values.dtype, values.device)
    launch(take_every_kernel if values.dtype == float32 else take_every_wide_kernel, count, [values, stride, out])
    return download(out)  # sync
