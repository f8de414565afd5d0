"""The pipeline from photographs to a mesh on held-out sets: registered images, accuracy, cost.

    python benchmarks/photo_chain.py WORK [--only drone] [--size 480] [--colmap] [--output results.json]
    POINTLOOM_DATA=<folder> python benchmarks/photo_chain.py WORK --only temple

No constant was chosen on these sets. Synthetic sets (photo_sets.py) have exact ground truth; of real ones only the
cameras of the temple and the fountain are known, none of sceaux. Each set runs in a separate process, as `pointloom
video` with a work folder in WORK/<set>, and then `pointloom texture`. Errors of camera centers are those after the best
similarity; for the drone without any, in the frame given by GPS. Accuracy is the fraction of the mesh area within a
threshold of the true surface; completeness is the fraction of the points visible in three images within it of the mesh.
COLMAP is pycolmap's incremental mapper with its defaults (one camera per EXIF, all pairs) on the same images and masks.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from photo_real import REAL, RealSet
from photo_sets import SETS, WORLD_ORIGIN, PhotoSet
from photo_writing import seen_points, write_set
from sfm_accuracy import camera_errors, fit_similarity

import pointloom as loom
from pointloom.visualization.render.picture_files import write_image

SAMPLES = 100_000
FITS = 40  # iterations of ICP
SIZE = 480  # of images for the depth maps [px]


def run(name: str, work: Path, size: int) -> dict[str, Any]:
    """Run the pipeline on one set, in this process."""
    folder, photos = work / name, made_or_real(name)
    if not (folder / "images").is_dir():
        write_set(photos, folder) if isinstance(photos, PhotoSet) else photos.write(folder)
    masks = folder / "masks" if (folder / "masks").is_dir() else None
    settings = loom.photogrammetry.VideoSettings(max_size=size, masks=masks)
    outputs = loom.photogrammetry.VideoOutputs(mesh=folder / "mesh.ply")
    result = loom.photogrammetry.reconstruct_video(
        folder / "images", settings, outputs=outputs, work=folder / "work", overwrite=True, device="cpu"
    )
    quality, count = result.figures.quality, result.figures.image_count
    report: dict[str, Any] = {
        "set": name,
        "images": count,
        "placed": quality.registered_count,
        "error_px": quality.error,
        "cameras": list(result.figures.cameras),
        "confirmed_fraction": result.figures.confirmed_fraction,
        "triangles": result.figures.triangle_count,
        "warnings": result.warnings,
        "units": result.units,
        "cpu_seconds_an_image": {
            stage: round(reached.cost["cpu_seconds"] / count, 2) for stage, reached in result.reached.items()
        },
        "peak_mib": {stage: round(reached.cost["peak_bytes"] / 2**20) for stage, reached in result.reached.items()},
    }
    if result.model is not None and photos.poses:
        report |= compared(photos, result)
    return report


def compared(photos: Any, result: Any) -> dict[str, Any]:
    """Errors of cameras and mesh against the truth."""
    model, poses = by_name(result.model), photos.poses
    report: dict[str, Any] = {"centers": camera_errors(model, poses)}
    true = np.array([poses[name][:3, 3] for name in model.names])
    scale, R, t = fit_similarity(model.centers, true)
    frames = {"mesh": (scale, R, t)}
    if getattr(photos, "places", False) and result.fit is not None and result.fit.frame is not None:
        frame, world = result.fit.frame, loom.WorldFrame(*WORLD_ORIGIN)
        report["world"] = in_world(model, poses, frame)
        frames["mesh in the world"] = 1.0, np.eye(3), world.to_enu(frame.to_geodetic(np.zeros((1, 3))))[0]
    if result.mesh is not None and isinstance(photos, PhotoSet):
        for which, (s, R, t) in frames.items():
            moved = loom.TriangleMesh(s * result.mesh.vertices @ R.T + t, result.mesh.triangles)
            report[which] = mesh_errors(photos, moved)
        s, R, t = frames["mesh"]
        report["mesh by itself"] = mesh_errors(
            photos, by_itself(photos, s * result.mesh.vertices @ R.T + t, result.mesh)
        )
    return report


def in_world(model: Any, poses: dict[str, Any], frame: Any) -> dict[str, Any]:
    """Errors of a model in meters east, north, up, without alignment."""
    true = np.array([poses[name] for name in model.names])
    centers = loom.WorldFrame(*WORLD_ORIGIN).to_enu(frame.to_geodetic(model.centers))
    errors = centers - true[:, :3, 3]
    scale, R, _ = fit_similarity(model.centers, true[:, :3, 3])
    return {
        "rms": float(np.sqrt((errors**2).sum(1).mean())),
        "mean_shift": errors.mean(0).round(3).tolist(),
        "up_degrees": float(np.degrees(np.arccos(np.clip(R[2, 2], -1, 1)))),
        "north_degrees": float(np.degrees(np.arctan2(R[0, 1], R[1, 1]))),
        "scale": 1 / float(scale),
        "epsg": frame.epsg,
    }


def by_name(model: Any) -> Any:
    """The same model with the names of the ground truth: images may have been rewritten with other suffixes."""
    return loom.SfmModel([Path(name).stem for name in model.names], model.cameras, model.T_camera_world)


def by_itself(photos: PhotoSet, vertices: Any, mesh: Any) -> Any:
    """The mesh aligned to the ground truth by a similarity of its surface (closest points), not of its cameras."""
    scene, rows = photos.stage.scene(), np.linspace(0, len(vertices) - 1, 20_000).astype(int)
    for _ in range(FITS):
        near = scene.compute_closest_points(vertices[rows].astype(np.float32))["points"].astype(float)
        distances = np.linalg.norm(near - vertices[rows], axis=1)
        near_rows = distances < np.quantile(distances, 0.9)
        s, R, t = fit_similarity(vertices[rows][near_rows], near[near_rows])
        vertices = s * vertices @ R.T + t
    return loom.TriangleMesh(vertices, mesh.triangles)


def mesh_errors(photos: PhotoSet, mesh: Any) -> dict[str, Any]:
    """Distances between a mesh, sampled by area, and the ground truth."""
    scene, mesh_scene = photos.stage.scene(), loom.RaycastingScene()
    points = mesh.sample_points_uniformly(SAMPLES, seed=0).points
    accuracy = scene.compute_distance(points.astype(np.float32))
    mesh_scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
    targets = seen_points(photos, photos.thresholds[0])
    missed = mesh_scene.compute_distance(targets.astype(np.float32))
    report: dict[str, Any] = {"median": float(np.median(accuracy)), "95 %": float(np.quantile(accuracy, 0.95))}
    for threshold in photos.thresholds:
        report[f"accuracy {threshold:g} m"] = round(float((accuracy < threshold).mean()), 4)
        report[f"completeness {threshold:g} m"] = round(float((missed < threshold).mean()), 4)
    return report


def colmap(name: str, work: Path) -> dict[str, Any]:
    """COLMAP's incremental mapper on the same images, with its defaults."""
    import pycolmap

    folder, photos = work / name, made_or_real(name)
    colmap_folder = folder / "colmap"
    colmap_folder.mkdir(exist_ok=True)
    (colmap_folder / "database.db").unlink(missing_ok=True)
    begin = cpu_seconds()
    reader = pycolmap.ImageReaderOptions()
    if (folder / "masks").is_dir():
        reader.mask_path = folder / "masks"
    pycolmap.extract_features(
        colmap_folder / "database.db", folder / "images", reader_options=reader, device=pycolmap.Device.cpu
    )
    pycolmap.match_exhaustive(colmap_folder / "database.db", device=pycolmap.Device.cpu)
    models = pycolmap.incremental_mapping(colmap_folder / "database.db", folder / "images", colmap_folder)
    report: dict[str, Any] = {"models": len(models), "placed": 0, "cpu_seconds": round(cpu_seconds() - begin, 1)}
    if models:
        best = max(models.values(), key=lambda model: model.num_reg_images())
        best.write(colmap_folder)
        model = by_name(loom.read_cameras(colmap_folder))
        report |= {"placed": len(model.names), "error_px": round(best.compute_mean_reprojection_error(), 3)}
        report["focals"] = sorted({round(float(camera.params[0]), 1) for camera in model.cameras})
        if photos.poses:
            report["centers"] = camera_errors(model, photos.poses)
    return report


def made_or_real(name: str) -> PhotoSet | RealSet:
    return SETS[name]() if name in SETS else REAL[name]()


def cpu_seconds() -> float:
    own, children = (resource.getrusage(target) for target in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def textured(name: str, work: Path) -> dict[str, Any]:
    """`pointloom texture` of the mesh, and renderings of both from the first camera."""
    folder = work / name
    begin, command = cpu_seconds(), [sys.executable, "-m", "pointloom", "texture"]
    done = subprocess.run(
        [*command, folder / "mesh.ply", folder / "work", "-o", folder / "textured.obj", "--force"],
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode not in (0, 3):
        return {"error": done.stderr[-500:]}
    report = {"cpu_seconds": round(cpu_seconds() - begin, 1), "code": done.returncode}
    model = loom.read_cameras(folder / "work" / "mesh" / "sparse")
    mesh = loom.read_triangle_mesh(folder / "textured.obj")
    for k in (0, len(model.names) // 2):
        camera = model.cameras[k]
        lens = loom.PinholeCameraIntrinsic(640, 480, *[camera.params[0] * 640 / camera.width] * 2, 319.5, 239.5)
        view = loom.View(lens, np.linalg.inv(model.T_camera_world[k]))
        write_image(folder / f"view{k}.png", loom.render({"geometry": mesh, "shaded": False}, view))
    return report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--only", action="append", choices=[*SETS, *REAL], help="default: all synthetic sets")
    parser.add_argument("--size", type=int, default=SIZE)
    parser.add_argument("--colmap", action="store_true")
    parser.add_argument("--output", type=Path)
    parser.add_argument("--job", choices=("run", "colmap", "textured"), help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.job:
        name = given.only[0]
        done = run(name, given.work, given.size) if given.job == "run" else globals()[given.job](name, given.work)
        (given.work / name / f"{given.job}.json").write_text(json.dumps(done))
        return
    reports = json.loads(given.output.read_text()) if given.output and given.output.exists() else {}
    for name in given.only or SETS:
        (given.work / name).mkdir(parents=True, exist_ok=True)
        report: dict[str, Any] = {}
        for job in ("run", "textured", *(["colmap"] if given.colmap else [])):
            begin = time.monotonic()
            command = [
                sys.executable,
                __file__,
                str(given.work),
                "--only",
                name,
                "--size",
                str(given.size),
                "--job",
                job,
            ]
            code = subprocess.run(command, check=False, env=os.environ).returncode
            file = given.work / name / f"{job}.json"
            report[job] = json.loads(file.read_text()) if code == 0 else {"exit": code}
            print(name, job, f"{time.monotonic() - begin:.0f} s", json.dumps(report[job]), flush=True)
        reports[name] = report
        if given.output:
            given.output.write_text(json.dumps(reports, indent=1) + "\n")


if __name__ == "__main__":
    main()
