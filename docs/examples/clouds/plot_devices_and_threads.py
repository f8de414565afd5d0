"""
Devices, threads, and the same bits
===================================

Where does it run, how many cores does it take, and is the result the same tomorrow? The same call runs on all cores
of the CPU and on CUDA; results do not depend on the number of threads, and most not on the device. Take this page
when a script moves to another machine.
"""

import hashlib

import numpy as np
import warp as wp

import pointloom as loom
from pointloom.core.threads import get_num_threads

# %%
# What is here. ``device="auto"`` takes the GPU where there is one.
devices = ["cpu"] + [str(device) for device in wp.get_cuda_devices()]
print("devices:", devices, "| threads:", get_num_threads())
room = loom.datasets.room_cloud().voxel_down_sample(0.03)
chosen = room.to("auto")
print("auto is", chosen.device)
assert str(chosen.device) == devices[min(1, len(devices) - 1)]


# %%
# A pipeline: normals, clusters, planes, a surface. Its whole result becomes one number, the SHA-256 of all bytes.
def pipeline(cloud):
    """Normals, planes and clusters of a cloud; returns them as arrays."""
    thin = cloud.voxel_down_sample(0.05).estimate_normals(max_nn=20)
    labels, planes = thin.segment_planes(0.03, num_iterations=200, min_points=300, max_planes=6)
    clusters = thin.select_by_mask(labels < 0).cluster_dbscan(0.12, 8)
    return thin.points, thin.normals, labels, planes, clusters


def digest(arrays):
    """The SHA-256 of the arrays' bytes."""
    return hashlib.sha256(b"".join(np.ascontiguousarray(array).tobytes() for array in arrays)).hexdigest()[:16]


# %%
# With one thread, with two, with all: one digest. Sums run in a fixed order, and what happens first is never what
# decides. So a test may compare results bit for bit, and an experiment can be repeated.
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
# And on the GPU, where there is one. Distances and labels agree with the CPU's to the last bit or about it; what is
# guaranteed is the same bits from run to run.
for device in devices[1:]:
    moved = room.to(device)
    runs = [digest(pipeline(moved)) for _ in range(2)]
    print(f"{device:16} {runs[0]}", "the same twice" if runs[0] == runs[1] else "DIFFERENT")
    assert runs[0] == runs[1]
    wp.synchronize()
    print(f"memory in use on {device}: {wp.get_mempool_used_mem_current(device) / 2**20:.1f} MiB")
if len(devices) == 1:
    print("no GPU here: the calls are the same, with device='cuda:0' or cloud.to('cuda:0')")

# %%
# A cloud stays where it is, and two clouds of one call lie on one device. A device that is not there is an error that
# says what there is, and nothing falls back in silence.
try:
    room.to("cuda:7")
except loom.DeviceError as error:
    print("DeviceError:", error)
else:
    raise AssertionError("there are eight GPUs?")

# %%
# Images are results too: drawn on either device they have the same bits.
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
shown = thin.crop(loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2]))
view = loom.View.fit(shown.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
image = loom.render(shown, view)
again = loom.render(shown.to(devices[-1]), view)
print("image", digest([image]), "on", devices[-1], digest([again]))
assert np.array_equal(image, again)
