"""The live page in Chromium, driven by a small program: drawing, events of controls, and the connection."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from playwright.sync_api import expect

from .live_pages import Program, control
from .pixels import count_pixels, picture, ready, see, wait_for_messages, wait_until

RED, BLUE, WHITE = (255, 0, 0), (0, 0, 255), (255, 255, 255)
EVIL = "<script>document.title = 'evil'</script><img src=x onerror=alert(1)>"


def test_a_batch_is_drawn_completely_and_then_acknowledged(program, visit):
    page = visit()
    signed: list[Any] = []
    (client,) = program.pages.get_clients().values()
    client.on_sign(signed.append)
    with program.pages.atomic():
        first = program.add_square(RED)
    see(page, lambda image: count_pixels(image, RED) > 20_000)
    with program.pages.atomic():
        first.remove()
        program.add_square(BLUE)
        client.request_signal()
    wait_until(page, lambda: signed, lambda: "no sign")
    image = picture(page)
    assert count_pixels(image, BLUE) > 20_000
    assert count_pixels(image, RED) == 0


def test_each_control_reports_its_new_value(program, visit, tmp_path):
    gui, hear = program.pages.gui, program.hear
    check = hear(gui.add_checkbox("check", False))
    hear(gui.add_slider("slide", 0.0, 1.0, 0.1, 0.3))
    number = hear(gui.add_number("number", 2.5, step=0.5, min=0.0, max=9.0))
    text = hear(gui.add_text("text", "before"))
    choice = hear(gui.add_dropdown("choice", ("one", "two")))
    color = hear(gui.add_rgb("color", (1, 2, 3)))
    hear(gui.add_range("span", 0.0, 10.0, 1.0, (2.0, 8.0)))
    button = hear(gui.add_button("press"))
    upload = hear(gui.add_upload_button("bring", accept=""))
    time = hear(gui.add_timeline(0.0, 9.0, 1.0, 3.0))
    page = visit()

    control(page, check).get_by_role("checkbox").check()
    program.wait_for(page, "checkbox", True)
    page.get_by_role("slider", name="slide").press("ArrowRight")
    program.wait_for(page, "slider", 0.4)
    page.get_by_role("spinbutton", name="slide, as a number").fill("0.85")
    page.keyboard.press("Enter")
    program.wait_for(page, "slider", 0.85)  # exactly, though no step is there
    control(page, number).locator("input").fill("77")
    page.keyboard.press("Tab")
    program.wait_for(page, "number", 9.0)
    control(page, number).locator("input").press("ArrowDown")
    program.wait_for(page, "number", 8.5)
    control(page, text).locator("input").fill("after")
    program.wait_for(page, "text", "after")
    control(page, choice).locator("select").select_option("two")
    program.wait_for(page, "dropdown", "two")
    control(page, color).locator("input").fill("#ff8000")
    program.wait_for(page, "rgb", (255, 128, 0))
    low, high = (page.get_by_role("slider", name=f"span, {end}") for end in ("low", "high"))
    low.press("ArrowRight")
    program.wait_for(page, "range", (3.0, 8.0))
    high.press("Home")
    program.wait_for(page, "range", (3.0, 3.0))  # the ends do not pass each other
    control(page, button).get_by_role("button").click()
    program.wait_for(page, "button", None)
    (tmp_path / "view.json").write_text('{"a": "ä"}', encoding="utf-8")
    control(page, upload).locator("input").set_input_files(tmp_path / "view.json")
    wait_until(page, lambda: program.last("upload"), lambda: program.events)
    assert (program.last("upload").name, program.last("upload").text) == ("view.json", '{"a": "ä"}')
    page.locator("#scene").press("ArrowRight")
    program.wait_for(page, "timeline", 4.0)
    assert control(page, time).locator("output").inner_text() == "4 / 9"
    page.locator("#scene").press("Space")
    wait_until(page, lambda: program.last("timeline") > 5, lambda: program.events[-3:])
    assert dict(program.events).keys() >= {"button"}


def test_values_set_by_the_program_are_shown_as_text_in_order(program, visit):
    gui = program.pages.gui
    with gui.add_folder(EVIL, order=2):
        words = gui.add_words(f"two\nlines {EVIL}")
        gui.add_table([(EVIL, "1.5 m")])
    with gui.add_folder("first", order=1):
        check = gui.add_checkbox(EVIL, False)
        button = gui.add_button("a button", hint=EVIL)
    page = visit()
    expect(page.locator("summary")).to_have_text(["first", EVIL])
    check.value, button.disabled, words.value = True, True, "three"
    expect(control(page, check).get_by_label(EVIL)).to_be_checked()
    expect(control(page, button).get_by_role("button")).to_be_disabled()
    expect(control(page, words)).to_have_text("three")
    check.visible = False
    expect(control(page, check)).to_be_hidden()
    program.pages.get_clients()[0].notify(EVIL, EVIL, seconds=60)
    expect(page.locator(".notice strong")).to_have_text(EVIL)
    page.keyboard.press("Control+k")
    assert page.locator("script").count() == 1
    assert page.locator("img").count() == 0
    assert page.title() == "a title"


def test_ten_thousand_rows_have_the_elements_of_those_in_sight(program, visit):
    changes: list[tuple[tuple[str, ...], bool]] = []
    tree = program.pages.gui.add_tree()
    tree.on_update(lambda event: changes.append(event.value))
    labels = {f"k{k}": f"tiles/{k // 100:02d}/box {k}" for k in range(10_000)}
    with program.pages.atomic():
        for key, label in labels.items():
            tree.put(key, label, True)
    page = visit(height=900)
    count_keys = lambda: sum(len(keys) for keys, _ in changes)  # noqa: E731
    filtered = {key for key, label in labels.items() if "box" in label and "99" in label}

    def wait_for(count: int) -> None:
        wait_until(page, lambda: count_keys() == count, count_keys)
        changes.clear()

    expect(page.locator(".tree .count")).to_have_text("10,000 of 10,000 shown")
    assert page.locator(".tree-row").count() < 60
    page.get_by_role("treeitem", name="07", exact=True).locator(".tick").click()
    wait_for(100)
    assert {key for key, is_shown in tree.value.items() if not is_shown} == {f"k{k}" for k in range(700, 800)}
    page.get_by_placeholder("Filter").fill("99 box")
    expect(page.locator(".tree .count")).to_contain_text(f"{len(filtered)} of 10,000 names")
    page.get_by_role("button", name="None", exact=True).click()
    wait_for(len(filtered) - 1)  # k799 was hidden already
    assert not any(tree.value[key] for key in filtered)
    page.get_by_placeholder("Filter").fill("")
    page.get_by_role("button", name="All", exact=True).click()
    wait_for(100 + len(filtered) - 1)
    page.get_by_role("tree").press("Space")  # on the root group: more keys than one message may contain
    wait_until(page, lambda: count_keys() == 10_000, count_keys)
    assert len(changes) > 1
    assert not any(tree.value.values())


def test_the_palette_finds_each_command_once_with_all_its_keys(program, visit):
    for key in ("plus", "=", "pageup"):
        command = program.pages.gui.add_command("Larger points", key)
        command.on_trigger(lambda _: program.events.append(("command", "+")))
    program.hear(program.pages.gui.add_button("Measure (M)"))
    page = visit()
    page.keyboard.press("Control+k")
    offered = page.locator("#palette li .label")
    for label in ("Larger points", "Measure", "Keys and commands"):  # those added while it is open are offered as well
        expect(offered.get_by_text(label, exact=True)).to_have_count(1)
    labels = offered.all_inner_texts()
    assert len({label.lower() for label in labels}) == len(labels)
    row = page.locator("#palette li", has_text="Larger points")
    assert row.locator("kbd").all_inner_texts() == ["+", "=", "Page up"]
    page.keyboard.type("measure")
    expect(page.get_by_role("option")).to_have_count(1)
    page.keyboard.press("Enter")
    program.wait_for(page, "button", None)
    expect(page.locator("#palette")).to_be_hidden()
    page.keyboard.press("Control+k")
    page.keyboard.type("larger")
    page.keyboard.press("Enter")
    program.wait_for(page, "command", "+")
    assert program.events == [("button", None), ("command", "+")]


def test_the_open_palette_follows_the_program_and_keeps_what_was_chosen(program, visit):
    page = visit()
    page.keyboard.press("Control+k")
    page.keyboard.press("ArrowDown")
    chosen = page.locator("#palette li[aria-selected=true] .label").inner_text()
    button = program.hear(program.pages.gui.add_button("Come lately"))
    expect(page.locator("#palette li .label").get_by_text("Come lately", exact=True)).to_have_count(1)
    expect(page.locator("#palette li[aria-selected=true] .label")).to_have_text(chosen)
    button.remove()
    expect(page.locator("#palette li .label").get_by_text("Come lately", exact=True)).to_have_count(0)


def test_keys_are_the_programs_first_and_none_while_one_types(program, visit):
    command = program.pages.gui.add_command("Our own", "H")
    command.on_trigger(lambda event: program.events.append(("command", event.client_id)))
    text = program.pages.gui.add_text("text", "")
    page = visit()
    page.keyboard.press("h")
    program.wait_for(page, "command", 0)
    control(page, text).locator("input").press("h")
    page.keyboard.press("Escape")
    page.keyboard.press("?")
    help_ = page.locator("#help")
    expect(help_).to_be_visible()
    expect(help_).to_have_attribute("aria-labelledby", "help-title")
    assert [kbd for kbd in help_.locator("dt", has_text="H").all_inner_texts() if kbd == "H"] == ["H"]
    page.keyboard.press("Escape")
    expect(help_).to_be_hidden()
    command.remove()
    expect(control(page, program.pages.gui.add_words("it has gone"))).to_be_visible()
    page.keyboard.press("h")
    expect(help_).to_be_visible()
    assert program.events == [("command", 0)]


def test_a_connection_gap_preserves_the_scene_and_camera(program, visit):
    program.add_square(RED)
    with program.pages.gui.add_folder("folder", open=False):
        program.pages.gui.add_words("within")
    page = visit(faults=False)
    first = count_pixels(see(page, lambda image: count_pixels(image, RED) > 20_000), RED)
    page.mouse.move(200, 300)
    page.mouse.wheel(0, 400)
    page.locator("summary").click()
    smaller = see(page, lambda image: 1000 < count_pixels(image, RED) < 0.5 * first)
    expected = count_pixels(smaller, RED)
    program.pages.stop()
    expect(page.get_by_text("Connection lost; trying again")).to_be_visible()
    assert 0.9 < count_pixels(picture(page), RED) / expected < 1.1
    again = Program(program.port)
    try:
        again.add_square(RED)
        again.add_square(BLUE).set_transform(np.eye(3), (5, 0, 0))
        with again.pages.gui.add_folder("folder", open=False):
            again.pages.gui.add_words("another")
        expect(page.get_by_text("another")).to_be_visible()  # the opened folder is still open
        expect(page.locator("#state")).to_be_hidden()
        assert 0.9 < count_pixels(picture(page), RED) / expected < 1.1
        (client,) = again.pages.get_clients().values()
        wait_until(page, lambda: client.camera.position[2] > 4, lambda: client.camera.position)
    finally:
        again.pages.stop()


def test_an_end_message_explains_how_to_start_again(program, visit):
    page = visit(faults=False)
    program.pages.end("Start it again: pointloom view scan.ply")
    with page.expect_event("websocket"):  # the message remains during an attempt to connect
        program.pages.stop()
        expect(page.get_by_text("The program has ended.")).to_be_visible()
        expect(page.get_by_text("pointloom view scan.ply")).to_be_visible()
    expect(page.get_by_text("pointloom view scan.ply")).to_be_visible()


def test_a_program_that_does_not_answer_for_long_has_ended(program, visit):
    page = visit(faults=False)
    page.clock.install()
    program.pages.stop()
    expect(page.get_by_text("Connection lost; trying again")).to_be_visible()
    ended = page.get_by_text("The program has ended.")  # an attempt takes real time, independent of the page's clock
    wait_for_messages(page, lambda: page.clock.run_for(4_000) or ended.is_visible())
    expect(page.get_by_text("Start it again")).to_be_visible()


def test_a_network_that_comes_back_is_taken_at_once(program, visit):
    page = visit()
    (first,) = program.pages.get_clients().values()
    page.evaluate("window.dispatchEvent(new Event('online'))")
    wait_until(page, lambda: not first.is_open, lambda: "still open")
    ready(page)
    assert len(program.pages.get_clients()) == 1


def test_an_outdated_page_shows_a_reload_message(program, visit, monkeypatch):
    page = visit()
    monkeypatch.setattr("pointloom.visualization.viewer.link.hub.PROTOCOL", "pointloom.2")
    program.pages.disconnect_all()
    expect(page.get_by_role("button", name="Reload")).to_be_visible()
    monkeypatch.undo()
    with page.expect_event("load"):
        page.get_by_role("button", name="Reload").click()
    ready(page)


def test_clicks_are_reported_on_request_with_the_camera(program, visit):
    program.add_square(RED)
    page = visit()
    clicks: list[Any] = []
    box = page.locator("#picture").bounding_box()
    position = (box["x"] + 0.25 * box["width"], box["y"] + 0.75 * box["height"])
    page.mouse.click(*position)
    program.pages.scene.on_click(clicks.append)
    ready(page)
    page.mouse.click(*position)
    wait_until(page, lambda: clicks, lambda: "no click")
    (click,) = clicks
    assert (click.x, click.y) == pytest.approx((0.25, 0.75), abs=0.01)
    assert click.camera.size == (round(box["width"]), round(box["height"]))
