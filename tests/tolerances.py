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
    "smoothed_relative": (
        1.5e-7,
        "a smoothed position is rounded once to float32: 6.0e-8 of each of three coordinates, together 1.04e-7 of the "
        "largest; weights are float32's exp, right to 1e-7 of the search radius",
    ),
    "smoothed_share": (
        0.9998,
        "neighbours whose distances are equal in float32 but not in Open3D's float64 may take each other's last place: "
        "their share was up to 1.4e-4 (LiDAR, terrain)",
    ),
    "smoothed_share_of_two": (
        0.995,
        "after two passes each point that `smoothed_share` leaves out has been a neighbour of some 12 others, and "
        "rounding to float32 between the passes adds more",
    ),
    "plane_inliers": (
        0.97,
        "of the inliers of Open3D's best of 1000 samples: two sets of random samples, of which either may be luckier; "
        "over 12 seeds the best of 1500 samples varied by 1.4 % for both",
    ),
    "plane_degrees": (1.5, "[degrees] between the planes of two sets of samples, each fitted to its own inliers"),
    "plane_overlap": (0.8, "inliers that two sets of samples share, of all that either has"),
    "plane_fit_degrees": (
        0.01,
        "[degrees] Open3D's fit minimises distances along an axis, ours those to the plane: they differ by the tilt "
        "times the ratio of the variances across and along; 0.002 were measured",
    ),
    "plane_fit_residual": (1e-9, "the sum of squared distances in float64, of up to 30,000 terms"),
    "plane_unit": (1e-12, "a unit vector of float64"),
    "intensity_relative": (
        4e-7,
        "three products, two sums and a quotient in float32 round 6 times; Open3D's compiler may order them otherwise",
    ),
    "normal_map": (
        2e-4,
        "Open3D subtracts points in float32: 1.2e-7 m of rounding at 2 m over steps of 2e-3 m between pixels, on both "
        "ends; ours are float64 until the last rounding",
    ),
    "projected_relative": (3e-7, "Open3D moves points and scales depth in float32: 4 roundings"),
    "projected_share": (
        0.9999,
        "of the pixels; points that Open3D's float32 projects onto the border of two pixels may lie in the other one",
    ),
    "depth_filter_relative": (
        1.5e-6,
        "weighted means of up to 37 depths in float32: ours about the pixel's own depth, Open3D's about zero, where "
        "each of the sums rounds",
    ),
    "distance_relative": (
        1e-6,
        "the root of a squared distance (see `sqdist_relative`) of coordinates that were rounded to float32",
    ),
    "distance_absolute": (
        1e-5,
        "[m] coordinates below 100 m rounded to float32 at both ends: 2 x 100 x 6.0e-8 a difference of two, at most",
    ),
    "moment_relative": (
        1e-7,
        "mean and covariance against the cloud's extent: the sums are float64, the coordinates rounded to float32",
    ),
    "mahalanobis_relative": (
        1e-5,
        "float32 coordinates at both ends, near the mean a difference of nearly equal numbers",
    ),
    "outlier_share": (
        2e-5,
        "float32 distances decide points whose mean distance is the threshold to 7 digits: one in 50,000 at most",
    ),
    "patch_degrees": (5.0, "[degrees] between the normals of a flat patch and Open3D's of the same place"),
    "patch_slack": (
        0.03,
        "[m] how far a patch's plane may lie from Open3D's: a few of the scan's depth steps of 5 to 10 mm; the boxes "
        "themselves are up to 0.1 m thick",
    ),
    "patch_overlap": (0.5, "the share of a patch's face in the other's, that they are the same patch"),
    "patch_area": (
        0.95,
        "of the area of the patches of one library that the other knows too; 0.978 and more were measured",
    ),
    "ground_total_error": (
        4.6,
        "[%] mean over nine tiles with known ground, of a single set of parameters; 4.42 was measured (docs/ground.md)",
    ),
    "ground_tile_error": (9.5, "[%] of the worst tile, a steep slope with vegetation and houses; 8.85 was measured"),
    "ground_kappa": (89.5, "[%] mean agreement beyond chance; 90.38 was measured"),
    "fpfh_block": (
        0.02,
        "a bin of a block of 11 that sums to 200: 1e-4 of the sum. Bins are counted exactly as float64 does; the "
        "weighted sums of 100 positive float32 terms round by 6e-6 of themselves, and one neighbour in another bin "
        "changes 1",
    ),
    "fpfh_ties": (
        2e-3,
        "the share of rows where another of several equally distant neighbours may have been taken: 0.1 % of an "
        "airborne scan whose coordinates are multiples of 0.5 m, none of the other scans",
    ),
    "eigen_feature": (
        2e-6,
        "ratios of eigenvalues, and verticality, rounded once to float32 (6e-8); covariances are float64 of the same "
        "float32 coordinates, but the cube root of three of them feels 1e-16 at zero as 5e-6, the direction of a "
        "nearly round neighbourhood 1e-15 as 1e-6",
    ),
    "covariance_relative": (
        5e-7,
        "relative to the largest entry: a difference of float32 coordinates rounds once, its square counts that twice, "
        "and the entry rounds once: 3 x 6.0e-8, doubled for entries that are a difference of two sums",
    ),
    "orientation_share": (
        0.99,
        "the share of normals on Open3D's side: edges of equal weight, and bridges between parts of the graph in place "
        "of the whole Euclidean tree, may turn a patch whose normals are noise",
    ),
    "hull_measure": (
        1e-9,
        "volume and area of a hull, relative: sums of up to some thousand float64 triangles that cancel a thousandfold "
        "and facets that Qhull merges within its own rounding",
    ),
    "hull_outside": (
        1e-10,
        "how far a point may lie outside a triangle of its hull, of the cloud's size: Qhull's facets are right to some "
        "1e-15 and triangles that are a thousandth wide as they are long have normals a thousand times less so",
    ),
    "box_volume": (
        1e-6,
        "issue: the smallest box is at most this share larger than Open3D's, which rounds its own to about 1e-7",
    ),
    "box_share": (
        1e-9,
        "[of the cloud's size] a box's extents and centre: float64 vertices turned into eigenvectors that two solvers "
        "find to 1e-15 over the gap of their eigenvalues",
    ),
}


class Tolerances:
    """The table's values by name: `tolerances.voxel_mean`."""

    def __getattr__(self, name: str) -> float:
        try:
            return TABLE[name][0]
        except KeyError:
            raise AttributeError(f"no tolerance {name!r} in tests/tolerances.py") from None
