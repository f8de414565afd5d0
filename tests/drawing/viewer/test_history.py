"""Changes of a page are taken back and done again."""

from pointloom.drawing.viewer import history as module
from pointloom.drawing.viewer.history import Change, History


class Page:
    def __init__(self):
        self.now, self.value = 0.0, 0
        self.history = History(clock=lambda: self.now)

    def put(self, value):
        self.value = value

    def change(self, value, key=None, nbytes=0):
        before, self.value = self.value, value
        undo, redo = (lambda: self.put(before)), (lambda: self.put(value))
        self.history.add(Change(f"Set {value}", undo, redo, key, nbytes))


def test_changes_are_taken_back_in_their_order_and_done_again():
    page = Page()
    for value in (1, 2, 3):
        page.change(value)
    assert [page.history.undo() for _ in range(2)] == ["Taken back: Set 3", "Taken back: Set 2"] and page.value == 1
    assert page.history.redo() == "Done again: Set 2" and page.value == 2
    page.change(7)
    assert page.history.redo() == "There is nothing to do again." and page.history.labels()[0] == [
        "Set 1",
        "Set 2",
        "Set 7",
    ]
    for _ in range(3):
        page.history.undo()
    assert page.value == 0 and page.history.undo() == "There is nothing to take back."


def test_a_slider_that_is_dragged_is_one_change():
    page = Page()
    for value in range(1, 6):
        page.now += 0.3
        page.change(value, key="size")
    page.now += 5
    page.change(9, key="size")
    page.history.undo()
    assert page.value == 5
    page.history.undo()
    assert page.value == 0
    page.history.redo()
    assert page.value == 5


def test_what_a_change_does_while_it_is_taken_back_is_no_change():
    page = Page()
    page.history.add(Change("Twice", lambda: page.change(4), lambda: page.change(5)))
    page.history.undo()
    assert page.value == 4 and page.history.labels() == ([], ["Twice"])


def test_a_change_of_what_has_gone_says_so():
    page = Page()

    def fails():
        raise ValueError("scan is no longer in the scene")

    page.history.add(Change("Hide scan", fails, fails))
    assert page.history.undo() == "Cannot be taken back: Hide scan: scan is no longer in the scene"
    assert page.history.labels() == ([], [])


def test_a_history_is_bounded_by_number_and_memory():
    page = Page()
    for value in range(module.MOST + 10):
        page.change(value)
    assert len(page.history.labels()[0]) == module.MOST
    for _ in range(module.MOST):
        page.history.undo()
    assert "the 10 before are no longer kept" in page.history.undo()
    for value in range(4):
        page.change(value, nbytes=module.MOST_BYTES // 2)
    assert len(page.history.labels()[0]) == 2
