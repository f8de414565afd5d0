"""Recordings as one HTML file: their content, and rejected input."""

import base64
import dataclasses
import hashlib
import math
import tracemalloc

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.visualization.recording import page as page_module
from pointloom.visualization.recording.page import write_page
from pointloom.visualization.recording.shared_player import PLAYER, share_player, write_player
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline
from pointloom.visualization.render.view import View, fit_view

from .reading import Page, outside_addresses

SQUARE = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
HOSTILE = '</script ><img src=x onerror="alert(1)">{{script}}<!--\u2028&lt;'


def points(rng, count=1000, **more) -> Shape:
    return Shape("points", rng.normal(size=(count, 3)).astype(np.float32), **more)


def moved(x: float) -> np.ndarray:
    T = np.eye(4)
    T[0, 3] = x
    return T


def one_frame(*shapes: Shape) -> Timeline:
    return Timeline(np.zeros(3), list(shapes), [Frame({"a": Placement(tuple(range(len(shapes))))})])


@pytest.fixture
def write(tmp_path):
    """Write the page of a timeline and read it as its player does."""

    def write_one(timeline: Timeline, **options) -> Page:
        write_page(tmp_path / "p.html", timeline, **options)
        return Page(tmp_path / "p.html")

    return write_one


@pytest.fixture
def timeline(rng) -> Timeline:
    """All kinds of shapes, three frames, two plots."""
    shapes = [
        points(rng, colors=rng.integers(0, 256, (1000, 3)).astype(np.uint8), normals=rng.normal(size=(1000, 3))),
        Shape("triangles", SQUARE, normals=np.float32([[0, 0, 1]] * 4), indices=np.int32([[0, 1, 2], [0, 2, 3]])),
        Shape("lines", SQUARE, np.uint8([[255, 0, 0], [0, 255, 0]]), indices=np.int32([[0, 1], [2, 3]]), size=3.0),
    ]
    frames = [
        Frame({"cloud": Placement((0,), moved(k)), "mesh": Placement((1, 2))}, f"step {k}", {"fitness": k / 3})
        for k in range(3)
    ]
    frames[1].values["rmse"] = math.nan
    return Timeline(np.array([5e5, 5e6, 100.0]), shapes, frames, title="a recording", fps=5)


@pytest.fixture
def written(timeline, write):
    return write(timeline)


def test_positions_colors_and_indices_are_bitwise_identical(written, timeline):
    for described, shape in zip(written.description["shapes"], timeline.shapes, strict=True):
        assert described["kind"] == shape.kind
        assert written.array(described["positions"]).tobytes() == shape.positions.tobytes()
        for name in ("colors", "indices"):
            np.testing.assert_array_equal(written.array(described.get(name)), getattr(shape, name))


def test_normals_keep_their_direction_to_a_hundredth_of_a_degree(written, timeline):
    units = timeline.shapes[0].normals / np.linalg.norm(timeline.shapes[0].normals, axis=1, keepdims=True)
    normals = written.array(written.description["shapes"][0]["normals"]).astype(float)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.degrees(np.linalg.norm(np.cross(units, normals), axis=1)).max() < 0.01


def test_normals_of_no_length_or_of_nan_are_none(rng, write):
    normals = np.float32([[0, 0, 0], [np.nan, 0, 1], [np.inf, 0, 0], [0, 0, 1e-30], [0, 3, 0]])
    page = write(one_frame(points(rng, 5, normals=normals)))
    written_normals = page.array(page.description["shapes"][0]["normals"])
    assert written_normals.tolist() == [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 32767], [0, 32767, 0]]


def test_frames_list_the_displayed_shapes_and_poses(written):
    for k in range(3):
        shown = written.shown(k)
        assert list(shown) == ["cloud", "mesh"]
        assert shown["cloud"][0] == [0] and shown["mesh"][0] == [1, 2]
        np.testing.assert_array_equal(shown["cloud"][1], moved(k))
        np.testing.assert_array_equal(shown["mesh"][1], np.eye(4))
        assert written.description["frames"][k]["label"] == f"step {k}"


def test_a_shape_or_pose_that_stays_is_stored_once(rng, write):
    shape = points(rng)
    frames = [Frame({"cloud": Placement((0,), moved(1))}) for _ in range(200)]
    one, many = (write(Timeline(np.zeros(3), [shape], frames[:count])) for count in (1, 200))
    assert len(many.arrays) == 2 and len(many.description["placements"]) == 1
    assert len(many.text) - len(one.text) < 200 * 30


def test_numbers_of_plots_have_gaps_where_there_are_none(written):
    series = {each["name"]: each["values"] for each in written.description["series"]}
    assert series == {"fitness": [0, 1 / 3, 2 / 3], "rmse": [None, None, None]}


def test_a_page_refers_to_nothing_external_and_runs_only_its_scripts(written):
    code = written.text.split('<script type="text/plain"')[0] + written.scripts[0]
    assert outside_addresses(code) == []
    assert [tag for tag, attributes in written.elements if {"src", "srcset", "style"} & set(attributes)] == []
    assert [a["href"] for _, a in written.elements if "href" in a] == ["data:,"]
    assert not any(name.startswith("on") for _, attributes in written.elements for name in attributes)
    policy = written.policy()
    assert policy["default-src"] == ["'none'"] and policy["img-src"] == ["data:"]
    for name, texts in (("script-src", written.scripts), ("style-src", written.styles)):
        digest = hashlib.sha256(texts[0].encode()).digest()
        assert len(texts) == 1 and policy[name] == [f"'sha256-{base64.b64encode(digest).decode()}'"]
    assert "eval(" not in written.scripts[0] and "innerHTML" not in written.scripts[0]


def test_hostile_titles_labels_and_names_stay_text(rng, write):
    frame = Frame({HOSTILE: Placement((0,))}, HOSTILE, {HOSTILE: 1.0})
    key = HOSTILE, np.zeros((4, 6, 3), np.uint8)
    page = write(Timeline(np.zeros(3), [points(rng)], [frame], title=HOSTILE), key=key)
    images = [attributes for tag, attributes in page.elements if tag == "img"]
    assert images == [{"id": "key", "alt": "", "hidden": None}]  # filled by the player
    assert (page.description["key"]["text"], page.description["key"]["width"]) == (HOSTILE, 3.0)
    assert page.description["items"] == [HOSTILE]
    assert page.title == HOSTILE.replace("\u2028", "\\u2028")
    texts = page.description
    assert texts["title"] == texts["frames"][0]["label"] == texts["series"][0]["name"] == HOSTILE
    assert len(page.scripts) == 1 and HOSTILE not in page.text
    assert page.text.lower().count("</script") == 2 + len(page.arrays)  # of the description, the player and the arrays


def test_without_frames_or_points_there_is_still_a_page(write):
    nothing = Shape("points", np.empty((0, 3), np.float32))
    no_lines = Shape("lines", np.empty((0, 3), np.float32), indices=np.empty((0, 2), np.int32))
    frame = Frame({"a": Placement((0, 1)), "b": Placement(())})
    for each in (Timeline(np.zeros(3)), Timeline(np.zeros(3), [nothing, no_lines], [frame])):
        described = write(each).description
        assert np.isfinite(described["camera"]["eye"]).all() and described["bounds"] == [[0, 0, 0], [0, 0, 0]]


@pytest.mark.parametrize("count", [1, 100, 101, 307])
def test_arrays_of_any_length_come_back(rng, write, count, monkeypatch):
    monkeypatch.setattr(page_module, "ROWS_PER_BLOCK", 100)
    shape = points(rng, count, colors=rng.integers(0, 256, (count, 3)).astype(np.uint8))
    page = write(one_frame(shape))
    for name in ("positions", "colors"):
        np.testing.assert_array_equal(page.arrays[page.description["shapes"][0][name]], getattr(shape, name))


def test_the_view_is_counted_from_the_timelines_origin(timeline, write):
    view = fit_view(SQUARE + timeline.origin, width=320, height=200)
    lens = dataclasses.replace(view.intrinsic, fx=300.0, fy=400.0, cx=-5.0)
    view = View(lens, view.T_world_camera)
    camera = write(timeline, view=view).description["camera"]
    np.testing.assert_allclose(camera["eye"], view.T_world_camera[:3, 3] - timeline.origin, atol=1e-8)
    np.testing.assert_array_equal(np.reshape(camera["rotation"], (3, 3)), view.T_world_camera[:3, :3])
    assert [camera[name] for name in ("width", "height", "fx", "fy", "cx")] == [320, 200, 300, 400, -5]


def test_without_a_view_all_frames_fit_the_window(rng, write):
    shape = points(rng, 50_000)
    frames = [Frame({"a": Placement((0,), moved(20 * k))}) for k in range(3)]
    described = write(Timeline(np.zeros(3), [shape], frames)).description
    camera, R = described["camera"], np.reshape(described["camera"]["rotation"], (3, 3))
    everything = np.concatenate([shape.positions + np.array([20 * k, 0, 0]) for k in range(3)])
    x, y, z = ((everything - camera["eye"]) @ R).T
    columns, rows = camera["fx"] * x / z + camera["cx"], camera["fy"] * y / z + camera["cy"]
    assert z.min() > 0 and columns.min() > 0 and columns.max() < 1279 and rows.min() > 0 and rows.max() < 959
    assert np.ptp(columns) > 0.85 * 1280 or np.ptp(rows) > 0.85 * 960
    np.testing.assert_allclose(described["bounds"], [everything.min(0), everything.max(0)], rtol=1e-6)


def test_vertices_that_no_triangle_uses_do_not_count_for_the_view(write):
    stray = np.vstack([SQUARE, np.float32([[1000, 0, 0]])])
    page = write(one_frame(Shape("triangles", stray, indices=np.int32([[0, 1, 2]]))))
    assert page.description["bounds"] == [[0, 0, 0], [1, 1, 0]]


def test_a_size_of_points_given_is_that_of_all_points(timeline, write):
    assert [each["size"] for each in write(timeline, point_size=7).description["shapes"]] == [7.0, 2.0, 3.0]


@pytest.mark.slow
def test_writing_takes_little_memory_beside_the_points(rng, tmp_path):
    shape = points(rng, 500_000)
    tracemalloc.start()
    write_page(tmp_path / "p.html", one_frame(shape))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 1.5 * shape.positions.nbytes + 2**24


def test_an_existing_file_is_replaced_atomically_and_only_on_request(timeline, tmp_path, monkeypatch):
    path = tmp_path / "p.html"
    path.write_text("mine")
    with pytest.raises(FileError, match="exists already"):
        write_page(path, timeline, overwrite=False)
    with pytest.raises(FileError, match=r"/p\.html:"):
        write_page(tmp_path / "none" / "p.html", timeline)
    monkeypatch.setattr(page_module, "_base64_pieces", lambda values: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        write_page(path, timeline)
    assert path.read_text() == "mine" and list(tmp_path.iterdir()) == [path]


@pytest.fixture
def recorded(tmp_path, rng):
    write_page(tmp_path / "whole.html", one_frame(Shape("points", rng.random((100, 3)).astype(np.float32))))
    return tmp_path / "whole.html"


def test_a_page_without_its_player_names_the_player_files(recorded, tmp_path):
    write_player(tmp_path)
    share_player(recorded, tmp_path / "shared.html", "../")
    standalone, shared = recorded.read_text(), (tmp_path / "shared.html").read_text()
    script, style = ((tmp_path / f"{PLAYER}{suffix}").read_text() for suffix in (".js", ".css"))
    assert script in standalone and style in standalone and script not in shared and style not in shared
    assert f'<script src="../{PLAYER}.js">' in shared and f'href="../{PLAYER}.css"' in shared
    assert "script-src 'self' file:;" in shared and "default-src 'none'" in shared and "sha256" not in shared
    arrays = [text[text.index('data-array="0"') :].split("</script>")[0] for text in (standalone, shared)]
    assert arrays[0] == arrays[1]


def test_a_page_that_is_no_recording_is_refused(tmp_path):
    (tmp_path / "page.html").write_text("<html></html>")
    with pytest.raises(FileError, match="no recording"):
        share_player(tmp_path / "page.html", tmp_path / "shared.html")
    assert not (tmp_path / "shared.html").exists()
