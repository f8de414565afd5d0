"""Recordings of a site share one player, which lies beside them."""

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.drawing.recording.page import write_page
from pointloom.drawing.recording.shared_player import PLAYER, share_player, write_player
from pointloom.drawing.recording.timeline import Frame, Placed, Shape, Timeline


@pytest.fixture
def recorded(tmp_path, rng):
    shape = Shape("points", rng.random((100, 3)).astype(np.float32))
    write_page(tmp_path / "whole.html", Timeline(np.zeros(3), [shape], [Frame({"cloud": Placed((0,))})]))
    return tmp_path / "whole.html"


def test_a_page_without_its_player_names_the_files_that_hold_it(recorded, tmp_path):
    write_player(tmp_path)
    share_player(recorded, tmp_path / "shared.html", "../")
    whole, shared = recorded.read_text(), (tmp_path / "shared.html").read_text()
    script, style = ((tmp_path / f"{PLAYER}{suffix}").read_text() for suffix in (".js", ".css"))
    assert script in whole and style in whole and script not in shared and style not in shared
    assert f'<script src="../{PLAYER}.js">' in shared and f'href="../{PLAYER}.css"' in shared
    assert "script-src 'self' file:;" in shared and "default-src 'none'" in shared and "sha256" not in shared
    arrays = [text[text.index('data-array="0"') :].split("</script>")[0] for text in (whole, shared)]
    assert arrays[0] == arrays[1]


def test_a_page_that_is_no_recording_is_refused(tmp_path):
    (tmp_path / "page.html").write_text("<html></html>")
    with pytest.raises(FileError, match="no recording"):
        share_player(tmp_path / "page.html", tmp_path / "shared.html")
    assert not (tmp_path / "shared.html").exists()
