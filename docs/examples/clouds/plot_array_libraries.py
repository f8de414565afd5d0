"""
Clouds from NumPy, pandas, PyTorch and CuPy, and back
=====================================================

A cloud is a table of points with named columns, and the library you already use holds its columns as well. NumPy
arrays are copied in; arrays of PyTorch, CuPy, JAX and Warp are shared, on the CPU and on the GPU, and what you ask
for comes back in their form. What is not installed here is said, and the rest runs.
"""

import importlib.util

import numpy as np
import warp as wp

import pointloom as loom

# %%
# **NumPy.** Columns are attributes, of any number type, whose rows follow the points through every operation.
rng = np.random.default_rng(0)
points = rng.uniform(-1, 1, (40_000, 3)) * [1.0, 1.0, 0.25]
cloud = loom.PointCloud(points, intensity=np.hypot(points[:, 0], points[:, 1]).astype(np.float32))
cloud["ring"] = (points[:, 2] // 0.05).astype(np.int32)
print(cloud, sorted(cloud.attributes))
bright = cloud.select_by_mask(cloud["intensity"] < 0.5)
assert bright["intensity"].max() < 0.5 and len(bright["ring"]) == len(bright)

# %%
# Masks and indices are NumPy's own, so one filters with what one knows. Colors are numbers from 0 to 1.
swirl = np.sin(8 * cloud["intensity"] + np.arctan2(points[:, 1], points[:, 0]))
cloud["swirl"] = swirl.astype(np.float32)
image = loom.render(
    {"geometry": cloud, "color_by": "swirl", "colormap": "viridis", "point_size": 3},
    loom.View.fit(points, direction=(-0.4, 0.6, -0.6), width=960, height=640),
    color_bar=True,
)

# %%
# **pandas**, and every other table that speaks columns: a dictionary there, a dictionary back.
columns = dict(zip("xyz", cloud.points.T, strict=True)) | {name: cloud[name] for name in ("intensity", "ring")}
if importlib.util.find_spec("pandas"):
    import pandas

    table = pandas.DataFrame(columns)
    nearest = table.sort_values("intensity").head(1000)
    back = loom.PointCloud(nearest[["x", "y", "z"]].to_numpy(), intensity=nearest["intensity"].to_numpy())
    print(table.groupby("ring")["intensity"].mean().round(3).to_dict())
else:
    order = np.argsort(columns["intensity"])[:1000]
    back = loom.PointCloud(
        np.column_stack([columns[axis][order] for axis in "xyz"]), intensity=columns["intensity"][order]
    )
    print("pandas is not installed: the same by NumPy")
assert len(back) == 1000 and back["intensity"].max() <= np.partition(cloud["intensity"], 999)[999]

# %%
# **Without a copy.** float32 arrays of shape [n, 3] are taken as they are: no memory moves, and the cloud sees what
# you write afterward. Shown with Warp, which is always here; torch, cupy and jax arrays are passed just the same.
warp_array = wp.array(points.astype(np.float32), dtype=wp.vec3f, device="cpu")
shared = loom.PointCloud(warp_array)
assert shared.array("points").ptr == warp_array.ptr
labels = shared.cluster_dbscan(0.05, 5)
print("labels of a cloud made of", shared.array_library, "arrays:", type(labels).__name__)
assert isinstance(labels, wp.array)

# %%
# **PyTorch, CuPy.** A tensor on the GPU stays there: the cloud lies on that device, and so do its labels, which
# select as a mask of that library. Nothing of it goes to the host. On a machine without them this cell says so.
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
# **Out again.** ``cloud.array("points")`` is the device's array, which ``torch.from_dlpack`` and its kin take;
# ``numpy.from_dlpack`` does on the CPU. ``.points`` is NumPy always.
same = np.from_dlpack(shared.array("points"))
print("DLPack gives", same.shape, same.dtype, "at the same address:", same.ctypes.data == warp_array.ptr)
assert same.ctypes.data == warp_array.ptr
assert np.array_equal(np.asarray(shared.points, np.float32), points.astype(np.float32))
