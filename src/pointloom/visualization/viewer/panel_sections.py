"""Order of the sections of the panel, from the top."""

COUNTS, TOOL, TOOLS, COLOR, SCENE, POINTS, VIEW = 0, 0.5, 1, 2, 3, 4, 5
