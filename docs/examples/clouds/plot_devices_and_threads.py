"""
Devices, threads and reproducible results
=========================================

The same calls run on all cores of the CPU and on CUDA. On this page you select a device, set the number of threads, and
check that results are bitwise identical for any number of threads.
"""

import hashlib

import numpy as np
import warp as wp

import pointloom as loom
from pointloom.core.threads import get_num_threads

# %%
# Available devices
# -----------------
# ``device="auto"`` selects the GPU if there is one.
devices = ["cpu"] + [str(device) for device in wp.get_cuda_devices()]
print("devices:", devices, "| threads:", get_num_threads())
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
chosen = room.to("auto")
print("auto is", chosen.device)
assert str(chosen.device) == devices[min(1, len(devices) - 1)]


# %%
# A test pipeline
# ---------------
# The pipeline computes normals, planes and clusters. The SHA-256 digest of all results detects any difference.
def pipeline(cloud):
    """Return points, normals, plane labels, planes and clusters of a cloud."""
    thin = cloud.voxel_down_sample(0.05).estimate_normals(max_nn=20)
    labels, planes = thin.segment_planes(0.03, num_iterations=200, min_points=300, max_planes=6)
    clusters = thin.select_by_mask(labels < 0).cluster_dbscan(0.12, 8)
    return thin.points, thin.normals, labels, planes, clusters


def digest(arrays):
    """Return the SHA-256 digest of all arrays."""
    return hashlib.sha256(b"".join(np.ascontiguousarray(array).tobytes() for array in arrays)).hexdigest()[:16]


# %%
# Number of threads
# -----------------
# The digest is the same for any number of threads, since the order of summation is fixed. Tests may compare results
# bitwise, and experiments can be repeated.
before = get_num_threads()
digests = {}
for threads in (1, 2, before):
    loom.set_num_threads(threads)
    digests[f"cpu, {threads} threads"] = digest(pipeline(room))
loom.set_num_threads(before)
for name, value in digests.items():
    print(f"{name:16} {value}")
assert len(set(digests.values())) == 1

# %%
# GPU
# ---
# On the GPU, repeated runs are bitwise identical. Results on CPU and GPU agree up to rounding.
for device in devices[1:]:
    on_device = room.to(device)
    runs = [digest(pipeline(on_device)) for _ in range(2)]
    print(f"{device:16} {runs[0]}", "identical in both runs" if runs[0] == runs[1] else "DIFFERENT")
    assert runs[0] == runs[1]
    wp.synchronize()
    print(f"memory in use on {device}: {wp.get_mempool_used_mem_current(device) / 2**20:.1f} MiB")
if len(devices) == 1:
    print("no GPU available: use device='cuda:0' or cloud.to('cuda:0') on a machine with a GPU")

# %%
# Unavailable devices
# -------------------
# A cloud remains on its device, and all inputs of a call must be on the same device. An unavailable device raises an
# error with the list of available devices. There is no silent fallback.
try:
    room.to("cuda:7")
except loom.DeviceError as error:
    print("DeviceError:", error)
else:
    raise AssertionError("expected an error, since there are fewer than eight GPUs")

# %%
# Images
# ------
# Rendered images are bitwise identical on all devices.
labels = pipeline(room)[2]
thin = room.voxel_down_sample(0.05)
palette = np.array(
    [
        (0.9, 0.35, 0.2),
        (0.2, 0.55, 0.85),
        (0.3, 0.7, 0.35),
        (0.95, 0.7, 0.15),
        (0.6, 0.35, 0.75),
        (0.2, 0.7, 0.7),
        (0.82, 0.82, 0.8),
    ]
)
thin.colors = palette[labels]
low, high = room.get_min_bound(), room.get_max_bound()
without_ceiling = thin.crop(
    loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
)
view = loom.View.fit(without_ceiling.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
image = loom.render(without_ceiling, view)
second_image = loom.render(without_ceiling.to(devices[-1]), view)
print("image", digest([image]), "on", devices[-1], digest([second_image]))
assert np.array_equal(image, second_image)

# %%
# What to change
# --------------
# - ``loom.set_num_threads``: compare the run time of 1, 2 and all threads.
# - ``device``: ``"cuda:0"`` instead of ``"auto"`` raises an error on a machine without a GPU.
#
# Next
# ----
# - :doc:`Determinism and precision </determinism>`: all guarantees.
# - :doc:`GPUs </gpu>`: memory and kernel compilation.
