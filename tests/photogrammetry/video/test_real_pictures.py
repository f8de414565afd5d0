"""The full chain on nine small pictures of the room's bookcase, compared with the truth."""

import importlib.util

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.datasets.scenes.room import look_along, room_views, surface_errors

from ...cli.commands import answer

COUNT, WIDTH, HEIGHT, FOCAL = 9, 320, 240, 262.5
SIZE = 240  # of the pictures for depth: a pixel is 1 cm at 2 m
EYE, RIGHT, TARGET = np.array([2.5, 2.05, 1.6]), np.array([-0.907, 0.422, 0.0]), np.array([1.6, 0.1, 1.0])


@pytest.fixture(scope="module")
def views():
    """A meter from left to right, alternating up and down, looking at the middle of the bookcase."""
    camera = PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)
    poses = []
    for k, side in enumerate(np.linspace(-1, 1, COUNT)):
        eye = EYE + 0.5 * side * RIGHT + 0.1 * (-1) ** k * np.array([0, 0, 1])
        poses.append(look_along(eye, tuple(TARGET - eye)))
    return room_views(np.array(poses), camera)


@pytest.fixture(scope="module")
def photos(views, tmp_path_factory):
    folder = tmp_path_factory.mktemp("photos")
    for k in range(COUNT):
        Image.fromarray(views.read(k).color).save(folder / f"photo_{k}.png")
    return folder


@pytest.fixture(scope="module")
def made(photos, tmp_path_factory):
    """The report of one run, and its folder."""
    if importlib.util.find_spec("pycolmap") is None:  # never imported beside NumPy
        pytest.skip("the extra sfm is not there")
    folder = tmp_path_factory.mktemp("made")
    return run_in(folder, photos), folder


def run_in(folder, photos, *words):
    outputs = ("-o", folder / "mesh.ply", "--trajectory", folder / "poses.log", "--work", folder / "work")
    return answer("video", photos, *outputs, "--max-size", SIZE, "--device", "cpu", *words)


def true_points(views):
    """Points of every 4th pixel of every picture, in the room [m]."""
    v, u = (each.reshape(-1) for each in np.mgrid[0:HEIGHT:4, 0:WIDTH:4])
    rays = np.stack([(u - (WIDTH - 1) / 2) / FOCAL, (v - (HEIGHT - 1) / 2) / FOCAL, np.ones(len(u))], axis=1)
    points = []
    for k in range(COUNT):
        frame = views.read(k)
        depth = np.asarray(frame.depth, np.float64)[v, u]
        points.append((rays * depth[:, None])[depth > 0] @ frame.T_world_camera[:3, :3].T + frame.T_world_camera[:3, 3])
    return np.concatenate(points)


def errors_of_cameras(folder, views):
    """Errors of the cameras after the best similarity transform to the true ones."""
    path = loom.read_trajectory(folder / "poses.log")
    assert path.ids[:, 0].tolist() == list(range(COUNT))  # the numbers in the photos' names
    truth = loom.Trajectory(views.poses)
    return loom.registration.evaluate_trajectory(loom.Trajectory(path.poses), truth, with_scale=True)


@pytest.mark.slow
def test_photos_alone_give_accurate_poses_and_surface(made, views):
    report, folder = made
    assert (report["model"]["registered_count"], report["units"], report["reliable"]) == (COUNT, "arbitrary", True)
    assert report["fused"]["share"] > 0.6
    errors = errors_of_cameras(folder, views)
    assert errors.absolute_translation.rmse < 0.005 * np.linalg.norm(np.ptp(views.poses[:, :3, 3], axis=0))
    mesh = loom.read_triangle_mesh(folder / "mesh.ply").transform(errors.transformation)
    away, scene = surface_errors(mesh.vertices), loom.RaycastingScene()
    scene.add_triangles(mesh)
    assert np.median(away) < 0.01
    assert np.mean(away <= 0.02) > 0.9
    assert np.mean(scene.compute_distance(true_points(views).astype(np.float32)) <= 0.02) > 0.6


@pytest.mark.slow
def test_a_known_distance_gives_meters_and_remakes_only_the_mesh(made, photos, views):
    _, folder = made
    eyes = [views.read(k).T_world_camera[:3, 3] for k in (0, COUNT - 1)]
    known = f"photo_0,photo_{COUNT - 1}.png,{np.linalg.norm(eyes[0] - eyes[1])}"
    report = run_in(folder, photos, "--resume", "--force", "--known", known)
    assert [name for name, stage in report["stages"].items() if not stage["kept"]] == ["mesh"]
    assert errors_of_cameras(folder, views).scale == pytest.approx(1.0, abs=0.005)
    assert b"\ncomment units meters\n" in (folder / "mesh.ply").read_bytes()[:300]
    bounds = report["mesh"]["bounds"]
    assert 2 < np.linalg.norm(np.subtract(bounds["max"], bounds["min"])) < 6  # the room is 5 m x 4 m x 2.6 m


@pytest.mark.slow
def test_the_call_from_python_gives_what_the_command_wrote(made, photos):
    report, folder = made
    settings = loom.video.Settings(max_size=SIZE)
    result = loom.video.reconstruct(photos, settings, work=folder / "work", resume=True, device="cpu")
    assert all(stage.is_reused for name, stage in result.stages.items() if name != "mesh")
    mesh = loom.read_triangle_mesh(folder / "work" / "mesh" / "mesh.ply")
    np.testing.assert_array_equal(result.mesh.vertices, mesh.vertices)
    assert len(result.cloud) == report["fused"]["points"]
    assert result.model.names == tuple(f"photo_{k}.png" for k in range(COUNT))
    assert result.figures.quality.to_dict() == {key: report["model"][key] for key in result.figures.quality.to_dict()}
