"""Recordings in Chromium: opened from disk without a network, played, turned, and hostile."""

import math
import time

import numpy as np
import pytest

import pointloom as loom
from pointloom.app.pictures.view import View, fit_view
from pointloom.app.recording import page as page_module
from pointloom.app.recording.page import write_page
from pointloom.app.recording.timeline import Frame, Placed, Shape, Timeline
from tests.browser.pixels import count_pixels, is_color, middle_of, picture

RED, BLUE, GREEN = (220, 30, 20), (20, 60, 220), (20, 170, 40)
SETTLED = "document.documentElement.dataset.settled === 'true'"
HOSTILE = "</script ><img src=x onerror=\"document.title='taken'\"><b>bold"


def grid(count=60, size=1.0, z=0.0) -> np.ndarray:
    """A square of points."""
    axis = np.linspace(-size, size, count)
    x, y = np.meshgrid(axis, axis)
    return np.column_stack([x.ravel(), y.ravel(), np.full(count * count, z)]).astype(np.float32)


def one_frame(*shapes: Shape, origin=(0, 0, 0), label="") -> Timeline:
    """Shapes that stay, each under a name of its own."""
    shown = {f"part {number}": Placed((number,)) for number in range(len(shapes))}
    return Timeline(np.array(origin, float), list(shapes), [Frame(shown, label)])


def moved(x: float, y: float = 0.0) -> np.ndarray:
    T = np.eye(4)
    T[:2, 3] = x, y
    return T


def two_clouds(frame_count=8, origin=(0, 0, 0)) -> Timeline:
    """A red square that moves from the left onto a blue one that stands."""
    up = np.tile(np.float32([0, 0, 1]), (3600, 1))
    shapes = [
        Shape("points", grid(), None, up, size=4.0, plain=RED),
        Shape("points", grid(z=-0.5), None, up, size=4.0, plain=BLUE),
    ]
    last = frame_count - 1
    frames = [
        Frame(
            {"source": Placed((0,), moved(3 * (k / last - 1))), "target": Placed((1,))},
            f"iteration {k}",
            {"fitness": k / last, "inlier_rmse": 0.1 * math.exp(-k)},
        )
        for k in range(frame_count)
    ]
    return Timeline(np.array(origin, float), shapes, frames, title="two squares", fps=20)


def from_above(height=10.0, width=640, rows=480, origin=(0, 0, 0)) -> View:
    """A camera over the origin that looks down, y up in the picture."""
    T = np.diag([1.0, -1, -1, 1])
    T[:3, 3] = np.add(origin, (0, 0, height))
    return View(loom.PinholeCameraIntrinsic(width, rows, 600.0, 600.0, (width - 1) / 2, (rows - 1) / 2), T)


@pytest.fixture
def open_recording(open_page, tmp_path):
    """Write a page, open it from disk without a network, and wait for its first picture."""

    def open_one(timeline, *, width=1000, height=700, faults=True, **options):
        path = tmp_path / "recording.html"
        write_page(path, timeline, **options)
        page = open_page(path.as_uri(), width=width, height=height, offline=True, faults=faults)
        wait_for(page, SETTLED)
        return page

    return open_one


def wait_for(page, expression: str, seconds: float = 30.0) -> None:
    """Until the expression is true; the page's policy forbids playwright's own way, which is `eval` in the page."""
    end = time.monotonic() + seconds
    while not page.evaluate(expression):
        assert time.monotonic() < end, f"never true: {expression}"
        page.wait_for_timeout(30)


def stage(page) -> np.ndarray:
    """The picture of the scene once nothing moves, without what lies over it."""
    page.evaluate(
        """() => {
            for (const id of ["panel", "help", "help-button"]) document.getElementById(id).style.opacity = 0;
            document.getElementById("scene").style.outline = "none";
        }"""
    )
    wait_for(page, SETTLED)
    box = page.locator("#scene").bounding_box()
    return picture(page, panels=True)[: round(box["height"]), : round(box["width"])]


def is_reddish(image: np.ndarray) -> np.ndarray:
    """Which pixels are red, however dark."""
    red, green, blue = np.moveaxis(image.astype(int), -1, 0)
    return (red > 40) & (red > 2 * (green + blue))


def statistics(page) -> dict:
    return page.evaluate("recording.statistics()")


def test_it_opens_from_disk_without_a_network_and_asks_for_nothing(open_recording):
    page = open_recording(two_clouds())
    assert [url.split(":")[0] for url in page.visit.requests] == ["file"]
    assert page.title() == page.text_content("h1") == "two squares"
    assert page.text_content("#label") == "iteration 0" and page.text_content("#place") == "1 / 8"
    assert page.text_content("#count") == "7,200 points drawn"


def test_each_shape_is_there_in_its_color(open_recording):
    image = stage(open_recording(two_clouds(), view=from_above()))
    assert count_pixels(image, RED, 60) > 5000 and count_pixels(image, BLUE, 60) > 5000
    assert middle_of(image, RED, 60)[0] < middle_of(image, BLUE, 60)[0] - 100


def test_playing_moves_the_red_cloud_and_ends_where_it_began(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    first, blue = middle_of(stage(page), RED, 60), count_pixels(stage(page), BLUE, 60)
    page.uncheck("#loop")
    page.focus("#scene")
    page.keyboard.press("Space")
    wait_for(page, "recording.statistics().frame === 7 && !recording.statistics().playing")
    last = middle_of(stage(page), RED, 60)
    assert last[0] > first[0] + 100 and abs(last[1] - first[1]) < 4
    assert count_pixels(stage(page), BLUE, 60) < 0.4 * blue  # the red cloud lies over it
    page.click("#play")
    wait_for(page, "recording.statistics().playing && recording.statistics().frame > 0")
    page.click("#play")
    assert not statistics(page)["playing"]


def test_frames_send_nothing_again(open_recording):
    page = open_recording(two_clouds())
    before = statistics(page)
    for _ in range(2):
        for frame in range(8):
            page.evaluate("frame => recording.go(frame)", frame)
    after = statistics(page)
    assert (after["uploads"], after["bytes"]) == (before["uploads"], before["bytes"]) == (2, 2 * 3600 * 18)


def test_the_slider_is_moved_by_keys(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    before = stage(page)
    page.focus("#slider")
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    wait_for(page, "recording.statistics().frame === 3")
    assert page.input_value("#slider") == "3"
    assert page.get_attribute("#slider", "aria-valuetext") == "4 of 8 iteration 3"
    assert middle_of(stage(page), RED, 60)[0] > middle_of(before, RED, 60)[0] + 20
    page.keyboard.press("Tab")
    page.evaluate("document.activeElement.blur()")
    for key, frame in (("End", 7), ("ArrowLeft", 6), ("Home", 0), ("ArrowRight", 1)):
        page.keyboard.press(key)
        wait_for(page, f"recording.statistics().frame === {frame}")


def mark_of(page, number: int) -> float:
    """The column of the middle of the mark in a plot, by its colour."""
    image = picture(page, panels=True)
    box = page.locator("#plots canvas").nth(number).bounding_box()
    x, y = math.ceil(box["x"]), math.ceil(box["y"])
    part = image[y : y + int(box["height"]) - 1, x : x + int(box["width"]) - 1]
    columns = np.nonzero(is_color(part, (200, 55, 27), 30).sum(axis=0) > 20)[0]
    assert len(columns) > 0
    return float(columns.mean())


def test_plots_mark_the_frame_and_a_click_goes_to_one(open_recording):
    page = open_recording(two_clouds())
    assert page.locator("#plots span").all_text_contents() == ["fitness", "inlier_rmse"]
    assert page.locator("#plots output").all_text_contents() == ["0", "0.1"]
    first = mark_of(page, 0)
    page.keyboard.press("End")
    wait_for(page, "recording.statistics().frame === 7")
    assert mark_of(page, 0) > first + 200 and mark_of(page, 1) > first + 200
    box = page.locator("#plots canvas").first.bounding_box()
    page.mouse.click(box["x"] + 6 + (box["width"] - 12) * 6 / 7, box["y"] + 50)
    wait_for(page, "recording.statistics().frame === 6")
    assert abs(mark_of(page, 1) - (6 + (box["width"] - 12) * 6 / 7)) < 2


@pytest.mark.parametrize(
    ("size", "origin"),
    [((640, 480), (0, 0, 0)), ((1000, 700), (456_789.25, 5_345_678.5, 512.0)), ((400, 600), (0, 0, 0))],
)
def test_points_are_seen_where_the_view_projects_them(open_recording, size, origin):
    rng = np.random.default_rng(3)
    places = rng.uniform(-1, 1, (3, 3)).astype(np.float32)
    colors = np.uint8([RED, BLUE, GREEN])
    view = fit_view(np.vstack([places, -places]) + np.array(origin), width=640, height=480)
    timeline = Timeline(
        np.array(origin, float), [Shape("points", places, colors, size=9.0)], [Frame({"dots": Placed((0,))})]
    )
    image = stage(open_recording(timeline, width=size[0], height=size[1], view=view))
    scale = min(size[0] / 640, size[1] / 480)
    camera, T = view.intrinsic, view.T_world_camera
    for place, color in zip(places, (RED, BLUE, GREEN), strict=True):
        x, y, z = (place + np.array(origin) - T[:3, 3]) @ T[:3, :3]
        column = size[0] / 2 + scale * (camera.fx * x / z + camera.cx + 0.5 - 320)
        row = size[1] / 2 + scale * (camera.fy * y / z + camera.cy + 0.5 - 240)
        assert math.dist(middle_of(image, color, 90), (column, row)) < 1.5


def box_of_triangles() -> Shape:
    low, high = np.array([-1, -1, -0.5]), np.array([1, 1, 0.5])
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)], np.float32)
    faces = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4]]
    faces += [[2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
    return Shape("triangles", corners, indices=np.int32(faces), plain=(204, 199, 189))


def ball_of_points(rng) -> Shape:
    places = rng.normal(size=(20_000, 3))
    places /= np.linalg.norm(places, axis=1, keepdims=True)
    return Shape("points", places.astype(np.float32), None, places.astype(np.float32), size=8.0, plain=(89, 128, 158))


def near_outlines(image: np.ndarray, contrast=12) -> np.ndarray:
    """Pixels in whose square of 3 x 3 the picture is not even."""
    squares = np.lib.stride_tricks.sliding_window_view(np.pad(image, ((1, 1), (1, 1), (0, 0)), "edge"), (3, 3), (0, 1))
    return (squares.max(axis=(-2, -1)).astype(int) - squares.min(axis=(-2, -1)) > contrast).any(axis=-1)


@pytest.mark.parametrize("kind", ["mesh", "cloud"])
def test_a_page_looks_as_our_pictures_do(open_recording, rng, kind):
    shape = box_of_triangles() if kind == "mesh" else ball_of_points(rng)
    view = fit_view(shape.positions, width=640, height=480)
    if kind == "mesh":
        geometry = loom.TriangleMesh(shape.positions, shape.indices)
    else:
        geometry = loom.PointCloud(shape.positions, normals=shape.normals)
    style = {"geometry": geometry, "color": tuple(value / 255 for value in shape.plain)}
    expected = loom.render(style, view, point_size=8.0, device="cpu")
    page = open_recording(one_frame(shape), width=640, height=480, view=view)
    away = np.abs(stage(page).astype(int) - expected).max(axis=-1)
    inside = ~near_outlines(expected) & (expected < 255).any(axis=-1)
    assert inside.mean() > 0.1
    assert (away[inside] > 12).mean() < 0.001
    assert (away > 12).mean() < 0.04  # outlines: our pictures have four samples a pixel


def test_mouse_and_keys_move_the_camera_and_r_brings_it_back(open_recording):
    page = open_recording(two_clouds(2))
    project = "recording.project([0.5, 0.2, 0])"
    first, seen = page.evaluate(project), stage(page)

    def drag(dx, dy, button="left", shift=False):
        if shift:
            page.keyboard.down("Shift")
        page.mouse.move(300, 400)
        page.mouse.down(button=button)
        page.mouse.move(300 + dx, 400 + dy, steps=4)
        page.mouse.up(button=button)
        if shift:
            page.keyboard.up("Shift")

    def reset():
        page.keyboard.press("r")
        np.testing.assert_allclose(page.evaluate(project), first)

    drag(80, 30)
    turned = page.evaluate(project)
    assert math.dist(turned[:2], first[:2]) > 5
    assert (stage(page) != seen).any(axis=-1).mean() > 0.02
    reset()
    for options in ({"button": "right"}, {"shift": True}):
        drag(50, -20, **options)
        x, y, _ = page.evaluate(project)
        assert x - first[0] > 30 and y - first[1] < -10
        reset()
    at = page.evaluate(project)
    page.mouse.move(at[0], at[1])
    page.mouse.wheel(0, -400)
    wait_for(page, f"recording.project([0.5, 0.2, 0])[2] < 0.9 * {first[2]}")
    nearer = page.evaluate(project)
    assert math.dist(nearer[:2], at[:2]) < 40  # what is under the pointer stays about there
    reset()
    page.keyboard.press("Shift+ArrowRight")
    assert math.dist(page.evaluate(project)[:2], first[:2]) > 2
    reset()
    np.testing.assert_array_equal(stage(page), seen)


def test_a_double_click_makes_what_is_there_the_middle_of_turning(open_recording):
    page = open_recording(two_clouds(2), view=from_above())
    place = "[-2.5, 0.4, 0]"
    x, y, depth = page.evaluate(f"recording.project({place})")
    page.mouse.dblclick(x, y)
    wait_for(page, SETTLED)
    box = page.locator("#scene").bounding_box()
    middle = (box["width"] / 2, box["height"] / 2)
    centered = page.evaluate(f"recording.project({place})")
    assert math.dist(centered[:2], middle) < 4 and abs(centered[2] - depth) < 0.01
    page.mouse.move(300, 400)
    page.mouse.down()
    page.mouse.move(360, 380)
    page.mouse.up()
    turned = page.evaluate(f"recording.project({place})")
    assert math.dist(turned[:2], middle) < 4 and abs(turned[2] - depth) < 0.05


def test_keys_change_sizes_normals_edges_and_light(open_recording):
    square = np.float32([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    faces = np.int32([[0, 1, 2], [0, 2, 3]])
    dots = grid(12) + np.float32([3, 0, 0])
    tilted = np.tile(np.float32([0.6, 0, 0.8]), (len(dots), 1))
    shapes = [
        Shape("triangles", square, indices=faces, plain=GREEN),
        Shape("points", dots, None, tilted, size=5.0, plain=RED),
    ]
    page = open_recording(
        Timeline(np.zeros(3), shapes, [Frame({"mesh": Placed((0,)), "dots": Placed((1,))})]), view=from_above()
    )
    first = stage(page)
    large = [is_reddish(first).sum()]
    for key in ("+", "+", "-", "-", "-"):
        page.keyboard.press(key)
        large.append(is_reddish(stage(page)).sum())
    assert large[0] < large[1] < large[2] > large[3] > large[5] and large[4] == large[0]
    page.keyboard.press("=")
    dark = (first.max(axis=-1) < 40).sum()
    page.keyboard.press("w")
    page.wait_for_timeout(100)
    assert (stage(page).max(axis=-1) < 40).sum() > dark + 300
    page.keyboard.press("w")
    page.wait_for_timeout(100)
    np.testing.assert_array_equal(stage(page), first)
    page.keyboard.press("n")
    colored = stage(page)
    assert count_pixels(colored, (128, 128, 255), 6) > 5000  # the square looks up
    assert count_pixels(colored, (204, 128, 230), 6) > 1000
    page.keyboard.press("n")
    page.keyboard.press("l")
    page.keyboard.press("l")
    assert count_pixels(stage(page), GREEN, 2) > 5000  # no light: the colour as it is
    assert count_pixels(first, GREEN, 2) < 500


def test_a_name_that_is_unticked_is_not_drawn(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    page.uncheck("#items li:first-child input")
    image = stage(page)
    assert count_pixels(image, RED, 60) < 30 and count_pixels(image, BLUE, 60) > 5000
    assert page.text_content("#count") == "3,600 points drawn"
    page.check("#items li:first-child input")
    assert count_pixels(stage(page), RED, 60) > 5000


def test_lines_are_as_wide_as_asked_and_end_behind_the_camera(open_recording):
    ends = np.float32([[-1, 0, 0], [1, 0, 0], [0, -1, 0], [2, -1, 40], [-2, -1, 40]])
    lines = Shape("lines", ends, np.uint8([RED, BLUE, GREEN]), indices=np.int32([[0, 1], [2, 3], [4, 2]]), size=6.0)
    timeline = one_frame(lines)
    image = stage(open_recording(timeline, width=640, height=480, view=from_above()))
    assert abs(is_color(image, RED)[:, 300].sum() - 6) <= 1
    assert abs(is_color(image, RED)[240].sum() - 120 - 6) <= 3
    for color, slope in ((BLUE, 0.5), (GREEN, -0.5)):  # one that begins before the camera, one that ends there
        seen = is_color(image, color)
        rows = np.nonzero(seen.any(axis=1))[0]
        assert rows.min() > 290 and rows.max() == 479  # it runs out of the picture below, and never back in
        middles = [np.nonzero(seen[row])[0].mean() for row in range(320, 480, 10)]
        np.testing.assert_allclose(middles, 319.5 + slope * (np.arange(320, 480, 10) - 299.5), atol=1)
        assert all(abs(seen[row].sum() - 6 * math.sqrt(1.25)) < 2 for row in range(320, 480, 10))


def test_hostile_names_are_shown_as_text(open_recording):
    cloud = Shape("points", grid(5))
    frames = [Frame({HOSTILE: Placed((0,))}, HOSTILE, {HOSTILE: float(k)}) for k in range(2)]
    page = open_recording(Timeline(np.zeros(3), [cloud], frames, title=HOSTILE))
    assert page.title().startswith("</script >")
    assert page.text_content("#items label") == page.text_content("#label") == page.text_content("h1") == HOSTILE
    assert page.text_content("#plots span") == HOSTILE
    assert page.locator("img").count() == page.locator("b").count() == 0


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
    page.wait_for_timeout(200)
    assert page.title() == "two squares"
    assert page.evaluate("fetch('data:,x').then(() => 'fetched', () => 'refused')") == "refused"
    assert any("Content Security Policy" in fault for fault in page.visit.faults)


def test_one_frame_fills_the_window_and_needs_no_bar(open_recording):
    timeline = Timeline(
        np.zeros(3), [Shape("points", grid(1), size=12.0, plain=RED)], [Frame({"dot": Placed((0,))}, "one dot")]
    )
    page = open_recording(timeline, width=640, height=480)
    assert page.locator("#scene").bounding_box() == {"x": 0, "y": 0, "width": 640, "height": 480}
    assert not page.is_visible("#bar") and not page.is_visible("#plots")
    assert math.dist(middle_of(stage(page), RED, 60), (320, 240)) < 2
    assert abs(count_pixels(stage(page), RED, 60) - math.pi * 36) < 25
    assert page.text_content("#label") == "one dot" and page.text_content("#count") == "1 point drawn"


def test_a_recording_of_nothing_says_so(open_recording):
    page = open_recording(Timeline(np.zeros(3), title="nothing"))
    assert "Nothing was recorded" in page.text_content("#message")
    assert page.is_visible("#message")


def test_backgrounds_are_dark_or_light(open_recording):
    page = open_recording(two_clouds(), background=(0.1, 0.1, 0.15))
    assert page.get_attribute("html", "data-theme") == "dark"
    assert count_pixels(stage(page), (26, 26, 38), 1) > 200_000


def test_where_no_webgl_is_the_page_says_what_to_do(open_page, tmp_path):
    write_page(tmp_path / "p.html", two_clouds())
    page = open_page("about:blank", faults=False)
    page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null")
    page.goto((tmp_path / "p.html").as_uri())
    wait_for(page, "document.getElementById('message').textContent.includes('WebGL 2')")
    assert page.visit.faults == []


def test_a_card_that_forgets_everything_is_filled_again(open_recording):
    page = open_recording(two_clouds(), view=from_above())
    before = stage(page)
    page.evaluate(
        """async () => {
            const loss = document.getElementById("scene").getContext("webgl2").getExtension("WEBGL_lose_context");
            loss.loseContext();
            await new Promise((resolve) => setTimeout(resolve, 100));
            loss.restoreContext();
            await new Promise((resolve) => setTimeout(resolve, 300));
        }"""
    )
    np.testing.assert_array_equal(stage(page), before)


def test_huge_and_tiny_scenes_are_drawn(open_recording):
    for scale in (1e-7, 1e7):
        shape = Shape("points", grid(40) * np.float32(scale), size=5.0, plain=RED)
        image = stage(open_recording(one_frame(shape)))
        assert is_reddish(image).mean() > 0.01


def test_many_points_move_thinned_and_are_drawn_whole_at_rest(open_recording):
    rng = np.random.default_rng(0)
    shapes = [Shape("points", rng.normal(size=(150_000, 3)).astype(np.float32), plain=color) for color in (RED, BLUE)]
    frames = [Frame({"a": Placed((0,), moved(6 - 0.03 * k)), "b": Placed((1,))}) for k in range(200)]
    page = open_recording(Timeline(np.zeros(3), shapes, frames, fps=10))
    page.keyboard.press("Space")
    wait_for(page, "recording.statistics().frame >= 6")
    page.keyboard.press("Space")
    wait_for(page, SETTLED)
    assert statistics(page)["every"] == 1 and statistics(page)["uploads"] == 2
    image = stage(page)
    assert is_reddish(image).sum() > 5000 and is_color(image, BLUE, 130).sum() > 5000


@pytest.fixture
def changed_player(monkeypatch):
    """Change the text of the player before the page is written."""
    plain = page_module._source

    def change(old: str, new: str) -> None:
        assert any(old in plain(f"{name}.js") for name in page_module.SCRIPTS)
        monkeypatch.setattr(page_module, "_source", lambda name: plain(name).replace(old, new))

    return change


def test_shapes_of_frames_long_gone_are_freed_and_come_back(open_recording, changed_player):
    changed_player("const MEMORY_BUDGET = 2 ** 30", "const MEMORY_BUDGET = 150_000")
    shapes = [Shape("points", grid() + np.float32([k, 0, 0]), size=4.0, plain=RED) for k in range(8)]  # 43,200 B each
    frames = [Frame({"cloud": Placed((k,))}) for k in range(8)]
    page = open_recording(Timeline(np.zeros(3), shapes, frames), view=from_above(20.0))
    first = stage(page)
    for frame in [*range(8), 0]:
        page.evaluate("frame => recording.go(frame)", frame)
        assert statistics(page)["bytes"] <= 150_000
    assert statistics(page)["uploads"] == 9
    np.testing.assert_array_equal(stage(page), first)
    page.keyboard.press("Space")
    wait_for(page, "recording.statistics().frame === 5")


def test_smoothed_outlines_change_nothing_else(open_recording, changed_player):
    """As a graphics card draws them; software is spared the samples."""
    timeline = one_frame(box_of_triangles(), Shape("points", grid(8) + np.float32([0, 0, 1]), size=9.0, plain=RED))
    plain = stage(open_recording(timeline, width=640, height=480))
    changed_player("isSoftware(gl) ? 0 : ", "")
    page = open_recording(timeline, width=640, height=480)
    smooth = stage(page)
    away = np.abs(plain.astype(int) - smooth).max(axis=-1) > 12
    assert away.sum() > 50 and away[~near_outlines(plain)].mean() < 0.001
    assert len(np.unique(smooth.reshape(-1, 3), axis=0)) > len(np.unique(plain.reshape(-1, 3), axis=0))
    x, y, _ = page.evaluate("recording.project([0, 0, 0.5])")
    page.mouse.dblclick(x, y)  # depths are read from where the samples were averaged
    assert math.dist(page.evaluate("recording.project([0, 0, 0.5])")[:2], (320, 240)) < 4


def test_shapes_without_anything_in_them_are_no_error(open_recording):
    nothing = np.empty((0, 3), np.float32)
    shapes = [
        Shape("points", nothing, np.empty((0, 3), np.uint8), nothing),
        Shape("lines", nothing, indices=np.empty((0, 2), np.int32)),
        Shape("triangles", nothing, indices=np.empty((0, 3), np.int32), wireframe=True),
    ]
    page = open_recording(one_frame(*shapes))
    assert (stage(page) == 255).all() and not page.is_visible("#count")
