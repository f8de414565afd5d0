"""Folders that a run owns: files of other programs, links, damaged files, and a second program, for every kind."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.records import digest_of_file
from pointloom.core.work_folder import locked

from .rgbd.reconstruction.walks import ShortSequence, config

CAMERA = loom.PinholeCameraIntrinsic(32, 24, 30.0, 30.0, 15.5, 11.5)
GREEN, DEPTH = np.full((24, 32, 3), (0, 255, 0), np.uint8), np.full((24, 32), 1000, np.uint16)


def wall():
    return loom.TriangleMesh([[-0.1, -0.1, 1], [0.1, -0.1, 1], [0, 0.1, 1]], [[0, 2, 1]])


def textured(made):
    return [] if made.vertex_colors is None else made.vertex_colors.tolist(), [
        int(each.sum()) for each in made.textures
    ]


def by_frames(folder):
    frames = loom.frames_from([(GREEN, DEPTH)], CAMERA)
    return textured(loom.meshing.texture_mesh(wall(), frames, [np.eye(4)], method="non-rigid", work=folder).mesh)


def by_images(folder):
    return textured(loom.meshing.texture_from_images(wall(), [GREEN], CAMERA, [np.eye(4)], work=folder).mesh)


def reconstructed(folder):
    sizes = config(n_frames_per_fragment=1, n_frames_least=1, tsdf_voxel_size=0.06)
    report = loom.rgbd.run_reconstruction_system(ShortSequence(range(2), width=40), sizes, folder, resume=True)
    return report.used, report.mesh


def paged(folder):
    """Continue the volume of a folder, or begin one."""
    if (folder / "volume.npz").exists():
        volume = loom.PagedTSDFVolume.load(folder, max_blocks=200)
    else:
        volume = loom.PagedTSDFVolume(folder, voxel_size=0.05, page_blocks=2, max_blocks=200)
    with volume:
        if not volume.frame_count:
            volume.integrate(DEPTH, CAMERA, np.eye(4))
        volume.save()
        return volume.extract_triangle_mesh(0).vertices.tolist()


def drive(slam, count=8):
    rng = np.random.default_rng(0)
    walls = [rng.random((3000, 3)) * [30, 0.01, 4] + [-15, y, -1] for y in (-6, 6)]
    walls += [rng.random((3000, 3)) * [0.01, 12, 4] + [x, -6, -1] for x in (-15, 15)]
    points = np.concatenate([*walls, rng.random((2000, 3)) * [30, 12, 0.01] + [-15, -6, -1]])
    for k in range(count):
        slam.register(loom.PointCloud(points - [0.4 * k, 0, 0]))
    slam.finish()


def mapped(folder):
    """Begin a map or add a session to it. Returns the first submap."""
    is_new = not (folder / "map.npz").exists()
    SLAM = loom.registration.LidarSLAM
    drive(SLAM(folder=folder, submap_length=1.0) if is_new else SLAM.open(folder))
    with np.load(folder / "submap-000000.npz") as stored:
        return stored["values"].tolist()


RUNS = {"frames": by_frames, "images": by_images, "reconstruction": reconstructed, "pages": paged, "map": mapped}
MARKERS = {"frames": "inputs.json", "images": "inputs.json", "reconstruction": "config.json", "pages": "volume.npz",
           "map": "map.npz"}  # fmt: skip
FOREIGN = ("notes.txt", "scan.npz", "rigid.npz", "choice.npz", "00000001.npz", "submap-000000.npz", "20251130.npz")


@pytest.fixture(scope="module")
def finished(tmp_path_factory):
    """The folders of finished runs with their results, by kind, made when they are needed."""
    made = {}

    def of(kind):
        if kind not in made:
            folder = tmp_path_factory.mktemp(kind) / "work"
            made[kind] = folder, RUNS[kind](folder)
        return made[kind]

    return of


@pytest.fixture(params=RUNS)
def kind(request):
    return request.param


@pytest.fixture
def folder(finished, kind, tmp_path):
    """A copy of a finished run that a test may change."""
    return Path(shutil.copytree(finished(kind)[0], tmp_path / "work"))


def contents(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_link_in_place_of_any_file_is_neither_followed_nor_removed(kind, folder, tmp_path):
    for number, name in enumerate(sorted(contents(folder))):
        mine, link = tmp_path / f"mine-{number}", folder / name
        link.rename(mine)
        link.symlink_to(mine)
        before = mine.read_bytes()
        with pytest.raises(loom.FileError, match=r"is a symbolic link"):
            RUNS[kind](folder)
        assert link.is_symlink() and mine.read_bytes() == before, name
        link.unlink()
        mine.rename(link)


def test_a_second_program_is_an_error(kind, folder):
    before = contents(folder)
    with locked(folder), pytest.raises(loom.FileError, match="another run is using it"):
        RUNS[kind](folder)
    assert contents(folder) == before


def test_files_of_other_programs_in_the_folder_of_a_run_are_kept(kind, folder, finished):
    own = {path.name for path in folder.rglob("*")}
    others = {Path(name): name.encode() for name in FOREIGN if name not in own}
    for name, content in others.items():
        (folder / name).write_bytes(content)
    assert RUNS[kind](folder) == finished(kind)[1]
    assert contents(folder).items() >= others.items()


@pytest.mark.parametrize("marker", [True, False])
def test_a_folder_of_another_program_is_not_used(kind, tmp_path, marker):
    folder = tmp_path / "work"
    folder.mkdir()
    for name in (*FOREIGN, *([MARKERS[kind]] if marker else ())):
        (folder / name).write_text(f'{{"name": "{name}"}}')
    before = contents(folder)
    with pytest.raises(loom.FileError, match=str(folder)):
        RUNS[kind](folder)
    assert contents(folder) == before


def test_a_volume_replaces_only_a_volume(tmp_path):
    np.savez(tmp_path / "volume.npz", values=np.zeros(3))
    before = contents(tmp_path)
    with pytest.raises(loom.FileError, match="do not belong to a run"):
        loom.PagedTSDFVolume(tmp_path, voxel_size=0.05, overwrite=True)
    assert contents(tmp_path) == before


@pytest.mark.parametrize(
    "damage", [lambda body: b"", lambda body: body[:-9], lambda body: body[:70] + b"x" + body[71:]]
)
def test_a_damaged_file_is_made_again_or_an_error_that_names_the_folder(kind, folder, finished, damage):
    for name, body in contents(folder).items():
        (folder / name).write_bytes(damage(body))
        try:
            assert RUNS[kind](folder) == finished(kind)[1], name
        except loom.FileError as error:
            assert str(folder) in str(error), name
        shutil.rmtree(folder)
        shutil.copytree(finished(kind)[0], folder)


HUGE = {"i": 10**9, "f": 1e30}
CHANGES = {
    "no rows": lambda values: values[:0] if values.ndim else values,
    "one row less": lambda values: values[:-1] if values.ndim else values,
    "texts": lambda values: values.astype("U5"),
    "NaN": lambda values: np.full_like(values, np.nan) if values.dtype.kind == "f" else values[:0],
    "huge": lambda values: values[:0] if values.dtype == bool else np.full_like(values, HUGE[values.dtype.kind]),
    "negative": lambda values: np.full_like(values, -7) if values.dtype.kind != "b" else values[:0],
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("kind", ["frames", "images"], indirect=True)
def test_a_kept_step_of_other_values_is_made_again_though_its_digest_matches(kind, folder, finished, change):
    manifest = folder / "inputs.json"
    for path in sorted(folder.glob("*.npz")):
        before = path.read_bytes()
        with np.load(path) as stored:
            arrays = dict(stored)
        for name, values in arrays.items():
            if name == "shifts" and (change(values) == -7).all():
                continue  # [px] which a warp may have
            np.savez(path, **{**arrays, name: change(values)})
            content = json.loads(manifest.read_text())
            content["files"][path.name] = digest_of_file(path)
            manifest.write_text(json.dumps(content))
            assert RUNS[kind](folder) == finished(kind)[1], (path.name, name)
            assert path.read_bytes() == before, name
