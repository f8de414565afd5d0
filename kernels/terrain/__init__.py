"""Heights on grids whose cells are fixed in space: bare earth, and rasters of what lies in or near a cell."""
