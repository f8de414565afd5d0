"""Rows of the scene used by tests of the toolbox commands."""

from pathlib import Path

import pointloom as loom


def rows_of(path: Path) -> list[int]:
    return loom.read_point_cloud(path)["row"].tolist()


FLOOR, FIRST_BLOB, SECOND_BLOB = range(600), range(600, 750), range(750, 850)
STRAY, REPEATED, NOT_FINITE = 850, 851, 852
