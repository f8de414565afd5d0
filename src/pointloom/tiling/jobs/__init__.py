"""Jobs other than tiles: fusion by cubes, sequences, registration."""
