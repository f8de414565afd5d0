"""How far points reach: boxes, hulls, polygons, masks, visibility."""
