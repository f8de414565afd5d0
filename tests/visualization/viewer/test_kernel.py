"""Cells run by a real Jupyter kernel: their outputs, output sizes and printed text."""

import json

import pytest

nbclient = pytest.importorskip("nbclient")
nbformat = pytest.importorskip("nbformat")
pytest.importorskip("ipykernel")

pytestmark = pytest.mark.slow

CELLS = {
    "start": "import numpy as np, pointloom as loom\n"
    "cloud = loom.PointCloud(np.random.default_rng(0).random((300_000, 3)))",
    "inline": "loom.draw([cloud], inline=True, width=320, height=240)",
    "live": "viewer = loom.draw([cloud], port=0, inline=False, width=320, height=240)\nviewer",
    "closed": "viewer.close()\nviewer",
    "picture": "loom.render(cloud, size=(320, 240))",
    "cloud": "cloud",
    "mesh": "loom.TriangleMesh.create_box()",
    "many": "for _ in range(50): display(cloud)",
    "progress": "reported = []\nsphere = loom.TriangleMesh.create_sphere(resolution=40)\n"
    "loom.meshing.simplify_mesh(sphere, triangles=500, progress=lambda *step: reported.append(step))\n"
    "print(len(reported) > 0, reported[-1][0])",
    "records": "import logging\nlogging.getLogger('pointloom').setLevel(logging.DEBUG)\n"
    "small = loom.meshing.simplify_mesh(loom.TriangleMesh.create_sphere(resolution=40), triangles=500)",
    "warning": "cloud.translate([1, 0, 0])\ncloud.estimate_normals(radius=0.01)\nNone",
}
STATE = (
    "import gc, json, os, threading\n"
    "from pointloom.visualization.viewer.draw import _opened\n"
    "gc.collect()\n"
    "print(json.dumps({'open': [viewer().url for _, viewer in _opened if viewer() and not viewer().closed],\n"
    "    'threads': threading.active_count(),\n"
    "    'bytes': int(open('/proc/self/statm').read().split()[1]) * os.sysconf('SC_PAGE_SIZE')}))"
)
LARGE = (
    "points = np.random.default_rng(0).random((6_000_000, 3), np.float32)\n"
    "viewer = loom.draw(loom.PointCloud(points), inline=False, max_points=6_000_000)"
)
MANY = {"start": CELLS["start"], "alone": STATE, **{f"same {iteration}": f"{LARGE}\n{STATE}" for iteration in range(5)}}


@pytest.fixture(scope="module")
def outputs():
    return run(CELLS)


@pytest.fixture(scope="module")
def many():
    return run(MANY)


def run(cells):
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for source in cells.values()])
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("POINTLOOM_INLINE", raising=False)
        nbclient.NotebookClient(book, timeout=120, kernel_name="python3").execute()
    return {name: cell.outputs for name, cell in zip(cells, book.cells, strict=True)}


def shown(outputs, kind):
    return next(one.data[kind] for one in outputs if "data" in one and kind in one.data)


def words(outputs, stream):
    return "".join(one.text for one in outputs if one.output_type == "stream" and one.name == stream)


def test_a_cell_that_draws_inline_contains_a_bounded_page(outputs):
    page = shown(outputs["inline"], "text/html")
    assert "<iframe srcdoc=" in page and "of 300,000 points" in page
    assert 500_000 < len(page) < 5 * 2**20 and 5_000 < len(shown(outputs["inline"], "image/jpeg")) < 270_000


def test_a_cell_that_draws_live_contains_a_frame_of_the_server(outputs):
    page = shown(outputs["live"], "text/html")
    assert 'data-src="http://127.0.0.1:' in page and len(page) < 300_000
    assert 5_000 < len(shown(outputs["live"], "image/jpeg")) < 270_000
    assert "text/html" not in outputs["closed"][0].data and "closed" in shown(outputs["closed"], "text/plain")


def test_a_picture_shows_itself(outputs):
    assert len(shown(outputs["picture"], "image/png")) > 1000


def test_geometries_show_small_tables_however_many_there_are(outputs):
    assert "300,000 points" in shown(outputs["cloud"], "text/html")
    assert "int32 [12, 3]" in shown(outputs["mesh"], "text/html")
    assert sum(len(str(one)) for one in outputs["many"]) < 50 * 3000


def test_progress_records_and_warnings_come_through(outputs):
    assert words(outputs["progress"], "stdout").startswith("True ")
    assert "pointloom: " in words(outputs["records"], "stderr")
    assert "DroppedResultWarning" in words(outputs["warning"], "stderr")


def state(outputs):
    return json.loads(words(outputs, "stdout"))


def test_a_cell_that_runs_again_leaves_one_viewer_and_one_cloud(many):
    runs = [state(many[f"same {run}"]) for run in range(5)]
    assert [len(run["open"]) for run in runs] == [1] * 5
    page_urls = [run["open"][0].partition("?")[0] for run in runs]  # each with its own token
    assert runs[4]["threads"] <= runs[0]["threads"] and page_urls[0] == page_urls[4]
    assert runs[4]["bytes"] - runs[1]["bytes"] < 150e6  # three more of them would have 216 MB
