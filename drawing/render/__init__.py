"""Pictures of clouds, meshes, lines and figures, by our own kernels: no window, no graphics library."""
