"""The viewer in a notebook: shown at once, with a still picture for where no server can run."""

import base64
import builtins
import io
import sys
import types

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.drawing.viewer import draw as drawing
from pointloom.drawing.viewer.notebook import StillPicture, frame_html, in_notebook
from pointloom.drawing.viewer.server import ViewerError, ViewerExtraError


@pytest.fixture
def notebook(monkeypatch):
    """As in a kernel of Jupyter's."""
    shell = type("ZMQInteractiveShell", (), {})()
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: shell))


@pytest.fixture
def without_viser(monkeypatch):
    """As where the extra is not installed."""
    for name in [name for name in sys.modules if name.split(".")[0] == "viser" or name.endswith("drawing.viewer.hub")]:
        monkeypatch.delitem(sys.modules, name)
    import_module = builtins.__import__

    def refuse(name, *rest, **more):
        if name.split(".")[0] == "viser":
            raise ModuleNotFoundError("No module named 'viser'", name="viser")
        return import_module(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", refuse)


@pytest.fixture
def cloud(rng):
    return loom.PointCloud(rng.random((500, 3)))


def pixels_of(encoded):
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(encoded))).convert("RGB"))


def test_a_script_is_no_notebook():
    assert not in_notebook()


def test_a_notebook_goes_on_at_once_and_shows_the_page(notebook, cloud, capfd):
    with loom.draw([cloud], port=0, width=320, height=240) as viewer:
        shown = viewer._repr_mimebundle_()
    assert capfd.readouterr() == ("", "")
    assert f'<iframe src="{viewer.url}"' in shown["text/html"]
    assert "ssh -L" in shown["text/html"]
    encoded = shown["text/html"].partition("base64,")[2].partition('"')[0]
    picture = pixels_of(encoded)
    assert picture.shape == (240, 320, 3)
    assert (picture < 250).any(axis=2).sum() > 500
    assert viewer._repr_mimebundle_() == {"text/plain": repr(viewer)}  # once it is closed


def test_a_still_picture_comes_where_the_extra_is_missing(notebook, without_viser, cloud):
    still = loom.draw([cloud], width=320, height=240, front=[1, 0, 0], up=[0, 0, 1])
    assert isinstance(still, StillPicture)
    assert still.picture.shape == (240, 320, 3)
    shown = still._repr_mimebundle_()
    assert (pixels_of(shown["image/png"]) == still.picture).all()
    assert "pip install" in shown["text/html"]
    assert "<iframe" not in shown["text/html"]


def test_a_script_is_told_what_to_install(without_viser, cloud):
    with pytest.raises(ViewerExtraError, match=r'pip install "pointloom\[viewer\]"') as raised:
        loom.draw([cloud])
    assert isinstance(raised.value, ImportError)


def test_a_still_picture_comes_where_no_port_is_free(notebook, cloud, monkeypatch):
    def refuse(**_):
        raise ViewerError("ports 8080 to 8099: all taken")

    monkeypatch.setattr(drawing, "Viewer", refuse)
    still = loom.draw([cloud])
    assert "all taken" in repr(still)


def test_what_stands_in_the_frame_is_escaped():
    shown = frame_html('http://x"><script>', "<b>", None, 100)
    assert "<script>" not in shown
    assert "<b>" not in shown
