"""The chain from photographs to a mesh on sets that chose none of its constants: what is placed, how well, the cost.

    python benchmarks/photo_chain.py WORK [--only drone] [--size 480] [--colmap] [--output results.json]
    POINTLOOM_DATA=<folder> python benchmarks/photo_chain.py WORK --only temple

Made sets (photo_sets.py) have exact truth; of real ones what there is: cameras of the temple and the fountain, none of
sceaux. Each set runs in a process of its own, as `pointloom video` does with a work folder in WORK/<set>, and then
`pointloom texture`. Centers are off after the similarity that fits them best; those of the drone without any, in the
frame that GPS gave. Accuracy is the share of the mesh, by area, that lies within a threshold of the true surface,
completeness that of the points which three pictures see within it of the mesh. COLMAP is pycolmap's incremental mapper
with its own defaults (a camera a picture's EXIF, all pairs) on the same pictures and masks.
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
from photo_sets import PLACE, SETS, PhotoSet
from photo_writing import seen_points, write_set
from sfm_accuracy import camera_errors, fit_similarity

import pointloom as loom
from pointloom.visualization.render.picture_files import save_picture

SAMPLES = 100_000
FITS = 40  # steps of closest points
SIZE = 480  # of pictures of which depth is found [px]


def run(name: str, work: Path, size: int) -> dict[str, Any]:
    """The chain on one set, in this process."""
    folder, photos = work / name, made_or_real(name)
    if not (folder / "pictures").is_dir():
        write_set(photos, folder) if isinstance(photos, PhotoSet) else photos.write(folder)
    masks = folder / "masks" if (folder / "masks").is_dir() else None
    settings = loom.video.Settings(max_size=size, masks=masks)
    outputs = loom.video.Outputs(mesh=folder / "mesh.ply")
    result = loom.video.reconstruct(
        folder / "pictures", settings, outputs=outputs, work=folder / "work", overwrite=True, device="cpu"
    )
    quality, count = result.figures.quality, result.figures.picture_count
    report: dict[str, Any] = {
        "set": name,
        "pictures": count,
        "placed": quality.registered_count,
        "error_px": quality.error,
        "cameras": list(result.figures.cameras),
        "confirmed_share": result.figures.confirmed_share,
        "triangles": result.figures.triangle_count,
        "warnings": result.warnings,
        "units": result.units,
        "cpu_seconds_a_picture": {
            stage: round(told.cost["cpu_seconds"] / count, 2) for stage, told in result.reached.items()
        },
        "peak_mib": {stage: round(told.cost["peak_bytes"] / 2**20) for stage, told in result.reached.items()},
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
        frame, world = result.fit.frame, loom.video.WorldFrame(*PLACE)
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
    """Errors of a model in meters east, north, up, without any fit."""
    true = np.array([poses[name] for name in model.names])
    found = loom.video.WorldFrame(*PLACE).to_enu(frame.to_geodetic(model.centers))
    off = found - true[:, :3, 3]
    scale, R, _ = fit_similarity(model.centers, true[:, :3, 3])
    return {
        "rms": float(np.sqrt((off**2).sum(1).mean())),
        "mean_shift": off.mean(0).round(3).tolist(),
        "up_degrees": float(np.degrees(np.arccos(np.clip(R[2, 2], -1, 1)))),
        "north_degrees": float(np.degrees(np.arctan2(R[0, 1], R[1, 1]))),
        "scale": 1 / float(scale),
        "epsg": frame.epsg,
    }


def by_name(model: Any) -> Any:
    """The same model with the names of the truth: pictures may have been written anew with other endings."""
    return loom.SfmModel([Path(name).stem for name in model.names], model.cameras, model.T_camera_world)


def by_itself(photos: PhotoSet, vertices: Any, mesh: Any) -> Any:
    """The mesh after the similarity that brings itself, not its cameras, nearest to the truth (closest points)."""
    scene, rows = photos.stage.scene(), np.linspace(0, len(vertices) - 1, 20_000).astype(int)
    for _ in range(FITS):
        near = scene.compute_closest_points(vertices[rows].astype(np.float32))["points"].astype(float)
        off = np.linalg.norm(near - vertices[rows], axis=1)
        kept = off < np.quantile(off, 0.9)
        s, R, t = fit_similarity(vertices[rows][kept], near[kept])
        vertices = s * vertices @ R.T + t
    return loom.TriangleMesh(vertices, mesh.triangles)


def mesh_errors(photos: PhotoSet, mesh: Any) -> dict[str, Any]:
    """Distances between a mesh, sampled by area, and the truth."""
    scene, ours = photos.stage.scene(), loom.RaycastingScene()
    points = mesh.sample_points_uniformly(SAMPLES, seed=0).points
    accuracy = scene.compute_distance(points.astype(np.float32))
    ours.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
    asked = seen_points(photos, photos.thresholds[0])
    missed = ours.compute_distance(asked.astype(np.float32))
    report: dict[str, Any] = {"median": float(np.median(accuracy)), "95 %": float(np.quantile(accuracy, 0.95))}
    for threshold in photos.thresholds:
        report[f"accuracy {threshold:g} m"] = round(float((accuracy < threshold).mean()), 4)
        report[f"completeness {threshold:g} m"] = round(float((missed < threshold).mean()), 4)
    return report


def colmap(name: str, work: Path) -> dict[str, Any]:
    """COLMAP's incremental mapper on the same pictures, with its defaults."""
    import pycolmap

    folder, photos = work / name, made_or_real(name)
    place = folder / "colmap"
    place.mkdir(exist_ok=True)
    (place / "database.db").unlink(missing_ok=True)
    begin = cpu_seconds()
    reader = pycolmap.ImageReaderOptions()
    if (folder / "masks").is_dir():
        reader.mask_path = folder / "masks"
    pycolmap.extract_features(
        place / "database.db", folder / "pictures", reader_options=reader, device=pycolmap.Device.cpu
    )
    pycolmap.match_exhaustive(place / "database.db", device=pycolmap.Device.cpu)
    found = pycolmap.incremental_mapping(place / "database.db", folder / "pictures", place)
    report: dict[str, Any] = {"models": len(found), "placed": 0, "cpu_seconds": round(cpu_seconds() - begin, 1)}
    if found:
        best = max(found.values(), key=lambda model: model.num_reg_images())
        best.write(place)
        model = by_name(loom.read_colmap_model(place))
        report |= {"placed": len(model.names), "error_px": round(best.compute_mean_reprojection_error(), 3)}
        report["focals"] = sorted({round(float(camera.params[0]), 1) for camera in model.cameras})
        if photos.poses:
            report["centers"] = camera_errors(model, photos.poses)
    return report


def made_or_real(name: str) -> PhotoSet | RealSet:
    return SETS[name]() if name in SETS else REAL[name]()


def cpu_seconds() -> float:
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


def textured(name: str, work: Path) -> dict[str, Any]:
    """`pointloom texture` of the mesh, and pictures of both as the first camera sees them."""
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
    model = loom.read_colmap_model(folder / "work" / "mesh" / "sparse")
    mesh = loom.read_triangle_mesh(folder / "textured.obj")
    for k in (0, len(model.names) // 2):
        camera = model.cameras[k]
        lens = loom.PinholeCameraIntrinsic(640, 480, *[camera.params[0] * 640 / camera.width] * 2, 319.5, 239.5)
        seen = loom.View(lens, np.linalg.inv(model.T_camera_world[k]))
        save_picture(folder / f"view{k}.png", loom.render({"geometry": mesh, "shaded": False}, seen))
    return report


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", type=Path)
    parser.add_argument("--only", action="append", choices=[*SETS, *REAL], help="all made ones where not given")
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
    found = json.loads(given.output.read_text()) if given.output and given.output.exists() else {}
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
        found[name] = report
        if given.output:
            given.output.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    main()
