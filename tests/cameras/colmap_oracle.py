"""Results of COLMAP for cameras, images and models: pycolmap in a separate process.

It must never be imported together with NumPy and OpenCV: their libraries conflict. Input and output are JSON, NaN
included.
"""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

_PROGRAM = """
import json, sys
import pycolmap

def camera_of(asked):
    model, width, height, params = asked
    return pycolmap.Camera(model=model, width=width, height=height, params=params)

def options_of(asked):
    options = pycolmap.UndistortCameraOptions()
    options.blank_pixels, options.max_image_size = asked
    return options

def project(asked):
    return [camera_of(c).img_from_cam(points).tolist() for c, points in asked]

def unproject(asked):
    return [camera_of(c).cam_from_img(pixels).tolist() for c, pixels in asked]

def undistort_cameras(asked):
    cameras = [pycolmap.undistort_camera(options_of(o), camera_of(c)) for c, o in asked]
    return [[u.model_name, u.width, u.height, u.params.tolist()] for u in cameras]

def undistort_images(asked):
    for c, o, source, target in asked:
        image, _ = pycolmap.undistort_image(options_of(o), pycolmap.Bitmap.read(source, True), camera_of(c))
        image.write(target)

def synthesize(asked):
    options = pycolmap.SyntheticDatasetOptions()
    for name, value in asked["options"].items():
        setattr(options, name, value)
    pycolmap.set_random_seed(1)
    model = pycolmap.synthesize_dataset(options)
    for folder in asked["binary"]:
        model.write_binary(folder)
    for folder in asked["text"]:
        model.write_text(folder)
    return describe_model(model)

def describe(asked):
    return describe_model(pycolmap.Reconstruction(asked))

def describe_model(model):
    model.update_point_3d_errors()
    images = {}
    for image in model.images.values():
        seen = [[*p.xy.tolist(), *model.points3D[p.point3D_id].xyz.tolist()] for p in image.points2D if p.has_point3D()]
        camera = model.cameras[image.camera_id]
        pose = image.cam_from_world().matrix().tolist()
        images[image.name] = [[camera.model_name, camera.width, camera.height, camera.params.tolist()], pose, seen]
    points = [[*p.xyz.tolist(), *p.color.tolist(), len(p.track.elements)] for p in model.points3D.values()]
    return {"images": images, "points": points, "error": model.compute_mean_reprojection_error()}

answer = globals()[sys.argv[1]](json.load(sys.stdin))
json.dump(answer, sys.stdout)
"""


def query_colmap(what: str, question: Any) -> Any:
    """The answer of one function of the program above; the test is skipped where pycolmap is missing."""
    if not any((Path(folder) / "pycolmap").is_dir() for folder in sys.path if folder):
        pytest.skip("pycolmap is not installed")
    command = [sys.executable, "-c", _PROGRAM, what]
    done = subprocess.run(command, input=json.dumps(question), capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)
