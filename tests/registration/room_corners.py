"""Corners of rooms: a floor and two walls, identical in all of them, and boxes that differ."""

import numpy as np

SIDE, HEIGHT, NOISE = 2.5, 1.8, 0.003  # [m]
ONE = ((0.3, 0.0, 0.5, 0.4, 1.0), (1.4, 1.2, 0.7, 0.5, 0.7), (0.0, 1.6, 0.4, 0.8, 1.4))  # x, y, width, depth, height
OTHER = ((1.6, 0.0, 0.7, 0.5, 1.3), (0.6, 1.5, 0.4, 0.7, 0.5), (0.0, 0.5, 0.5, 0.6, 0.8))


def corner(rng: np.random.Generator, boxes=(), count: int = 40000) -> np.ndarray:
    """Points of a corner of 2.5 x 2.5 x 1.8 m that opens to +x, +y and +z, with boxes; 3 mm noise."""
    faces = [
        ((0, 0, 0), (SIDE, 0, 0), (0, SIDE, 0)),
        ((0, 0, 0), (SIDE, 0, 0), (0, 0, HEIGHT)),
        ((0, 0, 0), (0, SIDE, 0), (0, 0, HEIGHT)),
    ]
    for x, y, width, depth, height in boxes:
        faces += [
            ((x, y, height), (width, 0, 0), (0, depth, 0)),
            ((x, y + depth, 0), (width, 0, 0), (0, 0, height)),
            ((x + width, y, 0), (0, depth, 0), (0, 0, height)),
            ((x, y, 0), (width, 0, 0), (0, 0, height)),
            ((x, y, 0), (0, depth, 0), (0, 0, height)),
        ]
    start, first, second = np.array(faces, float).swapaxes(0, 1)
    areas = np.linalg.norm(np.cross(first, second), axis=1)
    face = rng.choice(len(areas), count, p=areas / areas.sum())
    u, v = rng.random((2, count, 1))
    points = start[face] + u * first[face] + v * second[face]
    hidden = np.zeros(count, bool)
    for x, y, width, depth, height in boxes:
        inside = (points > [x - 1e-9, y - 1e-9, -1e-9]) & (points < [x + width - 1e-6, y + depth - 1e-6, height - 1e-6])
        hidden |= inside.all(axis=1) & (face < 3)  # the floor and the walls behind a box
    return points[~hidden] + rng.normal(0, NOISE, (int((~hidden).sum()), 3))
