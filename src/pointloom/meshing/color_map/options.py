"""Options of color map optimization, with Open3D's names and defaults, and of textures from images."""

from __future__ import annotations

import dataclasses

from numpy.typing import ArrayLike

from ...cameras.depth_range import UNLIMITED_DEPTH
from ...core.checks import check_color, check_count, check_positive

MAX_KERNEL_HALF_SIZE = 64  # [px] around a boundary: beyond it little of an image remains
MAX_ANCHORS = 256  # rows: one every few pixels
MAX_SMOOTHNESS = 1000.0
UNSEEN_COLOR = (0.5, 0.5, 0.5)


@dataclasses.dataclass(frozen=True, kw_only=True)
class ColorMapOption:
    """Options of `optimize_color_map`. Open3D's `debug_output_dir` is not supported.

    Args:
        maximum_iteration: Maximum; stops below a gain of 1e-6. 0 (Open3D's default) moves no pose. 50 usually suffice.
        maximum_allowable_depth: Maximum depth of used pixels [m].
        depth_threshold_for_visibility_check: Maximum depth difference of pixel and visible vertex [m].
        depth_threshold_for_discontinuity_check: Sobel response of the depth [m] at boundaries, 8 times the step.
        half_dilation_kernel_size_for_discontinuity_map: Ignored pixels around a boundary.
        image_boundary_margin: Ignored pixels at the image border.
        invisible_vertex_color_knn: Nearest colored vertices averaged for unseen ones. 0 leaves them black.
        number_of_vertical_anchors: Rows of the anchor grid of a warp. Columns follow from the aspect ratio.
        non_rigid_anchor_point_weight: Weight of the anchors' regularization, times the fraction of visible vertices.

    Raises:
        ValueError, TypeError: If a number is out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.meshing.ColorMapOption(maximum_iteration=50).image_boundary_margin
        10
    """

    maximum_iteration: int = 0
    maximum_allowable_depth: float = 2.5
    depth_threshold_for_visibility_check: float = 0.03
    depth_threshold_for_discontinuity_check: float = 0.1
    half_dilation_kernel_size_for_discontinuity_map: int = 3
    image_boundary_margin: int = 10
    invisible_vertex_color_knn: int = 3
    number_of_vertical_anchors: int = 16
    non_rigid_anchor_point_weight: float = 0.316

    def __post_init__(self):
        for name in ("maximum_iteration", "image_boundary_margin", "invisible_vertex_color_knn"):
            check_count(name, getattr(self, name), minimum=0)
        name = "half_dilation_kernel_size_for_discontinuity_map"
        check_count(
            name,
            getattr(self, name),
            minimum=0,
            maximum=MAX_KERNEL_HALF_SIZE,
            because="larger kernels mask most of the image",
        )
        for name in ("depth_threshold_for_visibility_check", "depth_threshold_for_discontinuity_check"):
            check_positive(name, getattr(self, name), allow_infinite=True)
        check_positive("maximum_allowable_depth", self.maximum_allowable_depth, allow_infinite=True)
        limit = {"maximum": MAX_ANCHORS, "because": "images do not have more rows of detail"}
        check_count("number_of_vertical_anchors", self.number_of_vertical_anchors, minimum=2, **limit)
        check_positive("non_rigid_anchor_point_weight", self.non_rigid_anchor_point_weight)


@dataclasses.dataclass(frozen=True, kw_only=True)
class ImageTextureOption:
    """Options of `texture_from_images`.

    Args:
        smoothness: Cost of an edge between two images, relative to the value of a triangle's best image.
        outliers: Ignore images where a triangle's color differs from most of at least four.
        exposures: First equalize exposure and vignetting per channel by shared triangles.
        seam_leveling: Shift the colors of charts at vertices to agree at seams.
        local_leveling: Blend strips of 20 texels beside seams.
        depth_max: Maximum distance of a usable image [unit of the poses].
        plain: Color of unseen triangles without vertex colors, 0..1.

    Raises:
        ValueError, TypeError: If a number or a color is out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.meshing.ImageTextureOption(exposures=False, depth_max=3.0).smoothness
        1.0
    """

    smoothness: float = 1.0
    outliers: bool = True
    exposures: bool = True
    seam_leveling: bool = True
    local_leveling: bool = True
    depth_max: float = UNLIMITED_DEPTH
    plain: ArrayLike = UNSEEN_COLOR

    def __post_init__(self):
        check_positive("smoothness", self.smoothness, allow_zero=True, maximum=MAX_SMOOTHNESS)
        check_positive("depth_max", self.depth_max, allow_infinite=True)
        check_color("plain", self.plain)
