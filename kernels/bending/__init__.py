"""Bodies that bend: deformation graphs, what brings them onto a surface, and coherent point drift."""
