"""Order of the sections of the panel, from the top."""

COUNTS_ORDER, TOOL_ORDER, TOOLS_ORDER, COLOR_ORDER, SCENE_ORDER, POINTS_ORDER, VIEW_ORDER = 0, 0.5, 1, 2, 3, 4, 5
