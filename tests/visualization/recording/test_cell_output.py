"""A recording as the last line of a notebook cell displays itself, in at most 4 MB."""

import base64
import html
import io
import shutil

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.visualization.recording import cell_output

RED, GROUND = (255, 0, 0), (0, 0, 1.0)


def recorded(path, **options):
    with loom.record(path, size=(160, 120), background=GROUND, **options) as r:
        r.add("shown", np.random.default_rng(0).random((500, 3)), color=(0, 1, 0))
        r.step("first")
        r.add("shown", loom.TriangleMesh.create_box(), color=(1, 0, 0), shaded=False)
        r.step("last")
    return r


def still_of(shown):
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(shown["image/jpeg"]))).convert("RGB")).astype(int)


def reds(picture):
    return (np.abs(picture - RED) < 40).all(axis=-1).sum()


def test_a_page_is_embedded_in_the_notebook_over_its_last_frame(tmp_path):
    r = recorded(tmp_path / "a.html")
    shown = r._repr_mimebundle_()
    page = shown["text/html"].partition('srcdoc="')[2].partition('"')[0]
    assert html.unescape(page) == (tmp_path / "a.html").read_text()
    assert "a.html, " in shown["text/html"] and shown["text/plain"] == repr(r)
    assert reds(still_of(shown)) > 1000


@pytest.mark.parametrize(
    ("suffix", "start"),
    [
        (".gif", '<img alt="" src="data:image/gif;base64,'),
        pytest.param(
            ".mp4", '<video controls loop src="data:video/mp4;base64,',
            marks=pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="no ffmpeg here"),
        ),
    ],
)  # fmt: skip
def test_animations_and_videos_play_below_the_cell(tmp_path, suffix, start):
    shown = recorded(tmp_path / f"a{suffix}")._repr_mimebundle_()
    assert shown["text/html"].startswith(start)
    data = base64.b64decode(shown["text/html"][len(start) :].partition('"')[0])
    assert data == (tmp_path / f"a{suffix}").read_bytes() and reds(still_of(shown)) > 1000


def test_large_files_are_shown_by_their_last_frame_and_path(tmp_path, monkeypatch):
    monkeypatch.setattr(cell_output, "MAX_PAGE_BYTES", 10_000)
    shown = recorded(tmp_path / "large.html")._repr_mimebundle_()
    assert "<iframe" not in shown["text/html"] and "large.html" in shown["text/html"] and reds(still_of(shown)) > 1000
    assert "9.8 KiB in notebooks: open it in a browser" in shown["text/html"] and len(shown["text/html"]) < 300_000


def test_a_deleted_file_is_shown_by_its_last_frame(tmp_path):
    r = recorded(tmp_path / "a.html")
    (tmp_path / "a.html").unlink()
    shown = r._repr_mimebundle_()
    assert "cannot be read" in shown["text/html"] and reds(still_of(shown)) > 1000


def test_an_unwritten_recording_is_shown_as_text(tmp_path):
    r = loom.record(tmp_path / "a.html")
    with r:
        r.add("square", np.eye(3))
        r.step()
        assert r._repr_mimebundle_() == {"text/plain": repr(r)}
        r.discard()
    assert not (tmp_path / "a.html").exists() and r._repr_mimebundle_() == {"text/plain": repr(r)}
