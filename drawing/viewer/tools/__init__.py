"""What one does with the mouse in the viewer: picking, measuring, cutting out, registering by hand."""
