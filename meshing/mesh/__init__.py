"""TriangleMesh, and what one does with it; surfaces from points."""
