"""Every tolerance of the tests of kernels and point clouds, and why it is as large as it is.

float32 rounds by 6.0e-8 of a number (half a unit in the last place), float64 by 1.1e-16.
"""

from __future__ import annotations

TABLE: dict[str, tuple[float, str]] = {
    "sqdist_relative": (
        6e-7,
        "squared distance in float32 of float32 coordinates: a difference, its square and two sums round 4 times, the "
        "difference's error counts twice; 5 x 6.0e-8, doubled for the products that CUDA fuses",
    ),
    "sqdist_absolute": (
        4e-38,
        "[m^2] three squares below the normal float32 numbers (1.2e-38) count as zero in threads that flush them, as "
        "Taichi's do: points 1e-19 m apart are one",
    ),
    "query_relative": (
        2e-7,
        "a coordinate is rounded once to float32 relative to the origin: 6.0e-8 of it on each axis, on both ends",
    ),
    "float32_relative": (6.1e-8, "one rounding to float32"),
    "position": (
        1e-3,
        "[m] what the class promises for any cloud that lies within 10 km of its own middle: 1e4 x 6.0e-8",
    ),
    "normal_dot": (
        0.9999,
        "issue 2: |dot| with Open3D above this (0.8 degrees) for 99.9 % of points; what remains are near-isotropic "
        "neighbourhoods, where both answers are right",
    ),
    "normal_share": (0.999, "issue 2: the share of normals that must reach `normal_dot`"),
    "unit_length": (2e-7, "three components rounded to float32, each by 6.0e-8 of at most 1"),
    "eigen_residual": (
        1e-14,
        "|A v - lambda v| / |A| of a non-iterative float64 solver: some 150 operations at 1.1e-16 each",
    ),
    "eigenvalue_relative": (
        2e-14,
        "the Rayleigh quotient of the vector found, against LAPACK's smallest eigenvalue, relative to |A|; both round",
    ),
    "voxel_mean": (
        3e-7,
        "[m] the mean is summed in float64 and rounded once to float32 at coordinates below 4 m: 4 x 6.0e-8; Open3D's "
        "is float64 of the same float32 input",
    ),
    "voxel_attribute": (6.1e-8, "colours and normals lie within 1 and are rounded once to float32"),
    "image_relative": (
        3e-7,
        "Open3D divides the raw depth in float32 and unprojects in float64; ours rounds the depth and then the point "
        "to float32, and an extrinsic adds a few float64 roundings: up to 4 x 6.0e-8",
    ),
    "image_absolute": (5e-7, "[m] as `image_relative`, where a coordinate is near zero but the depth is up to 4 m"),
    "color_8bit": (1.0 / 510 + 1e-6, "files that hold 8 bits a channel round by half of 1/255"),
    "text_relative": (
        1e-15,
        "text holds the shortest digits that give the same number, so only the parser could round",
    ),
    "transform_relative": (
        1e-7,
        "float64 arithmetic, then one rounding to float32 relative to the new origin",
    ),
}


class Tolerances:
    """The table's values by name: `tolerances.voxel_mean`."""

    def __getattr__(self, name: str) -> float:
        try:
            return TABLE[name][0]
        except KeyError:
            raise AttributeError(f"no tolerance {name!r} in tests/tolerances.py") from None
