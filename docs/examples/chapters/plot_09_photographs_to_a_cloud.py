"""
9. Point clouds from photographs and videos
===========================================

Photographs from several positions determine depth without a depth camera. In this chapter you learn the steps from
photographs to points, run them with known camera poses, and use the single command for videos with unknown poses. You
also learn why the scale of such a model is arbitrary.
"""

# %%
# The steps
# ---------
# =============  ===================================================  ===========================================
# step           result                                               function
# =============  ===================================================  ===========================================
# frames         sharp images of a video with sufficient motion       ``loom.photogrammetry.choose_frames``
# poses          poses of the images, and the camera                  ``loom.photogrammetry.reconstruct_images``
# sparse points  some thousand points visible in several images       ``loom.photogrammetry.triangulate``
# depth          depth of each pixel                                  ``loom.photogrammetry.estimate_depth_maps``
# filter         depth that several images confirm                    ``loom.photogrammetry.filter_depth_maps``
# cloud or mesh  all images merged                                    ``loom.photogrammetry.fuse_depth_maps``
# =============  ===================================================  ===========================================
#
# For a video, one command runs all steps. It requires ``pip install "pointloom[sfm]"`` and takes some minutes:
#
# .. code-block:: console
#
#    $ pointloom video walk.mp4 -o room.ply --picture room.png
#
# Open3D has no photogrammetry. Its users run COLMAP or Metashape, whose cameras ``loom.read_cameras`` reads. In this
# chapter the poses are known, as from these programs, a robot arm or a turntable.

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

shots = loom.datasets.photographs(24)
images, intrinsic, poses = shots.images[:4], shots.intrinsic, shots.poses[:4]
height, width = images[0].shape[:2]
print(f"{len(images)} images of {width} x {height} pixels, {intrinsic}")

# %%
# The images must **overlap**, and the camera must **move**. Consecutive images should share two thirds of their
# content, with viewing directions that differ by 5 to 30 degrees. A camera that only rotates provides no depth.

step = np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", poses[1:, :3, 2], poses[:-1, :3, 2]), -1, 1)))
print("from one image to the next:", step.round(0), "degrees")
assert (step > 3).all() and (step < 35).all()

# %%
# To save time, the script uses half the resolution and the middle columns. The camera parameters change accordingly:
# half the resolution halves the focal length, and cropping shifts the principal point. Averaging 2 x 2 pixels shifts
# pixel centers by half a pixel, which also changes the principal point.

LEFT, RIGHT = 85, 235


def halved(image: np.ndarray) -> np.ndarray:
    """Average 2 x 2 pixels and select the middle columns."""
    averaged = image.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))
    return averaged[:, LEFT:RIGHT].round().astype(np.uint8)


small = [halved(image) for image in images]
camera = loom.PinholeCameraIntrinsic(
    RIGHT - LEFT, height // 2, intrinsic.fx / 2, intrinsic.fy / 2,
    (intrinsic.cx - 0.5) / 2 - LEFT, (intrinsic.cy - 0.5) / 2,
)  # fmt: skip

# %%
# Multi-view stereo expects world-to-camera transformations: the **inverse** of the poses. Wrong transformations are the
# most common mistake. The result is then empty or mostly noise.

cameras = [loom.photogrammetry.PosedCamera(camera, np.linalg.inv(pose)) for pose in poses]
maps = loom.photogrammetry.estimate_depth_maps(small, cameras)
filtered = loom.photogrammetry.filter_depth_maps(maps)
fraction = np.mean([(filtered[k].depth > 0).mean() for k in range(len(small))])
print(f"{fraction:.0%} of the pixels have a depth that other images confirm")

# %%
# The ground truth is known here, so the error can be measured. The error of confirmed pixels is a fraction of a
# percent. Unconfirmed pixels are removed: the uniform background, edges, and surfaces that are visible in one image
# only.

truth = shots.depths[2][::2, ::2][:, LEFT:RIGHT]
depth = filtered[2].depth
both = (depth > 0) & (truth > 0)
relative = abs(depth - truth)[both] / truth[both]
print(f"median error of the depth {np.median(relative):.2%}, 90th percentile"
      f" {np.quantile(relative, 0.9):.1%}")  # fmt: skip
assert np.median(relative) < 0.01

# %%
# Merge the depth maps
# --------------------
# Pixels of several images that show the same surface are merged to one point with color, normal and ``views``, the
# number of images that agree. The depth of the uniform gray background is unreliable. The script removes it by its
# color, and small isolated groups of points by clustering (chapter 3).

cloud = loom.photogrammetry.fuse_depth_maps(filtered, small)
print(cloud, "views from", int(cloud["views"].min()), "to", int(cloud["views"].max()))
gray = np.median(small[2][:20].reshape(-1, 3), axis=0) / 255
plain = np.linalg.norm(cloud.colors - gray, axis=1) < 0.12
figure = cloud.select_by_mask(~plain)
labels = np.asarray(figure.cluster_dbscan(eps=0.01, min_points=10))
figure = figure.select_by_mask(labels == np.bincount(labels[labels >= 0]).argmax())
print(f"{len(cloud) - len(figure)} points of the background removed")
view = {"front": poses[2][:3, 3].tolist(), "up": [0, 0, 1], "zoom": 0.52}
fused = loom.render(
    [figure] + [{"geometry": loom.CameraFrustum(camera, pose, 0.08), "color": (0.1, 0.4, 0.9)} for pose in poses],
    {"front": (poses[2][:3, 3] + [0.1, 0, 0.3]).tolist(), "up": [0, 0, 1], "zoom": 0.55},
    (960, 640),
)  # fmt: skip
close = loom.render(figure, view, (960, 640))

# %%
# Compare with the ground truth
# -----------------------------

owl = figure.select_by_mask((figure.points[:, 2] > -0.13) & (np.linalg.norm(figure.points[:, :2], axis=1) < 0.12))
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.object_mesh())
owl["error"] = scene.compute_distance(owl.points.astype(np.float32)) * 1000
print(f"{len(owl)} points of the figure, median error {np.median(owl['error']):.1f} mm")
assert len(owl) > 3000
assert np.median(owl["error"]) < 2.0
errors = loom.render(
    {"geometry": owl, "color_by": "error", "limits": (0.0, 4.0), "colormap": "turbo"},
    {**view, "zoom": 0.7},
    (960, 640),
    color_bar=True,
)

# %%
# The result as an interactive page:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "owl.html", automatic=False, max_points=60_000, title="From four photographs") as recording:
    recording.add("figure", figure)
    for k, pose in enumerate(poses):
        recording.add(f"camera {k}", loom.CameraFrustum(camera, pose, 0.06), color=(0.1, 0.4, 0.9))
    recording.step("points and cameras")
page = folder / "owl.html"

# %%
# Scale
# -----
# The poses are in meters, so the cloud is, too. If the poses are estimated from images alone, the scale is
# **arbitrary**: a small and a large model give the same images. One known distance determines it: ``--known
# IMG_0012,IMG_0040,1.5`` states that two cameras are 1.5 m apart.
#
# Common mistakes
# ---------------
# **Inverted poses.** With poses instead of their inverses, images do not agree:

wrong = [loom.photogrammetry.PosedCamera(camera, pose) for pose in poses[:2]]
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    mistaken = loom.photogrammetry.filter_depth_maps(loom.photogrammetry.estimate_depth_maps(small[:2], wrong))
confirmed_fraction = np.mean([(mistaken[k].depth > 0).mean() for k in range(2)])
print(caught[0].message)
print(f"confirmed with wrong poses: {confirmed_fraction:.0%}, with right ones: {fraction:.0%}")
assert confirmed_fraction < 0.02 < fraction and "T_camera_world is world to camera" in str(caught[0].message)

# %%
# **Uniform, reflective and moving surfaces** cannot be matched: white walls, glass, people. Take images from a shorter
# distance, add texture such as a patterned cloth, and avoid motion.
#
# What to change
# --------------
# - The images: use every second one. Which part of the surface is lost first?
# - ``to``: ``loom.photogrammetry.fuse_depth_maps(filtered, small, to="tsdf")`` returns a mesh.
# - The threshold 0.12 of the background color (0 to 1): a larger value removes more of the object.
# - The input: record a video around an object on a table, and run ``pointloom video``.
#
# Next
# ----
# - :ref:`Chapter 10 <sphx_glr_chapters_plot_10_colored_icp.py>`: ICP with colors.
# - :doc:`Video or photographs to mesh </video>`: all options of the command.
# - :doc:`Structure from motion </sfm>`: estimation of the poses.
# - :doc:`Multi-view stereo </mvs>`: the steps of this chapter with measurements.
