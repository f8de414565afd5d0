"""The light of our pictures in the page: from everywhere, from the camera and from above left of it.

`render` multiplies the colours of the screen by shares of light; the page adds up light and maps tones after that. So
surfaces are sent as they look under the light that most of them are seen in, `USUAL`, and the lamps of the page have
other strengths: those that come nearest to our picture of a ball without colours, each of its pixels alike (least
squares; tests/drawing/viewer/test_lights.py says what is left). Both lamps go with the camera, which the page reports
as it moves.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.drawing.shading import KEY_X, KEY_Y, KEY_Z
from .items import rotation

if TYPE_CHECKING:
    import viser

USUAL = 0.8  # the share of light, in our pictures, under which surfaces have the colours that they are sent with

# What falls on a surface that faces the lamp, as shares of what shows colours as they are sent.
EVERYWHERE, LAMP, KEY = 0.156, 0.625, 0.846

# away from the lamp above left, in the camera's frame: x right, y down
KEY_DIRECTION = np.array([KEY_X, KEY_Y, KEY_Z])


def light_evenly(server: viser.ViserServer) -> None:
    """Replace the lights that viser has by the share from everywhere, in all pages."""
    server.scene.configure_default_lights(enabled=False, cast_shadow=False)
    server.scene.configure_environment_map(None)
    server.scene.add_light_ambient("/light", intensity=_strength(EVERYWHERE))


class Lamps:
    """The lamps of one page.

    Args:
        client: The page.
    """

    def __init__(self, client: viser.ClientHandle):
        camera, scene = client.camera, client.scene
        self._client = client
        place, direction = _places(camera)
        self._lamp = scene.add_light_point(
            "/light/lamp", intensity=_strength(LAMP), decay=0.0, cast_shadow=False, position=place
        )
        self._key = scene.add_light_directional(
            "/light/key", intensity=_strength(KEY), cast_shadow=False, position=direction
        )

    def follow(self, camera: Any) -> None:
        """Go where the camera went."""
        with self._client.atomic():
            self._lamp.position, self._key.position = _places(camera)


def page_light(normals: NDArray[np.float64]) -> NDArray[np.float64]:
    """The light on surfaces straight before a camera, shape [n], of normals away from it in its frame, [n, 3]."""
    return EVERYWHERE + LAMP * np.maximum(normals[:, 2], 0) + KEY * np.maximum(normals @ KEY_DIRECTION, 0)


def _places(camera: Any) -> tuple[Any, Any]:
    """Where the lamp at the camera is, and a place in the direction of the other as seen from the page's zero."""
    away = rotation(camera.wxyz) @ KEY_DIRECTION
    x, y, z = (float(value) for value in camera.position)
    return (x, y, z), tuple((-away).tolist())


def _strength(share: float) -> float:
    """The page's number for a light under which a surface shows this share of its colour: it divides by pi."""
    return math.pi * share
