"""Jobs other than tiles: fusion by cubes, registration."""
