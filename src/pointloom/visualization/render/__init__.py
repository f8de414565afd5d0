"""Images of clouds, meshes, lines and plots by pointloom's kernels, without a window or a graphics library."""
