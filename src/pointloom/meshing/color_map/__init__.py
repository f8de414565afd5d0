"""Vertex colors and textures of a mesh from posed images (Zhou and Koltun 2014)."""
