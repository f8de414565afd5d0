"""Small matrices: eigenvalues, rigid motions, transforms, moments."""
