"""The engine of pages in Chromium: drawn nodes, cameras, views, clicks and drags."""

import io
import math

import numpy as np
import pytest
from PIL import Image

from .engine_page import add, at, look_down, png, seen, set_node, statistics, write_engine_page
from .pixels import count_pixels, drag, middle_of, ready

RED, GREEN, BLUE = (220, 30, 20), (20, 170, 40), (20, 60, 220)
SQUARE = np.float32([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
FACES = np.uint32([[0, 1, 2], [0, 2, 3]])
MESH = {"positions": SQUARE, "indices": FACES}
FAR = (5e6 + 0.125, -5e6, 5e6)


@pytest.fixture
def engine(open_page, tmp_path):
    """The engine's page with a camera over the origin: 48 px a unit, 640 x 480 px."""
    write_engine_page(tmp_path / "engine.html")
    page = open_page((tmp_path / "engine.html").as_uri(), offline=True)
    look_down(page)
    return page


def where(x, y, middle=(320, 240)):
    return middle[0] + 48 * x, middle[1] - 48 * y


def test_each_kind_of_node_is_drawn_at_its_position(engine):
    dot = np.float32([[0, 0, 0]])
    add(engine, 1, "points", arrays={"positions": dot}, size=20, plain=RED, pose=at(-4, 3, 0))
    add(engine, 2, "points", arrays={"positions": dot}, size=0.5, metric=True, plain=RED, pose=at(-2, 3, 0, 2))
    add(engine, 3, "triangles", arrays=MESH, lit=False, plain=GREEN, pose=at(1, 3, 0))
    ends = np.float32([[-1, 0, 0], [1, 0, 0]])
    add(engine, 4, "lines", arrays={"positions": ends, "colors": np.uint8([BLUE, BLUE])}, width=6, pose=at(-4, 0, 0))
    image = seen(engine)
    big = math.pi * 24**2  # a diameter of 0.5 in a node that scales by 2
    assert abs(count_pixels(image[:200, 100:160], RED, 1) - math.pi * 100) < 40
    assert abs(count_pixels(image[60:140, 180:270], RED, 1) - big) < 60
    assert math.dist(middle_of(image[:120, :250], RED, 1), where(-2.6, 3)) < 20
    assert math.dist(middle_of(image[:200], GREEN, 1), where(1, 3)) < 1.5
    assert abs(count_pixels(image[:200], GREEN, 1) - 96**2) < 200
    assert abs(count_pixels(image[220:260, :260], BLUE, 1) - (96 + 6) * 6) < 30
    assert statistics(engine)["calls"] == 4


def test_a_pose_far_from_the_origin_is_exact(engine):
    look_down(engine, middle=FAR)
    arrays = {"positions": np.float32([[0.25, 0, 0]])}
    add(engine, 1, "group", pose=at(*FAR))
    add(engine, 2, "points", parent=1, arrays=arrays, size=9, plain=RED, pose=at(2, 0, 0))
    add(engine, 3, "points", parent=1, arrays=arrays, size=9, plain=BLUE, pose=at(2, 1 / 48, 0))
    projected = engine.evaluate(f"engine.project([{FAR[0]} + 2.25, {FAR[1]}, {FAR[2]}])")
    assert math.dist(projected[:2], where(2.25, 0)) < 1e-6
    set_node(engine, 3, visible=False)
    assert math.dist(middle_of(seen(engine), RED, 1), where(2.25, 0)) < 1
    set_node(engine, 2, visible=False)
    set_node(engine, 3, visible=True)
    assert math.dist(middle_of(seen(engine), BLUE, 1), where(2.25, 1 / 48)) < 1


def test_half_floats_are_drawn_where_floats_are(engine):
    rng = np.random.default_rng(2)
    positions = rng.uniform(-4, 4, (500, 3)).astype(np.float16)
    colors = rng.integers(0, 200, (500, 3)).astype(np.uint8)
    add(engine, 1, "points", arrays={"positions": positions.astype(np.float32), "colors": colors}, size=7)
    first = seen(engine)
    add(engine, 1, "points", arrays={"positions": positions, "colors": colors}, size=7)
    assert (first != 255).any(axis=-1).sum() > 5000
    np.testing.assert_array_equal(seen(engine), first)
    assert statistics(engine)["bytes"] == 500 * 9


def test_nodes_change_hide_what_is_below_them_and_are_freed(engine):
    add(engine, 1, "group")
    add(engine, 2, "triangles", parent=1, arrays=MESH, lit=False, plain=RED)
    add(engine, 3, "points", parent=2, arrays={"positions": SQUARE}, size=9, plain=BLUE, pose=at(3, 0, 0))
    assert abs(count_pixels(seen(engine), RED, 1) - 96**2) < 200
    set_node(engine, 1, pose=at(0, 0, 0, 0.5))
    assert abs(count_pixels(seen(engine), RED, 1) - 48**2) < 100
    set_node(engine, 2, arrays={"colors": np.uint8([GREEN] * 4)})
    assert count_pixels(seen(engine), GREEN, 1) > 2000
    set_node(engine, 2, plain=RED, pose=at(-2, 0, 0))
    assert math.dist(middle_of(seen(engine), RED, 1), where(-1, 0)) < 1.5
    set_node(engine, 1, visible=False)
    set_node(engine, 3, visible=True)  # hidden as well
    assert (seen(engine) == 255).all()
    set_node(engine, 1, visible=True)
    assert count_pixels(seen(engine), BLUE, 1) > 200
    assert statistics(engine)["nodes"] == 3 and statistics(engine)["bytes"] > 0
    engine.evaluate("engine.drop(1)")
    assert (seen(engine) == 255).all()
    assert (statistics(engine)["nodes"], statistics(engine)["bytes"], statistics(engine)["kept"]) == (0, 0, 0)


def test_textures_have_their_first_row_at_v_0_and_words_stay_words(engine):
    texture = np.empty((8, 8, 3), np.uint8)
    texture[:4], texture[4:] = RED, BLUE
    uvs = np.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
    arrays = {"positions": SQUARE, "indices": FACES, "uvs": uvs, "texture": png(texture)}
    add(engine, 1, "triangles", arrays=arrays, lit=False)
    engine.evaluate("engine.tree.get(1).geometry.texture.ready")
    image = seen(engine)
    for color, y in ((RED, 0.5), (BLUE, -0.5)):
        assert math.dist(middle_of(image, color, 3), where(0, y)) < 4
    words = "<img src=x onerror=alert(1)> two\nlines"
    add(engine, 2, "label", text=words, anchor="center", pose=at(0, 3, 0))
    changed = (seen(engine) != image).any(axis=-1)
    assert changed.sum() > 300 and math.dist(np.argwhere(changed).mean(axis=0), where(0, 3)[::-1]) < 12
    assert engine.locator("img").count() == 0
    blob = "engine.screenshot().then((b) => b.arrayBuffer()).then((a) => Array.from(new Uint8Array(a)))"
    screenshot = np.asarray(Image.open(io.BytesIO(bytes(engine.evaluate(blob)))).convert("RGB"))
    assert (screenshot != seen(engine)).any(axis=-1).mean() < 0.002


def test_opacity_blends_with_the_background(engine):
    add(engine, 1, "triangles", arrays=MESH, lit=False, plain=BLUE, opacity=0.5, pose=at(0, 0, 0.5))
    add(engine, 2, "triangles", arrays=MESH, lit=False, plain=RED, pose=at(0, 0, 0))
    image = seen(engine)
    assert np.abs(image[240, 320].astype(float) - np.mean([RED, BLUE], axis=0)).max() < 3
    assert statistics(engine)["calls"] == 3  # both sides of a transparent surface


def test_parallel_rays_keep_sizes_and_axis_views_look_along_axes(engine):
    add(engine, 1, "triangles", arrays=MESH, lit=False, plain=RED, pose=at(-2, 0, 0.9))
    add(engine, 2, "triangles", arrays=MESH, lit=False, plain=BLUE, pose=at(2, 0, -0.9))
    image = seen(engine)
    assert count_pixels(image, RED, 1) > 1.2 * count_pixels(image, BLUE, 1)
    engine.evaluate("engine.setOrthographic(true)")
    image = seen(engine)
    assert abs(count_pixels(image, RED, 1) - 96**2) < 200 and abs(count_pixels(image, BLUE, 1) - 96**2) < 200
    assert abs(engine.evaluate("engine.pickDepth(224, 240)") - 9.1) < 1e-3  # read back from the GPU
    x, y, z = engine.evaluate("engine.pick(424, 250)")
    assert math.dist((x, y, z), (104 / 48, -10 / 48, -0.9)) < 1e-3
    engine.evaluate("engine.setUnit('m')")
    seen(engine)
    assert engine.text_content(".scale-bar") == "2 m"
    assert engine.evaluate("document.querySelector('.scale-bar i').getBoundingClientRect().width") == 96
    for axis, forward in (("+x", [1, 0, 0]), ("-y", [0, -1, 0]), ("+z", [0, 0, 1])):
        engine.evaluate("(axis) => engine.lookAlong(axis)", axis)
        rotation = engine.evaluate("engine.camera().rotation")
        np.testing.assert_allclose(np.reshape(rotation, (3, 3))[:, 2], forward, atol=1e-12)
        assert abs(np.linalg.det(np.reshape(rotation, (3, 3))) - 1) < 1e-9
    engine.evaluate("engine.setUp('z')")
    engine.evaluate("engine.lookAlong('+x')")
    seen(engine)
    engine.locator(".gizmo [data-axis='+y'] circle").click()
    np.testing.assert_allclose(engine.evaluate("engine.camera().rotation"), [1, 0, 0, 0, 0, 1, 0, -1, 0], atol=1e-12)
    assert engine.evaluate("reported.clicks") == []  # the gizmo received it


def test_two_views_rotate_together_only_when_linked(engine):
    add(engine, 1, "points", arrays={"positions": np.float32([[0, 0, 0]])}, size=20, plain=RED)
    engine.evaluate("engine.setViews(1, true)")
    assert engine.evaluate("engine.camera().position") == [0, 0, 10]
    engine.evaluate("engine.setViews(2, true)")
    assert abs(engine.evaluate("engine.camera().position")[2] - 10 * 480 / 319) < 1e-9  # so that as much is seen
    image = seen(engine)
    for half in (image[:, :319], image[:, 321:]):
        assert math.dist(middle_of(half, RED, 1), (159.5, 240)) < 1.5
    assert math.dist(engine.evaluate("engine.pick(480, 240)"), (0, 0, 0)) < 1 / 32  # a pixel of the view there
    rotations = "engine.views.cameras.map((camera) => camera.rotation)"
    before = np.reshape(engine.evaluate(rotations), (2, 3, 3))
    engine.evaluate("engine.orbit(0.4, 0)")
    after = np.reshape(engine.evaluate(rotations), (2, 3, 3))
    relative_rotations = after @ np.swapaxes(before, 1, 2)
    np.testing.assert_allclose(relative_rotations[0], relative_rotations[1], atol=1e-9)
    assert np.trace(relative_rotations[0]) < 2.9
    engine.evaluate("engine.setViews(2, false)")
    before = np.reshape(engine.evaluate(rotations), (2, 3, 3))
    drag(engine, (480, 200), (520, 200), steps=4)
    after = np.reshape(engine.evaluate(rotations), (2, 3, 3))
    np.testing.assert_array_equal(after[0], before[0])
    assert np.abs(after[1] - before[1]).max() > 0.05
    seen(engine)
    assert engine.evaluate("reported.cameras.at(-1).size") == [319, 480]


def test_a_press_is_a_click_and_a_drag_is_none(engine):
    seen(engine)
    engine.mouse.click(160, 120)
    assert engine.evaluate("reported.clicks") == [[0.25, 0.25]]
    seen(engine)
    count = engine.evaluate("reported.cameras.length")
    drag(engine, (300, 200), (360, 220), steps=5)
    seen(engine)
    assert engine.evaluate("reported.clicks.length") == 1
    assert 1 <= engine.evaluate("reported.cameras.length") - count <= 6
    engine.mouse.click(320, 240)
    assert engine.evaluate("reported.clicks.at(-1)") == [0.5, 0.5]
    seen(engine)
    draws = statistics(engine)["draws"]
    for _ in range(5):
        ready(engine)  # two frames
    assert statistics(engine)["draws"] == draws  # nothing changes, nothing is drawn


def test_a_lost_gpu_context_is_restored_from_stored_arrays(engine):
    add(engine, 1, "points", arrays={"positions": SQUARE}, size=9, plain=RED)
    add(engine, 2, "triangles", arrays=MESH, plain=GREEN, pose=at(3, 0, 0))
    before = seen(engine)
    add(engine, 3, "points", arrays={"positions": SQUARE}, size=9, plain=BLUE, keep=False, pose=at(-3, 0, 0))
    assert (seen(engine) != before).any()
    engine.evaluate(
        """async () => {
            const loss = engine.painter.gl.getExtension("WEBGL_lose_context");
            const happens = (name) =>
              new Promise((done) => engine.canvas.addEventListener(name, () => setTimeout(done)));
            const [lost, restored] = [happens("webglcontextlost"), happens("webglcontextrestored")];
            loss.loseContext();
            await lost;
            loss.restoreContext();
            await restored;
        }"""
    )
    assert engine.evaluate("reported.lost") == [[3]]
    same = "engine.tree.get(4).geometry.arrays.positions === window.sent"
    engine.evaluate("window.sent = new Float32Array(60_000)")
    engine.evaluate("engine.add(4, 0, 'points', { visible: false }, { positions: sent })")
    assert engine.evaluate(same)  # the stored array is the received one, not a copy
    np.testing.assert_array_equal(seen(engine), before)


def test_uncolored_surfaces_are_visible_and_a_page_follows_the_dark_theme(engine):
    add(engine, 1, "triangles", arrays=MESH)
    light = seen(engine)
    assert (light[240, 320] < 230).all() and np.ptp(light[240, 320].astype(int)) > 8  # warm gray, not white on white
    engine.emulate_media(color_scheme="dark")
    engine.evaluate("engine.setBackground([1, 1, 1], false)")
    dark = seen(engine)
    assert dark[10, 600].max() < 45 and engine.get_attribute("#overlay", "data-theme") == "dark"
    np.testing.assert_array_equal(dark[240, 320], light[240, 320])
    engine.evaluate("engine.setBackground([1, 1, 1], true)")
    assert (seen(engine)[10, 600] == 255).all()
