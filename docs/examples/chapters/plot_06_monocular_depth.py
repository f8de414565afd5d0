"""
6. Depth of one photograph
==========================

A depth network looks at one image and guesses how far each pixel is. You learn the steps around such a network:
which kind it is, what its numbers are worth, how one or two known distances make them meters, how to measure its
errors, and how a cloud is made of the result. You bring the network as an ONNX file; the package downloads nothing.
"""

# %%
# A stand-in for the network
# --------------------------
# **This chapter has no real network.** Real ones (Depth Anything V2, MiDaS, Metric3D and others) are files of 50 MB
# and more that their authors publish. So that the chapter runs anywhere we make a stand-in: an ONNX file that holds
# the answer for one image, spoilt in the ways in which networks spoil it. It does not look at the image at all.
# All that follows is what you do with a real file; the quality of the result says nothing about any network.
#
# The stand-in answers as MiDaS and Depth Anything do, with **relative inverse depth**: near is large, far is small, and
# 1 / depth = scale x d + shift with a scale and a shift that nobody knows.
#
# It wants ``pip install "pointloom[depth]"``.

import tempfile
from pathlib import Path

import numpy as np
import onnx
from onnx import helper, numpy_helper

import pointloom as loom
from pointloom.photogrammetry.depth.evaluation import evaluate_depth

SIDE = 384  # MiDaS looks at 384 x 384 pixels, whatever the image's shape

frame = loom.datasets.room_frames(24, noise=False)[20]
truth = frame.depth  # meters, exact: what nobody has in life, and what we measure errors with


def answer_of_a_network(depth: np.ndarray) -> np.ndarray:
    """Inverse depth, float32 [384, 384]: stretched, with an unknown scale and shift, softened, slowly wrong by 2 %."""
    rows = np.linspace(0, depth.shape[0] - 1, SIDE).round().astype(int)
    columns = np.linspace(0, depth.shape[1] - 1, SIDE).round().astype(int)
    inverse = 1 / depth[np.ix_(rows, columns)].astype(np.float64)
    v, u = np.mgrid[:SIDE, :SIDE] / SIDE
    inverse *= 1 + 0.02 * np.sin(5 * u + 1) * np.cos(4 * v)
    for _ in range(2):  # the mean of 3 x 3: edges run over some pixels, as networks' do
        padded = np.pad(inverse, 1, mode="edge")
        inverse = sum(padded[i : i + SIDE, j : j + SIDE] for i in range(3) for j in range(3)) / 9
    return (700 * inverse + 60).astype(np.float32)


def write_fake_network(path: Path, answer: np.ndarray) -> None:
    """An ONNX file that gives this answer to any image, and ends in a ReLU as MiDaS's files do."""
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
write_fake_network(folder / "stand_in.onnx", answer_of_a_network(truth))

# %%
# Ask it
# ------
# ``preset`` says which network the file is: the size of its input, how colors are normalized, and what its numbers
# mean. The page *Depth of one photograph* lists them, with the licenses of the weights. Open3D has nothing for this
# step; its users call OpenCV or PyTorch.

model = loom.photogrammetry.DepthModel(folder / "stand_in.onnx", preset="midas-v2.1-onnx")
alone = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic)
print(alone)
print("unit:", alone.unit, " in meters:", alone.is_metric, " camera:", alone.intrinsic_source)
assert not alone.is_metric

# %%
# Without any known distance the unit is **arbitrary**: the nearest pixel is put at 1, the farthest at 10. Such a
# depth is good for blurring the background of a portrait. Its cloud is bent, since the shift is made up: a wall comes
# out curved.
#
# Known distances make it meters
# ------------------------------
# Two distances are enough to find scale and shift: take a tape measure and note column, row and meters. More are
# better, because two cannot be checked: the fraction of references that agree, ``inlier_fraction``, is then None,
# however
# wrong one of them is.


def at(column: int, row: int) -> tuple[int, int, float]:
    """What the tape measure says there, to a centimetre."""
    return column, row, round(float(truth[row, column]), 2)


tape = np.array([at(60, 60), at(160, 150), at(260, 200), at(40, 210), at(280, 60)])
print(tape)
measured = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=tape)
checked = measured.inlier_fraction is not None
print("unit:", measured.unit, " references that agree:", f"{measured.inlier_fraction:.0%}" if checked else "not known")

two = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=tape[:2])
print("of two distances:", two.inlier_fraction)
assert checked and two.inlier_fraction is None

# %%
# Or a depth camera that looked at the same view, however coarse and however full of holes; or a sparse model of COLMAP
# (chapter 9). A depth image of a file goes in as meters, too: ``loom.read_depth`` gives what is stored, mostly
# millimeters in 16 bits, so divide by 1000 (some data sets store other units). The same holds where you read a
# distance off such an image in place of a tape.

sensor = loom.datasets.room_frames(24)[20].depth
rng = np.random.default_rng(0)
sparse = np.where(rng.random(sensor.shape) < 0.02, sensor, 0.0).astype(np.float32)
fitted = loom.photogrammetry.estimate_depth(frame.color, model, intrinsic=frame.intrinsic, align=sparse)
print(f"{fitted.references} references, {fitted.inlier_fraction:.0%} agree")
assert fitted.is_metric and fitted.inlier_fraction > 0.9

# %%
# How good is it?
# ---------------
# ``evaluate_depth`` gives the figures of the papers. ``abs_rel`` is the mean of ``abs(z - true) / true``: 0.05 means
# that depth is off by 5 %. ``delta1`` is the fraction of pixels that are right within a factor of 1.25. They compare
# with what a **metric** depth should be, so an arbitrary unit scores badly, however good the shapes.

results = {"alone": alone, "with a tape": measured, "with a sensor": fitted}
for name, estimate in results.items():
    errors = evaluate_depth(estimate.depth, truth)
    print(f"{name:14} abs_rel {errors.abs_rel:.3f}, rmse {errors.rmse:.3f} m, within 25 %: {errors.delta1:.1%}")

scores = {name: evaluate_depth(estimate.depth, truth).abs_rel for name, estimate in results.items()}
assert scores["with a sensor"] < 0.03 and scores["with a tape"] < 0.06
assert scores["alone"] > 5 * scores["with a sensor"]

# %%
# The cloud
# ---------
# Between a near and a far thing a network's depth runs from one to the other within some pixels, which would fly
# between them. ``to_point_cloud`` drops those.

cloud = fitted.to_point_cloud()
with_edges = fitted.to_point_cloud(keep_edges=True)
print(f"{len(cloud)} points; {len(with_edges) - len(cloud)} that flew between two surfaces are left out")
assert len(cloud) < len(with_edges)

beside = {"front": [0.55, -0.5, -0.75], "up": [0, -1, 0], "zoom": 0.48}
image = loom.render(cloud, beside, (960, 640))

# %%
# The same, colored by how far each point is from the truth. The error is the slow wave that the stand-in was
# spoilt with: things are right among themselves, and a whole wall is some centimeters off.

exact = loom.PointCloud.create_from_depth_image(truth, frame.intrinsic)
cloud["error"] = cloud.compute_point_cloud_distance(exact)
print(f"half of the points are within {np.median(cloud['error']) * 100:.1f} cm of the true surface")
by_error = loom.render(
    {"geometry": cloud, "color_by": "error", "limits": (0.0, 0.1)}, beside, (960, 640), color_bar=True
)
assert np.median(cloud["error"]) < 0.05

# %%
# The unaligned one, made about as large. From where the camera stood the two look alike; from beside, walls lean and
# the room is a funnel.

bent = alone.to_point_cloud()
shrunk = bent.scale(float(np.median(truth) / np.median(alone.depth)), center=[0, 0, 0])
funnel = loom.render(shrunk, beside, (960, 640))

# %%
# To turn, right and bent:

with loom.record(folder / "depth.html", automatic=False, max_points=50_000, title="Aligned, then not") as recording:
    recording.add("room", cloud)
    recording.step("aligned to known depth")
    recording.update("room", shrunk)
    recording.step("scale and shift made up")
page = folder / "depth.html"

# %%
# What goes wrong
# ---------------
# **The wrong preset.** Files of relative and metric networks look alike. The graph itself tells them apart, so this
# is an error before anything is computed, and names what to take:

try:
    loom.photogrammetry.DepthModel(folder / "stand_in.onnx", preset="zoedepth")
except loom.FileError as error:
    message = str(error).replace(str(folder), "...")
    print(message)
assert "preset" in message

# %%
# **References of another image.** Rooms resemble each other: floor below, wall behind. So a scale and a shift are
# often found, and part of the references agree with them by chance. Look at ``inlier_fraction``. With a depth camera's
# image of the same view it is near 1; well below that, ask whether both show the same. A wall that is seen from the
# front tells nothing either way. Where near and far change places, or nearly nothing agrees, it is an error.

elsewhere = loom.datasets.room_frames(24)[2].depth
try:
    fraction = loom.photogrammetry.estimate_depth(
        frame.color, model, intrinsic=frame.intrinsic, align=elsewhere
    ).inlier_fraction
except ValueError as error:
    fraction = 0.0
    print(error)
print(f"references of another image: {fraction:.0%} agree; of this one: {fitted.inlier_fraction:.0%}")
assert fraction < 0.8 and fitted.inlier_fraction > 0.95

# %%
# **The camera is not known.** Without ``intrinsic`` the focal length is EXIF's, else 60 degrees are assumed, and said
# (``intrinsic_source``). With the wrong one the cloud is stretched along the view.
#
# Try it
# ------
# - Give two distances only, one of them wrong by a metre. Nothing tells you, but ``evaluate_depth``, which wants the
#   truth. With five, one of them wrong, ``inlier_fraction`` does.
# - An image that you like: ``loom.write_image("room.png", image)``.
# - With a real file: ``pointloom depth photo.jpg --model depth_anything_v2_vits.onnx -o cloud.ply --picture
#   cloud.png``.
#
# Where to go next
# ----------------
# :ref:`Chapter 9 <sphx_glr_chapters_plot_09_photographs_to_a_cloud.py>` gets depth from many photographs, which needs
# no network and is far more exact. The page :doc:`Depth of one photograph </depth>` has all networks, and how large
# images are shown to them in parts.
