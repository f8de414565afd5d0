"""Formats of triangle meshes: OBJ, STL, OFF, GLB; and any file by its extension."""
