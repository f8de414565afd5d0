"""The viewer in a notebook: served live, or embedded as a page where no server can run or be reached."""

import base64
import builtins
import html
import io
import sys
import types

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.visualization.viewer import draw as drawing
from pointloom.visualization.viewer.draw import HOSTED_NOTEBOOKS, MAX_BYTES, VARIABLE, InlinePage, wants_inline
from pointloom.visualization.viewer.server import ViewerError, ViewerExtraError


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
    for name in [
        name for name in sys.modules if name.split(".")[0] == "websockets" or ".visualization.viewer.link" in name
    ]:
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
    inner = shown.partition('srcdoc="')[2].partition('"')[0]
    return html.unescape(inner)


def test_the_page_is_embedded_if_the_extra_is_missing(notebook, without_extra, cloud):
    page = loom.draw([cloud], width=320, height=240, front=[1, 0, 0], up=[0, 0, 1])
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
    monkeypatch.setattr(drawing, "MAX_BYTES", 250_000)
    many = loom.PointCloud(rng.random((60_000, 3)), colors=rng.random((60_000, 3)))
    page = loom.draw({"many": many, "few": cloud}, inline=True, width=160, height=120)
    assert page.html is not None and 100_000 < len(page.html) <= 250_000
    assert "of 60,000 points" in repr(page) and "MB of this notebook" in repr(page)
    monkeypatch.setattr(drawing, "MAX_BYTES", 10_000)  # less than the player
    page = loom.draw(many, inline=True, width=160, height=120)
    assert page.html is None and "<iframe" not in page._repr_mimebundle_()["text/html"]
    assert MAX_BYTES == 4 * 2**20


def test_a_script_gets_an_install_hint(without_extra, cloud):
    with pytest.raises(ViewerExtraError, match="pip install websockets") as raised:
        loom.draw([cloud], block=False)
    assert isinstance(raised.value, ImportError)


def test_the_page_is_embedded_if_no_port_is_free(notebook, cloud, monkeypatch):
    def refuse(**_):
        raise ViewerError("ports 8080 to 8099: all in use")

    monkeypatch.setattr(drawing, "Viewer", refuse)
    assert "all in use" in repr(loom.draw([cloud], width=160, height=120))


def test_printing_costs_a_small_table_and_no_picture(monkeypatch, cloud):
    def refuse(*_, **__):
        raise AssertionError("drawn")

    monkeypatch.setattr("pointloom.visualization.render.render.render", refuse)
    mesh = loom.TriangleMesh.create_box()
    lines = loom.LineSet.create_from_triangle_mesh(mesh)
    box = mesh.get_axis_aligned_bounding_box()
    summary = loom.compare_meshes(mesh, mesh)
    for shown in (cloud, mesh, lines, box, mesh.get_oriented_bounding_box(), summary):
        text = shown._repr_html_()
        assert text.startswith("<table><caption>" + type(shown).__name__) and len(text) < 3000
    assert "<td>triangles</td><td>int32 [12, 3]</td>" in mesh._repr_html_()
    assert "<td>sides [m]</td><td>[1.0, 1.0, 1.0]</td>" in box._repr_html_()
