"""Device code: all data-parallel kernels, and the kernel language."""
