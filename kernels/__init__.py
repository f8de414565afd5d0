"""Device code: every data-parallel kernel, and the compiler front that they are written for."""
