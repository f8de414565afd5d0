"""Mouse tools of the viewer: picking, measuring, cropping, manual registration."""
