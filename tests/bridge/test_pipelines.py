"""Scripts of Open3D's pages on pipelines give Open3D's numbers when their import line is changed."""

from __future__ import annotations

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d

from .pipeline_files import write_pipeline_files
from .runner import differences, draw_nothing, found_by

open3d = pytest.importorskip("open3d", exc_type=ImportError)

USUAL = 1e-6  # positions are float32 about an origin here, float64 there
TOLERANCES = {
    "icp_registration": {},
    "colored_icp": {},
    # residuals near 0 weigh up to 1e9 under L1: what rounding makes of them decides the way
    "robust_kernels": {"l1": 1e-2},
    # ICP begins at poses that two draws of samples found, and ends where steps are small
    "global_registration": {"icp": 1e-3, "icp fitness": 1e-3},
    # the misfit of a turn is 2 sin(a / 2) here and sin(a) there; a last step that still helps is taken
    "multiway_registration": {"poses": 1e-5, "again": 1e-5, "moved by": 1e-5, "confidence": 1e-5, "middle": 1e-5},
    # what brightness alone leaves nearly open is found by 35 steps of other sums
    "rgbd_odometry": {"color": 1e-3},
}
VOXEL = 0.05  # [m] of rgbd_integration


@pytest.fixture(scope="module")
def folder_and_poses(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages")
    return folder, write_pipeline_files(folder)


@pytest.fixture
def both(folder_and_poses, monkeypatch):
    """What a page's script finds with Open3D and with its names here, which draw the same."""

    def run(page):
        shown = [draw_nothing(monkeypatch, module) for module in (open3d, pointloom.open3d)]
        pair = [
            found_by(f"../pages/{page}", package, folder_and_poses[0]) for package in ("open3d", "pointloom.open3d")
        ]
        assert shown[0] == shown[1] != []
        return pair

    return run


def apart(page, theirs, ours):
    return differences(theirs, ours, TOLERANCES[page], USUAL)


@pytest.mark.parametrize("page", ["icp_registration", "colored_icp", "robust_kernels", "multiway_registration"])
def test_a_page_on_registration_gives_the_same_numbers(page, both):
    assert apart(page, *both(page)) == []


def test_registration_without_a_pose_comes_near_the_truth(both, folder_and_poses):
    pointloom.open3d.utility.random.seed(0)
    theirs, ours = both("global_registration")
    poses = [found.pop("poses") for found in (theirs, ours)][1]
    features = [found.pop("target features") for found in (theirs, ours)]
    counts = [found.pop("matches") for found in (theirs, ours)]
    assert apart("global_registration", theirs, ours) == []
    assert (
        np.abs(features[0] - features[1]).mean() < 0.02
    )  # of up to 200: an angle on the edge of two bins is in either
    assert abs(counts[0] - counts[1]) < 0.01 * counts[0]
    truth = np.linalg.inv(folder_and_poses[1][1]) @ folder_and_poses[1][0]
    assert np.abs(poses["ransac"] - truth).max() < 0.1
    assert np.abs(poses["fast"] - truth).max() < 0.05  # half a voxel


def test_odometry_gives_the_same_numbers(both):
    assert apart("rgbd_odometry", *both("rgbd_odometry")) == []


def test_a_volume_has_the_same_surface(both):
    theirs, ours = both("rgbd_integration")
    surfaces = [loom.TriangleMesh(*found.pop("surface")) for found in (theirs, ours)]
    clouds = [found.pop("cloud") for found in (theirs, ours)]
    scalable = [found.pop("scalable") for found in (theirs, ours)]
    tolerances = {"mean color": 0.01, "area": 0.02}  # voxels lie at other places, edges of the surface with them
    assert differences(theirs, ours, tolerances, USUAL) == []
    # Open3D 0.20 divides the depth of an RGBDImage, which is in metres, by 1000 again, and finds no block of voxels
    assert len(scalable[0]) == 0
    pairs = [(surfaces[0], points) for points in (surfaces[1].vertices, clouds[1], scalable[1])]
    for surface, points in (*pairs, (surfaces[1], surfaces[0].vertices), (surfaces[1], clouds[0])):
        scene = loom.RaycastingScene()
        scene.add_triangles(surface)
        distances = np.quantile(scene.compute_distance(points), [0.5, 0.9])
        assert (distances < np.array([0.2, 0.6]) * VOXEL).all()


def test_colour_maps_give_the_same_colours(both):
    theirs, ours = both("color_map_optimization")
    plain = [found.pop("plain") for found in (theirs, ours)]
    # but where a vertex lies half way between two pixels, or takes the colour of one that does
    assert (np.abs(plain[0] - plain[1]).max(axis=1) < 1e-6).mean() > 0.95
    # a step of theirs is an eighth of ours, so as many of them end elsewhere
    assert differences(theirs, ours, {"rigid": 0.01, "bent": 0.01}, USUAL) == []
