"""Outputs are written atomically: file modes, and the previous file."""

import contextlib
import errno
import os
import socket
import stat
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.cameras.trajectory_formats import TRAJECTORY_FORMATS
from pointloom.core import atomic
from pointloom.core.atomic import atomic_folder, atomic_write, restore_folder
from pointloom.io.images.image_formats import PICTURES
from pointloom.io.meshes.mesh_formats import MESH_FORMATS
from pointloom.io.optional_imports import foreign_errors
from pointloom.io.points.formats import WRITTEN
from pointloom.io.splats.splat_files import EXTENSIONS


def write(path, content, **options):
    with atomic_write(path, **options) as file:
        file.write(content)


@pytest.mark.parametrize(("mask", "mode"), [(0o022, 0o644), (0o077, 0o600), (0o002, 0o664)])
def test_new_file_mode_follows_the_umask(tmp_path, mask, mode):
    before = os.umask(mask)
    try:
        write(tmp_path / "a", b"new")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == mode


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o666])
def test_a_file_that_is_replaced_keeps_its_mode(tmp_path, mode):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    path.chmod(mode)
    write(path, b"new")
    assert path.read_bytes() == b"new" and path.stat().st_mode & 0o777 == mode


@pytest.fixture
def access(monkeypatch):
    """Permissions are those of the mode bits of the owner, also for root."""

    def is_allowed(path, wanted, **options):
        mode = Path(path).stat().st_mode
        return all(mode & bits for flag, bits in ((os.W_OK, 0o200), (os.X_OK, 0o100)) if wanted & flag)

    monkeypatch.setattr(os, "access", is_allowed)


@pytest.mark.parametrize("existing", [True, False])
def test_a_link_is_written_through(tmp_path, existing):
    (tmp_path / "disk").mkdir()
    target, link = tmp_path / "disk" / "run.ply", tmp_path / "latest.ply"
    if existing:
        target.write_bytes(b"old")
    link.symlink_to(Path("disk", "run.ply"))
    write(link, b"new")
    assert link.is_symlink() and target.read_bytes() == b"new"
    assert [path.name for path in target.parent.iterdir()] == ["run.ply"]
    with pytest.raises(loom.FileError, match="exists already"):
        write(link, b"newer", overwrite=False)


def test_links_to_nothing_writable_are_errors(tmp_path):
    for name, target in (("self", "self"), ("lost", "none/a"), ("folder", ".")):
        (tmp_path / name).symlink_to(target)
        with pytest.raises(loom.FileError, match=name):
            write(tmp_path / name, b"new")
        assert (tmp_path / name).is_symlink()


def test_pipes_and_devices_are_written_and_remain(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    for name in ("pipe", "link"):
        with subprocess.Popen(["cat", tmp_path / name], stdout=subprocess.PIPE) as reader:
            write(tmp_path / name, b"new")
            assert reader.communicate()[0] == b"new"
    before = Path("/dev/null").stat()
    write("/dev/null", b"new")
    assert stat.S_ISFIFO((tmp_path / "pipe").stat().st_mode) and (tmp_path / "link").is_symlink()
    assert Path("/dev/null").stat().st_ino == before.st_ino and len([*tmp_path.iterdir()]) == 2


def test_sockets_are_refused(tmp_path):
    with contextlib.closing(socket.socket(socket.AF_UNIX)) as end:
        end.bind(str(tmp_path / "a"))
        with pytest.raises(loom.FileError, match="a: is a socket"):
            write(tmp_path / "a", b"new")


def test_a_read_only_file_or_folder_is_refused(tmp_path, access):
    path, folder = tmp_path / "raw.ply", tmp_path / "raw"
    path.write_bytes(b"old")
    path.chmod(0o444)
    with pytest.raises(loom.FileError, match=r"raw\.ply: is read-only\. Change its permissions"):
        write(path, b"new")
    write_folder(folder, "old")
    folder.chmod(0o555)
    with pytest.raises(loom.FileError, match="raw: is read-only"):
        write_folder(folder, "new")
    assert path.read_bytes() == b"old" and (folder / "marker").read_text() == "old"
    folder.chmod(0o755)


LONG = {"plain": "x" * 255, "suffix": "x" * 251 + ".ply", "wide": "\N{CJK UNIFIED IDEOGRAPH-70B9}" * 85}


@pytest.mark.parametrize("name", LONG.values(), ids=LONG)
def test_names_of_255_bytes_are_written_and_replaced(tmp_path, name):
    (tmp_path / "in").mkdir()
    for content in ("old", "new"):
        write(tmp_path / name, content.encode())
        write_folder(tmp_path / "in" / name, content)
        assert (tmp_path / name).read_text() == (tmp_path / "in" / name / "marker").read_text() == content
    with pytest.raises(loom.FileError, match="too long"):
        write(tmp_path / (name + "x"), b"new")


def test_all_names_of_a_file_show_the_new_content(tmp_path):
    path, other = tmp_path / "a", tmp_path / "b"
    path.write_bytes(b"old and longer")
    os.link(path, other)
    write(path, b"new")
    assert path.read_bytes() == other.read_bytes() == b"new" and path.samefile(other)
    assert {each.name for each in tmp_path.iterdir()} == {"a", "b"}


def test_a_file_in_a_read_only_folder_is_overwritten_in_place(tmp_path, access, monkeypatch):
    path = tmp_path / "a"
    path.write_bytes(b"old and longer")
    tmp_path.chmod(0o555)
    before = path.stat().st_ino
    write(path, b"new")
    assert path.read_bytes() == b"new" and path.stat().st_ino == before
    with pytest.raises(loom.FileError, match="not writable"):
        write(tmp_path / "b", b"new")
    tmp_path.chmod(0o755)


def test_the_owner_is_kept(tmp_path, monkeypatch):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    before = path.stat()
    given = []
    monkeypatch.setattr(os, "chown", lambda *words: given.append(words[1:]))
    # the new file seems to have another group
    owner_of = lambda status: (status.st_uid, status.st_gid + (status.st_ino != before.st_ino))  # noqa: E731
    monkeypatch.setattr(atomic, "_owner_of", owner_of)
    write(path, b"new")
    assert given == [(before.st_uid, before.st_gid)]

    def refused(*words):
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "chown", refused)
    inode = path.stat().st_ino
    before = path.stat()
    write(path, b"newer")
    assert path.read_bytes() == b"newer" and path.stat().st_ino == inode  # in place, so that the owner remains


def test_extended_attributes_are_kept(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    try:
        os.setxattr(path, "user.origin", b"scanner")
    except (AttributeError, OSError):
        pytest.skip("this file system has no extended attributes")
    write(path, b"new")
    assert os.getxattr(path, "user.origin") == b"scanner"


def test_a_new_file_needs_no_hard_links(tmp_path, monkeypatch):
    def unsupported(*words):
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "link", unsupported)
    write(tmp_path / "a", b"new", overwrite=False)
    assert (tmp_path / "a").read_bytes() == b"new" and len([*tmp_path.iterdir()]) == 1
    with pytest.raises(loom.FileError, match="exists already"), atomic_write(tmp_path / "b", overwrite=False) as file:
        file.write(b"mine")
        (tmp_path / "b").write_bytes(b"theirs")
    assert (tmp_path / "b").read_bytes() == b"theirs"


def test_a_full_disk_leaves_a_file_with_two_names_unchanged(tmp_path, monkeypatch):
    def full(*words):
        raise OSError(errno.ENOSPC, "No space left on device")

    path = tmp_path / "a"
    path.write_bytes(b"old")
    os.link(path, tmp_path / "b")
    monkeypatch.setattr(os, "posix_fallocate", full)
    with pytest.raises(loom.FileError, match="a: cannot be written: No space left on device"):
        write(path, b"new and longer")
    assert path.read_bytes() == b"old"


def test_open_readers_of_the_old_file_are_unaffected(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old bytes")
    with path.open("rb") as reader:
        first = reader.read(4)
        write(path, b"new bytes, and more")
        assert first + reader.read() == b"old bytes"
    assert path.read_bytes() == b"new bytes, and more"


@pytest.mark.parametrize("overwrite", [True, False])
def test_target_is_unchanged_until_the_block_ends(tmp_path, overwrite):
    path = tmp_path / "a"
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(b"half")
        file.flush()
        assert not path.exists()
    assert path.read_bytes() == b"half" and [p.name for p in tmp_path.iterdir()] == ["a"]


def test_file_created_by_another_program_or_before_an_error_in_the_block_is_preserved(tmp_path):
    path = tmp_path / "a"
    with pytest.raises(loom.FileError, match="a:"), atomic_write(path, overwrite=False) as file:
        file.write(b"mine")
        path.write_bytes(b"theirs")
    with pytest.raises(RuntimeError, match="midway"), atomic_write(path) as file:
        file.write(b"new")
        raise RuntimeError("midway")
    assert path.read_bytes() == b"theirs" and [p.name for p in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize(("mask", "before", "mode"), [(0o022, 0, 0o755), (0o077, 0, 0o700), (0o022, 0o700, 0o700)])
def test_a_folder_has_the_mode_of_mkdir_or_of_the_replaced_folder(tmp_path, mask, before, mode):
    path, old_mask = tmp_path / "out", os.umask(mask)
    try:
        if before:
            path.mkdir()
            path.chmod(before)
        write_folder(path, "new")
    finally:
        os.umask(old_mask)
    assert path.stat().st_mode & 0o777 == mode


def test_writers_never_call_umask(tmp_path, monkeypatch):
    def forbidden(mask):
        raise AssertionError("the umask belongs to all threads")

    monkeypatch.setattr(os, "umask", forbidden)
    write(tmp_path / "a", b"new")
    write_folder(tmp_path / "out", "new")


def write_folder(path, content):
    with atomic_folder(path, "marker") as folder:
        (folder / "marker").write_text(content)


@pytest.mark.parametrize("why", ["the parent is read-only", "it is a mount point"])
def test_an_empty_folder_that_cannot_be_renamed_is_filled(tmp_path, access, monkeypatch, why):
    path = tmp_path / "parent" / "out"
    path.mkdir(parents=True)
    if why == "it is a mount point":
        monkeypatch.setattr(os.path, "ismount", lambda each: Path(each) == path)
    else:
        path.parent.chmod(0o555)
    (path / f".out.{'0' * 16}.part").mkdir()  # of a killed process
    before, seen = path.stat().st_ino, []
    rename = Path.rename
    monkeypatch.setattr(Path, "rename", lambda self, target: [seen.append(self.name), rename(self, target)][1])
    with pytest.raises(KeyboardInterrupt), atomic_folder(path, "marker") as folder:
        (folder / "marker").write_text("half")
        raise KeyboardInterrupt
    assert len([*path.iterdir()]) == 1
    with atomic_folder(path, "marker") as folder:
        for name in ("a", "marker", "z"):
            (folder / name).write_text("new")
        assert folder.parent == path
    assert path.stat().st_ino == before and sorted(seen) == ["a", "marker", "z"] and seen[-1] == "marker"
    assert (path / "marker").read_text() == "new" and len([*path.parent.iterdir()]) == 1
    with pytest.raises(loom.FileError, match=r"is not writable|is a mount point") as error:
        write_folder(path, "newer")
    assert "empty this one first" in str(error.value) and (path / "marker").read_text() == "new"
    path.parent.chmod(0o755)


KILLED = """
import os, sys
from pointloom.cameras.trajectory_formats import TRAJECTORY_FORMATS
from pointloom.core import atomic
from pointloom.core.atomic import atomic_folder
calls = [0]
def counted(function):
    def call(*args, **kwargs):
        if (calls := calls_of()) == int(sys.argv[2]):
            os._exit(9)
        return function(*args, **kwargs)
    return call
def calls_of():
    calls[0] += 1
    return calls[0]
os.rename, os.rmdir, os.unlink = counted(os.rename), counted(os.rmdir), counted(os.unlink)
with atomic_folder(sys.argv[1], "marker") as folder:
    (folder / "marker").write_text("new")
"""


@pytest.mark.slow
@pytest.mark.parametrize("reader", ["restore", "write"])
def test_a_folder_survives_a_kill_at_each_step_of_its_replacement(tmp_path, reader):
    ends = set()
    for step in range(1, 9):
        path = tmp_path / str(step) / "out"
        path.parent.mkdir()
        write_folder(path, "old")
        done = subprocess.run([sys.executable, "-c", KILLED, path, str(step)], check=False)
        if reader == "restore":
            restore_folder(path / "marker")
            ends.add((done.returncode, (path / "marker").read_text()))
        else:
            with pytest.raises(loom.FileError, match="exists already"), atomic_folder(path, "marker", overwrite=False):
                pass
            write_folder(path, "next")
            assert not [*path.parent.glob("*.old")]
    assert reader == "write" or ends == {(9, "old"), (9, "new"), (0, "new")}


def test_folder_that_cannot_be_replaced_is_preserved(tmp_path, monkeypatch):
    path, rename = tmp_path / "out", os.rename
    write_folder(path, "old")

    def failing(source, target):
        if str(source).endswith(".part"):
            raise OSError(5, "Input/output error")
        rename(source, target)

    monkeypatch.setattr(os, "rename", failing)
    with pytest.raises(loom.FileError, match="out"):
        write_folder(path, "new")
    assert (path / "marker").read_text() == "old" and [p.name for p in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("answer", ["raises", "goes on"])
@pytest.mark.parametrize("stop", [KeyboardInterrupt, SystemExit])
def test_original_error_is_reported_through_other_packages(tmp_path, monkeypatch, answer, stop):
    def interrupted(file, data):
        raise stop("time is up")

    monkeypatch.setattr(atomic, "_write", interrupted)
    with pytest.raises(stop), atomic_write(tmp_path / "a.laz") as file, foreign_errors("a.laz", "cannot be written"):
        try:
            file.write(bytes(1 << 20))
        except BaseException:  # as in Rust's callbacks
            if answer == "raises":
                raise RuntimeError("IoError: Failed to call write") from None
    assert not [*tmp_path.iterdir()]


def cloud(**arrays):
    return loom.PointCloud(np.random.default_rng(0).random((50, 3)), **arrays)


def write_cloud(path):
    colors = np.full((50, 3), 0.5)
    loom.write_point_cloud(path, cloud(colors=colors, normals=colors), drop_unsupported=True)


def write_track(path):
    loom.write_trajectory(path, TRACK, intrinsic=CAMERA if path.suffix == ".json" else None)


def occupied():
    grid = loom.OccupancyGrid(0.5)
    grid.insert_scan([[2.2, 0.2, 0.2]], origin=[0.2, 0.2, 0.2])
    return grid


def splats():
    quaternions = np.tile([1.0, 0, 0, 0], (4, 1))
    return loom.GaussianSplats(np.eye(4, 3), np.full((4, 3), 0.04), quaternions, np.full(4, 0.9), np.zeros((4, 3)))


def volume():
    made = loom.TSDFVolume(voxel_size=0.05, color=False)
    made.integrate(np.full((30, 40), 1000, np.uint16), CAMERA, np.eye(4))
    return made


def record(path):
    with loom.record(path, fps=2) as recording:
        recording.add("cloud", cloud())
        recording.step()
        recording.step()


def save_field(path):
    loom.DistanceField.from_occupancy_grid(occupied(), max_distance=2).save(path)


def write_raster(path):
    loom.rasterize(cloud(), 0.25, kind="dsm").write(path)


CAMERA = loom.PinholeCameraIntrinsic(40, 30, 32.0, 32.0, 19.5, 14.5)
PIXELS = np.zeros((8, 8, 3), np.uint8)
GRAPH = loom.registration.PoseGraph([loom.registration.PoseGraphNode(np.eye(4))])
TRACK = loom.Trajectory(np.eye(4)[None], [0.0])
SPHERE = loom.TriangleMesh.create_sphere(1.0, 6)
BRIDGE = o3d.geometry.TriangleMesh.create_box()
TENSOR = o3d.core.Tensor(np.arange(3))
TENSOR_CLOUD = o3d.t.geometry.PointCloud(o3d.core.Tensor(np.eye(3)))
# Name of a file -> a function that writes it.
WRITERS = {
    **{f"c{extension}": write_cloud for extension in (*WRITTEN, ".copc.laz")},
    **{f"m{extension}": lambda path: loom.write_triangle_mesh(path, SPHERE) for extension in MESH_FORMATS},
    **{f"t{extension}": write_track for extension, names in TRAJECTORY_FORMATS.items() if len(names) == 1},
    **{f"s{extension}": lambda path: loom.write_splats(path, splats()) for extension in EXTENSIONS},
    **{f"p{extension}": lambda path: loom.write_image(path, PIXELS) for extension in PICTURES},
    "graph.json": lambda path: loom.registration.write_pose_graph(path, GRAPH),
    "camera.json": lambda path: CAMERA.write(path),
    "config.json": lambda path: loom.rgbd.ReconstructionConfig().write(path),
    "view.json": lambda path: loom.write_view(path, loom.View(CAMERA, np.eye(4)), ([0, 0, 0], [1, 1, 1])),
    "stations.e57": lambda path: loom.write_stations(path, [cloud()], [np.eye(4)]),
    "volume.npz": lambda path: volume().save(path),
    "grid.npz": lambda path: occupied().save(path),
    "field.npz": save_field,
    "terrain.tif": write_raster,
    "contours.gpkg": lambda path: loom.rasterize(cloud(), 0.25, kind="dsm").write_contours(path, 0.5),
    "record.html": record,
    "record.gif": record,
    "o.ply": lambda path: o3d.io.write_triangle_mesh(path, BRIDGE),
    "o.pcd": lambda path: o3d.io.write_point_cloud(path, BRIDGE.sample_points_uniformly(20)),
    **dict.fromkeys(("tensor.ply", "tensor.xyz"), lambda path: o3d.t.io.write_point_cloud(path, TENSOR_CLOUD)),
    "tensor.stl": lambda path: o3d.t.io.write_triangle_mesh(path, o3d.t.geometry.TriangleMesh.from_legacy(BRIDGE)),
    "o.jpg": lambda path: o3d.io.write_image(path, o3d.geometry.Image(PIXELS)),
    "o.npy": lambda path: TENSOR.save(path),
    "lines.ply": lambda path: o3d.io.write_line_set(path, o3d.geometry.LineSet.create_from_triangle_mesh(BRIDGE)),
    "voxels.ply": lambda path: o3d.io.write_voxel_grid(
        path, o3d.geometry.VoxelGrid.create_dense([0.0, 0, 0], [1.0, 0, 0], 0.5, 1, 1, 1)
    ),
    "graph2.json": lambda path: o3d.io.write_pose_graph(path, o3d.pipelines.registration.PoseGraph()),
    "intrinsic.json": lambda path: o3d.io.write_pinhole_camera_intrinsic(
        path, o3d.camera.PinholeCameraIntrinsic(40, 30, 32.0, 32.0, 19.5, 14.5)
    ),
}


def test_files_that_are_replaced_together_follow_the_rules_of_open(tmp_path, access):
    camera, disk = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240]), tmp_path / "disk"
    models = [loom.SfmModel([name], [camera], np.eye(4)[None]) for name in ("old.png", "new.png")]
    folder, names = tmp_path / "sparse", ("cameras.bin", "images.bin", "points3D.bin")
    loom.write_colmap_model(folder, models[0])
    disk.mkdir()
    (folder / names[1]).rename(disk / names[1])
    (folder / names[1]).symlink_to(disk / names[1])
    (folder / names[0]).chmod(0o600)
    loom.write_colmap_model(folder, models[1], overwrite=True)
    assert (folder / names[1]).is_symlink() and b"new.png" in (disk / names[1]).read_bytes()
    assert (folder / names[0]).stat().st_mode & 0o777 == 0o600
    assert loom.read_cameras(folder).names == ("new.png",)
    (folder / names[0]).chmod(0o444)
    with pytest.raises(loom.FileError, match="read-only"):
        loom.write_colmap_model(folder, models[0], overwrite=True)
    assert loom.read_cameras(folder).names == ("new.png",) and len([*folder.iterdir()]) == 3


@pytest.mark.parametrize("name", WRITERS)
def test_every_writer_follows_the_rules_of_open(name, tmp_path, access):
    if name.endswith((".tif", ".gpkg")):
        pytest.importorskip("rasterio" if name.endswith(".tif") else "pyogrio")
    write_file, suffix = WRITERS[name], name[name.index(".") :]
    write_file(tmp_path / name)
    expected = {path.suffix for path in tmp_path.iterdir()}

    (tmp_path / "disk").mkdir()
    target, link = tmp_path / "disk" / f"target{suffix}", tmp_path / f"link{suffix}"
    link.symlink_to(target)
    for _ in range(2):
        write_file(link)
        assert link.is_symlink() and target.stat().st_size

    os.link(target, other := tmp_path / f"other{suffix}")
    write_file(target)
    assert target.samefile(other)

    target.chmod(0o444)
    for path in (link, target):
        content = target.read_bytes()
        with pytest.raises(loom.FileError, match="is read-only"):
            write_file(path)
        assert target.read_bytes() == content and target.stat().st_mode & 0o777 == 0o444
    (tmp_path / "disk").chmod(0o555)
    with pytest.raises(loom.FileError, match="is not writable"):
        write_file(tmp_path / "disk" / f"new{suffix}")
    (tmp_path / "disk").chmod(0o755)

    (tmp_path / "long").mkdir()
    write_file(tmp_path / "long" / ("x" * (255 - len(suffix)) + suffix))
    assert {path.suffix for path in (tmp_path / "long").iterdir()} == expected

    pipe = tmp_path / f"pipe{suffix}"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE) as reader:
        write_file(pipe)
        assert reader.communicate()[0]
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert not [path for path in tmp_path.rglob("*") if path.name.startswith(".")]


@pytest.mark.parametrize("exists", [False, True])
@pytest.mark.parametrize("name", WRITERS)
def test_a_name_without_extension_is_written_or_the_error_lists_the_extensions(name, exists, tmp_path):
    """A writer either accepts any name, or names the extension that the format has in WRITERS."""
    if name.endswith((".tif", ".gpkg")):
        pytest.importorskip("rasterio" if name.endswith(".tif") else "pyogrio")
    path = tmp_path / "output"
    if exists:
        path.write_bytes(b"old")
    try:
        WRITERS[name](path)
    except ValueError as error:
        assert Path(name).suffix.removeprefix(".") in str(error) and "exist" not in str(error)
        assert (path.read_bytes() == b"old") if exists else not path.exists()
    else:
        assert path.stat().st_size


def test_an_error_of_numpy_without_a_reason_of_the_system_names_the_file(tmp_path):
    match = r"a\.npy: cannot be written: 20000 requested and 130 written"
    with pytest.raises(loom.FileError, match=match), atomic_write(tmp_path / "a.npy"):
        raise OSError("20000 requested and 130 written")
    assert list(tmp_path.iterdir()) == []
