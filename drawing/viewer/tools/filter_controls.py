"""The controls that hide points by what is known of them, in one page: `FilterControls`."""

from __future__ import annotations

import dataclasses
import math
import threading
from collections.abc import Callable
from typing import Any

import numpy as np

from ....core.units import symbol_of
from ...render.colormaps import ENTRIES, colormap_table
from ..history import Change
from .filters import CLASSES, TIMES, Census, Filter, column_in_world, filters_of, take_census
from .stage import Stage

NOTHING = "nothing"
TICK = 0.2  # [s] between the steps of a window that plays
STEPS = 100  # of a window that plays from end to end


class FilterControls:
    """A histogram with a range, classes to tick, a window of time; what they leave out is hidden in this page alone.

    Args:
        stage: The page.
        folder: Of the panel, in which they are.
        apply: Has the scene show what `stage.filters` leaves.
    """

    def __init__(self, stage: Stage, folder: Any, apply: Callable[[], None]):
        self._stage, self._apply = stage, apply
        self._rules: dict[str, Filter] = {}
        self._census: Census | None = None
        self._controls: list[Any] = []
        self._ticks: dict[int, Any] = {}
        self._timer: threading.Timer | None = None
        self._is_closed = False
        gui, ask = stage.client.gui, stage.ask
        with folder:
            self.folder = gui.add_folder("Filter", open=False)
        with self.folder:
            self._by = gui.add_dropdown("filter by", (NOTHING,))
            self._own = gui.add_folder(None)
            self._told = gui.add_table([])
            self._clear = gui.add_button("Remove all filters", disabled=True)
        self._by.on_update(lambda _: ask(self._choose))
        self._clear.on_click(lambda _: ask(lambda: self._set({}, "Remove all filters")))
        self.sync()

    def sync(self) -> None:
        """After the scene has changed: offer what its clouds have."""
        names: list[str] = []
        for item in self._stage.items():
            names += [name for name in filters_of(item.cloud) if name not in names] if item.cloud is not None else []
        options = (NOTHING, *names)
        if tuple(self._by.options) != options:
            chosen = self._by.value
            self._by.options = options
            self._by.value = chosen if chosen in options else NOTHING
            if self._by.value != chosen:
                self._choose()

    def close(self) -> None:
        """The page has gone."""
        self._is_closed = True
        self._stop_playing()

    # -- the one that is looked at ------------------------------------------------------------------------------------

    def _choose(self) -> None:
        """Count the values, and offer what fits them."""
        self._stop_playing()
        for control in self._controls:
            control.remove()
        self._controls, self._ticks, self._census = [], {}, None
        if self._by.value != NOTHING:
            self._census = self._count(self._by.value)
            with self._own:
                self._offer(self._census)

    def _count(self, by: str) -> Census:
        stage, columns = self._stage, []
        for item in stage.items():
            if item.cloud is not None and len(item.cloud):
                column = column_in_world(item.cloud, by, stage.pose_of(item))
                columns += [column] if column is not None else []
        return take_census(by, columns)

    def _offer(self, census: Census) -> None:
        rule = self._rules.get(census.by, Filter(census.by))
        add = self._offer_classes if census.kind == CLASSES else self._offer_range
        self._controls = add(census, rule)
        if census.missing:
            tick = self._stage.client.gui.add_checkbox(f"no value ({census.missing:,})", rule.missing)
            tick.on_update(lambda event: self._change(missing=bool(event.target.value)))
            self._controls.append(tick)

    def _offer_range(self, census: Census, rule: Filter) -> list[Any]:
        gui = self._stage.client.gui
        ends = _within(rule, census)
        unit = symbol_of(self._stage.unit(item.name for item in self._stage.items()))
        self._range = gui.add_histogram(
            census.by,
            census.counts.tolist(),
            (census.low, census.high),
            ends,
            unit=unit if census.by in ("x", "y", "height") else "",
            colors=self._colors(census.by, ends),
        )
        self._range.on_update(lambda _: self._stage.ask(self._take_range))
        if census.kind != TIMES:
            return [self._range]
        self._play = gui.add_checkbox("play", False, hint="moves the window on; its width is that of the range")
        self._play.on_update(lambda _: self._stage.ask(self._start_playing))
        return [self._range, self._play]

    def _offer_classes(self, census: Census, rule: Filter) -> list[Any]:
        gui, names = self._stage.client.gui, census.names()
        group = gui.add_button_group("classes", ("all", "none"))
        group.on_click(lambda event: self._stage.ask(lambda: self._tick_all(event.value == "all")))
        for number, count in census.classes.items():
            shown = rule.classes is None or number in rule.classes
            name = names[number] if names[number].endswith(f" {number}") else f"{number} {names[number]}"
            self._ticks[number] = tick = gui.add_checkbox(f"{name} ({count:,})", shown)
            tick.on_update(lambda _: self._stage.ask(self._take_classes))
        return [group, *self._ticks.values()]

    def _colors(self, by: str, ends: tuple[float, float]) -> Any:
        """The colours in the scene of values between two ends, uint8 [256, 3]; None where something else is shown."""
        if self._stage.viewer.coloring.by != by:
            return None
        for item in self._stage.items():
            coloring = item.coloring
            if coloring is not None and coloring.limits is not None and coloring.colormap is not None:
                low, high = coloring.limits
                values = np.linspace(*ends, ENTRIES)
                shares = np.clip((values - low) / (high - low), 0, 1) if high > low else np.zeros(ENTRIES)
                table = colormap_table(coloring.colormap)
                return np.rint(255 * table[np.rint(shares * (ENTRIES - 1)).astype(int)]).astype(np.uint8)
        return None

    # -- what is said -------------------------------------------------------------------------------------------------

    def _take_range(self) -> None:
        census = self._census
        if census is not None:
            low, high = self._range.value
            self._recolor()
            # a range at its end does not cut there: values beyond the bars are seen as well
            step = (census.high - census.low) * 1e-6
            self._change(
                low=-math.inf if low <= census.low + step else float(low),
                high=math.inf if high >= census.high - step else float(high),
            )

    def _recolor(self) -> None:
        """The bars' colours are told from one end of the range to the other."""
        if self._census is not None:
            self._range.colors = self._colors(self._census.by, self._range.value)

    def _take_classes(self) -> None:
        shown = frozenset(number for number, tick in self._ticks.items() if tick.value)
        self._change(classes=None if len(shown) == len(self._ticks) else shown)

    def _tick_all(self, shown: bool) -> None:
        for tick in self._ticks.values():
            tick.value = shown
        self._take_classes()

    def _change(self, **fields: Any) -> None:
        if self._census is not None:
            by = self._census.by
            rule = dataclasses.replace(self._rules.get(by, Filter(by)), **fields)
            rest = {name: other for name, other in self._rules.items() if name != by}
            key = f"filter {by}" if "low" in fields else None  # a range that is dragged is one change
            self._set({**rest, by: rule} if rule.cuts else rest, f"Filter by {by}", key)

    def _set(self, rules: dict[str, Filter], label: str, key: str | None = None) -> None:
        """Other rules from now on; the page's history can go back."""
        before = self._rules
        if rules == before:
            return
        self._show(rules)
        self._stage.history.add(Change(label, lambda: self._restore(before), lambda: self._restore(rules), key))

    def _show(self, rules: dict[str, Filter]) -> None:
        self._rules = rules
        self._stage.filters = tuple(rules.values())
        self._clear.disabled = not rules
        self._apply()
        self._told.value = [(name, rule.in_words()) for name, rule in rules.items()]

    def _restore(self, rules: dict[str, Filter]) -> None:
        """Rules as they were, and the controls with them."""
        self._show(rules)
        census = self._census
        if census is None:
            return
        rule = rules.get(census.by, Filter(census.by))
        if census.kind == CLASSES:
            for number, tick in self._ticks.items():
                tick.value = rule.classes is None or number in rule.classes
        else:
            self._range.value = _within(rule, census)
            self._recolor()

    # -- a window that plays ------------------------------------------------------------------------------------------

    def _start_playing(self) -> None:
        self._stop_playing()
        if self._play.value and self._census is not None:
            low, high = self._range.value
            if high - low >= 0.999 * (self._census.high - self._census.low):  # all of it: a tenth is a window
                self._range.value = self._census.low, self._census.low + (self._census.high - self._census.low) / 10
                self._take_range()
            self._wait()

    def _wait(self) -> None:
        self._timer = threading.Timer(TICK, lambda: self._stage.ask(self._step))
        self._timer.daemon = True
        self._timer.start()

    def _step(self) -> None:
        """Move the window on by a hundredth, and from the end back to the start."""
        census = self._census
        if self._timer is None or census is None or self._is_closed or not self._play.value:
            return
        low, high = self._range.value
        width = high - low
        low = low + (census.high - census.low) / STEPS
        low = census.low if low + width > census.high * (1 + 1e-12) + 1e-12 else low
        self._range.value = low, min(low + width, census.high)
        self._take_range()
        self._wait()

    def _stop_playing(self) -> None:
        timer, self._timer = self._timer, None
        if timer is not None:
            timer.cancel()


def _within(rule: Filter, census: Census) -> tuple[float, float]:
    """A rule's range as far as the bars reach."""
    low, high = (min(max(end, census.low), census.high) for end in (rule.low, rule.high))
    return low, high
