"""
Errors, warnings and log messages
=================================

On this page you catch errors by type, turn warnings into errors, and control log messages. Use it before a script runs
unattended.
"""

import logging
import warnings

import numpy as np

import pointloom as loom

cloud = loom.datasets.object_mesh().sample_points_uniformly(20_000, seed=0).without("normals")

# %%
# Errors
# ------
# Errors that depend on the environment (files, devices, cameras, data sets) are subclasses of ``PointloomError``. Wrong
# arguments raise Python's ``ValueError``, ``TypeError`` or ``IndexError``. Each message contains the expected and the
# actual value.
error_types = []


def print_error(what, call):
    """Run `call` and print the error that it raises."""
    try:
        call()
    except (loom.PointloomError, loom.UnitWarning, ValueError, TypeError, IndexError) as error:
        error_types.append(type(error).__name__)
        print(f"{what}\n    {type(error).__name__}: {str(error)[:200]}")
    else:
        raise AssertionError(f"{what}: expected an error")


plane = loom.registration.TransformationEstimationPointToPlane()
print_error("normals missing", lambda: loom.registration.registration_icp(cloud, cloud, 0.1, estimation_method=plane))
print_error("(3, n) instead of (n, 3)", lambda: loom.PointCloud(np.zeros((3, 5000))))
print_error(
    "colors of 8 bits as floats", lambda: loom.PointCloud(np.zeros((2, 3)), colors=[[255.0, 0, 0], [0, 128.0, 0]])
)
print_error("a voxel size of 0", lambda: cloud.voxel_down_sample(0.0))
print_error("a mesh instead of a cloud", lambda: loom.classify_ground(loom.TriangleMesh.create_sphere(1.0)))
print_error("a missing file", lambda: loom.read_point_cloud("no/such/scan.ply"))
print_error("a missing device", lambda: cloud.to("cuda:9"))
assert set(error_types) == {"ValueError", "TypeError", "FileError", "DeviceError"}
assert issubclass(loom.FileError, loom.PointloomError) and issubclass(loom.DeviceError, loom.PointloomError)

# %%
# Discarded results
# -----------------
# Operations return new objects and do not modify their input. A discarded result emits a warning.
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    cloud.voxel_down_sample(0.004)  # the result is discarded
discarded = [warning for warning in caught if issubclass(warning.category, loom.DroppedResultWarning)]
assert len(discarded) == 1
print(discarded[0].message)

# %%
# Warnings as errors
# ------------------
# An unattended pipeline should stop at a warning. Degrees used as lengths emit a ``UnitWarning``. Reading a file in
# degrees emits a ``GeographicWarning``.
geographic = loom.PointCloud([[7.62, 51.96, 60.0], [7.63, 51.97, 61.0]], unit="degree")
with warnings.catch_warnings():
    for kind in (loom.UnitWarning,):
        warnings.simplefilter("error", kind)
    print_error(
        "degrees instead of meters",
        lambda: geographic.compute_point_cloud_distance(loom.PointCloud(geographic.points, unit="metre")),
    )

# %%
# Log messages
# ------------
# A call that takes longer than a few seconds logs its progress to Python's logger "pointloom".
logger = logging.getLogger("pointloom")
before = logger.level
logger.setLevel(logging.ERROR)
clusters = cloud.cluster_dbscan(0.004, 5)
logger.setLevel(before)

# %%
# The corrected calls
# -------------------
downsampled = cloud.voxel_down_sample(0.004).estimate_normals(max_nn=16)
downsampled = loom.estimate_curvature(downsampled, max_nn=30)
view = loom.View.fit(
    np.vstack([downsampled.points, downsampled.translate([0.24, 0, 0]).points]),
    direction=(-0.4, 0.8, -0.3),
    width=960,
    height=640,
)
image = loom.render(
    [downsampled, {"geometry": downsampled.translate([0.24, 0, 0]), "color_by": "curvature"}], view, color_bar=True
)

# %%
# What to change
# --------------
# - ``warnings.simplefilter``: ``"error"`` raises warnings as errors, ``"ignore"`` suppresses them.
# - The level of the logger: ``logging.INFO`` displays progress, ``logging.ERROR`` only errors.
#
# Next
# ----
# - :doc:`Common mistakes </mistakes>`: causes and corrections.
# - :doc:`Logging and progress </logging>`: handlers and progress events.
# - :doc:`Robustness </robustness>`: behavior with invalid input.
