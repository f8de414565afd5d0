"""TriangleMesh and surface reconstruction."""
