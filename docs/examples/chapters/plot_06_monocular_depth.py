"""
6. Depth from a single photograph
=================================

A monocular depth network estimates the depth of each pixel from one image. In this chapter you run such a network, find
out whether its output is metric, align it to known distances, measure its error, and convert it to a point cloud. The
network is an ONNX file that you provide. pointloom does not download models.
"""

# %%
# A substitute for the network
# ----------------------------
# **This chapter does not contain a real network.** Networks such as Depth Anything V2, MiDaS and Metric3D are files of
# 50 MB and more, published by their authors. So that the chapter runs without them, the script writes an ONNX file that
# returns a stored depth map for any input. The stored map has typical errors of networks. All later steps are the same
# with a real file. The accuracy in this chapter does not describe any network.
#
# Like MiDaS and Depth Anything, the substitute returns **relative inverse depth**: close surfaces have large values,
# and 1 / depth = scale x d + shift with unknown scale and shift.
#
# This chapter requires ``pip install "pointloom[depth]"``.

import tempfile
from pathlib import Path

import numpy as np
import onnx
from onnx import helper, numpy_helper

import pointloom as loom
from pointloom.photogrammetry.depth.evaluation import evaluate_depth

SIDE = 384  # MiDaS uses 384 x 384 pixels for all image sizes

frame = loom.datasets.room_frames(24, noise=False)[20]
truth = frame.depth  # ground truth in meters, used to measure errors


def simulated_output(depth: np.ndarray) -> np.ndarray:
    """Inverse depth, float32 (384, 384): resized, blurred, with unknown scale and shift and a smooth error of 2 %."""
    rows = np.linspace(0, depth.shape[0] - 1, SIDE).round().astype(int)
    columns = np.linspace(0, depth.shape[1] - 1, SIDE).round().astype(int)
    inverse = 1 / depth[np.ix_(rows, columns)].astype(np.float64)
    v, u = np.mgrid[:SIDE, :SIDE] / SIDE
    inverse *= 1 + 0.02 * np.sin(5 * u + 1) * np.cos(4 * v)
    for _ in range(2):  # mean of 3 x 3 pixels: blurred edges, as in the output of networks
        padded = np.pad(inverse, 1, mode="edge")
        inverse = sum(padded[i : i + SIDE, j : j + SIDE] for i in range(3) for j in range(3)) / 9
    return (700 * inverse + 60).astype(np.float32)


def write_substitute(path: Path, answer: np.ndarray) -> None:
    """Write an ONNX file that returns `answer` for any image. Its last layer is a ReLU, as in MiDaS."""
    nodes = [
        helper.make_node("Mul", ["image", "zero"], ["nothing"]),
        helper.make_node("ReduceMean", ["nothing"], ["blank"], axes=[1], keepdims=0),
        helper.make_node("Add", ["blank", "answer"], ["sum"]),
        helper.make_node("Relu", ["sum"], ["depth"]),
    ]
    ends = [
        helper.make_tensor_value_info("image", onnx.TensorProto.FLOAT, [1, 3, SIDE, SIDE]),
        helper.make_tensor_value_info("depth", onnx.TensorProto.FLOAT, [1, SIDE, SIDE]),
    ]
    values = [numpy_helper.from_array(np.float32(0), "zero"), numpy_helper.from_array(answer[None], "answer")]
    graph = helper.make_graph(nodes, "stand_in", ends[:1], ends[1:], values)
    onnx.save(helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8), str(path))


folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
write_substitute(folder / "stand_in.onnx", simulated_output(truth))

# %%
# Run the network
# ---------------
# ``preset`` selects the type of network: input size, normalization of colors, and meaning of the output. The page
# :doc:`Monocular depth </depth>` lists all presets and the licenses of their weights. Open3D has no equivalent. Its
# users call OpenCV or PyTorch.

model = loom.photogrammetry.DepthModel(folder / "stand_in.onnx", preset="midas-v2.1-onnx")
unaligned = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic)
print(unaligned)
print("unit:", unaligned.unit, " in meters:", unaligned.is_metric, " camera:", unaligned.intrinsic_source)
assert not unaligned.is_metric

# %%
# Without known distances the unit is **arbitrary**: the closest pixel is assigned depth 1, the farthest 10. This is
# sufficient to blur the background of a portrait. The point cloud is distorted, since the shift is unknown: planar
# walls become curved.
#
# Align to known distances
# ------------------------
# Two known distances determine scale and shift. Measure them with a tape, and enter column, row and distance in meters.
# With only two, errors cannot be detected, and ``inlier_fraction`` is None. It is the fraction of references that agree
# with the fit.


def at(column: int, row: int) -> tuple[int, int, float]:
    """Column, row and measured depth [m], rounded to 1 cm."""
    return column, row, round(float(truth[row, column]), 2)


references = np.array([at(60, 60), at(160, 150), at(260, 200), at(40, 210), at(280, 60)])
print(references)
measured = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=references)
has_inlier_fraction = measured.inlier_fraction is not None
print(
    "unit:",
    measured.unit,
    " references that agree:",
    f"{measured.inlier_fraction:.0%}" if has_inlier_fraction else "not available",
)

two = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=references[:2])
print("with two distances:", two.inlier_fraction)
assert has_inlier_fraction and two.inlier_fraction is None

# %%
# References can also come from a depth camera with the same view, even if its depth is sparse, or from a sparse COLMAP
# model (chapter 9). The reference depth must be in meters. ``loom.read_depth`` returns stored values, usually 16-bit
# millimeters: divide them by 1000.

sensor = loom.datasets.room_frames(24)[20].depth
rng = np.random.default_rng(0)
sparse = np.where(rng.random(sensor.shape) < 0.02, sensor, 0.0).astype(np.float32)
fitted = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=sparse)
print(f"{fitted.references} references, {fitted.inlier_fraction:.0%} agree")
assert fitted.is_metric and fitted.inlier_fraction > 0.9

# %%
# Measure the error
# -----------------
# ``evaluate_depth`` computes the metrics of the literature. ``abs_rel`` is the mean of ``abs(z - true) / true``: 0.05
# is an error of 5%. ``delta1`` is the fraction of pixels with a ratio below 1.25. Both metrics assume **metric** depth,
# so a result with an arbitrary unit has large errors even if its shape is accurate.

results = {"unaligned": unaligned, "five distances": measured, "depth camera": fitted}
for name, estimate in results.items():
    errors = evaluate_depth(estimate.depth, truth)
    print(f"{name:14} abs_rel {errors.abs_rel:.3f}, rmse {errors.rmse:.3f} m, within 25 %: {errors.delta1:.1%}")

scores = {name: evaluate_depth(estimate.depth, truth).abs_rel for name, estimate in results.items()}
assert scores["depth camera"] < 0.03 and scores["five distances"] < 0.06
assert scores["unaligned"] > 5 * scores["depth camera"]

# %%
# Convert to a point cloud
# ------------------------
# At depth discontinuities, the output of networks changes gradually over several pixels. These pixels would become
# points between two surfaces. ``to_point_cloud`` removes them.

cloud = fitted.to_point_cloud()
with_edges = fitted.to_point_cloud(keep_edges=True)
print(f"{len(cloud)} points; {len(with_edges) - len(cloud)} between two surfaces are removed")
assert len(cloud) < len(with_edges)

from_side = {"front": [0.55, -0.5, -0.75], "up": [0, -1, 0], "zoom": 0.48}
image = loom.render(cloud, from_side, (960, 640))

# %%
# The cloud colored by its distance from the ground truth. The error is the smooth error of the substitute: relative
# depths are accurate, while a complete wall is displaced by some centimeters.

exact = loom.PointCloud.create_from_depth_image(truth, frame.intrinsic)
cloud["error"] = cloud.compute_point_cloud_distance(exact)
print(f"median error of the points: {np.median(cloud['error']) * 100:.1f} cm")
by_error = loom.render(
    {"geometry": cloud, "color_by": "error", "limits": (0.0, 0.1)}, from_side, (960, 640), color_bar=True
)
assert np.median(cloud["error"]) < 0.05

# %%
# The unaligned result, scaled to the same size. From the camera position it looks the same. From the side, the walls
# are inclined and curved.

distorted = unaligned.to_point_cloud()
shrunk = distorted.scale(float(np.median(truth) / np.median(unaligned.depth)), center=[0, 0, 0])
unaligned_view = loom.render(shrunk, from_side, (960, 640))

# %%
# An interactive page with the aligned and the unaligned cloud:

with loom.record(folder / "depth.html", automatic=False, max_points=50_000, title="Aligned, then not") as recording:
    recording.add("room", cloud)
    recording.step("aligned to known depth")
    recording.update("room", shrunk)
    recording.step("scale and shift unknown")
page = folder / "depth.html"

# %%
# Common mistakes
# ---------------
# **A wrong preset.** The files of relative and metric networks have the same suffix. pointloom compares the graph of
# the network with the preset. A mismatch raises an error that names suitable presets:

try:
    loom.photogrammetry.DepthModel(folder / "stand_in.onnx", preset="zoedepth")
except loom.FileError as error:
    message = str(error).replace(str(folder), "...")
    print(message)
assert "preset" in message

# %%
# **References from another image.** Many rooms have similar depth: floor in the lower part, a wall behind it. A fit to
# references of another image therefore often succeeds, and some references agree by chance. Check ``inlier_fraction``.
# With depth of the same view it is close to 1. If nearly no reference agrees, or if depth is inverted, an error is
# raised. A single wall that is perpendicular to the optical axis cannot be checked in this way.

other_view = loom.datasets.room_frames(24)[2].depth
try:
    fraction = loom.photogrammetry.estimate_depth(
        frame.color, model, intrinsic=frame.intrinsic, align=other_view
    ).inlier_fraction
except ValueError as error:
    fraction = 0.0
    print(error)
print(f"references of another image: {fraction:.0%} agree; of this one: {fitted.inlier_fraction:.0%}")
assert fraction < 0.8 and fitted.inlier_fraction > 0.95

# %%
# **An unknown camera.** Without ``intrinsic``, the focal length is read from EXIF. If EXIF has none, a field of view of
# 60 degrees is assumed. ``intrinsic_source`` reports which one was used. A wrong focal length stretches the cloud along
# the optical axis.
#
# What to change
# --------------
# - ``align``: use two distances, one of them with an error of 1 m. Only ``evaluate_depth`` detects it. With five
#   distances, ``inlier_fraction`` detects it.
# - ``keep_edges``: ``True`` keeps the points at depth discontinuities.
# - The model: ``pointloom depth photo.jpg --model depth_anything_v2_vits.onnx -o cloud.ply --picture cloud.png`` uses a
#   real network.
#
# Next
# ----
# - :ref:`Chapter 9 <sphx_glr_chapters_plot_09_photographs_to_a_cloud.py>`: depth from many photographs, which is more
#   accurate and needs no network.
# - :doc:`Monocular depth </depth>`: all networks, and large images in tiles.
