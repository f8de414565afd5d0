"""Recordings in Chromium with hostile or no content, and browsers without required features."""

import numpy as np
import pytest

from pointloom.visualization.recording.page import write_page
from pointloom.visualization.recording.timeline import Frame, Placement, Shape, Timeline

from ..pixels import wait_for_messages, wait_in_page
from .scenes import from_above, grid, one_frame, stage, two_clouds

HOSTILE = "</script ><img src=x onerror=\"document.title='taken'\"><b>bold"


def test_hostile_names_are_shown_as_text(open_recording):
    frames = [Frame({HOSTILE: Placement((0,))}, HOSTILE, {HOSTILE: float(k)}) for k in range(2)]
    page = open_recording(Timeline(np.zeros(3), [Shape("points", grid(5))], frames, title=HOSTILE))
    assert page.title().startswith("</script >")
    assert page.text_content("#items label") == page.text_content("#label") == page.text_content("h1") == HOSTILE
    assert page.text_content("#plots span") == HOSTILE
    assert page.locator("img:not(#key)").count() == page.locator("b").count() == 0


def test_the_policy_stops_scripts_and_requests_that_get_in_all_the_same(open_recording):
    page = open_recording(two_clouds(), faults=False)
    page.evaluate(
        """() => {
            const script = document.createElement("script");
            script.textContent = "document.title = 'taken'";
            document.body.append(script);
            const image = document.createElement("img");
            image.setAttribute("onerror", "document.title = 'taken'");
            image.src = "elsewhere.png";
            document.body.append(image);
        }"""
    )
    stopped = lambda: sum("Content Security Policy" in fault for fault in page.visit.faults)  # noqa: E731
    wait_for_messages(page, lambda: stopped() >= 2)
    assert page.title() == "two squares"
    assert page.evaluate("fetch('data:,x').then(() => 'fetched', () => 'refused')") == "refused"
    wait_for_messages(page, lambda: stopped() >= 3)


def test_an_empty_recording_shows_a_message(open_recording):
    page = open_recording(Timeline(np.zeros(3), title="nothing"))
    assert "Nothing was recorded" in page.text_content("#message")
    assert page.is_visible("#message")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("HTMLCanvasElement.prototype.getContext = () => null", "WebGL 2"),
        ("delete window.DecompressionStream", "2023 or later"),
    ],
)
def test_missing_browser_features_are_reported_with_a_remedy(open_page, tmp_path, change, words):
    write_page(tmp_path / "p.html", two_clouds())
    page = open_page("about:blank", faults=False)
    page.add_init_script(change)
    page.goto((tmp_path / "p.html").as_uri())
    wait_in_page(page, f"document.getElementById('message').textContent.includes('{words}')")
    assert page.visit.faults == []


def test_a_lost_gpu_context_is_restored(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    before = stage(page)
    page.evaluate(
        """async () => {
            const canvas = document.getElementById("scene");
            const loss = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
            const lost = new Promise((done) => canvas.addEventListener("webglcontextlost", () => setTimeout(done)));
            loss.loseContext();
            await lost;
            loss.restoreContext();
        }"""
    )
    wait_in_page(page, "recording.statistics().uploads === 4")
    assert np.array_equal(stage(page), before)


def test_shapes_without_anything_in_them_are_no_error(open_recording):
    nothing = np.empty((0, 3), np.float32)
    shapes = [
        Shape("points", nothing, np.empty((0, 3), np.uint8), nothing),
        Shape("lines", nothing, indices=np.empty((0, 2), np.int32)),
        Shape("triangles", nothing, indices=np.empty((0, 3), np.int32), wireframe=True),
    ]
    page = open_recording(one_frame(*shapes))
    assert (stage(page) == 255).all() and not page.is_visible("#count")
