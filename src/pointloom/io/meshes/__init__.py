"""Triangle mesh formats: OBJ, STL, OFF, GLB. Any file by extension."""
