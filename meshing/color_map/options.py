"""What a colour map is made by: Open3D's names and defaults, checked."""

from __future__ import annotations

import dataclasses

from ...core.checks import check_count, check_positive

MOST_REACH = 64  # [px] of a boundary: beyond it little of a picture is left
MOST_ANCHORS = 256  # down a picture: every few pixels one


@dataclasses.dataclass(frozen=True, kw_only=True)
class RigidOptimizerOption:
    """How `run_rigid_optimizer` works. (Open3D's `debug_output_dir` is not there: nothing is written.)

    Args:
        maximum_iteration: Turns at most; the search ends by itself where a turn wins less than a millionth. Open3D's
            default, 0, moves no pose: colours are averaged as the poses are. 50 are enough for most.
        maximum_allowable_depth: Pixels farther away show nothing [m].
        depth_threshold_for_visibility_check: A pixel shows a vertex where their depths differ by less than this [m].
        depth_threshold_for_discontinuity_check: Slope of the depth [m] above which a pixel lies at a boundary: the sum
            of Sobel's filter, 8 times the step to the next pixel.
        half_dilation_kernel_size_for_discontinuity_map: Pixels around a boundary that show nothing either.
        image_boundary_margin: Pixels at a picture's border that are not looked at.
        invisible_vertex_color_knn: A vertex that no picture shows takes the mean colour of so many nearest ones that
            have one; 0 leaves it black.

    Raises:
        ValueError, TypeError: A number out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.color_map.RigidOptimizerOption(maximum_iteration=50).image_boundary_margin
        10
    """

    maximum_iteration: int = 0
    maximum_allowable_depth: float = 2.5
    depth_threshold_for_visibility_check: float = 0.03
    depth_threshold_for_discontinuity_check: float = 0.1
    half_dilation_kernel_size_for_discontinuity_map: int = 3
    image_boundary_margin: int = 10
    invisible_vertex_color_knn: int = 3

    def __post_init__(self):
        for name in ("maximum_iteration", "image_boundary_margin", "invisible_vertex_color_knn"):
            check_count(name, getattr(self, name), minimum=0)
        name = "half_dilation_kernel_size_for_discontinuity_map"
        check_count(name, getattr(self, name), minimum=0, maximum=MOST_REACH, because="little of a picture is left")
        for name in ("depth_threshold_for_visibility_check", "depth_threshold_for_discontinuity_check"):
            check_positive(name, getattr(self, name), allow_infinite=True)
        check_positive("maximum_allowable_depth", self.maximum_allowable_depth, allow_infinite=True)


@dataclasses.dataclass(frozen=True, kw_only=True)
class NonRigidOptimizerOption(RigidOptimizerOption):
    """How `run_non_rigid_optimizer` works: as `RigidOptimizerOption`, and each picture is bent.

    Args:
        number_of_vertical_anchors: Anchors of the grid down a picture; along it there are as many as cover it.
        non_rigid_anchor_point_weight: How strongly anchors are held at their places; times the share of the mesh's
            vertices that the picture shows.

    Raises:
        ValueError, TypeError: A number out of range.

    Example:
        >>> import pointloom as loom
        >>> loom.color_map.NonRigidOptimizerOption(maximum_iteration=50).number_of_vertical_anchors
        16
    """

    number_of_vertical_anchors: int = 16
    non_rigid_anchor_point_weight: float = 0.316

    def __post_init__(self):
        super().__post_init__()
        most = {"maximum": MOST_ANCHORS, "because": "a picture has not so many rows of detail"}
        check_count("number_of_vertical_anchors", self.number_of_vertical_anchors, minimum=2, **most)
        check_positive("non_rigid_anchor_point_weight", self.non_rigid_anchor_point_weight)
