"""A job with fast stages that write small files of the real kinds."""

import json
from dataclasses import replace
from inspect import signature
from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.sfm.model_quality import ModelQuality
from pointloom.photogrammetry.video import chain, motion, surface
from pointloom.photogrammetry.video.units import fit_units

COUNT = 8


def write_json(path, **content):
    path.write_text(json.dumps(content))


@pytest.fixture
def film(tmp_path):
    path = tmp_path / "walk.mp4"
    path.write_bytes(b"a film")
    return path


def set_stage(monkeypatch, name, make, stages=chain.STAGES, *, inputs_of=None):
    """Replace a stage. Its inputs are the keyword parameters of `inputs_of`, by default of `make`."""
    _folder, _report, *inputs = signature(inputs_of or make).parameters
    monkeypatch.setitem(stages, name, replace(stages[name], make=make, inputs=tuple(inputs), resumes=False))


@pytest.fixture
def quick(monkeypatch):
    """Fast stages; `ran` lists the stages that ran, and the other attributes set their results."""
    state = SimpleNamespace(
        ran=[], registered=COUNT, reasons=[], only_rotated=False, fraction=0.6, triangles=2, fail=None
    )
    state.damage = []

    def stage(name):
        def wrapped(make):
            def run(folder, report, **given):
                state.ran.append(name)
                if state.fail == name:
                    (folder / "half").write_text("half")
                    raise KeyboardInterrupt
                report("step", 1, 1)
                return make(folder, report, **given)

            set_stage(monkeypatch, name, run, inputs_of=make)

        return wrapped

    @stage("frames")
    def take_frames(folder, report, *, source, max_frames):
        (folder / motion.IMAGES).mkdir()
        count = min(COUNT, max_frames)
        for number in range(0, 10 * count, 10):
            (folder / motion.IMAGES / f"frame_{number:06d}.png").write_bytes(source.read_bytes() + b"%d" % number)
        return {"kept": count, "frames": 80, "notes": ["80 of 90 suitable frames are used"], "warnings": state.damage}

    @stage("features")
    def find_features(folder, report, *, frames, intrinsic, seed):
        of = motion.image_names(frames)
        write_json(folder / "features.json", camera=str(intrinsic), seed=seed, of=of)
        return {}

    @stage("matches")
    def match(folder, report, *, frames, features, seed):
        (folder / "matches.json").write_bytes((features.folder / "features.json").read_bytes())
        return {}

    @stage("model")
    def map_images(folder, report, *, frames, matches, fixed_camera, seed):
        names = motion.image_names(frames)[: state.registered]
        quality = ModelQuality(COUNT, len(names), (len(names),), 100, 50.0, 8.0, 30.0, 0.4, tuple(state.reasons))
        if names:
            poses = np.tile(np.eye(4), (len(names), 1, 1))
            poses[:, 0, 3], poses[::2, 1, 3] = -0.5 * np.arange(len(names)), 1.0  # half a unit apart, in a zigzag
            camera = loom.CameraModel("PINHOLE", 64, 48, [50, 50, 32, 24])
            loom.write_colmap_model(folder / motion.MODEL, loom.SfmModel(names, [camera] * len(names), poses))
        contents = {"missing": [], "cameras": ["PINHOLE 64 x 48: 50 50 32 24"], "turned": state.only_rotated}
        return quality.to_dict() | contents

    @stage("undistorted")
    def straighten(folder, report, *, frames, model, max_size, device):
        loom.write_colmap_model(folder / surface.SPARSE, motion.read_model(model))
        state.max_size = max_size
        (folder / surface.IMAGES).mkdir()
        (folder / surface.IMAGES / "all").write_text(str(min(max_size, 64)))
        return {"images": state.registered, "sizes": [[min(max_size, 64), 48]]}

    @stage("depth")
    def estimate(folder, report, *, undistorted, seed, device):
        write_json(folder / "depth.json", seed=seed, size=(undistorted.folder / surface.IMAGES / "all").read_text())
        return {"images": state.registered, "fraction": 1.0}

    @stage("fused")
    def fuse_points(folder, report, *, undistorted, depth, device):
        loom.write_point_cloud(folder / surface.CLOUD, loom.PointCloud([[0, 0, 1], [0, 1, 1], [1, 0, 1.0]]))
        (folder / "of").write_bytes((depth.folder / "depth.json").read_bytes())
        return {"fraction": state.fraction, "points": 3}

    @stage("mesh")
    def make_mesh(folder, report, *, undistorted, fused, units, device):
        model, _, _ = surface.open_straightened(undistorted)
        fit = fit_units(units, model)
        square = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
        mesh = loom.TriangleMesh(square, [[0, 2, 1], [0, 3, 2]][: state.triangles], vertex_colors=np.ones((4, 3)))
        mesh = mesh.transform(fit.T_world_model)
        loom.write_triangle_mesh(folder / surface.MESH, mesh)
        bounds = {"min": mesh.vertices.min(axis=0).tolist(), "max": mesh.vertices.max(axis=0).tolist()}
        return {"vertices": 4, "triangles": len(mesh), "bounds": bounds, "floaters": 0}

    return state
