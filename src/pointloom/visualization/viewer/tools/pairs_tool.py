"""Tool that registers two clouds from picked point pairs."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ....cameras.pose_files import write_pose
from ....core.units import LengthUnit
from ....registration.rigid import invert_pose
from ...render.view import View
from .measuring import length_text
from .picking import Pick, Target, world_point
from .stage import Color, Tool, check_room

if TYPE_CHECKING:
    from .correspondences import PairRegistration

SOURCE_COLOR: Color = (230, 60, 20)
TARGET_COLOR: Color = (20, 110, 230)
SECONDS_A_POSE = 0.05  # [s] between displayed poses while ICP runs

Matrix = NDArray[np.float64]


class PairsTool(Tool):
    """Picks corresponding points alternately in source and target, and registers the clouds."""

    label = "Register by pairs"
    key = "J"
    hint = "Click a point of the source, then the same point in the target; after three pairs Enter registers."

    def __init__(self, stage: Any):
        super().__init__(stage)
        self._picks: list[Pick] = []  # source, target, source, ...
        self._registration: PairRegistration | None = None
        self._was: tuple[str, Matrix | None] | None = None
        self._shown = 0.0

    def start(self) -> None:
        names, gui, run = self.stage.clouds(), self.stage.client.gui, self.stage.run
        if len(names) < 2:
            raise ValueError(f"registration requires two clouds; the scene shows {len(names)}")
        self._source = gui.add_dropdown("source", names, names[0])
        self._target = gui.add_dropdown("target", names, names[1])
        self._alone = gui.add_checkbox("show one at a time", False)
        self._refine = gui.add_checkbox("refine by ICP", True)
        self._distance = gui.add_number(
            "distance, 0: automatic", 0.0, min=0.0, hint="in the clouds' unit, else in meters"
        )
        buttons = (
            ("Register (Enter)", self.finish),
            ("Back to the old pose", self.undo_pose),
            ("Save pairs and pose", self.save),
        )
        for label, action in buttons:
            gui.add_button(label).on_click(lambda _, action=action: run(action))
        for choice in (self._source, self._target):
            choice.on_update(lambda _: run(self._restart))
        self._alone.on_update(lambda _: run(self._show_due))

    def stop(self) -> None:
        self._show_only(None)

    def click(self, view: View, x: float, y: float) -> None:
        name = self._due()
        if self._source.value == self._target.value:
            raise ValueError("source and target are the same cloud: choose two")
        check_room(self._picks)
        pick = self.stage.pick(view, x, y, [name])
        if pick is None:
            self.stage.set_status(f"No point of {name} there. {self._next()}")
            return
        self._picks.append(pick)
        self._show(view)

    def undo(self) -> None:
        if self._picks:
            self._picks.pop()
            self._show(self.stage.view())

    def finish(self) -> None:
        stage, count = self.stage, len(self._picks) // 2
        from .correspondences import MIN_PAIRS, register_from_pairs  # imports the complete registration package

        if count < MIN_PAIRS:
            raise ValueError(f"at least three pairs are needed, there are {count}: pick {MIN_PAIRS - count} more")
        (source, moving), (target, fixed) = stage.cloud(self._source.value), stage.cloud(self._target.value)
        positions = self._pair_positions(moving, fixed)
        base = stage.pose_of(target)
        before = source.pose
        unit = stage.unit((self._source.value, self._target.value))
        stage.set_status("Registering…")
        registration = register_from_pairs(
            moving,
            fixed,
            *positions,
            refine=self._refine.value,
            max_correspondence_distance=self._distance.value or None,
            on_pose=lambda T: self._move(source, base, T),
        )
        self._shown = 0.0
        self._move(source, base, registration.transformation)
        if self._was is None or self._was[0] != source.name:
            self._was = source.name, before
        self._registration = registration
        self._show(stage.view())
        stage.show(_rows(registration, unit))
        messages = [f"{source.name} is registered to {target.name}."]
        stage.set_status(
            " ".join(messages + [f"{warning[0].upper()}{warning[1:]}." for warning in registration.warnings])
        )

    def refresh(self) -> None:
        names = tuple(self.stage.clouds())
        if len(names) > 1 and names != tuple(self._source.options):
            for choice in (self._source, self._target):
                chosen, choice.options = choice.value, names
                choice.value = chosen if chosen in names else names[0]

    def undo_pose(self) -> None:
        """Restore the pose before the first registration."""
        if self._was is not None:
            (name, pose), self._was, self._registration = self._was, None, None
            if name in self.stage.scene.shown:
                self.stage.edits.set_pose(name, np.eye(4) if pose is None else pose)
            self._show(self.stage.view())

    def save(self) -> None:
        """Download the pairs as JSON and the pose as 4 rows of numbers."""
        if self._registration is None:
            raise ValueError("register first: there is no pose to save yet")
        names, registration = (self._source.value, self._target.value), self._registration
        positions = self._pair_positions(*(self.stage.cloud(name)[1] for name in names))
        from .correspondences import save_pairs

        self.stage.download("pairs.json", lambda path: save_pairs(path, names, self._rows(), *positions, registration))
        self.stage.download("pairs.txt", lambda path: write_pose(path, registration.transformation))
        self.stage.set_status("The pairs are downloaded as pairs.json, the pose as pairs.txt.")

    def _due(self) -> str:
        return self._target.value if len(self._picks) % 2 else self._source.value

    def _next(self) -> str:
        pair = len(self._picks) // 2 + 1
        return f"Pair {pair}: click a point of {self._due()}."

    def _rows(self) -> NDArray[np.int64]:
        count = 2 * (len(self._picks) // 2)
        return np.array([pick.index for pick in self._picks[:count]], np.int64).reshape(-1, 2)

    def _pair_positions(self, source: Any, target: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        rows = self._rows()
        return source.select_by_index(rows[:, 0]).points, target.select_by_index(rows[:, 1]).points

    def _move(self, source: Any, base: Matrix | None, T: Matrix) -> None:
        """Show the source at a pose, at a limited rate."""
        now = time.monotonic()
        if now - self._shown < SECONDS_A_POSE:
            return
        self._shown = now
        world = T if base is None else base @ T
        own = source.points.pose
        self.stage.edits.set_pose(source.name, world if own is None else world @ invert_pose(own))

    def _restart(self) -> None:
        self._picks, self._registration = [], None
        self._show(self.stage.view())

    def _show(self, view: View) -> None:
        stage = self.stage
        stage.clear()
        for number, pick in enumerate(self._picks):
            assert pick.index is not None
            item, cloud = stage.cloud(pick.name)
            color = TARGET_COLOR if number % 2 else SOURCE_COLOR
            position = world_point(Target(pick.name, cloud, pose=stage.pose_of(item)), pick.index)
            stage.mark(view, position, f"{'t' if number % 2 else 's'}{number // 2 + 1}", color)
        stage.show([])
        self._show_due()
        stage.set_status(self._next())

    def _show_due(self) -> None:
        self._show_only(self._due() if self._alone.value else None)

    def _show_only(self, name: str | None) -> None:
        """Hide the other of the two clouds in this page."""
        session = self.stage.session
        with self.stage.scene.lock:
            for choice in (self._source, self._target):
                stream = session.streams.get(choice.value)
                item = self.stage.scene.shown.get(choice.value)
                if stream is not None and item is not None:
                    stream.set_visible(item.visible and name in (None, choice.value))


def _rows(registration: PairRegistration, unit: LengthUnit | None) -> list[tuple[str, str]]:
    residuals = registration.fit.residuals
    return [
        ("rms of the pairs", length_text(registration.fit.rms, unit)),
        ("worst pair", f"{int(residuals.argmax()) + 1}, off by {length_text(float(residuals.max()), unit)}"),
        ("fitness", f"{100 * registration.fitness:.1f} %"),
        ("inlier rmse", length_text(registration.inlier_rmse, unit)),
        ("within", length_text(registration.distance, unit)),
        ("refined by ICP", "yes" if registration.refined else "no"),
    ]
