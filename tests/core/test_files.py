"""Paths, SQLite files of unknown origin, locks of folders, and exceptions of signal handlers during file operations."""

import contextlib
import functools
import inspect
import os
import signal
import sqlite3
from types import ModuleType

import numpy as np
import pytest

import pointloom as loom
from pointloom.core import work_folder
from pointloom.core.errors import FileError
from pointloom.core.paths import job_file
from pointloom.core.sqlite_files import protect
from pointloom.core.stages import Chain
from pointloom.io.frames.depth_cameras import driver_errors
from pointloom.io.optional_imports import foreign_errors, ignored_errors
from pointloom.io.source import content_errors
from pointloom.photogrammetry.sfm.colmap_jobs import open_database
from pointloom.rgbd.reconstruction.job_files import JobFiles
from pointloom.tiling.manifest import NAME, Manifest, new_manifest, read_plan

PATHS = ("PathLike", "FilePath")


def public_calls(module, prefix="loom"):
    """Functions, classes and class methods of a package and its public modules, by name."""
    for name in module.__all__:
        value, full = getattr(module, name), f"{prefix}.{name}"
        if isinstance(value, ModuleType):
            if hasattr(value, "__all__") and name != "torch":  # which may not be installed, and opens no files
                yield from public_calls(value, full)
        elif inspect.isclass(value):
            if not issubclass(value, BaseException):
                yield full, value
            yield from ((f"{full}.{each}", call) for each, call in inspect.getmembers(value, inspect.ismethod))
        elif inspect.isfunction(value):
            yield full, value


def parameters_of(call):
    try:
        return list(inspect.signature(call).parameters.values())
    except ValueError:  # a class without a signature
        return []


def takes_a_path(call):
    first = next(iter(parameters_of(call)), None)
    annotation = "" if first is None else str(first.annotation)
    is_other = any(word in annotation for word in ("None", "Sequence", "Iterable"))
    is_required = first is not None and first.default is first.empty
    return is_required and not is_other and any(kind in annotation for kind in PATHS)


CALLS = {
    name: call
    for name, call in public_calls(loom)
    if takes_a_path(call) and not name.rpartition(".")[2].startswith("_") and ".open3d." not in name
}


@pytest.mark.parametrize("name", CALLS)
def test_invalid_paths_raise_the_same_error(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    _, *others = parameters_of(CALLS[name])
    required = [each.name for each in others if each.default is each.empty and each.kind is not each.VAR_KEYWORD]
    given = dict.fromkeys(required, "a.ply")  # where the arguments are swapped, the path is here
    for wrong, kind in ((loom.PointCloud(), "PointCloud"), (7, "int"), (None, "NoneType"), (b"a.ply", "bytes")):
        with pytest.raises(TypeError, match=rf"\w+: expected the path of a file or folder, got a {kind}"):
            CALLS[name](wrong, **given)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", CALLS)
def test_names_that_the_system_rejects_are_file_errors(name, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "file").write_text("a")
    _, *others = parameters_of(CALLS[name])
    required = [each.name for each in others if each.default is each.empty and each.kind is not each.VAR_KEYWORD]
    for path in ("a" * 300, "loop", f"file/{'a' * 300}", "file/a"):
        for ending in ("", ".ply", ".json", ".txt"):
            with contextlib.suppress(loom.PointloomError, ValueError, TypeError):
                CALLS[name](tmp_path / f"{path}{ending}", **dict.fromkeys(required, loom.PointCloud()))


FOLDERS = {
    "LidarSLAM": lambda path: loom.registration.LidarSLAM(folder=path),
    "read_cameras": loom.read_cameras,
    "read_image_positions": lambda path: loom.photogrammetry.read_image_positions([path]),
    "plan_tiles": lambda path: loom.tiling.plan_tiles([path], [{"step": "count"}], path, size=5.0),
    "plan_registration": lambda path: loom.tiling.plan_registration([path, path], path, voxel_size=0.5),
    "write_colmap_model": lambda path: loom.write_colmap_model(path, loom.SfmModel([], [], np.empty((0, 4, 4)))),
}


@pytest.mark.parametrize("name", FOLDERS)
@pytest.mark.parametrize("path", ["a" * 300, "loop", "file", "file/a", f"file/{'a' * 300}"])
def test_other_arguments_with_such_names_are_file_errors(name, path, tmp_path):
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "file").write_text("a")
    with contextlib.suppress(FileError, ValueError):
        FOLDERS[name](tmp_path / path)


def test_the_table_has_the_readers_and_writers():
    names = {"read_point_cloud", "write_point_cloud", "read_triangle_mesh", "write_triangle_mesh", "write_image"}
    names |= {"read_trajectory", "write_trajectory", "open_frames", "registration.read_pose_graph", "TSDFVolume.load"}
    assert {f"loom.{name}" for name in names} <= CALLS.keys() and len(CALLS) > 50


CODE = [
    "CREATE VIEW more AS SELECT 1",
    "CREATE TRIGGER more AFTER INSERT ON meta BEGIN DELETE FROM meta; END",
    "CREATE VIRTUAL TABLE more USING fts4(a)",
]


@pytest.mark.parametrize("code", CODE, ids=["view", "trigger", "virtual"])
def test_a_manifest_or_database_with_code_is_an_error(tmp_path, code):
    with new_manifest(tmp_path, {}, "1", "CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID"):
        pass
    with contextlib.closing(sqlite3.connect(tmp_path / NAME)) as base:
        base.execute(code)
        base.commit()
    with pytest.raises(loom.FileError, match="'more'"):
        Manifest(tmp_path)
    with pytest.raises(loom.FileError, match="'more'"), open_database(tmp_path / NAME):
        pass


def test_a_plan_that_is_a_view_is_an_error(tmp_path):
    with contextlib.closing(sqlite3.connect(tmp_path / NAME)) as base:
        base.execute("CREATE VIEW meta AS SELECT 'plan' AS key, '{}' AS value")
    with pytest.raises(loom.FileError, match=NAME):
        read_plan(tmp_path)


@pytest.mark.parametrize("use", [lambda path: Manifest(path.parent), lambda path: open_database(path).__enter__()])
def test_databases_that_end_within_a_page_are_an_error(tmp_path, use):
    """SQLite fills up the page with zeros."""
    path = tmp_path / NAME
    with contextlib.closing(sqlite3.connect(path)) as base:
        base.execute("CREATE TABLE meta (key, value)")
        base.execute("INSERT INTO meta VALUES ('plan', zeroblob(9000))")
        base.commit()
    path.write_bytes(path.read_bytes()[:-10])
    with pytest.raises(FileError, match="is cut off: it has 16374 bytes, which are not complete pages of 4096"):
        use(path)


def test_a_bounded_query_ends(tmp_path):
    with contextlib.closing(sqlite3.connect(tmp_path / "a.db")) as base:
        base.execute("CREATE TABLE a (b)")
        protect(base, tmp_path / "a.db", is_bounded=True)
        with pytest.raises(sqlite3.OperationalError):
            base.execute("WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT max(x) FROM c")


TEMPLATES = ("fragment_pointcloud", "fragment_posegraph", "fragment_posegraph_optimized", "global_posegraph_optimized",
             "refined_posegraph", "refined_posegraph_optimized", "global_mesh", "global_traj")  # fmt: skip


def reconstruction(root, template=TEMPLATES[0]):
    name = "a/b/%03d.ply" if "fragment" in template else "a/b/000.ply"
    return JobFiles.make(root, loom.rgbd.ReconstructionConfig(**{f"template_{template}": name}))


FOLDERS_OF_JOBS = {
    "file": lambda root: job_file(root / "a" / "b" / "000.ply", root),
    **{template: functools.partial(reconstruction, template=template) for template in TEMPLATES},
    "stages": lambda root: Chain(root, ["a"], resume=True, progress=lambda *step: None),
}


@pytest.mark.parametrize("use", FOLDERS_OF_JOBS.values(), ids=FOLDERS_OF_JOBS)
def test_folders_of_jobs_with_links_at_any_level_are_not_used(tmp_path, use):
    """The folder itself may be a link of the user."""
    other, root = tmp_path / "other", tmp_path / "job"
    (tmp_path / "disk").mkdir()
    other.mkdir()
    root.symlink_to(tmp_path / "disk")
    for name in ("a", "a/b", "a/b/000.ply"):
        (root / name).parent.mkdir(exist_ok=True)
        (root / name).symlink_to(other)
        with pytest.raises(FileError, match=rf"job/{name}: is a symbolic link"):
            use(root)
        (root / name).unlink()
    use(root)
    assert not [*other.iterdir()]


def test_a_file_in_place_of_a_folder_of_a_job_is_an_error(tmp_path):
    (tmp_path / "a").write_text("")
    for use in (FOLDERS_OF_JOBS["file"], reconstruction):
        with pytest.raises(FileError, match=r"/a(/b)?: cannot be created: "):
            use(tmp_path)


def test_a_locked_folder_is_in_use_for_other_runs(tmp_path):
    with work_folder.locked(tmp_path), pytest.raises(FileError, match="in"), work_folder.locked(tmp_path):
        pass
    with work_folder.locked(tmp_path):
        pass


def test_without_locks_a_folder_is_not_opened(tmp_path, monkeypatch):
    """Windows opens no folders."""
    monkeypatch.setattr(work_folder, "fcntl", None)
    monkeypatch.delattr(os, "open")
    with work_folder.locked(tmp_path), work_folder.locked(tmp_path):
        pass


class Late(ValueError):  # noqa: N818
    """A time limit of the program."""


class Panic(BaseException):
    """An error of a package in Rust."""


Panic.__name__, Panic.__module__ = "PanicException", "pyo3_runtime"


def late(*_):
    raise Late("time is up")


class Limit:
    def __call__(self, number, frame):
        late()

    def end(self, number, frame):
        late()


@pytest.fixture(
    params=[late, functools.partial(late, 1), Limit(), Limit().end], ids=["def", "partial", "call", "bound"]
)
def handler(request):
    old = signal.signal(signal.SIGUSR1, request.param)
    yield
    signal.signal(signal.SIGUSR1, old)


@pytest.mark.parametrize(
    ("error", "expected"),
    [
        (ValueError("bad"), loom.FileError),
        (OSError(5, "bad"), loom.FileError),
        (Panic("bad"), loom.FileError),
        (MemoryError(), MemoryError),
        (KeyboardInterrupt(), KeyboardInterrupt),
        (SystemExit(3), SystemExit),
        (BaseException("time is up"), BaseException),
    ],
    ids=repr,
)
def test_errors_of_packages_become_file_errors_and_nothing_else_does(error, expected):
    with pytest.raises(expected) as caught, foreign_errors("cloud.laz", "damaged"):
        raise error
    assert type(caught.value) is expected


GUARDS = {
    "foreign": lambda: foreign_errors("cloud.laz", "damaged"),
    "ignored": ignored_errors,
    "driver": lambda: driver_errors("camera", "Plug it in"),
    "content": lambda: content_errors("cloud.ply"),
}


@pytest.mark.parametrize("guard", GUARDS)
@pytest.mark.parametrize("wraps", [False, True])
def test_exceptions_of_signal_handlers_pass_through_packages(handler, wraps, guard):
    with pytest.raises(Late), GUARDS[guard]():
        try:
            signal.raise_signal(signal.SIGUSR1)
        except Late as error:
            if wraps:
                raise ArithmeticError("cannot decode") from error
            raise


def test_a_damaged_file_that_is_read_while_a_time_limit_is_handled_is_called_damaged(handler):
    try:
        signal.raise_signal(signal.SIGUSR1)
    except Late:
        with pytest.raises(loom.FileError, match=r"cloud\.laz"), foreign_errors("cloud.laz", "damaged"):
            raise ValueError("bad")  # noqa: B904
