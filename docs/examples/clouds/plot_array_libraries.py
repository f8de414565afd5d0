"""
Arrays of NumPy, pandas, PyTorch and CuPy
=========================================

A point cloud is a table of points with named columns. On this page you create clouds from arrays of other libraries and
convert results back. NumPy arrays are copied. Arrays of PyTorch, CuPy, JAX and Warp are shared without a copy, on the
CPU and on the GPU, and results have the type of the input. If a library is not installed, its cell prints a message.
"""

import importlib.util

import numpy as np
import warp as wp

import pointloom as loom

# %%
# NumPy
# -----
# Columns are attributes of any numeric type. All operations preserve them.
rng = np.random.default_rng(0)
points = rng.uniform(-1, 1, (40_000, 3)) * [1.0, 1.0, 0.25]
cloud = loom.PointCloud(points, intensity=np.hypot(points[:, 0], points[:, 1]).astype(np.float32))
cloud["ring"] = (points[:, 2] // 0.05).astype(np.int32)
print(cloud, sorted(cloud.attributes))
bright = cloud.select_by_mask(cloud["intensity"] < 0.5)
assert bright["intensity"].max() < 0.5 and len(bright["ring"]) == len(bright)

# %%
# Masks and indices are NumPy arrays. Colors range from 0 to 1.
swirl = np.sin(8 * cloud["intensity"] + np.arctan2(points[:, 1], points[:, 0]))
cloud["swirl"] = swirl.astype(np.float32)
image = loom.render(
    {"geometry": cloud, "color_by": "swirl", "colormap": "viridis", "point_size": 3},
    loom.View.fit(points, direction=(-0.4, 0.6, -0.6), width=960, height=640),
    color_bar=True,
)

# %%
# pandas
# ------
# Data frames and other tables are converted column by column.
columns = dict(zip("xyz", cloud.points.T, strict=True)) | {name: cloud[name] for name in ("intensity", "ring")}
if importlib.util.find_spec("pandas"):
    import pandas

    table = pandas.DataFrame(columns)
    nearest = table.sort_values("intensity").head(1000)
    selection = loom.PointCloud(nearest[["x", "y", "z"]].to_numpy(), intensity=nearest["intensity"].to_numpy())
    print(table.groupby("ring")["intensity"].mean().round(3).to_dict())
else:
    order = np.argsort(columns["intensity"])[:1000]
    selection = loom.PointCloud(
        np.column_stack([columns[axis][order] for axis in "xyz"]), intensity=columns["intensity"][order]
    )
    print("pandas is not installed: the same with NumPy")
assert len(selection) == 1000 and selection["intensity"].max() <= np.partition(cloud["intensity"], 999)[999]

# %%
# Sharing memory
# --------------
# Arrays of Warp, PyTorch, CuPy and JAX with type float32 and shape ``(n, 3)`` are not copied. Later changes of the
# array change the cloud. The example uses Warp, which is always installed.
warp_array = wp.array(points.astype(np.float32), dtype=wp.vec3f, device="cpu")
shared = loom.PointCloud(warp_array)
assert shared.array("points").ptr == warp_array.ptr
labels = shared.cluster_dbscan(0.05, 5)
print("labels of a cloud made of", shared.array_library, "arrays:", type(labels).__name__)
assert isinstance(labels, wp.array)

# %%
# PyTorch and CuPy
# ----------------
# A tensor on the GPU remains there: the cloud uses the same device, and its labels are tensors on this device that
# select points as a mask. No data is copied to the host.
for library in ("torch", "cupy"):
    if importlib.util.find_spec(library) is None:
        print(f"{library} is not installed: pip install {library}")
        continue
    module = importlib.import_module(library)
    on_gpu = wp.is_cuda_available()
    tensor = module.asarray(points.astype(np.float32))
    if library == "torch" and on_gpu:
        tensor = tensor.to("cuda:0")
    given = loom.PointCloud(tensor)
    labels = given.cluster_dbscan(0.05, 5)
    part = given.select_by_mask(labels == 0)
    print(
        f"{library}: cloud on {given.device}, labels {type(labels).__module__} on {labels.device}, {len(part)} "
        "points in cluster 0"
    )
    assert type(labels).__module__.split(".")[0] == library

# %%
# Export
# ------
# ``cloud.array("points")`` is an array of the cloud's library without a copy, here a Warp array. On the CPU,
# ``numpy.from_dlpack`` accepts it. ``cloud.points`` is always a NumPy array.
dlpack_array = np.from_dlpack(shared.array("points"))
print(
    "DLPack gives",
    dlpack_array.shape,
    dlpack_array.dtype,
    "at the same address:",
    dlpack_array.ctypes.data == warp_array.ptr,
)
assert dlpack_array.ctypes.data == warp_array.ptr
assert np.array_equal(np.asarray(shared.points, np.float32), points.astype(np.float32))

# %%
# What to change
# --------------
# - ``on_gpu``: ``False`` keeps the tensor on the CPU.
# - The type of ``points``: float64 arrays are copied, since positions are float32 about an origin in float64.
# - ``eps`` of ``cluster_dbscan`` [m]: 0.02 instead of 0.05. How many points become noise?
#
# Next
# ----
# - :doc:`Array libraries </arrays>`: all conversions.
# - :ref:`Devices, threads and reproducible results <sphx_glr_gallery_clouds_plot_devices_and_threads.py>`
# - :ref:`Chapter 14 <sphx_glr_chapters_plot_14_robust_kernels_and_numpy.py>`: modify points with NumPy.
