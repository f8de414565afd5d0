"""Errors of commands name options and commands, not arguments and functions of Python."""

import re

import click
import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.cli.shell.command_words import in_options

from .commands import run

PYTHON = re.compile(
    r"\bloom\.|\bphotogrammetry\.|\b[a-z_]\w*=(?!=)|\b[a-z_][\w.]*\((?:[^ )]*|[^)]*=[^)]*)\)|\b[a-z]\w*\.[a-z_]\w* = "
    r"|\b(?:True|False|None)\b|(?<![\w/-])[a-z]+_[a-z_]+\b(?![/.])"
)
NO_PYTHON = re.compile(r"\w+_msgs/\S+|default of [\w-]+")  # names of ROS types


def frames_in(folder, depth=(480, 640), color=(480, 640), pose=None):
    folder.mkdir()
    for k in range(3):
        Image.fromarray(np.full(depth, 1000, np.uint16)).save(folder / f"frame-{k:06d}.depth.png")
        Image.fromarray(np.full((*color, 3), 90, np.uint8)).save(folder / f"frame-{k:06d}.color.png")
        if pose is not None:
            np.savetxt(folder / f"frame-{k:06d}.pose.txt", pose)


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    """Files and folders that commands reject, each for a reason of its own."""
    root, points = tmp_path_factory.mktemp("inputs"), np.random.default_rng(0).random((300, 3))
    far, degrees = points * 100 + [5e5, 5.65e6, 100], points * [1e-3, 1e-3, 100] + [9, 50, 0]
    clouds = {"a.ply": {}, "n.ply": {"normals": points}}
    clouds |= {"nan.ply": {"points": np.where(points > 0.95, np.nan, points)}}
    for name, changes in clouds.items():
        loom.write_point_cloud(root / name, loom.PointCloud(**{"points": points} | changes))
    for name, system, values in (("32", 25832, far), ("33", 25833, far), ("geo", 4326, degrees)):
        loom.write_point_cloud(root / f"{name}.laz", loom.PointCloud(values, crs=system))
    loom.write_point_cloud(root / "foot.laz", loom.PointCloud(points, unit="foot"))
    box = loom.TriangleMesh.create_box()
    loom.write_triangle_mesh(root / "box.ply", box)
    frames_in(root / "walk", pose=np.eye(4))
    frames_in(root / "odd", color=(480, 1000), pose=np.eye(4))
    frames_in(root / "lost", pose=np.full((4, 4), np.inf))
    frames_in(root / "free")
    (root / "images").mkdir()
    for k in range(3):
        Image.fromarray(np.full((48, 64), 1000, np.uint16)).save(root / "images" / f"{k}_depth.png")
        Image.fromarray(np.zeros((48, 64, 3), np.uint8)).save(root / "images" / f"{k}.png")
    loom.PinholeCameraIntrinsic(320, 240, 300, 300, 160, 120).write(root / "half.json")
    np.zeros((10, 7), np.float32).tofile(root / "seven.bin")
    np.save(root / "array.npy", np.zeros((5, 5)))
    (root / "seven.txt").write_text("1 2 3 4 5 6 7\n" * 4)
    (root / "e.txt").write_text("0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n")
    (root / "one.weird").write_text("x")
    (root / "scans").mkdir()
    loom.write_point_cloud(root / "scans" / "0.ply", loom.PointCloud(points))
    return root


LINES = """
transform a.ply o.laz --crs EPSG:25833
transform a.ply o.laz --crs NOPE
transform a.ply o.laz --crs EPSG:25833 --from-crs NOPE
transform a.ply o.laz --unit foot
transform a.ply o.laz --unit parsec
transform geo.laz o.ply --unit foot
transform n.ply o.ply --crs EPSG:4326 --from-crs EPSG:25832
transform 32.laz o.laz --crs EPSG:99999
merge 32.laz 33.laz -o o.laz
merge 32.laz foot.laz -o o.laz
merge 32.laz geo.laz -o o.laz
register a.ply a.ply -o T.txt --method colored
register a.ply a.ply -o T.txt --free x
change 32.laz 33.laz -o o.ply
ground nan.ply o.laz
dtm a.ply -o o.tif
dtm geo.laz -o o.tif --kind lowest
dtm a.ply -o o.tif --kind intensity
clean-mesh a.ply o.ply
simplify a.ply o.ply --ratio 0.5
sample-mesh a.ply o.ply --points 5
compare-meshes a.ply box.ply
smooth-mesh a.ply o.ply
crop a.ply o.ply --polygon seven.txt
downsample a.ply o.ply --voxel 1e-30
convert seven.bin o.ply
convert array.npy o.ply
convert seven.txt o.ply
convert *.ply o.ply
convert box.3mf o.ply
convert walk o.ply
convert nan.ply o.las
convert one.weird o.ply
convert a.ply a.ply
info images
info one.weird
info missing.ply
info odd
info seven.txt
track images -o p.txt
track walk -o p.txt --intrinsic half.json
track odd -o p.txt
track a.ply -o p.txt
track walk -o a.ply
fuse images -o o.ply
fuse lost -o o.ply
fuse free -o o.ply
fuse odd -o o.ply
fuse walk -o o.ply --intrinsic half.json
reconstruct images -o o.ply
reconstruct walk -o o.ply --intrinsic half.json
texture box.ply odd -o o.glb
texture box.ply lost -o o.glb
texture a.ply walk -o o.glb
odometry walk -o p.txt
odometry a.ply -o p.txt
odometry scans -o p.weird
map scans -o o.weird
multiway scans -o p.weird
multiway walk -o p.txt
evaluate e.txt a.ply
stations a.ply -o o.e57
split a.ply -o parts --by classification
tile plan geo.laz -o job --steps seven.txt
tile status walk
tile run walk
tile finish walk -o o.las
view one.weird --no-open --save-html x.html
view a.ply --color-by normals --screenshot x.png
video missing.mp4 -o o.ply
""".strip().splitlines()


def check_words(text, command):
    """An error has no Python, and its options are those of the command, or of the one that it names before them."""
    assert not PYTHON.search(NO_PYTHON.sub("", text)), text
    for found in re.finditer(r"(?<!\S)--(?!help)[a-z][a-z-]*", text):
        named = re.findall(r"pointloom ((?:tile )?[a-z-]+)", text[: found.start()])
        after = re.match(r"(?: \S+)? of pointloom ((?:tile )?[a-z-]+)", text[found.end() :])
        owners = [command, *(lookup(words) for words in [*named, *(after.groups() if after else ())])]
        assert any(found[0] in one.opts for owner in owners if owner for one in owner.params), (found[0], text)


def lookup(words):
    group = cli
    for word in words.split():
        group = group.commands.get(word) if isinstance(group, click.Group) else None
    return group


@pytest.mark.parametrize("line", LINES)
def test_errors_of_commands_are_about_commands(inputs, tmp_path, monkeypatch, line):
    pytest.importorskip("pyproj")
    pytest.importorskip("laspy")
    for entry in inputs.iterdir():
        (tmp_path / entry.name).symlink_to(entry)
    monkeypatch.chdir(tmp_path)
    result = run(*line.split())
    assert result.exit_code in (1, 2) and "unexpected" not in result.stderr, result.stderr
    words = line.split()
    check_words(result.stderr.replace(str(tmp_path), ""), lookup(" ".join(words[:2])) or lookup(words[0]))


@pytest.mark.parametrize("command", ["track", "fuse", "info"])
def test_color_larger_than_depth_is_resized(tmp_path, command):
    """Telephones have such images."""
    frames_in(tmp_path / "phone", (48, 64), (96, 128), np.eye(4))
    loom.PinholeCameraIntrinsic(64, 48, 60, 60, 32, 24).write(tmp_path / "phone" / "camera-intrinsics.json")
    output = () if command == "info" else ("-o", tmp_path / ("p.txt" if command == "track" else "o.ply"))
    result = run(command, tmp_path / "phone", *output)
    assert result.exit_code in (0, 3), result.stderr


def test_a_coordinate_system_that_is_not_in_the_file_is_given(tmp_path):
    pytest.importorskip("pyproj")
    points = np.random.default_rng(0).random((50, 3)) * 100 + [5e5, 5.65e6, 100]
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points))
    words = ("transform", tmp_path / "a.ply", tmp_path / "b.npz", "--crs", "EPSG:25833")
    assert run(*words, "--from-crs", "EPSG:25832").exit_code == 0
    known = loom.PointCloud(points, crs=25832).reproject(25833)
    np.testing.assert_allclose(loom.read_point_cloud(tmp_path / "b.npz").points, known.points, atol=0.5)
    assert run(*words[:3], "--scale", "2", "--from-crs", "EPSG:25832").exit_code == 2


@pytest.mark.parametrize(("command", "text", "printed"), [
    ("fuse", "or pass refine=True", "or pass --refine"), ("info", "Give columns=", "Give --columns"),
    ("plane", "Give intrinsic=, or", "Give --intrinsic of pointloom track, or"),
    ("mesh", "call cloud = cloud.estimate_normals()", "Run pointloom normals first"),
])  # fmt: skip
def test_arguments_are_options_of_the_command_or_of_another(command, text, printed):
    with click.Context(cli.commands[command]):
        assert in_options(text) == printed


@pytest.mark.parametrize("name", ["pose", "scale=3.txt", "from_crs"])
def test_a_file_with_the_name_of_an_option_keeps_its_name(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    loom.write_point_cloud("a.ply", loom.PointCloud(np.zeros((3, 3))))
    assert f"error: {name}: " in run("transform", "a.ply", "b.ply", "--pose", name).stderr
