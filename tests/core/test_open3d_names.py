"""The equivalents of Open3D's names are correct and used in messages."""

import re

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.open3d_names import sections


def test_rows_refer_to_existing_names():
    text = "\n".join(row for rows in sections().values() for row in rows.values())
    for name in set(re.findall(r"loom((?:\.\w+)+)", text)):
        owner = loom
        for part in name[1:].split("."):
            known = {*dir(owner), *getattr(owner, "__annotations__", {})}
            assert part in known, f"loom{name}"
            owner = getattr(owner, part, None)
    owners = {"cloud": loom.PointCloud, "mesh": loom.TriangleMesh, "volume": loom.TSDFVolume, "viewer": loom.Viewer}
    owners |= {"search": loom.NearestNeighborSearch, "trajectory": loom.Trajectory}
    for name, part in set(re.findall(rf"\b({'|'.join(owners)})\.(\w+)", text)):
        assert part in {*dir(owners[name]), *getattr(owners[name], "__annotations__", {})}, f"{name}.{part}"


MESSAGES = [
    ("loom.KDTreeFlann(cloud)", r"no attribute 'KDTreeFlann'; here: loom\.NearestNeighborSearch\(cloud\): knn_search"),
    ("loom.read_image('a.png')", r"here: loom\.read_color\(path\) or loom\.read_depth\(path\)"),
    ("loom.io.read_point_cloud", "here: loom itself: open3d.io.read_point_cloud is loom.read_point_cloud"),
    ("loom.PoseGraph()", "it is loom.registration.PoseGraph"),
    ("loom.registration.compute_iss_keypoints", "it is loom.compute_iss_keypoints"),
    ("loom.registration.OdometryOption", "it is loom.odometry.OdometryOption"),
    ("loom.PointClouds", "did you mean 'PointCloud'"),
    ("loom.registration.registration_ipc", r"did you mean 'registration_icp'\?"),
    ("cloud.normal", r"PointCloud has no attribute 'normal'; did you mean 'normals'\?"),
    ("cloud.color = [1, 0, 0]", r"PointCloud has no attribute 'color'; did you mean 'colors'\? .*cloud\['color'\]"),
    ("cloud.foo = 3", r"PointCloud has no attribute 'foo'; Add an attribute of the points with cloud\['foo'\]"),
    ("mesh.vertex_color = 1", r"TriangleMesh has no attribute 'vertex_color'; did you mean 'vertex_colors'\?"),
    ("loom.AxisAlignedBoundingBox().colour = (1, 0, 0)", r"has no attribute 'colour'; did you mean 'color'\?"),
    ("loom.VoxelGrid.create_from_point_cloud(cloud, 0.1)", "VoxelGrid has no attribute .*; not here: np.unique"),
    ("loom.TriangleMesh.create_from_point_cloud_ball", "did you mean 'create_from_point_cloud_ball_pivoting'"),
    ("mesh.estimate_normals()", r"here: mesh = mesh\.compute_vertex_normals\(\)"),
    ("cloud.is_watertight()", "PointCloud has no attribute 'is_watertight'; TriangleMesh has it"),
    ("volume.voxel_length", "here: volume.voxel_size"),
    ("search.search_knn_vector_3d([0, 0, 0], 5)", r"here: search\.knn_search\(point, knn\)"),
    ("cloud.estimate_normals(0.1, 30)", r"write estimate_normals\(radius=0\.1, max_nn=30\)"),
    ("cloud.estimate_normals(search_param=1)", r"no argument 'search_param'; here: keywords: radius=0\.1, max_nn=30"),
    ("cloud.estimate_normals(search_param=hybrid)", r"here: estimate_normals\(radius=0\.1, max_nn=30\)"),
    ("cloud.voxel_down_sample(voxle_size=1)", "did you mean 'voxel_size'"),
    ("cloud.voxel_down_sample()", "PointCloud.voxel_down_sample.. is missing voxel_size"),
    ("loom.compute_fpfh_feature(cloud, 0.25, 100)", r"write compute_fpfh_feature\(cloud, radius=0\.25, max_nn=100\)"),
    ("loom.TSDFVolume(0.02, 0.08)", r"write TSDFVolume\(voxel_size=0\.02, truncation=0\.08\)"),
    ("loom.PointCloud(cloud.points, cloud.points)", r"write PointCloud\(points, normals=\.\.\.\)"),
    ("loom.render(cloud, zoom=0.5)", r"a view is the second argument of render: loom\.render\(cloud, \{\"zoom\": 0\.5"),
    ("loom.draw(cloud, foo=1)", "has no argument 'foo'; it takes geometries, width, height"),
    (
        "loom.registration.registration_icp(cloud, cloud, 0.1, max_iteration=9)",
        "ICPConvergenceCriteria.max_iteration=30",
    ),
]


@pytest.mark.parametrize(("line", "message"), MESSAGES)
def test_the_error_for_an_open3d_name_quotes_its_row(line, message):
    class KDTreeSearchParamHybrid:
        radius, max_nn = 0.1, 30

    cloud = loom.PointCloud(np.zeros((9, 3)))
    names = {"cloud": cloud, "mesh": loom.TriangleMesh.create_box(), "search": loom.NearestNeighborSearch(cloud)}
    names |= {"loom": loom, "volume": loom.TSDFVolume(voxel_size=0.1), "hybrid": KDTreeSearchParamHybrid()}
    with pytest.raises((AttributeError, TypeError), match=message):
        exec(line, names)


def test_errors_from_within_stay_as_they_are():
    with pytest.raises(TypeError, match="voxel_size:"):
        loom.PointCloud(np.zeros((9, 3))).voxel_down_sample("0.05")  # pyright: ignore[reportArgumentType]
