"""
Write your own GPU operator
===========================

A kernel is a Python function that runs once per point, compiled for CUDA and for all cores of the CPU from one source.
On this page you write a kernel with a neighbor search, launch it on both devices, and verify it. The example is the
*roughness* of a surface: the distance of each point from the mean of its neighbors.
"""

# %%
# The kernel language is defined in one module for all devices. Kernels can also use the modules listed in
# ``kernels/README.md``: searches, small matrices, sorting. These modules are not public and may change in minor
# versions. Pin the version of pointloom if you depend on them.

import numpy as np

import pointloom as loom
from pointloom.kernels.lang import array, float32, func, int32, kernel, launch, length, tid, vec3
from pointloom.kernels.memory import download, full, zeros
from pointloom.kernels.search.bucket_walk import points_within
from pointloom.kernels.search.point_tree import BUCKET, PointTree

# %%
# The kernel
# ----------
# ``tid()`` is the index of the thread, here the index of a point in the order of the search tree. Adjacent points have
# adjacent indices, so threads read the same memory. ``points_within`` iterates over the neighbors. The tree is a single
# parameter, a structure. Only the fields that the kernel uses are passed.
#
# Each thread writes its own elements only, so the result is bitwise identical for any number of threads. A variable
# keeps the type of its first value: ``count = 0`` is an integer, ``total = vec3(0.0)`` a float32 vector.


@func
def distance_from_mean(p: vec3, total: vec3, count: int) -> float:
    """Distance [m] of a point from the mean of `count` points with this sum."""
    return length(p - total / float(count))


@kernel
def measure_roughness_kernel(
    radius: float, tree: PointTree, roughness: array(dtype=float32), counts: array(dtype=int32)
):
    """Each point's distance from the mean of the points within `radius` [m], itself included, and their number."""
    i = tid()
    p = tree.points[i]
    total = vec3(0.0)
    count = 0
    for j, _ in points_within(i // BUCKET, p, radius * radius, tree):
        total += tree.points[j]
        count += 1
    row = tree.order[i]  # the index of the point in the cloud
    counts[row] = count
    roughness[row] = distance_from_mean(p, total, count)


# %%
# The host function
# -----------------
# The function checks its arguments, allocates memory on the device of the cloud, and launches one thread per point. The
# search tree is built at the first search and cached by the cloud.


def measure_roughness(cloud: loom.PointCloud, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Roughness [m] of each point and the number of points within `radius` [m] of it."""
    if not radius > 0:
        raise ValueError(f"radius: expected a number above 0, got {radius}")
    tree = cloud.search_tree()
    roughness = full(len(cloud), np.nan, float32, cloud.device)  # NaN for non-finite points, which are not in the tree
    counts = zeros(len(cloud), int32, cloud.device)
    launch(measure_roughness_kernel, tree.count, [float(radius), tree, roughness, counts])
    return download(roughness), download(counts)


# %%
# Verify the result
# -----------------
# The test surface is a plane with a bump 4 cm high and 10 cm wide, and a region with noise. The result is compared with
# brute force in NumPy for some points. Write such a test for each of your operators.

rng = np.random.default_rng(0)
y, x = np.mgrid[-0.5:0.5:300j, -0.5:0.5:300j].reshape(2, -1) + rng.uniform(-0.001, 0.001, (2, 90_000))
z = 0.04 * np.exp(-((x + 0.2) ** 2 + y**2) / 0.05**2)
noisy = (np.abs(x - 0.25) < 0.1) & (np.abs(y) < 0.1)
z[noisy] += rng.normal(0.0, 0.004, noisy.sum())
cloud = loom.PointCloud(np.column_stack([x, y, z]))

radius = 0.02  # [m]: about 110 neighbors here, use 20 to 100
roughness, counts = measure_roughness(cloud, radius)

some = rng.integers(0, len(cloud), 50)
points = cloud.points
for row in some:
    is_neighbor = np.linalg.norm(points - points[row], axis=1) <= radius
    assert (
        abs(int(is_neighbor.sum()) - counts[row]) <= 1
    )  # float32 rounding may include or exclude a point at the radius
    expected = np.linalg.norm(points[row] - points[is_neighbor].mean(axis=0))
    assert abs(expected - roughness[row]) < 1e-3

inside = (np.abs(x) < 0.45) & (np.abs(y) < 0.45)  # neighborhoods at the border are incomplete
calm, rough = np.median(roughness[inside & ~noisy]), np.median(roughness[inside & noisy])
print(
    f"{counts.mean():.0f} neighbors a point; roughness {1000 * calm:.2f} mm, {1000 * rough:.2f} mm in the noisy patch"
)
assert rough > 5 * calm

# %%
# As an attribute, the result is preserved by all operations, stored in files, and displayed as a color.

cloud["roughness"] = roughness
view_options = {"front": [0.2, -0.7, 0.65], "lookat": [0.04, -0.06, 0.0], "up": [0.0, 0.0, 1.0], "zoom": 0.62}
style = {"name": "roughness [m]", "geometry": cloud, "color_by": "roughness", "point_size": 3.0}
image = loom.render([style], view_options, size=(960, 640), color_bar=True)

# %%
# The GPU
# -------
# ``cloud.to("cuda:0")`` moves the cloud, and the same function compiles the kernel for the GPU. The order of summation
# depends on the device, so results agree up to rounding. On machines without a GPU, ``make test-cuda-emulated`` runs
# the kernels on an emulated CUDA device.

try:
    moved = cloud.to("cuda:0")
except loom.DeviceError as error:
    print(f"no GPU available: {error}")
else:
    on_gpu, counts_on_gpu = measure_roughness(moved, radius)
    assert np.abs(counts_on_gpu - counts).max() <= 1 and np.abs(on_gpu - roughness).max() < 1e-3
    print(f"on {moved.device}: difference at most {1e6 * np.abs(on_gpu - roughness).max():.2f} micrometers")

# %%
# A kernel may contain arithmetic, ``if``, ``for`` over ranges and traversals, vectors, small matrices, and calls of
# ``@func`` functions. It may not contain lists, strings, closures, or ``return`` with a value. Violations raise an
# error with file and line when the function is decorated.
#
# What to change
# --------------
# - ``radius`` [m]: a larger value measures the roughness at a larger scale, and takes longer.
# - ``distance_from_mean``: return the squared distance instead, or the distance along the normal.
# - The size of the test cloud: 90,000 points. Compare the run time on CPU and GPU.
#
# Next
# ----
# - :doc:`/project/contributing`: all rules of the kernel language.
# - :doc:`/project/kernels`: the available building blocks.
# - :ref:`Neighbor search for all points at once <sphx_glr_gallery_clouds_plot_neighbor_search.py>`: neighbor search
#   without a kernel.
