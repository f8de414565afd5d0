"""Lists of file extensions come from the tables of formats: help, completion, pipes, messages, docstrings."""

import ast
import json
import re
import subprocess
import sys
from pathlib import Path

import click
import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory_formats import EUROC, FORMATS, NUMBERED, TRAJECTORY_FORMATS
from pointloom.cli.jobs.info import describe
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.completion import complete_path
from pointloom.cli.shell.format_lists import EXTENSIONS, LISTS, NUMBERED_OR_KITTI, READ, WRITTEN_FORMATS
from pointloom.cli.shell.options import CompletedPath
from pointloom.core import paths
from pointloom.io.images.image_formats import IMAGES, PHOTOS, PICTURES
from pointloom.io.meshes import mesh_formats
from pointloom.io.meshes.mesh_formats import MESH_FORMATS, WITH_TEXT_FORM
from pointloom.io.points import formats
from pointloom.io.points.formats import CLOUD_FORMATS, WITH_NAMED_COLUMNS, WRITTEN
from pointloom.io.points.scan_files import list_scans
from pointloom.io.splats.splat_files import EXTENSIONS as SPLATS
from pointloom.pcd.contour_files import joined_lines, write_contour_file
from pointloom.pcd.geotiff import ENDINGS as RASTERS
from pointloom.visualization.recording.extensions import RECORDINGS
from pointloom.visualization.viewer.view_files import read_geometry

ROOT = Path(__file__).resolve().parents[1]
TABLES = (CLOUD_FORMATS, MESH_FORMATS, TRAJECTORY_FORMATS, paths.RECORDINGS, IMAGES, PHOTOS, RECORDINGS, SPLATS)
EXTENSION = r"\.[a-z][a-z0-9]*\b"
#: Three or more extensions in a row, such as ".ply, .obj or .stl".
LIST = re.compile(rf"(?<!\w){EXTENSION}(?:(?: \([\w ]+\))?(?:,? (?:or |and )?|, ){EXTENSION}){{2,}}")
DERIVED = [
    *LISTS.values(), NUMBERED, NUMBERED_OR_KITTI, RECORDINGS, PICTURES, WITH_TEXT_FORM, WITH_NAMED_COLUMNS,
    mesh_formats.storing("textures"), SPLATS,
]  # fmt: skip


def lists_in(text):
    """The lists of extensions in a text, as sets."""
    return [set(re.findall(EXTENSION, found[0])) for found in LIST.finditer(" ".join(text.split()))]


def commands(group=cli, name="pointloom"):
    yield name, group
    for each, command in getattr(group, "commands", {}).items():
        yield from commands(command, f"{name} {each}")


def help_texts():
    for name, command in commands():
        yield name, command.help or ""
        for parameter in command.params:
            yield f"{name}, {parameter.name}", getattr(parameter, "help", None) or ""


# Lists of files that are no formats of a table: layouts of folders, distances, kinds of poses.
OTHER_LISTS = ({".las", ".laz", ".vpc"}, {".ply", ".pcd", ".e57", ".ptx"}, {".xyz", ".pts", ".csv"})


def test_every_list_in_the_help_of_a_command_is_that_of_a_table():
    known, checked = [set(each) for each in DERIVED], 0
    for name, text in help_texts():
        for found in lists_in(text):
            checked += 1
            assert found in known or found in OTHER_LISTS, (name, sorted(found))
    assert checked > 20


def test_every_file_parameter_completes_the_extensions_of_its_table(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for extension in {*READ, *PICTURES, *IMAGES, *TRAJECTORY_FORMATS, ".docx"}:
        Path(f"a{extension}").touch()
    expected = {
        **dict.fromkeys(("IN", "A", "B"), READ), "OUT": WRITTEN_FORMATS, "MESH": MESH_FORMATS, "PNG": PICTURES,
        "POSES": TRAJECTORY_FORMATS, "TRUTH": TRAJECTORY_FORMATS, "PICTURE": IMAGES,
    }  # fmt: skip
    used = {
        parameter.metavar
        for _, command in commands()
        for parameter in command.params
        if isinstance(parameter.type, CompletedPath) and isinstance(parameter.metavar, str)
    }
    assert expected.keys() <= used & EXTENSIONS.keys()
    for metavar, extensions in expected.items():
        assert {item.value for item in complete_path(metavar, "a")} == {f"a{each}" for each in extensions}, metavar


def test_pipes_have_the_formats_of_the_tables():
    choices = {
        parameter.name: {f".{each}" for each in parameter.type.choices}
        for parameter in cli.commands["convert"].params
        if isinstance(parameter.type, click.Choice)
    }
    assert choices["read_as"] == {*CLOUD_FORMATS, *MESH_FORMATS}
    assert choices["write_as"] == {*WRITTEN, *MESH_FORMATS}


CLOUD = loom.PointCloud(np.eye(3))
MESH = loom.TriangleMesh.create_box()
TRACK = loom.Trajectory(np.eye(4)[None])
LINES = loom.LineSet([[0, 0, 0], [1, 0, 0]], [[0, 1]])
SPLAT = loom.GaussianSplats([[0, 0, 1]], [[0.1, 0.1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
OUTPUTS = loom.photogrammetry.VideoOutputs
# Call with a file of an unknown extension -> the extensions that its error lists.
CALLS = {
    "read_point_cloud": (loom.read_point_cloud, CLOUD_FORMATS),
    "write_point_cloud": (lambda path: loom.write_point_cloud(path, CLOUD), WRITTEN),
    "read_triangle_mesh": (loom.read_triangle_mesh, MESH_FORMATS),
    "write_triangle_mesh": (lambda path: loom.write_triangle_mesh(path, MESH), MESH_FORMATS),
    "read_trajectory": (loom.read_trajectory, {*TRAJECTORY_FORMATS, EUROC}),
    "write_trajectory": (lambda path: loom.write_trajectory(path, TRACK), [f".{name}" for name in FORMATS]),
    "read_splats": (loom.read_splats, SPLATS),
    "write_splats": (lambda path: loom.write_splats(path, SPLAT), SPLATS),
    "write_image": (lambda path: loom.write_image(path, np.zeros((2, 2, 3), np.uint8)), PICTURES),
    "record": (lambda path: loom.record(path).__enter__(), RECORDINGS),
    "open_recording": (loom.open_recording, paths.RECORDINGS),
    "read_cameras": (loom.read_cameras, {*TRAJECTORY_FORMATS, ".xml"}),
    "VideoOutputs.mesh": (lambda path: OUTPUTS(mesh=path).check(overwrite=True), MESH_FORMATS),
    "VideoOutputs.cloud": (lambda path: OUTPUTS(cloud=path).check(overwrite=True), WRITTEN),
    "VideoOutputs.trajectory": (lambda path: OUTPUTS(trajectory=path).check(overwrite=True), NUMBERED),
    "info": (describe, {*READ, *IMAGES, *RASTERS, *TRAJECTORY_FORMATS, ".xml"}),
    "view": (read_geometry, {*READ, *RASTERS, *TRAJECTORY_FORMATS}),
    "write_contours": (
        lambda path: write_contour_file(path, joined_lines(LINES), None, overwrite=True),
        paths.CONTOURS,
    ),
    "list_scans": (lambda path: list_scans(path.parent), CLOUD_FORMATS),
}


@pytest.mark.parametrize("name", CALLS)
def test_the_error_of_an_unknown_extension_lists_those_of_the_table(name, tmp_path):
    call, extensions = CALLS[name]
    (path := tmp_path / "a.docx").write_bytes(b"?")
    with pytest.raises(loom.FileError) as error:
        call(path)
    words = str(error.value).replace(str(path), "").replace("one of log", "one of .log").replace(", tum", ", .tum")
    words = words.replace(", kitti", ", .kitti").replace(", json", ", .json")
    found = set(re.findall(EXTENSION, words)) - {".docx"}
    assert found - {".json"} == {*extensions} - {".json"}


def literals(tree):
    """The texts of a module: strings, and literal collections of strings."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.lineno, node.value
        elements = getattr(node, "keys" if isinstance(node, ast.Dict) else "elts", None) or []
        words = [each.value for each in elements if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        if words and not isinstance(node, ast.Constant):
            yield node.lineno, ", ".join(words)


# Modules with tables, and Open3D's own lists of the formats that it writes.
WITH_TABLES = {
    "io/points/formats.py", "io/meshes/mesh_formats.py", "io/images/image_formats.py", "core/paths.py",
    "io/splats/splat_files.py", "cameras/trajectory_formats.py", "visualization/recording/extensions.py",
    "open3d/io/shapes.py", "open3d/io/cameras.py",
}  # fmt: skip


def test_no_module_repeats_a_list_of_extensions():
    faults = []
    for path in sorted((ROOT / "src" / "pointloom").rglob("*.py")):
        name = path.relative_to(ROOT / "src" / "pointloom").as_posix()
        if name in WITH_TABLES or name.startswith("kernels/"):
            continue
        source = path.read_text(encoding="utf-8")
        if len(re.findall(r"(?<!from)[\s\"'(,]\.[a-z]", source)) < 3:
            continue
        for line, text in literals(ast.parse(source)):
            for found in lists_in(text):
                faults += [
                    f"{name}:{line}: {sorted(found)}" for table in TABLES if 2 * len(found & {*table}) >= len(table)
                ]
    assert faults == [], "derive it from the table, or refer to docs/files.md"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("the mesh, .ply .obj .stl .off .glb.", 1), ("(.ply, .obj or .stl)", 1), ("a.ply b.obj c.stl", 0),
        (".ply and .obj", 0), ("'.ply', .obj", 0), (".html (page with player), .gif, .mp4", 1),
    ],
)  # fmt: skip
def test_lists_of_extensions_are_recognized(text, expected):
    assert len(lists_in(text)) == expected


# A format is inserted into the source of a table, as an edit would do.
NEW = """
import json, sys, types, warnings
from importlib.util import find_spec

def insert(name, before):
    spec = find_spec(name)
    source = open(spec.origin, encoding="utf-8").read()
    assert before in source
    module = sys.modules[name] = types.ModuleType(name)
    module.__spec__, module.__package__, module.__file__ = spec, spec.parent, spec.origin
    exec(compile(source.replace(before, f'".newest": {before.partition(": ")[2]} {before}', 1), spec.origin, "exec"),
         module.__dict__)

insert(*sys.argv[1:3])
import click
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.format_lists import EXTENSIONS

def texts(group):
    yield group.help or ""
    for parameter in group.params:
        yield getattr(parameter, "help", None) or ""
        if isinstance(parameter.type, click.Choice):
            yield " ".join(f".{choice}" for choice in parameter.type.choices)
    for command in getattr(group, "commands", {}).values():
        yield from texts(command)

print(json.dumps([*texts(cli), *(" ".join(each) for each in EXTENSIONS.values())]))
"""


@pytest.mark.parametrize(
    ("module", "entry", "table"),
    [
        (mesh_formats, '".off": MeshFormat("OFF", _off, ("colors",), encoding="text"),', MESH_FORMATS),
        (formats, '".asc": _TABLE,', CLOUD_FORMATS),
    ],
    ids=["mesh", "cloud"],
)
def test_a_new_entry_of_a_table_is_in_every_help_completion_and_pipe(module, entry, table):
    program = [sys.executable, "-c", NEW, module.__name__, entry]
    result = subprocess.run(program, capture_output=True, text=True, timeout=120, check=False)
    assert result.returncode == 0, result.stderr
    lists = [found for text in json.loads(result.stdout) for found in lists_in(text)]
    complete = [found for found in lists if {*table} <= found]
    assert len(complete) >= 5 and [sorted(found) for found in complete if ".newest" not in found] == []


@pytest.mark.parametrize("extension", WRITTEN)
def test_a_format_of_clouds_stores_what_its_entry_states(extension, tmp_path):
    if extension in (".las", ".laz", ".e57"):
        pytest.importorskip("pye57" if extension == ".e57" else "laspy")
    vectors = np.array([[0, 0, 1.0], [0, 1, 0], [1, 0, 0]])
    cloud = loom.PointCloud(vectors, normals=vectors, colors=vectors, label=np.array([3, 1, 2], np.int32))
    loom.write_point_cloud(path := tmp_path / f"a{extension}", cloud, drop_unsupported=True)
    back, stores = loom.read_point_cloud(path), CLOUD_FORMATS[extension].stores
    if extension in (".xyz", ".xyzn", ".xyzrgb", ".pts"):
        assert ("normals" in stores, "colors" in stores) == (back.has_normals, back.has_colors)
    else:
        assert back.has_colors and back.has_normals and {"normals", "colors"} <= {*stores}
    assert ("labels" in stores) == ("label" in back.attributes)
    if "labels" in stores:
        assert back["label"].tolist() == [3, 1, 2]


@pytest.mark.parametrize("extension", MESH_FORMATS)
def test_a_format_of_meshes_stores_what_its_entry_states(extension, tmp_path, recwarn):
    format = MESH_FORMATS[extension]
    colored, textured = loom.TriangleMesh.create_box(), loom.TriangleMesh.create_box()
    colored.vertex_colors = np.tile([1.0, 0, 0], (8, 1))
    textured.triangle_uvs = np.random.default_rng(0).random((36, 2))
    textured.textures = [np.full((4, 4, 3), 90, np.uint8)]
    for name, mesh in (("colors", colored), ("textures", textured)):
        loom.write_triangle_mesh(path := tmp_path / f"{name}{extension}", mesh)
        back = loom.read_triangle_mesh(path)
        has = back.has_vertex_colors() if name == "colors" else len(back.textures) > 0
        assert has == (name in format.stores), name
    if not format.names_files:
        is_text = b"\0" not in (tmp_path / f"colors{extension}").read_bytes()
        assert is_text == (format.encoding == "text")


def test_formats_of_either_encoding_are_written_as_text_on_request(tmp_path):
    for extension in WITH_TEXT_FORM:
        loom.write_point_cloud(path := tmp_path / f"a{extension}", CLOUD, write_ascii=True)
        assert path.read_bytes().isascii() and b"\0" not in path.read_bytes()
        loom.write_point_cloud(path, CLOUD)
        assert b"\0" in path.read_bytes()
