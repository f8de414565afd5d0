"""Non-rigid registration: deformation graphs, correspondences, coherent point drift."""
