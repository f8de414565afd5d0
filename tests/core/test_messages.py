"""Messages: verbosity, names of Open3D, text without control characters, and warnings of dropped results."""

import ast
import inspect
import io
import json
import logging
import operator
import os
import pickle
import re
import subprocess
import sys
import warnings
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.core import dropped_results, html_tables, reports, verbosity, wording
from pointloom.core.checks import check_progress
from pointloom.core.dropped_results import returns_new
from pointloom.core.errors import FileError
from pointloom.core.escaped_text import escaped
from pointloom.core.open3d_names import sections
from pointloom.core.verbosity import VerbosityContextManager, VerbosityLevel, get_verbosity_level, set_verbosity_level
from pointloom.io.bags.recording import Recording
from pointloom.io.columns import warn_of_loss
from pointloom.io.points.by_extension import read_points
from pointloom.photogrammetry.video.ground_control import ScaleBar
from pointloom.public_names import results_of
from pointloom.rgbd.reconstruction.config import ReconstructionConfig
from pointloom.tiling.jobs.job import JobStatus

from ..test_imports import ROOT

SCRIPT = """
import sys, time, logging
import pointloom as loom
from pointloom.core import verbosity
from pointloom.core.checks import check_progress
{begin}
verbosity.LOG_INTERVAL = 0.0
say = check_progress(None)
say("pairs", 3, 10)
logging.getLogger("pointloom").debug("details")
"""


PAIRS = "pointloom: pairs 3 of 10, after 0 s\n"


@pytest.mark.parametrize(
    ("begin", "output"),
    [
        pytest.param("", PAIRS, marks=pytest.mark.slow),
        ("logging.getLogger('pointloom').setLevel(logging.DEBUG)", f"{PAIRS}pointloom: details\n"),
        ("logging.basicConfig(format='mine %(message)s')", "mine pairs 3 of 10, after 0 s\n"),
    ],
)
def test_a_long_call_prints_its_progress(begin, output):
    command = [sys.executable, "-c", SCRIPT.format(begin=begin)]
    settings = {name: value for name, value in os.environ.items() if name != "POINTLOOM_VERBOSITY"}
    run = subprocess.run(command, capture_output=True, text=True, check=True, env=settings)
    assert (run.stdout, run.stderr) == ("", output)


def test_a_missing_attribute_imports_no_package():
    """`hasattr` is called with any name. The message looks for it in all packages, and in clouds and meshes."""
    script = (
        "import sys, pointloom as loom\n"
        "cloud = loom.PointCloud([[0, 0, 0]])\n"
        "before = set(sys.modules)\n"
        "assert not hasattr(cloud, 'classify_everything') and not hasattr(loom, 'classify_everything')\n"
        "print(sorted(name for name in set(sys.modules) - before if name.count('.') == 1))"
    )
    found = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    others = ("registration", "rgbd", "photogrammetry", "datasets", "tiling")
    assert not any(f"pointloom.{name}'" in found for name in others), found


def test_a_short_call_prints_nothing(caplog):
    with caplog.at_level(logging.INFO, "pointloom"):
        report = check_progress(None)
        for done in range(100):
            report("pairs", done, 100)
    assert caplog.records == []


def test_debug_prints_each_stage(caplog):
    with VerbosityContextManager(VerbosityLevel.Debug):
        report = check_progress(None)
        for stage in ("voxels", "search", "search", "refine"):
            report(stage, 0, 0)
    assert [record.getMessage() for record in caplog.records] == ["voxels", "search", "refine"]


def test_a_block_leaves_the_level_as_it_was():
    logger = logging.getLogger("pointloom")
    before = logger.level
    with VerbosityContextManager(VerbosityLevel.Error):
        assert get_verbosity_level() is VerbosityLevel.Error and logger.level == logging.ERROR
        with pytest.raises(KeyError), VerbosityContextManager(VerbosityLevel.Debug):
            assert get_verbosity_level() is VerbosityLevel.Debug
            raise KeyError
        assert get_verbosity_level() is VerbosityLevel.Error
    assert logger.level == before
    for wrong in (2, "Info", None):
        with pytest.raises(TypeError, match=r"^verbosity_level:.*VerbosityLevel\.Error"):
            set_verbosity_level(wrong)
        with pytest.raises(TypeError, match="expected a VerbosityLevel"):
            VerbosityContextManager(wrong)


def test_requested_progress_is_printed(capsys):
    cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    cloud.cluster_dbscan(2.0, 2, print_progress=True)
    filtered, _ = cloud.remove_radius_outlier(1, 2.0, print_progress=True)
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "pointloom: clusters of 4 points ..."
    assert lines[1].startswith("pointloom: clusters of 4 points: ") and len(lines) == 4 and len(filtered) == 4
    cloud.cluster_dbscan(2.0, 2)
    assert capsys.readouterr().err == ""


def test_a_closed_stderr_is_ignored(monkeypatch, capsys):
    cloud = loom.PointCloud([[0, 0, 0]])
    monkeypatch.setattr(sys, "stderr", None)
    cloud.cluster_dbscan(2.0, 2, print_progress=True)
    assert capsys.readouterr().out == ""


@pytest.mark.slow
@pytest.mark.parametrize(("given", "level"), [("error", "Error"), ("DEBUG", "Debug"), ("", "Info")])
def test_the_environment_sets_the_verbosity(given, level):
    program = "import pointloom as loom; loom.PointCloud([[0, 0, 0]]); "
    program += "from pointloom.core.verbosity import get_verbosity_level as level; print(level().name)"
    command = [sys.executable, "-c", "from pointloom.core import verbosity; verbosity.start(); " + program]
    settings = os.environ | {"POINTLOOM_VERBOSITY": given}
    assert subprocess.run(command, capture_output=True, text=True, check=True, env=settings).stdout.strip() == level
    wrong = subprocess.run(command, capture_output=True, text=True, env=settings | {"POINTLOOM_VERBOSITY": "loud"})
    assert "ValueError: POINTLOOM_VERBOSITY: expected error, warning, info or debug, got 'loud'" in wrong.stderr


def test_rows_refer_to_existing_names():
    text = "\n".join(row for rows in sections().values() for row in rows.values())
    for name in set(re.findall(r"loom((?:\.\w+)+)", text)):
        owner = loom
        for part in name[1:].split("."):
            known = {*dir(owner), *getattr(owner, "__annotations__", {})}
            assert part in known, f"loom{name}"
            owner = getattr(owner, part, None) if owner is not loom.torch else None  # torch may not be installed
    owners = {"cloud": loom.PointCloud, "mesh": loom.TriangleMesh, "volume": loom.TSDFVolume, "viewer": loom.Viewer}
    owners |= {"search": loom.NearestNeighborSearch, "trajectory": loom.Trajectory}
    for name, part in set(re.findall(rf"\b({'|'.join(owners)})\.(\w+)", text)):
        assert part in {*dir(owners[name]), *getattr(owners[name], "__annotations__", {})}, f"{name}.{part}"


SUBPACKAGES = ("datasets", "meshing", "photogrammetry", "registration", "rgbd", "tiling")
MESSAGES = [
    ("loom.KDTreeFlann(cloud)", r"no attribute 'KDTreeFlann'; here: loom\.NearestNeighborSearch\(cloud\): knn_search"),
    ("loom.read_image('a.png')", r"here: loom\.read_color\(path\) or loom\.read_depth\(path\)"),
    ("loom.io.read_image", "module 'pointloom.io' has no attribute 'read_image'; here: loom.read_color"),
    ("loom.io.no_such_name", "here: loom itself: open3d.io.read_point_cloud is loom.read_point_cloud"),
    ("loom.geometry.read_point_cloud", "it is loom.read_point_cloud"),
    ("loom.core.float32", "here: arrays of NumPy"),
    ("loom.PoseGraph()", "it is loom.registration.PoseGraph"),
    ("loom.registration.compute_iss_keypoints", "it is loom.compute_iss_keypoints"),
    ("loom.registration.OdometryFrame", "it is loom.rgbd.OdometryFrame"),
    ("loom.PointClouds", "did you mean 'PointCloud'"),
    ("loom.meshing.run_non_rigid_optimizer", r'here: loom.meshing.optimize_color_map.method="non-rigid".'),
    ("loom.slam.Model", "here: loom.registration.LidarSLAM and LidarOdometry for scans, loom.rgbd.DenseSLAM for RGB-D"),
    ("loom.load('a.ply')", r"here: loom\.read_point_cloud\(path\) for points, loom\.read_triangle_mesh"),
    ("loom.KDTree(cloud).query_ball_point", r"here: loom\.NearestNeighborSearch\(points\)\.radius_search"),
    ("loom.cKDTree(points)", r"here: loom\.NearestNeighborSearch\(points\)"),
    ("loom.registration.icp", r"here: loom\.registration\.registration_icp"),
    ("loom.registration.load", r"here: loom\.read_point_cloud"),
    ("cloud.shape", r"PointCloud has no attribute 'shape'; here: len\(cloud\)"),
    ("mesh.faces", r"here: mesh\.triangles"),
    ("mesh.export('a.stl')", r"here: loom\.write_triangle_mesh\(path, mesh\)"),
    ("mesh.center", r"here: get_center\(\)"),
    ("loom.PointCloud.from_depth", r"here: loom\.PointCloud\.create_from_depth_image"),
    ("loom.LineSet([[0, 0, 0]], []).centroid", r"here: get_center\(\)"),
    ("loom.registration.registration_ipc", r"did you mean 'registration_icp'\?"),
    ("cloud.normal", r"PointCloud has no attribute 'normal'; did you mean 'normals'\?"),
    ("cloud.color = [1, 0, 0]", r"PointCloud has no attribute 'color'; did you mean 'colors'\? .*cloud\['color'\]"),
    ("cloud.foo = 3", r"PointCloud has no attribute 'foo'; Add an attribute of the points with cloud\['foo'\]"),
    ("mesh.vertex_color = 1", r"TriangleMesh has no attribute 'vertex_color'; did you mean 'vertex_colors'\?"),
    ("loom.AxisAlignedBoundingBox().colour = (1, 0, 0)", r"has no attribute 'colour'; did you mean 'color'\?"),
    ("loom.VoxelGrid.create_from_point_cloud(cloud, 0.1)", "VoxelGrid has no attribute .*; not here: np.unique"),
    ("loom.TriangleMesh.create_from_point_cloud_ball", "did you mean 'create_from_point_cloud_ball_pivoting'"),
    ("mesh.estimate_normals()", r"here: mesh = mesh\.compute_vertex_normals\(\)"),
    ("cloud.is_watertight()", "PointCloud has no attribute 'is_watertight'; TriangleMesh has it"),
    ("volume.voxel_length", "here: volume.voxel_size"),
    ("search.search_knn_vector_3d([0, 0, 0], 5)", r"here: search\.knn_search\(point, knn\)"),
    ("cloud.estimate_normals(0.1, 30)", r"write estimate_normals\(radius=0\.1, max_nn=30\)"),
    ("cloud.estimate_normals(search_param=1)", r"no argument 'search_param'; here: keywords: radius=0\.1, max_nn=30"),
    ("cloud.estimate_normals(search_param=hybrid)", r"here: estimate_normals\(radius=0\.1, max_nn=30\)"),
    ("cloud.voxel_down_sample(voxle_size=1)", "did you mean 'voxel_size'"),
    ("cloud.voxel_down_sample()", "PointCloud.voxel_down_sample.. is missing voxel_size"),
    ("loom.compute_fpfh_feature(cloud, 0.25, 100)", r"write compute_fpfh_feature\(cloud, radius=0\.25, max_nn=100\)"),
    ("loom.TSDFVolume(0.02, 0.08, True)", r"write TSDFVolume\(0\.02, 0\.08, color=True\)"),
    ("loom.PointCloud(cloud.points, cloud.points)", r"write PointCloud\(points, normals=\.\.\.\)"),
    ("loom.render(cloud, zoom=0.5)", r"a view is the second argument of render: loom\.render\(cloud, \{\"zoom\": 0\.5"),
    ("loom.draw(cloud, foo=1)", "has no argument 'foo'; it takes geometries, width, height"),
    ("loom.registration.gicp", "TransformationEstimationForGeneralizedICP"),
    ("loom.registration.ransac", r"here: loom\.registration\.registration_ransac_based_on_correspondence"),
    ("loom.registration.ate", r"here: loom\.registration\.evaluate_trajectory"),
    ("loom.registration.Odometry", r"here: loom\.registration\.LidarOdometry"),
    ("loom.registration.evaluate", "did you mean 'evaluate_trajectory' or 'evaluate_registration'"),
    ("loom.photogrammetry.mvs", r"here: loom\.photogrammetry\.estimate_depth_maps"),
    ("loom.M3C2", r"here: loom\.m3c2"),
    ("loom.read_bag('a.bag')", r"here: loom\.open_recording"),
    ("loom.read_poses('a.txt')", r"here: loom\.read_trajectory"),
    ("loom.iter_las('a.las')", r"here: loom\.read_las_chunks"),
    ("loom.torch.fps", r"here: loom\.torch\.farthest_points"),
    ("loom.torch.chamfer", r"here: loom\.torch\.chamfer_distance"),
    ("loom.torch.sample_points_from_meshes", r"mesh\.sample_points_uniformly.* \(without gradients\)"),
    ("loom.cuda.is_available()", "here: the argument device="),
    ("cloud.rasterize(1.0)", r"here: loom\.rasterize"),
    ("cloud.classify_ground()", r"it is loom\.classify_ground"),
    ("cloud.to_crs('EPSG:25832')", r"here: reproject\(crs\)"),
    ("mesh.unwrap()", r"here: mesh\.compute_uvatlas"),
    ("mesh.remove_duplicate_faces()", "did you mean 'remove_duplicated_triangles'"),
    ("loom.registration.registration_icp(cloud, cloud, 1, max_iteration=9)", "ICPConvergenceCriteria.max_iteration=30"),
]


@pytest.mark.parametrize(("line", "message"), MESSAGES)
def test_the_error_for_an_open3d_name_quotes_its_row(line, message):
    class KDTreeSearchParamHybrid:
        radius, max_nn = 0.1, 30

    cloud = loom.PointCloud(np.zeros((9, 3)))
    names = {"cloud": cloud, "mesh": loom.TriangleMesh.create_box(), "search": loom.NearestNeighborSearch(cloud)}
    names |= {"loom": loom, "volume": loom.TSDFVolume(voxel_size=0.1), "hybrid": KDTreeSearchParamHybrid()}
    with pytest.raises((AttributeError, TypeError), match=message):
        exec(line, names)


# Names of users without a counterpart, or with letters of another name only: nothing is proposed.
WITHOUT_HINT = """loom.load_path loom.Voronoi loom.bunny loom.config loom.DataError loom.create_server loom.FilterError
loom.registration.Constant loom.registration.symmetry loom.torch.emd loom.torch.iou loom.torch.mesh_laplacian_smoothing
cloud.io cloud.Gt cloud.variance cloud.With mesh.time mesh.dup mesh.skeleton mesh.symmetry mesh.create_server"""


@pytest.mark.parametrize("name", WITHOUT_HINT.split())
def test_no_name_is_proposed_that_only_shares_letters(name):
    known = {"loom": loom, "cloud": loom.PointCloud(), "mesh": loom.TriangleMesh()}
    with pytest.raises(AttributeError, match=f"has no attribute '{name.rpartition('.')[2]}'$"):
        eval(name, known)


def camel_case(name):
    first, *others = name.split("_")
    return first + "".join(word.title() for word in others)


def test_functions_of_all_modules_are_found_by_their_words():
    """Also without `compute`, in camel case, from another module and from a class."""
    packages = {"": loom, **{f".{name}": getattr(loom, name) for name in loom.__all__ if name in SUBPACKAGES}}
    functions = [f"loom{path}.{name}" for path, package in packages.items() for name in package.__all__]
    functions = [path for path in functions if path.islower() and "_" in path and path.count(".") < 3]
    assert len(functions) > 100
    for path in functions:
        name = path.rpartition(".")[2]
        for given in {camel_case(name), camel_case(name.removeprefix("compute_"))} - {*dir(loom)}:
            for owner in (loom, loom.registration, loom.PointCloud, loom.TriangleMesh):
                with pytest.raises(AttributeError) as error:
                    getattr(owner, given)
                assert re.search(rf"\b{name}\b|; here: ", str(error.value)), f"{path}: {error.value}"


@pytest.mark.parametrize("kind", [loom.PointCloud, loom.TriangleMesh, loom.RaycastingScene, loom.GaussianSplats])
def test_members_are_found_by_their_words(kind):
    for name in dir(kind):
        if "_" in name and name.islower() and not name.startswith("_"):
            with pytest.raises(AttributeError, match=rf"'; .*\b{name}\b"):
                getattr(kind, camel_case(name))
            misspelled = name[:-3] + name[-2] + name[-3] + name[-1]
            if misspelled != name:
                with pytest.raises(AttributeError, match=rf"'; .*\b{name}\b"):
                    getattr(kind, misspelled)


def packages_of(package):
    """A package of `pointloom.open3d` and the packages in it, without tensors and data sets."""
    yield package
    for name in {*package.__all__} - {"core", "data"}:
        if isinstance(value := getattr(package, name), ModuleType) and hasattr(value, "__path__"):
            yield from packages_of(value)


def test_the_error_of_each_name_of_open3d_that_is_not_in_loom_has_an_equivalent():
    names = {name for package in packages_of(o3d) for name in package.__all__}
    names -= {*o3d.__all__}  # modules, whose paths lead to pointloom's names
    absent = sorted(names - {*loom.__all__})
    assert {"registration_icp", "run_rigid_optimizer", "read_pinhole_camera_intrinsic", "KDTreeFlann"} <= {*absent}
    for name in absent:
        with pytest.raises(AttributeError, match=rf"'{name}'; (here: |it is loom|not here|always)"):
            getattr(loom, name)


def test_errors_from_within_stay_as_they_are():
    with pytest.raises(TypeError, match="voxel_size:"):
        loom.PointCloud(np.zeros((9, 3))).voxel_down_sample("0.05")  # pyright: ignore[reportArgumentType]


# Modules whose warnings contain no path and no name of a file, or are escaped by `listed`.
WITHOUT_NAMES = {"dropped_results.py", "ground.py", "scene_geometries.py"}
EVIL = "a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\r\x00b"
SHOWN = r"a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\x0d\x00b"


def warned(text):
    with pytest.warns(UserWarning) as caught:
        warn_of_loss(text, text, text)
    return str(caught[0].message)


def logged(text, capsys):
    verbosity._print(text)
    return capsys.readouterr().err


def missing(name):
    with pytest.raises(ValueError, match="other") as caught:
        loom.PointCloud(np.zeros((1, 3)), **{name: np.zeros(1)})["other"]
    return str(caught.value)


def refused(call, *arguments):
    with pytest.raises((ValueError, TypeError)) as caught:
        call(*arguments)
    return str(caught.value)


POINT, BOX = np.zeros((1, 3)), loom.TriangleMesh.create_box
TensorMap = o3d.t.geometry.TensorMap


def cloud_of(name, kind):
    return loom.PointCloud(POINT, **{name: np.zeros(1, kind)})


def missing_tensor(name):
    with pytest.raises(KeyError) as caught:
        TensorMap("positions")[name]
    return str(caught.value)


def refused_tensor(name):
    with pytest.raises(TypeError) as caught:
        TensorMap("positions")[name] = None
    return str(caught.value)


def other_length(name):
    with pytest.raises(RuntimeError) as caught:
        tensors = {"positions": o3d.core.Tensor([1]), name: o3d.core.Tensor([1, 2])}
        TensorMap("positions", tensors).assert_size_synchronized()
    return str(caught.value)


def tensor_cloud(name):
    made = o3d.t.geometry.PointCloud(o3d.core.Tensor(POINT))
    made.point[name] = POINT
    return made


def tensor_mesh(name):
    made = o3d.t.geometry.TriangleMesh.create_box()
    made.triangle[name] = np.zeros((12, 1))
    return made


def tensor_lines(name):
    made = o3d.t.geometry.LineSet(o3d.core.Tensor(POINT), o3d.core.Tensor([[0, 0]]))
    made.line[name] = np.zeros((1, 1))
    return made


def logged_by_program(text):
    records = []
    handler = logging.Handler()
    handler.emit = lambda record: records.append(handler.format(record))
    for name in ("pointloom", "pointloom.viewer"):
        logger = logging.getLogger(name)
        logger.addHandler(handler)
        try:
            logger.error("%s failed", text)
        finally:
            logger.removeHandler(handler)
    return "".join(records)


TEXTS = {
    "an error": lambda text, _: str(FileError(text, text, where=text, remedy=text)),
    "an error from another process": lambda text, _: str(pickle.loads(pickle.dumps(FileError(text, text)))),
    "a warning": lambda text, _: warned(text),
    "a report": lambda text, _: reports.in_columns([(text, text)]),
    "a table in a notebook": lambda text, _: html_tables.html_table(text, [(text, text)]),
    "a log": logged,
    "a job": lambda text, _: str(JobStatus("", "", "", 0, 0, 0, 0, 0, False, {text: text}, (text,))),
    "a cloud": lambda text, _: repr(loom.PointCloud(np.zeros((1, 3)), **{text: np.zeros(1)})),
    "an attribute that is missing": lambda text, _: missing(text),
    "a few names": lambda text, _: wording.few_of([text], 3),
    "a format without columns": lambda text, _: refused(read_points, f"a.{text}", ["x"]),
    "a configuration": lambda text, _: refused(ReconstructionConfig.from_names, {text: 1}),
    "a recording": lambda text, _: repr(Recording(Path(text.replace("\0", "")), [])),
    "a name of a job": lambda text, _: str(JobStatus("", text, "", 0, 0, 0, 0, 0, False, {}, ())),
    "an attribute of a wrong length": lambda text, _: refused(
        operator.setitem, loom.PointCloud(POINT), text, np.zeros(3)
    ),
    "an attribute of a mesh": lambda text, _: refused(operator.setitem, BOX().vertex_attributes, text, np.zeros(3)),
    "clouds of other types": lambda text, _: refused(operator.add, *(cloud_of(text, kind) for kind in ("f4", "f8"))),
    "a scale bar": lambda text, _: str(ScaleBar(text, "b", 1.0)),
    "a tensor map": lambda text, _: repr(TensorMap(text, {text: o3d.core.Tensor([1])})),
    "a missing tensor": lambda text, _: missing_tensor(text),
    "a reserved tensor": lambda text, _: refused_tensor(text),
    "tensors of other lengths": lambda text, _: other_length(text),
    "a cloud of tensors": lambda text, _: repr(tensor_cloud(text)),
    "a mesh of tensors": lambda text, _: repr(tensor_mesh(text)),
    "lines of tensors": lambda text, _: repr(tensor_lines(text)),
    "a material": lambda text, _: repr(type(o3d.t.geometry.TriangleMesh().material)(text)),
    "a log of a program": lambda text, _: logged_by_program(text),
}


@pytest.mark.parametrize("text_of", TEXTS.values(), ids=TEXTS)
def test_control_characters_are_shown(text_of, capsys):
    text = text_of(EVIL, capsys)
    assert r"a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\x0d" in text and escaped(text, lines=True) == text


def test_one_line_stays_one(capsys):
    assert "\n" not in str(FileError("a\nerror: none", "b\nc"))
    assert escaped("a\nb", lines=True) == "a\nb" and escaped(EVIL) == SHOWN
    assert reports.in_columns([("size", "1\nmesh  none")]) == "  size  1\n        mesh  none"


def test_json_keeps_what_it_escapes():
    text = wording.json_text({EVIL: EVIL, "line": "é\n\t"})
    assert escaped(text, lines=True) == text and json.loads(text) == {EVIL: EVIL, "line": "é\n\t"}


def test_warnings_with_values_are_escaped():
    """Each names a path, a name of a file, or only numbers and words of the library."""
    plain = set()
    package = ROOT / "src/pointloom"
    for path in set(package.rglob("*.py")) - set((package / "kernels").rglob("*.py")):
        source = path.read_text()
        for node in ast.walk(ast.parse(source)) if "warnings.warn(" in source else ():
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "warnings.warn":
                message = ast.unparse(node.args[0])
                is_safe = message.startswith("escaped(") or isinstance(node.args[0], ast.Constant)
                is_safe = is_safe or f"{message} = escaped(" in source
                plain |= set() if is_safe else {path.name}
    assert plain == WITHOUT_NAMES


class Box:
    @returns_new
    def scale(self, factor=1):
        return Box()

    @returns_new
    def cut(self):
        return Box(), [1]


@returns_new
def optimize(box):
    return Box()


DROPPED = """
box.scale()
(box
 .scale())
box.scale(*[2])
Box.scale(box)
box.cut()
boxes[0].scale().scale()
box and box.scale()
optimize(box)
for b in boxes: b.scale(2)
"""
TAKEN = """
taken = box.scale()
_, rows = box.cut()
boxes.append(box.scale())
boxes.extend(map(Box.scale, boxes[:1]))
boxes.extend(map(lambda b: b.scale(), boxes[:1]))
boxes += [b.scale() for b in boxes[:1]]
list(map(save, map(Box.scale, boxes)))
list(boxes).append(box.scale())
print(*(b.scale() for b in boxes), file=nowhere)
for b in [b.scale() for b in boxes]: b
"""


def lines(text):
    return text.strip().replace("\n ", "\r ").split("\n")


def warnings_of(line, *, in_a_function):
    names = {"box": Box(), "boxes": [Box(), Box()], "factor": 2, "save": bool, "nowhere": io.StringIO()}
    source = line.replace("\r", "\n")
    if in_a_function:
        body = source.replace("\n", "\n  ")
        source = f"def user(box, boxes, save, nowhere, factor):\n  {body}\nuser(**given)"
    with warnings.catch_warnings(record=True, action="always") as caught:
        exec(compile(source, "<user>", "exec"), {**names, "given": names, "Box": Box, "optimize": optimize})
    return [str(warning.message) for warning in caught]


@pytest.mark.parametrize("in_a_function", [False, True])
def test_only_a_call_that_is_a_statement_warns(in_a_function):
    for line in lines(DROPPED):
        messages = warnings_of(line, in_a_function=in_a_function)
        assert any("the result is discarded" in message for message in messages), line
    for line in lines(TAKEN):
        assert warnings_of(line, in_a_function=in_a_function) == [], line
    pair = "Box.cut: the result is discarded; it returns a new object and changes nothing: write box, _ = box.cut(...)"
    assert warnings_of("box.cut()", in_a_function=in_a_function) == [pair]


def test_code_without_positions_warns_of_nothing():
    bare = compile("box.scale()", "<user>", "exec").replace(co_linetable=b"")
    with warnings.catch_warnings(action="error"):
        exec(bare, {"box": Box()})


def test_an_unknown_python_warns_of_nothing(monkeypatch):
    monkeypatch.setattr(dropped_results, "READS_BYTECODE", False)
    assert warnings_of("box.scale()", in_a_function=True) == []


FOR_CODE_ON_THE_DEVICE = {"geometry"}


def public_classes(module):
    """Classes that users construct, without those of results."""
    for name in sorted(set(module.__all__) - results_of(module.__name__)):
        value = getattr(module, name)
        if inspect.isclass(value):
            yield value
        elif isinstance(value, ModuleType) and hasattr(value, "__all__") and name != "torch":  # it has functions alone
            yield from public_classes(value)


def returns_its_own(kind, method):
    """Whether a method returns an object of its class, or a pair whose first is one."""
    annotation = method.__annotations__.get("return", "")
    text = annotation if isinstance(annotation, str) else getattr(annotation, "__name__", "")
    first = text.removeprefix("tuple[").split(",")[0]
    return first in {"Self", *(base.__name__ for base in kind.__mro__[:-1])}


def test_every_method_that_returns_its_own_class_has_the_guard():
    methods = {
        (kind.__name__, name): method
        for kind in public_classes(loom)
        for name, method in inspect.getmembers(kind, inspect.isfunction)
        if not name.startswith(("_", "get_")) and name not in FOR_CODE_ON_THE_DEVICE
        if not isinstance(inspect.getattr_static(kind, name), staticmethod)
    }
    kinds = {kind.__name__: kind for kind in public_classes(loom)}
    guarded = {key: method for key, method in methods.items() if returns_its_own(kinds[key[0]], method)}
    assert [".".join(key) for key, method in guarded.items() if not hasattr(method, "__wrapped__")] == []
    assert {("LineSet", "transform"), ("PointCloud", "to"), ("TriangleMesh", "repair")} <= guarded.keys()
