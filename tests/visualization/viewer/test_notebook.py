"""Viewers in a notebook: served live or embedded; those of rerun cells and beyond the limit are closed."""

import base64
import builtins
import gc
import html
import io
import sys
import types
import weakref

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.visualization.viewer import draw as cells
from pointloom.visualization.viewer.draw import HOSTED_NOTEBOOKS, MAX_OPEN, VARIABLE, InlinePage, wants_inline
from pointloom.visualization.viewer.server import ViewerError, ViewerExtraError

from .events import wait_until
from .pages import hear_until, visitor_of


@pytest.fixture(autouse=True)
def at_home(monkeypatch):
    """A kernel on the machine of its browser, independent of the environment."""
    for variable, _ in HOSTED_NOTEBOOKS:
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.delenv(VARIABLE, raising=False)


@pytest.fixture
def notebook(monkeypatch):
    shell = type("ZMQInteractiveShell", (), {})()
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: shell))


@pytest.fixture
def without_extra(monkeypatch):
    """Simulate a missing optional package."""
    for name in [n for n in sys.modules if n.split(".")[0] == "websockets" or ".visualization.viewer.link" in n]:
        monkeypatch.delitem(sys.modules, name)
    import_module = builtins.__import__

    def refuse(name, *rest, **more):
        if name.split(".")[0] == "websockets":
            raise ModuleNotFoundError("No module named 'websockets'", name="websockets")
        return import_module(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", refuse)


@pytest.fixture
def cloud(rng):
    return loom.PointCloud(rng.random((500, 3)))


def pixels_of(encoded):
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(encoded))).convert("RGB"))


def test_a_notebook_goes_on_at_once_and_shows_the_page(notebook, cloud, capfd):
    with loom.draw([cloud], port=0, width=320, height=240) as viewer:
        shown = viewer._repr_mimebundle_()
    assert capfd.readouterr() == ("", "")
    assert f'data-src="{viewer.url}"' in shown["text/html"]
    assert "ssh -L" in shown["text/html"] and "<details" not in shown["text/html"]
    assert f'src="data:image/jpeg;base64,{shown["image/jpeg"]}"' in shown["text/html"]  # visible without a server
    picture = pixels_of(shown["image/jpeg"])
    assert picture.shape == (240, 320, 3)
    assert (picture < 250).any(axis=2).sum() > 500
    assert viewer._repr_mimebundle_() == {"text/plain": repr(viewer)}  # after it is closed


def page_in(shown):
    return html.unescape(shown.partition('srcdoc="')[2].partition('"')[0])


def test_the_page_is_embedded_if_the_extra_is_missing(notebook, without_extra, cloud):
    gray = {"geometry": cloud, "color": (0.5, 0.5, 0.5)}
    page = loom.draw([gray], width=320, height=240, front=[1, 0, 0], up=[0, 0, 1])
    assert isinstance(page, InlinePage)
    shown = page._repr_mimebundle_()
    difference = np.abs(pixels_of(shown["image/jpeg"]).astype(int) - page.picture)
    assert page.picture.shape == (240, 320, 3) and difference.mean() < 4
    assert "pip install" in shown["text/html"] and page_in(shown["text/html"]) == page.html
    assert 'sandbox="allow-scripts"' in shown["text/html"] and "http" not in shown["text/html"].partition("<iframe")[0]


@pytest.mark.parametrize("variable", [variable for variable, _ in HOSTED_NOTEBOOKS])
def test_the_page_is_embedded_where_no_server_is_reachable(notebook, cloud, monkeypatch, variable):
    monkeypatch.setenv(variable, "1")
    assert wants_inline(None, notebook=True) and wants_inline(False, notebook=True) is None
    assert wants_inline(None, notebook=False) is None
    monkeypatch.setenv(VARIABLE, "0")
    assert wants_inline(None, notebook=True) is None


def test_colab_and_the_environment_variable_embed_the_page(notebook, monkeypatch):
    assert wants_inline(None, notebook=True) is None
    monkeypatch.setenv(VARIABLE, "1")
    assert wants_inline(None, notebook=True) and wants_inline(None, notebook=False) is None
    monkeypatch.setenv(VARIABLE, "yes")
    with pytest.raises(ValueError, match="POINTLOOM_INLINE:"):
        wants_inline(None, notebook=True)
    monkeypatch.delenv(VARIABLE)
    monkeypatch.setitem(sys.modules, "google.colab", types.ModuleType("google.colab"))
    assert "Colab" in (wants_inline(None, notebook=True) or "")


def test_an_embedded_page_is_bounded_and_reports_omissions(cloud, monkeypatch, rng):
    assert cells.MAX_BYTES == 4 * 2**20
    monkeypatch.setattr(cells, "MAX_BYTES", 250_000)
    many = loom.PointCloud(rng.random((60_000, 3)), colors=rng.random((60_000, 3)))
    page = loom.draw({"many": many, "few": cloud}, inline=True, width=160, height=120)
    assert page.html is not None and 100_000 < len(page.html) <= 250_000
    assert "of 60,000 points" in repr(page) and "MB of this notebook" in repr(page)
    monkeypatch.setattr(cells, "MAX_BYTES", 10_000)  # less than the player
    page = loom.draw(many, inline=True, width=160, height=120)
    assert page.html is None and "<iframe" not in page._repr_mimebundle_()["text/html"]


def test_a_script_gets_an_install_hint(without_extra, cloud):
    with pytest.raises(ViewerExtraError, match="pip install websockets") as raised:
        loom.draw([cloud], block=False)
    assert isinstance(raised.value, ImportError)


def test_the_page_is_embedded_if_no_port_is_free(notebook, cloud, monkeypatch):
    def refuse(**_):
        raise ViewerError("ports 8080 to 8099: all in use")

    monkeypatch.setattr(cells, "Viewer", refuse)
    assert "all in use" in repr(loom.draw([cloud], width=160, height=120))


def test_printing_costs_a_small_table_and_no_picture(monkeypatch, cloud):
    def refuse(*_, **__):
        raise AssertionError("drawn")

    monkeypatch.setattr("pointloom.visualization.render.render.render", refuse)
    mesh = loom.TriangleMesh.create_box()
    lines = loom.LineSet.create_from_triangle_mesh(mesh)
    box = mesh.get_axis_aligned_bounding_box()
    for shown in (cloud, mesh, lines, box, mesh.get_oriented_bounding_box(), loom.meshing.compare_meshes(mesh, mesh)):
        text = shown._repr_html_()
        assert text.startswith("<table><caption>" + type(shown).__name__) and len(text) < 3000
    assert "<td>triangles</td><td>int32 [12, 3]</td>" in mesh._repr_html_()
    assert "<td>sides [m]</td><td>[1.0, 1.0, 1.0]</td>" in box._repr_html_()


class Kernel:
    """The request that a kernel is processing."""

    def __init__(self):
        self.count = 0

    def run(self, code, **metadata):
        self.count += 1
        request = {"header": {"msg_id": str(self.count)}, "metadata": metadata, "content": {"code": code}}
        self.get_parent = lambda: request


class StandIn:
    """A viewer without a server."""

    def __init__(self):
        self.closed, self.closing_notice = False, None

    def close(self):
        self.closed = True


@pytest.fixture
def kernel(monkeypatch):
    kernel = Kernel()
    kernel.kernel = kernel  # as of Jupyter's shells
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: kernel))
    monkeypatch.setattr(cells, "_opened", [])
    return kernel


def opened():
    cells.make_room()
    viewer = StandIn()
    cells.keep(viewer)
    return viewer


@pytest.mark.parametrize("metadata", [{}, {"cellId": "a"}, {"cell_id": "a"}])
def test_a_rerun_cell_closes_its_earlier_viewer(kernel, metadata):
    kernel.run("draw(a); draw(b)", **metadata)
    first = [opened(), opened()]
    kernel.run("draw(c)", cellId="another")
    other = opened()
    assert not any(viewer.closed for viewer in first)  # two of one run
    kernel.run("draw(a); draw(b)", **metadata)
    again = opened()
    assert (
        all(viewer.closed and viewer.closing_notice is None for viewer in first)
        and not other.closed
        and not again.closed
    )
    kernel.run("draw(a); draw(b)", cellId="of the same text")
    opened()
    assert not again.closed
    kernel.run("draw(edited)", **metadata)
    opened()
    assert again.closed == bool(metadata)


def test_the_oldest_viewer_is_closed_with_a_message_at_the_limit(kernel):
    viewers = []
    for number in range(MAX_OPEN + 4):
        kernel.run(f"draw({number})")
        viewers.append(opened())
    assert [viewer.closed for viewer in viewers] == [True] * 4 + [False] * MAX_OPEN
    assert all("oldest" in viewer.closing_notice for viewer in viewers[:4])
    kernel.run("draw(15)")
    opened()  # of an existing cell: no other viewer is closed
    assert [viewer.closed for viewer in viewers[4:]].count(True) == 1


@pytest.mark.parametrize("request_", [None, {}, {"metadata": None}, {"metadata": {}, "content": {}, "header": {}}])
def test_a_kernel_without_cell_ids_closes_viewers_only_at_the_limit(kernel, request_):
    kernel.get_parent = lambda: request_
    viewers = [opened() for _ in range(MAX_OPEN + 1)]
    assert [viewer.closed for viewer in viewers] == [True] + [False] * MAX_OPEN


def test_closed_or_collected_viewers_are_forgotten(kernel, quick_collection):
    kernel.run("draw(a)")
    let_go = weakref.ref(opened())
    closed = opened()
    closed.close()
    gc.collect()
    assert let_go() is None
    kernel.run("draw(b)")
    opened()
    assert len(cells._opened) == 1


def test_the_earlier_cloud_of_a_rerun_cell_is_freed(kernel, capfd, quick_collection):
    clouds, viewers = [], []
    for _ in range(3):
        kernel.run("viewer = loom.draw(cloud)", cellId="a")
        cloud = loom.PointCloud(np.random.default_rng(0).random((50, 3)))
        clouds.append(weakref.ref(cloud))
        viewers.append(loom.draw(cloud, port=0, inline=False, width=64, height=48))
        del cloud
    gc.collect()
    assert [viewer.closed for viewer in viewers] == [True, True, False]
    assert [cloud() is None for cloud in clouds] == [True, True, False]
    viewers[-1].close()
    assert capfd.readouterr() == ("", "")


def test_visitors_of_the_oldest_viewer_are_notified(kernel, monkeypatch):
    monkeypatch.setattr(cells, "MAX_OPEN", 1)
    kernel.run("loom.draw(first)")
    first = loom.draw(np.eye(3), port=0, inline=False, width=64, height=48)
    with visitor_of(first.server) as page:
        wait_until(lambda: first.sessions)
        kernel.run("loom.draw(second)")
        loom.draw(np.eye(3), port=0, inline=False, width=64, height=48).close()
        assert first.closed
        assert "the oldest" in hear_until(page, "end")["text"]
