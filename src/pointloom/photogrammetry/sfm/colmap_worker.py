"""Worker process for COLMAP: one JSON job on standard input ("stage" and its arguments), JSON lines on standard output.

Runs as `python colmap_worker.py < job.json`. It imports pycolmap first and nothing of this package but
colmap_cameras.py, since several packages with copies of the same libraries may hang or abort a process. Output:
{"registered": n} as progress, and finally {"done": {...}} or {"failed": "why"}. COLMAP logs to standard error.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import runpy
import signal
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import IO, Any

# Initial focal length without EXIF, relative to the longer side. Phones and depth cameras have 0.7 to 0.9 in videos.
# COLMAP's 1.2 registered 47 of 99 frames of a room, with a focal length a third too large. This value all of them.
FOCAL_FACTOR = 0.85
# For fisheye models: 125 degrees over the longer side, between action cameras and hemispheres. With 0.85 no image of a
# camera with 0.5 could be registered.
FISHEYE_FACTOR = 0.45

NO_CUDA = "this pycolmap was built without CUDA; pip uninstall pycolmap, then pip install pycolmap-cuda12"
NO_NETWORKS = (
    "ALIKED and LightGlue require a pycolmap built with ONNX, and their weights; PyPI's has neither. "
    'Build COLMAP with ONNX_ENABLED, or use kind="sift"'
)

_PR_SET_PDEATHSIG = 1  # Linux <sys/prctl.h>


def main() -> int:
    answers = _own_output()
    if sys.platform == "linux":  # ends this process if its parent is killed
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    job = json.load(sys.stdin)
    try:
        import pycolmap
    except ImportError as error:
        return _end(answers, {"missing": str(error)})
    pycolmap.logging.logtostderr = True
    pycolmap.logging.minloglevel = pycolmap.logging.WARNING.value
    pycolmap.set_random_seed(job.get("seed", 0))
    stages = {"features": find_features, "matches": match, "model": map_images, "points": triangulate}
    try:
        done = stages[job["stage"]](pycolmap, job, answers)
    except MemoryError:
        return _end(answers, {"failed": "out of memory"})
    except Exception as error:
        return _end(answers, {"failed": f"{type(error).__name__}: {error}"})
    return _end(answers, {"done": done})


def find_features(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[str, Any]:
    """Extract features. Images are numbered before the threads start, since these finish in any order."""
    extraction = pycolmap.FeatureExtractionOptions()
    extraction.max_image_size, extraction.num_threads = job["max_size"], job["threads"]
    extraction.use_gpu = on_gpu(pycolmap, job)
    _choose_kind(pycolmap, extraction, job["kind"])
    extraction.sift.max_num_features = job["max_features"]
    with pycolmap.Database.open(job["database"]):
        pass  # created if missing
    for group in job["groups"]:
        reader = pycolmap.ImageReaderOptions()
        reader.camera_model, reader.camera_params = group["model"], group["params"]
        reader.default_focal_length_factor = FISHEYE_FACTOR if is_fisheye(group["model"]) else FOCAL_FACTOR
        options = {"camera_mode": pycolmap.CameraMode.SINGLE, "image_names": group["names"]}
        pycolmap.import_images(job["database"], job["images"], options=reader, **options)
        if group["doubted"]:
            _forget_focal_length(pycolmap, job["database"], group, reader.default_focal_length_factor)
    names = [name for group in job["groups"] for name in group["names"]]
    reading = pycolmap.ImageReaderOptions()
    if job["masks"]:
        reading.mask_path = job["masks"]
    options = {"reader_options": reading, "extraction_options": extraction}
    options["device"] = pycolmap.Device.cuda if extraction.use_gpu else pycolmap.Device.cpu
    pycolmap.extract_features(job["database"], job["images"], image_names=names, **options)
    return {"gpu": extraction.use_gpu}


def _forget_focal_length(pycolmap: ModuleType, path: str, group: dict[str, Any], factor: float) -> None:
    with pycolmap.Database.open(path) as database:
        camera = database.read_camera(database.read_image_with_name(group["names"][0]).camera_id)
        params = list(camera.params)
        for index in camera.focal_length_idxs():
            params[index] = factor * max(camera.width, camera.height)
        camera.params, camera.has_prior_focal_length = params, False
        database.update_camera(camera)


def is_fisheye(model: str) -> bool:
    return "FISHEYE" in model or model == "FOV"


def on_gpu(pycolmap: ModuleType, job: dict[str, Any]) -> bool:
    """True if features use a GPU: pycolmap-cuda12 and a device. RuntimeError if requested but missing."""
    wanted = job["gpu"]
    if wanted is False:
        return False
    why = "" if pycolmap.has_cuda else NO_CUDA
    if not why and not _cuda_devices():
        why = "there is no CUDA device, or no driver"
    if why and wanted:
        raise RuntimeError(f"use_gpu: {why}")
    return not why


def _cuda_devices() -> int:
    try:
        driver = ctypes.CDLL("nvcuda.dll" if sys.platform == "win32" else "libcuda.so.1")
    except OSError:
        return 0
    count = ctypes.c_int(0)
    return count.value if driver.cuInit(0) == 0 and driver.cuDeviceGetCount(ctypes.byref(count)) == 0 else 0


def _choose_kind(pycolmap: ModuleType, options: Any, kind: str) -> None:
    """Select SIFT or a network. RuntimeError without ONNX, where COLMAP would abort the process."""
    if kind == "sift":
        return
    if not hasattr(options, "aliked"):
        raise RuntimeError(f"kind: {NO_NETWORKS}")
    is_matching = isinstance(options, pycolmap.FeatureMatchingOptions)
    matcher, extractor = pycolmap.FeatureMatcherType, pycolmap.FeatureExtractorType
    options.type = matcher.ALIKED_LIGHTGLUE if is_matching else extractor.ALIKED_N16ROT


def match(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[str, Any]:
    with _guesses_as_priors(pycolmap, job):
        return _match(pycolmap, job)


@contextlib.contextmanager
def _guesses_as_priors(pycolmap: ModuleType, job: dict[str, Any]) -> Iterator[None]:
    """Mark initial fisheye focal lengths as known: COLMAP 4.2 drops pairs and images of fisheyes without one."""
    with pycolmap.Database.open(job["database"]) as database:
        cameras = database.read_all_cameras()
    guessed = [camera for camera in cameras if is_fisheye(camera.model.name) and not camera.has_prior_focal_length]
    for is_known in (True, False):
        if guessed:
            with pycolmap.Database.open(job["database"]) as database:
                for camera in guessed:
                    camera.has_prior_focal_length = is_known
                    database.update_camera(camera)
        if is_known:
            yield


def _match(pycolmap: ModuleType, job: dict[str, Any]) -> dict[str, Any]:
    matching = pycolmap.FeatureMatchingOptions()
    matching.num_threads, matching.use_gpu = job["threads"], on_gpu(pycolmap, job)
    _choose_kind(pycolmap, matching, job["kind"])
    # The index of the approximate search is random.
    matching.sift.cpu_brute_force_matcher = False
    verification = pycolmap.TwoViewGeometryOptions()
    verification.compute_relative_pose = True
    verification.ransac.random_seed = job["seed"]
    common = {"matching_options": matching, "verification_options": verification}
    common["device"] = pycolmap.Device.cuda if matching.use_gpu else pycolmap.Device.cpu
    if job["pairs"] == "exhaustive":
        pycolmap.match_exhaustive(job["database"], **common)
        return {"gpu": matching.use_gpu}
    if "list" in job:
        listed = pycolmap.ImportedPairingOptions()
        listed.match_list_path = job["list"]
        pycolmap.match_image_pairs(job["database"], pairing_options=listed, **common)
        return {"gpu": matching.use_gpu}
    pairing = pycolmap.SequentialPairingOptions()
    pairing.overlap, pairing.quadratic_overlap = job["overlap"], True  # 1, 2, 4, 8, ... apart only
    pairing.loop_detection = False  # downloads a vocabulary, and aborts without a network
    pairing.num_threads = job["threads"]
    pycolmap.match_sequential(job["database"], pairing_options=pairing, **common)
    return {"gpu": matching.use_gpu}


def map_images(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[str, Any]:
    """Map, check the cameras (several cameras, EXIF's focal length), and write the largest model."""
    models = _mapped(pycolmap, job, answers)
    done: dict[str, Any] = {"sizes": [model.num_reg_images() for model in models], "cameras": {}}
    if models:
        resolve = runpy.run_path(os.fspath(Path(__file__).with_name("colmap_cameras.py")))["resolve_cameras"]
        again = lambda: _mapped(pycolmap, job, answers)  # noqa: E731
        models, done["cameras"] = resolve(pycolmap, job, models, again)
        done["sizes"] = [model.num_reg_images() for model in models]
        models[0].write(job["model"])
    return done


def _mapped(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> list[Any]:
    with _guesses_as_priors(pycolmap, job):
        models = (_map_globally if job["mapper"] == "global" else _map_incrementally)(pycolmap, job, answers)
    # The model number breaks ties of equal size.
    return [model for _, model in sorted(models.items(), key=lambda item: (-item[1].num_reg_images(), item[0]))]


def _map_globally(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[int, Any]:
    options = pycolmap.GlobalPipelineOptions()
    options.num_threads = options.mapper.num_threads = job["threads"]
    options.random_seed = options.mapper.random_seed = job["seed"]
    if job["fixed_camera"]:
        adjustment = options.mapper.bundle_adjustment
        adjustment.refine_focal_length = adjustment.refine_extra_params = False
    scratch = tempfile.mkdtemp(dir=job["scratch"])
    return pycolmap.global_mapping(job["database"], job["images"], scratch, options=options)


def _map_incrementally(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[int, Any]:
    options = pycolmap.IncrementalPipelineOptions()
    options.num_threads = options.mapper.num_threads = job["threads"]
    options.random_seed = options.mapper.random_seed = options.triangulation.random_seed = job["seed"]
    if job["fixed_camera"]:
        options.ba_refine_focal_length = options.ba_refine_extra_params = False
        options.mapper.abs_pose_refine_focal_length = options.mapper.abs_pose_refine_extra_params = False
    scratch, registered = tempfile.mkdtemp(dir=job["scratch"]), 0

    def begin() -> None:
        nonlocal registered
        registered = 2
        _send(answers, {"registered": registered})

    def proceed() -> None:
        nonlocal registered
        registered += 1
        _send(answers, {"registered": registered})

    return pycolmap.incremental_mapping(
        job["database"],
        job["images"],
        scratch,
        options=options,
        initial_image_pair_callback=begin,
        next_image_callback=proceed,
    )


def triangulate(pycolmap: ModuleType, job: dict[str, Any], answers: IO[str]) -> dict[str, Any]:
    """Triangulate matches with fixed poses. Feature positions are undistorted, relative to the principal point."""
    import numpy as np

    with np.load(job["arrays"]) as given:
        given = dict(given)
    model = pycolmap.Reconstruction()
    with pycolmap.Database.open(job["database"]) as database:
        _write_posed(pycolmap, np, model, database, given)
    options = pycolmap.IncrementalPipelineOptions()
    options.num_threads = options.mapper.num_threads = 1
    options.random_seed = options.mapper.random_seed = options.triangulation.random_seed = job["seed"]
    options.extract_colors, options.min_num_matches = False, job["fewest"]
    options.triangulation.ignore_two_view_tracks = len(given["poses"]) > 2
    options.triangulation.min_angle = options.mapper.filter_min_tri_angle = job["angle"]
    options.triangulation.merge_max_reproj_error = options.triangulation.complete_max_reproj_error = job["error"]
    options.mapper.filter_max_reproj_error = job["error"]
    options.triangulation.create_max_angle_error = options.triangulation.continue_max_angle_error = job["angle_error"]
    result = pycolmap.triangulate_points(model, job["database"], job["scratch"], job["scratch"], options=options)
    points = [result.points3D[number] for number in sorted(result.points3D)]
    seen = [(e.image_id - 1, e.point2D_idx, k) for k, point in enumerate(points) for e in point.track.elements]
    positions = np.array([point.xyz for point in points], np.float64).reshape(-1, 3)
    np.savez(job["found"], points=positions, seen=np.array(seen, np.int64).reshape(-1, 3))
    return {"points": len(points)}


def _write_posed(pycolmap: ModuleType, np: ModuleType, model: Any, database: Any, given: dict[str, Any]) -> None:
    for i, pose in enumerate(given["poses"]):
        width, height = (int(side) for side in given["sizes"][i])
        params = [given["focals"][i], given["focals"][i], 0.5, 0.5]
        camera = pycolmap.Camera(model="PINHOLE", width=width, height=height, params=params, camera_id=i + 1)
        model.add_camera_with_trivial_rig(camera)
        pixels = given["places"][given["firsts"][i] : given["firsts"][i + 1]] + 0.5
        image = pycolmap.Image(name=f"{i:06d}", keypoints=pixels, camera_id=i + 1, image_id=i + 1)
        model.add_image_with_trivial_frame(image, pycolmap.Rigid3d(pycolmap.Rotation3d(pose[:, :3]), pose[:, 3]))
    for camera in model.cameras.values():
        database.write_camera(camera, use_camera_id=True)
    for rig in model.rigs.values():
        database.write_rig(rig, use_rig_id=True)
    for frame in model.frames.values():
        database.write_frame(frame, use_frame_id=True)
    for number, image in model.images.items():
        database.write_image(image, use_image_id=True)
        pixels = given["places"][given["firsts"][number - 1] : given["firsts"][number]] + 0.5
        database.write_keypoints(number, pixels.astype(np.float32))
    for (a, b), first, last in zip(given["pairs"], given["starts"], given["starts"][1:], strict=False):
        geometry = pycolmap.TwoViewGeometry()
        geometry.config = pycolmap.TwoViewGeometryConfiguration.CALIBRATED
        geometry.inlier_matches = given["matches"][first:last].astype(np.uint32)
        database.write_matches(int(a) + 1, int(b) + 1, geometry.inlier_matches)
        database.write_two_view_geometry(int(a) + 1, int(b) + 1, geometry)


def _own_output() -> IO[str]:
    """Standard output for JSON only: library output is redirected to standard error."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return answers


def _send(answers: IO[str], message: dict[str, Any]) -> None:
    answers.write(json.dumps(message) + "\n")
    answers.flush()


def _end(answers: IO[str], message: dict[str, Any]) -> int:
    _send(answers, message)
    return 0 if "done" in message else 1


if __name__ == "__main__":
    sys.exit(main())
