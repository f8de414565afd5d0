"""
An operator of one's own
========================

Where no operation does what you need, write it: a kernel is a Python function that runs once per point, compiled
for CUDA and for all cores of the CPU from one text. Here it is the *roughness* of a surface: how far each point lies
from the mean of what surrounds it. You learn what a kernel may hold, how it searches for neighbors, how it is
launched on either device, and how to show that it is right.
"""

# %%
# The words of the kernel language come from one module, whatever the device. Everything else of pointloom that a
# kernel may use (searches, small matrices, sorts) lies in the rooms that ``kernels/README.md`` lists. These
# modules are no public names: they may change from one minor version to the next, so pin the version where you
# build on them.

import numpy as np

import pointloom as loom
from pointloom.kernels.lang import array, float32, func, int32, kernel, launch, length, tid, vec3
from pointloom.kernels.memory import download, full, zeros
from pointloom.kernels.search.bucket_walk import points_within
from pointloom.kernels.search.point_tree import BUCKET, PointTree

# %%
# The kernel
# ----------
#
# ``tid()`` is the number of the thread, here of a point in the order of the search tree: points that lie side by
# side in space have numbers side by side, so that threads share what they read. ``points_within`` loops over
# the neighbors. The tree is one parameter, a structure; only the fields that the kernel uses travel.
#
# A thread writes its own elements and nobody else's, so the result is the same bits for any number of threads. A
# variable keeps the type of its first value: ``count = 0`` is a whole number, ``total = vec3(0.0)`` a vector of
# float32.


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
    row = tree.order[i]  # the point's place in the cloud
    counts[row] = count
    roughness[row] = distance_from_mean(p, total, count)


# %%
# The function around it
# ----------------------
#
# It checks, allocates where the cloud lies, launches one thread per point, and returns. The search tree is the
# cloud's own: it is built at the first search and kept.


def measure_roughness(cloud: loom.PointCloud, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Roughness [m] of each point and how many points lie within `radius` [m] of it."""
    if not radius > 0:
        raise ValueError(f"radius: expected a number above 0, got {radius}")
    tree = cloud.search_tree()
    roughness = full(
        len(cloud), np.nan, float32, cloud.device
    )  # NaN stays where a point is not finite: no tree holds it
    counts = zeros(len(cloud), int32, cloud.device)
    launch(measure_roughness_kernel, tree.count, [float(radius), tree, roughness, counts])
    return download(roughness), download(counts)


# %%
# Is it right?
# ------------
#
# A surface whose answer is known: a plane with a bump, 4 cm high and 10 cm wide, and one patch of noise. NumPy
# gives the same answer for some points the slow way; an operator of yours deserves the same.

rng = np.random.default_rng(0)
y, x = np.mgrid[-0.5:0.5:300j, -0.5:0.5:300j].reshape(2, -1) + rng.uniform(-0.001, 0.001, (2, 90_000))
z = 0.04 * np.exp(-((x + 0.2) ** 2 + y**2) / 0.05**2)
noisy = (np.abs(x - 0.25) < 0.1) & (np.abs(y) < 0.1)
z[noisy] += rng.normal(0.0, 0.004, noisy.sum())
cloud = loom.PointCloud(np.column_stack([x, y, z]))

radius = 0.02  # [m]: some 110 neighbors here; take a radius in which 20 to 100 points of your scan lie
roughness, counts = measure_roughness(cloud, radius)

some = rng.integers(0, len(cloud), 50)
points = cloud.points
for row in some:
    near = np.linalg.norm(points - points[row], axis=1) <= radius
    assert abs(int(near.sum()) - counts[row]) <= 1  # a point on the very edge may fall either way in float32
    expected = np.linalg.norm(points[row] - points[near].mean(axis=0))
    assert abs(expected - roughness[row]) < 1e-3

inside = (np.abs(x) < 0.45) & (np.abs(y) < 0.45)  # neighborhoods at the rim are cut off
calm, rough = np.median(roughness[inside & ~noisy]), np.median(roughness[inside & noisy])
print(
    f"{counts.mean():.0f} neighbors a point; roughness {1000 * calm:.2f} mm, {1000 * rough:.2f} mm in the noisy patch"
)
assert rough > 5 * calm

# %%
# As an attribute the answer travels with the cloud through every operation, is written to files, and colors a
# image.

cloud["roughness"] = roughness
eye = {"front": [0.2, -0.7, 0.65], "lookat": [0.04, -0.06, 0.0], "up": [0.0, 0.0, 1.0], "zoom": 0.62}
shown = {"name": "roughness [m]", "geometry": cloud, "color_by": "roughness", "point_size": 3.0}
image = loom.render([shown], eye, size=(960, 640), color_bar=True)

# %%
# On the other device
# -------------------
#
# ``cloud.to("cuda:0")`` moves the cloud, and the same function compiles the same kernel for the GPU. Sums run in
# the order of the walk, which is the device's own, so answers agree to rounding and not to the bit. Where there
# is no GPU nothing is lost: ``make test-cuda-emulated`` runs kernels as CUDA compiles them on an emulated one.

try:
    moved = cloud.to("cuda:0")
except loom.DeviceError as error:
    print(f"no GPU here: {error}")
else:
    on_gpu, counts_on_gpu = measure_roughness(moved, radius)
    assert np.abs(counts_on_gpu - counts).max() <= 1 and np.abs(on_gpu - roughness).max() < 1e-3
    print(f"on {moved.device}: at most {1e6 * np.abs(on_gpu - roughness).max():.2f} micrometres apart")

# %%
# What a kernel may hold, in short: arithmetic, ``if``, ``for`` over ranges and walks, vectors and small matrices,
# calls of ``@func``. No lists, no strings, no closures, no ``return`` of a value. What breaks a rule is refused
# with its file and line when the function is decorated. The whole list of rules, with their reasons:
# :doc:`/project/contributing`; what there is to build from: :doc:`/project/kernels`.
