"""Gradients of an image loss with respect to Gaussian splats, and optimizer steps.

An experiment: colors of degree 0, without densification or pruning. Reference: Kerbl et al. 2023, appendix A; Adam
(Kingma and Ba 2015). One thread per tile traverses its list from back to front, all 256 pixels at each splat, so no sum
over threads is needed. One thread per splat then adds the gradients of its tiles in the order of tiles. Results are
bitwise reproducible.
"""

# Kernels' arguments have the types of the kernel language, which pyright does not know.
# pyright: reportInvalidTypeForm=false

import numpy as np

from pointloom.kernels.algebra.exponential import exp_in_float
from pointloom.kernels.array_types import Array2, Scalars, Vectors
from pointloom.kernels.arrays.key_starts import find_key_starts
from pointloom.kernels.arrays.sort import SortKeys, put_key
from pointloom.kernels.drawing.z_buffer import View, ray_through, to_camera
from pointloom.kernels.lang import (
    array,
    dot,
    float32,
    func,
    int32,
    int64,
    kernel,
    launch,
    mat33,
    sqrt,
    struct,
    tid,
    vec3,
    vec4,
)
from pointloom.kernels.memory import empty, zeros
from pointloom.kernels.splats.blending import MIN_LEFT, opacity_at
from pointloom.kernels.splats.projection import (
    CLAMP_MARGIN,
    MAX_OPACITY,
    TILE_PIXELS,
    ProjectedSplats,
    SplatColumns,
    axes_before_camera,
    axes_of,
)
from pointloom.kernels.splats.tile_lists import TileLists, pixel_of_thread

PARAMETERS = 14  # of a splat: position, logit, logarithms of three scales, quaternion, color
DECAY, SQUARE_DECAY, EPSILON = 0.9, 0.999, 1.0e-15  # Adam's usual constants


@struct
class Light:
    """A rendered image of splats, and the data for the backward pass.

    Attributes:
        colors: vec3 [pixels].
        left: float32 [pixels], the remaining transmittance.
        ends: int32 [pixels], the end of the traversal of the tile's list.
        errors: vec3 [pixels], gradients of the loss by the colors.
    """

    colors: array(dtype=vec3)
    left: array(dtype=float32)
    ends: array(dtype=int32)
    errors: array(dtype=vec3)

    def __init__(self, lists: TileLists) -> None:
        pixels, device = lists.width * lists.height, lists.members.device
        self.colors, self.errors = zeros(pixels, vec3, device), zeros(pixels, vec3, device)
        self.left, self.ends = zeros(pixels, float32, device), zeros(pixels, int32, device)


@struct
class Pulls:
    """Gradients by projected quantities, for each splat in each tile, and scratch memory of a tile's pixels.

    Attributes:
        positions: vec3 [entries], by column, row and opacity.
        conics, colors: vec3 [entries].
        left: float32 [tiles, 256], the transmittance behind the current splat.
        behind: vec3 [tiles * 256], the color behind it.
    """

    positions: array(dtype=vec3)
    conics: array(dtype=vec3)
    colors: array(dtype=vec3)
    left: array(dtype=float32)
    behind: array(dtype=vec3)

    def __init__(self, lists: TileLists) -> None:
        entries, device = lists.members.size, lists.members.device
        self.positions, self.conics, self.colors = (zeros(entries, vec3, device) for _ in range(3))
        self.left, self.behind = empty(lists.threads, float32, device), empty(lists.threads, vec3, device)


@kernel
def light_pixels_kernel(lists: TileLists, projected: ProjectedSplats, background: vec3, light: Light):
    """Render the color of each pixel over a background."""
    i = tid()
    pixel = pixel_of_thread(i, lists)
    if pixel >= 0:
        column = float(pixel % lists.width)
        row = float(pixel // lists.width)
        color = vec3(0.0)
        left = 1.0
        entry = lists.starts[i // TILE_PIXELS]
        last = lists.starts[i // TILE_PIXELS + 1]
        while entry < last and left > MIN_LEFT:
            splat = lists.members[entry]
            opacity = opacity_at(splat, column, row, projected)
            color = color + projected.colors[splat] * (left * opacity)
            left = left * (1.0 - opacity)
            entry += 1
        light.colors[pixel] = color + background * left
        light.left[pixel] = left
        light.ends[pixel] = entry


@kernel
def compare_pixels_kernel(light: Light, target: array(dtype=vec3), weight: float):
    """Compute the gradient of the mean absolute difference."""
    i = tid()
    error = vec3(0.0)
    for channel in range(3):
        difference = light.colors[i][channel] - target[i][channel]
        error[channel] = weight if difference > 0.0 else -weight
    light.errors[i] = error


@kernel
def pull_entries_kernel(lists: TileLists, projected: ProjectedSplats, light: Light, background: vec3, pulls: Pulls):
    """Compute the gradients for each splat of each tile."""
    tile = tid()
    base = tile * TILE_PIXELS
    for k in range(TILE_PIXELS):
        pixel = pixel_of_thread(base + k, lists)
        if pixel >= 0:
            pulls.left[base + k] = light.left[pixel]
            pulls.behind[base + k] = background
    entry = lists.starts[tile + 1] - 1
    while entry >= lists.starts[tile]:
        splat = lists.members[entry]
        middle = projected.middles[splat]
        conic = projected.conics[splat]
        by_position = vec3(0.0)
        by_conic = vec3(0.0)
        by_color = vec3(0.0)
        for k in range(TILE_PIXELS):
            pixel = pixel_of_thread(base + k, lists)
            end = 0
            if pixel >= 0:
                end = light.ends[pixel]
            if entry < end:
                column = float(pixel % lists.width)
                row = float(pixel // lists.width)
                opacity = opacity_at(splat, column, row, projected)
                if opacity > 0.0:
                    left = pulls.left[base + k] / (1.0 - opacity)
                    behind = pulls.behind[base + k]
                    color = projected.colors[splat]
                    error = light.errors[pixel]
                    by_color = by_color + error * (left * opacity)
                    pulls.left[base + k] = left
                    pulls.behind[base + k] = color * opacity + behind * (1.0 - opacity)
                    if opacity < MAX_OPACITY:
                        by_opacity = dot(error, color - behind) * left
                        by_power = by_opacity * opacity
                        x = column - middle[0]
                        y = row - middle[1]
                        by_position = by_position + vec3(
                            by_power * (conic[0] * x + conic[1] * y),
                            by_power * (conic[1] * x + conic[2] * y),
                            by_opacity * opacity / projected.opacities[splat],
                        )
                        by_conic = by_conic + vec3(-0.5 * x * x, -x * y, -0.5 * y * y) * by_power
        pulls.positions[entry] = by_position
        pulls.conics[entry] = by_conic
        pulls.colors[entry] = by_color
        entry -= 1


@kernel
def key_members_kernel(members: array(dtype=int32), keys: SortKeys):
    """The splat index of each entry."""
    i = tid()
    put_key(i, int64(members[i]), keys)


@func
def pull_of_conic(conic: vec3, by_conic: vec3) -> vec3:
    """The gradient by the image covariance, from that by its inverse: -Q G Q."""
    g01 = 0.5 * by_conic[1]
    left0 = conic[0] * by_conic[0] + conic[1] * g01
    left1 = conic[0] * g01 + conic[1] * by_conic[2]
    low0 = conic[1] * by_conic[0] + conic[2] * g01
    low1 = conic[1] * g01 + conic[2] * by_conic[2]
    return vec3(
        -(left0 * conic[0] + left1 * conic[1]),
        -2.0 * (left0 * conic[1] + left1 * conic[2]),
        -(low0 * conic[1] + low1 * conic[2]),
    )


@func
def pull_of_rotation(i: int, by_axes: mat33, splats: SplatColumns) -> vec4:
    """The gradient by an unnormalized quaternion, from that by its matrix."""
    w = splats.quaternions[i, 0]
    x = splats.quaternions[i, 1]
    y = splats.quaternions[i, 2]
    z = splats.quaternions[i, 3]
    size = sqrt(w * w + x * x + y * y + z * z)
    w = w / size
    x = x / size
    y = y / size
    z = z / size
    g = by_axes
    by_w = 2.0 * (x * (g[2, 1] - g[1, 2]) + y * (g[0, 2] - g[2, 0]) + z * (g[1, 0] - g[0, 1]))
    by_x = 2.0 * (y * (g[0, 1] + g[1, 0]) + z * (g[0, 2] + g[2, 0]) + w * (g[2, 1] - g[1, 2]))
    by_x = by_x - 4.0 * x * (g[1, 1] + g[2, 2])
    by_y = 2.0 * (x * (g[0, 1] + g[1, 0]) + z * (g[1, 2] + g[2, 1]) + w * (g[0, 2] - g[2, 0]))
    by_y = by_y - 4.0 * y * (g[0, 0] + g[2, 2])
    by_z = 2.0 * (x * (g[0, 2] + g[2, 0]) + y * (g[1, 2] + g[2, 1]) + w * (g[1, 0] - g[0, 1]))
    by_z = by_z - 4.0 * z * (g[0, 0] + g[1, 1])
    along = by_w * w + by_x * x + by_y * y + by_z * z
    return vec4((by_w - along * w) / size, (by_x - along * x) / size, (by_y - along * y) / size,
                (by_z - along * z) / size)  # fmt: skip


@kernel
def pull_splats_kernel(
    splats: SplatColumns,
    view: View,
    projected: ProjectedSplats,
    order: array(dtype=int32),
    starts: array(dtype=int32),
    pulls: Pulls,
    gradients: array(dtype=float32, ndim=2),
):
    """Compute the gradient by each parameter of each splat."""
    i = tid()
    by_position = vec3(0.0)
    by_conic = vec3(0.0)
    by_color = vec3(0.0)
    for row in range(starts[i], starts[i + 1]):
        by_position = by_position + pulls.positions[order[row]]
        by_conic = by_conic + pulls.conics[order[row]]
        by_color = by_color + pulls.colors[order[row]]
    for column in range(PARAMETERS):
        gradients[i, column] = 0.0
    if starts[i + 1] > starts[i]:
        q = to_camera(splats.points[i], view)
        axes = axes_before_camera(axes_of(i, splats), view.rotation, 1.0)
        scales = vec3(exp_in_float(splats.scales[i, 0]), exp_in_float(splats.scales[i, 1]),
                      exp_in_float(splats.scales[i, 2]))  # fmt: skip
        fx = float(view.camera.fx)
        fy = float(view.camera.fy)
        left = ray_through(-CLAMP_MARGIN * float(view.camera.width), -CLAMP_MARGIN * float(view.camera.height), view)
        right = ray_through(
            (1.0 + CLAMP_MARGIN) * float(view.camera.width), (1.0 + CLAMP_MARGIN) * float(view.camera.height), view
        )
        x = min(max(q[0] / q[2], left[0]), right[0])
        y = min(max(q[1] / q[2], left[1]), right[1])
        spread = pull_of_conic(projected.conics[i], by_conic)
        by_camera_axes = mat33(0.0)
        by_x = 0.0
        by_y = 0.0
        by_depth = 0.0
        for k in range(3):
            across = (axes[0, k] - x * axes[2, k]) * scales[k] * (fx / q[2])
            down = (axes[1, k] - y * axes[2, k]) * scales[k] * (fy / q[2])
            by_across = 2.0 * spread[0] * across + spread[1] * down
            by_down = 2.0 * spread[2] * down + spread[1] * across
            size_across = by_across * scales[k] * (fx / q[2])
            size_down = by_down * scales[k] * (fy / q[2])
            by_camera_axes[0, k] = size_across
            by_camera_axes[1, k] = size_down
            by_camera_axes[2, k] = -(x * size_across + y * size_down)
            by_x = by_x - axes[2, k] * size_across
            by_y = by_y - axes[2, k] * size_down
            by_depth = by_depth - (by_across * across + by_down * down) / q[2]
            gradients[i, 4 + k] = by_across * across + by_down * down
        if x != q[0] / q[2]:
            by_x = 0.0
        if y != q[1] / q[2]:
            by_y = 0.0
        by_x = by_x + by_position[0] * fx
        by_y = by_y + by_position[1] * fy
        by_q = vec3(by_x / q[2], by_y / q[2], by_depth - (by_x * q[0] + by_y * q[1]) / (q[2] * q[2]))
        by_axes = mat33(0.0)
        for k in range(3):
            for row in range(3):
                total = 0.0
                for m in range(3):
                    total = total + view.rotation[m, row] * by_camera_axes[m, k]
                by_axes[row, k] = total
            gradients[i, k] = (
                view.rotation[0, k] * by_q[0] + view.rotation[1, k] * by_q[1] + view.rotation[2, k] * by_q[2]
            )
            if projected.colors[i][k] > 0.0:
                gradients[i, 11 + k] = by_color[k] * splats.sizes[0]
        by_rotation = pull_of_rotation(i, by_axes, splats)
        for k in range(4):
            gradients[i, 7 + k] = by_rotation[k]
        opacity = projected.opacities[i]
        gradients[i, 3] = by_position[2] * opacity * (1.0 - opacity)


@kernel
def step_splats_kernel(
    gradients: array(dtype=float32, ndim=2),
    rates: array(dtype=float32),
    means: array(dtype=float32, ndim=2),
    squares: array(dtype=float32, ndim=2),
    mean_fraction: float,
    square_fraction: float,
    splats: SplatColumns,
):
    """One step of Adam for each splat."""
    i = tid()
    position = splats.points[i]
    for k in range(PARAMETERS):
        gradient = gradients[i, k]
        means[i, k] = DECAY * means[i, k] + (1.0 - DECAY) * gradient
        squares[i, k] = SQUARE_DECAY * squares[i, k] + (1.0 - SQUARE_DECAY) * gradient * gradient
        step = rates[k] * (means[i, k] / mean_fraction) / (sqrt(squares[i, k] / square_fraction) + EPSILON)
        if k < 3:
            position[k] = position[k] - step
        elif k == 3:
            splats.opacities[i] = splats.opacities[i] - step
        elif k < 7:
            splats.scales[i, k - 4] = splats.scales[i, k - 4] - step
        elif k < 11:
            splats.quaternions[i, k - 7] = splats.quaternions[i, k - 7] - step
        else:
            splats.first[i, k - 11] = splats.first[i, k - 11] - step
    splats.points[i] = position


def light_pixels(lists: TileLists, projected: ProjectedSplats, background: vec3) -> Light:
    """Render splats over a background."""
    light = Light(lists)
    launch(light_pixels_kernel, lists.threads, [lists, projected, background, light])
    return light


def find_gradients(
    splats: SplatColumns, view: View, lists: TileLists, projected: ProjectedSplats, light: Light, background: vec3
) -> Array2[float32]:
    """Gradients by the parameters of splats, float32 [n, 14], from `light.errors`."""
    count, device = splats.points.size, splats.points.device
    pulls = Pulls(lists)
    launch(pull_entries_kernel, lists.tile_count, [lists, projected, light, background, pulls])
    keys = SortKeys(lists.members.size, device)
    launch(key_members_kernel, lists.members.size, [lists.members, keys])
    by_splat, order = keys.sort(max(count.bit_length(), 1))
    starts = empty(count + 1, int32, device)
    find_key_starts(by_splat, starts)
    gradients = empty((count, PARAMETERS), float32, device)
    launch(pull_splats_kernel, count, [splats, view, projected, order, starts, pulls, gradients])
    return gradients


class Adam:
    """The Adam optimizer.

    Args:
        splats: Modified in place.
        rates: float32 [14], the step size of each parameter.
    """

    def __init__(self, splats: SplatColumns, rates: Scalars) -> None:
        count, device = splats.points.size, splats.points.device
        self.splats, self.rates, self.iteration = splats, rates, 0
        self.means, self.squares = (zeros((count, PARAMETERS), float32, device) for _ in range(2))

    def step(self, gradients: Array2[float32]) -> None:
        """Make one step."""
        self.iteration += 1
        fractions = 1 - DECAY**self.iteration, 1 - SQUARE_DECAY**self.iteration
        arrays = [gradients, self.rates, self.means, self.squares, *fractions, self.splats]
        launch(step_splats_kernel, self.splats.points.size, arrays)


def compare_pixels(light: Light, target: Vectors) -> None:
    """Fill `light.errors` with the gradient of the mean absolute color difference."""
    pixels = target.size
    launch(compare_pixels_kernel, pixels, [light, target, float(np.float32(1 / (3 * pixels)))])
