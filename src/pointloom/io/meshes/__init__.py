"""Triangle mesh formats: OBJ, STL, OFF, GLB; any file by extension."""
