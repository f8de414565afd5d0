"""
9. Photographs and videos to a cloud
====================================

No depth camera, only images: what several of them show from different places has a depth. You learn what the chain
from photographs to points consists of, how to run it where the cameras' places are known, the one command for videos
where nothing is known, and why its unit is arbitrary.
"""

# %%
# The chain
# ---------
# =============  ===================================================  ===========================================
# step           what it finds                                        call
# =============  ===================================================  ===========================================
# frames         sharp images of a video, where the camera has moved  ``loom.photogrammetry.choose_frames``
# poses          where each image was taken, and the lens             ``loom.photogrammetry.reconstruct_images``
# sparse points  some thousand corners that several images show       ``loom.photogrammetry.triangulate``
# depth          how far every pixel is                               ``loom.photogrammetry.estimate_depth_maps``
# filter         what several images say alike                        ``loom.photogrammetry.filter_depth_maps``
# cloud or mesh  each place once                                      ``loom.photogrammetry.fuse_depth_maps``
# =============  ===================================================  ===========================================
#
# For a video all of it is one command, which needs ``pip install "pointloom[sfm]"`` and some minutes:
#
# .. code-block:: console
#
#    $ pointloom video walk.mp4 -o room.ply --picture room.png
#
# Open3D has nothing for images alone; its users take COLMAP or Metashape, whose cameras ``loom.read_cameras`` reads.
# In this chapter the poses are known, as from there, or from a robot's arm, or a turntable.

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
# Images must **overlap and move**: the same place seen from 5 to 30 degrees apart, two thirds of each image in the
# next. A camera that only turns on the spot sees no depth.

step = np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", poses[1:, :3, 2], poses[:-1, :3, 2]), -1, 1)))
print("from one image to the next:", step.round(0), "degrees")
assert (step > 3).all() and (step < 35).all()

# %%
# Half the size, and the middle columns, are quick and enough to learn on. Whoever changes images has to change the
# camera with them: half the size is half the focal length, and cutting columns off moves the principal point. (The
# mean of 2 x 2 pixels has its center half a pixel off, which the principal point follows, too.)

LEFT, RIGHT = 85, 235


def halved(image: np.ndarray) -> np.ndarray:
    """The mean of 2 x 2 pixels, and of that the middle columns."""
    averaged = image.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3))
    return averaged[:, LEFT:RIGHT].round().astype(np.uint8)


small = [halved(image) for image in images]
camera = loom.PinholeCameraIntrinsic(
    RIGHT - LEFT, height // 2, intrinsic.fx / 2, intrinsic.fy / 2,
    (intrinsic.cx - 0.5) / 2 - LEFT, (intrinsic.cy - 0.5) / 2,
)  # fmt: skip

# %%
# Multi-view stereo wants world to camera: the **inverse** of the poses. Wrong ones are the commonest mistake; the
# result is then empty or fog.

cameras = [loom.photogrammetry.PosedCamera(camera, np.linalg.inv(pose)) for pose in poses]
maps = loom.photogrammetry.estimate_depth_maps(small, cameras)
filtered = loom.photogrammetry.filter_depth_maps(maps)
fraction = np.mean([(filtered[k].depth > 0).mean() for k in range(len(small))])
print(f"{fraction:.0%} of the pixels have a depth that other images confirm")

# %%
# How far off is it? The truth is known here. Confirmed pixels are right to a fraction of a per cent; what nobody
# confirms (the plain background, edges, what one image alone sees) is left out rather than guessed.

truth = shots.depths[2][::2, ::2][:, LEFT:RIGHT]
depth = filtered[2].depth
both = (depth > 0) & (truth > 0)
relative = abs(depth - truth)[both] / truth[both]
print(f"half of the pixels within {np.median(relative):.2%} of the true depth, nine tenths within"
      f" {np.quantile(relative, 0.9):.1%}")  # fmt: skip
assert np.median(relative) < 0.01

# %%
# One cloud
# ---------
# Pixels of several images that show one place become one point, with its color, its normal, and ``views``: how
# many images agree on it. The gray behind the figure is plain, so its depth is unknown, and
# estimates of it are unreliable. It is removed by its
# color, and specks in the air by clusters (chapter 3).

cloud = loom.photogrammetry.fuse_depth_maps(filtered, small)
print(cloud, "views from", int(cloud["views"].min()), "to", int(cloud["views"].max()))
gray = np.median(small[2][:20].reshape(-1, 3), axis=0) / 255
plain = np.linalg.norm(cloud.colors - gray, axis=1) < 0.12
figure = cloud.select_by_mask(~plain)
labels = np.asarray(figure.cluster_dbscan(eps=0.01, min_points=10))
figure = figure.select_by_mask(labels == np.bincount(labels[labels >= 0]).argmax())
print(f"{len(cloud) - len(figure)} points of the background are cut off")
view = {"front": poses[2][:3, 3].tolist(), "up": [0, 0, 1], "zoom": 0.52}
fused = loom.render(
    [figure] + [{"geometry": loom.CameraFrustum(camera, pose, 0.08), "color": (0.1, 0.4, 0.9)} for pose in poses],
    {"front": (poses[2][:3, 3] + [0.1, 0, 0.3]).tolist(), "up": [0, 0, 1], "zoom": 0.55},
    (960, 640),
)  # fmt: skip
close = loom.render(figure, view, (960, 640))

# %%
# Against the true figure
# -----------------------

owl = figure.select_by_mask((figure.points[:, 2] > -0.13) & (np.linalg.norm(figure.points[:, :2], axis=1) < 0.12))
scene = loom.RaycastingScene()
scene.add_triangles(loom.datasets.object_mesh())
owl["error"] = scene.compute_distance(owl.points.astype(np.float32)) * 1000
print(f"{len(owl)} points of the figure, half of them within {np.median(owl['error']):.1f} mm of its true surface")
assert len(owl) > 3000
assert np.median(owl["error"]) < 2.0
errors = loom.render(
    {"geometry": owl, "color_by": "error", "limits": (0.0, 4.0), "colormap": "turbo"},
    {**view, "zoom": 0.7},
    (960, 640),
    color_bar=True,
)

# %%
# To turn, as points:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "owl.html", automatic=False, max_points=60_000, title="From four photographs") as recording:
    recording.add("figure", figure)
    for k, pose in enumerate(poses):
        recording.add(f"camera {k}", loom.CameraFrustum(camera, pose, 0.06), color=(0.1, 0.4, 0.9))
    recording.step("points and cameras")
page = folder / "owl.html"

# %%
# The unit
# --------
# These poses are in meters, so the cloud is. Where poses are found from images alone, the unit is **arbitrary**: a
# doll's house and a house make the same images. One known distance settles it: ``--known IMG_0012,IMG_0040,1.5``
# says that two images were taken 1.5 m apart.
#
# What goes wrong
# ---------------
# **Poses the wrong way round.** With the poses themselves in place of their inverse nothing agrees:

wrong = [loom.photogrammetry.PosedCamera(camera, pose) for pose in poses[:2]]
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    mistaken = loom.photogrammetry.filter_depth_maps(loom.photogrammetry.estimate_depth_maps(small[:2], wrong))
left = np.mean([(mistaken[k].depth > 0).mean() for k in range(2)])
print(caught[0].message)
print(f"confirmed with wrong poses: {left:.0%}, with right ones: {fraction:.0%}")
assert left < 0.02 < fraction and "T_camera_world is world to camera" in str(caught[0].message)

# %%
# **Plain, shiny and moving things** have nothing that can be recognized, or change from image to image: white
# walls, glass, people. Move closer, add a tablecloth with a pattern, ask people to wait.
#
# Try it
# ------
# - Take every second image. What is lost first?
# - ``loom.photogrammetry.fuse_depth_maps(kept, small, to="tsdf")`` gives a mesh.
# - Film a thing on a table, once round, and run ``pointloom video``.
#
# Where to go next
# ----------------
# The page :doc:`From a video to a mesh </video>` has the command in full, :doc:`Structure from motion </sfm>` the
# search for poses, :doc:`Photographs with known poses </mvs>` this chapter's steps with figures.
