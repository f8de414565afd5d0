"""
Mistakes that are told, and how much is said
============================================

What goes wrong is said where it goes wrong, with what mends it: errors that one can catch by kind, warnings that
one can make errors. And a long call says how far it is, as loud or as quiet as wanted. Take this page when a script
is to run by itself.
"""

import logging
import warnings

import numpy as np

import pointloom as loom

cloud = loom.datasets.object_mesh().sample_points_uniformly(20_000, seed=0).without("normals")

# %%
# **Errors.** All that the library raises about the world outside (files, devices, cameras, data sets) are kinds of
# ``PointloomError``; wrong arguments are the ``ValueError``, ``TypeError`` and ``IndexError`` of Python. Each says
# what it expected and what it got.
raised = []


def try_it(what, call):
    """Call it, and keep what it says."""
    try:
        call()
    except (loom.PointloomError, loom.UnitWarning, ValueError, TypeError, IndexError) as error:
        raised.append(type(error).__name__)
        print(f"{what}\n    {type(error).__name__}: {str(error)[:200]}")
    else:
        raise AssertionError(f"{what}: nothing was said")


plane = loom.registration.TransformationEstimation.point_to_plane()
try_it("normals missing", lambda: loom.registration.registration_icp(cloud, cloud, 0.1, estimation_method=plane))
try_it("(3, n) for (n, 3)", lambda: loom.PointCloud(np.zeros((3, 5000))))
try_it("colors of 8 bits as floats", lambda: loom.PointCloud(np.zeros((2, 3)), colors=[[255.0, 0, 0], [0, 128.0, 0]]))
try_it("a voxel of nothing", lambda: cloud.voxel_down_sample(0.0))
try_it("a mesh for a cloud", lambda: loom.classify_ground(loom.TriangleMesh.create_sphere(1.0)))
try_it("no such file", lambda: loom.read_point_cloud("no/such/scan.ply"))
try_it("no such device", lambda: cloud.to("cuda:9"))
assert set(raised) == {"ValueError", "TypeError", "FileError", "DeviceError"}
assert issubclass(loom.FileError, loom.PointloomError) and issubclass(loom.DeviceError, loom.PointloomError)

# %%
# **A result that is dropped.** Operations return what they make, and change nothing in place; who forgets to keep it
# is warned.
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    cloud.voxel_down_sample(0.004)  # kept by nobody
dropped = [warning for warning in caught if issubclass(warning.category, loom.DroppedResultWarning)]
assert len(dropped) == 1
print(dropped[0].message)

# %%
# **Warnings as errors**: an unattended pipeline should stop at a warning. Degrees that are used as lengths raise one
# (files in degrees raise a ``GeographicWarning`` when they are read, a kind of its own).
geographic = loom.PointCloud([[7.62, 51.96, 60.0], [7.63, 51.97, 61.0]], unit="degree")
with warnings.catch_warnings():
    for kind in (loom.UnitWarning,):
        warnings.simplefilter("error", kind)
    try_it(
        "degrees for meters",
        lambda: geographic.compute_point_cloud_distance(loom.PointCloud(geographic.points, unit="metre")),
    )

# %%
# **Messages.** A call that takes longer than a few seconds logs its progress to the logger "pointloom" of Python.
logger = logging.getLogger("pointloom")
before = logger.level
logger.setLevel(logging.ERROR)
clusters = cloud.cluster_dbscan(0.004, 5)
logger.setLevel(before)

# %%
# What was asked for above, done right: kept, with normals, and seen.
thin = cloud.voxel_down_sample(0.004).estimate_normals(max_nn=16)
thin = loom.estimate_curvature(thin, max_nn=30)
view = loom.View.fit(
    np.vstack([thin.points, thin.translate([0.24, 0, 0]).points]), direction=(-0.4, 0.8, -0.3), width=960, height=640
)
image = loom.render([thin, {"geometry": thin.translate([0.24, 0, 0]), "color_by": "curvature"}], view, color_bar=True)
