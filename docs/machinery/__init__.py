"""What makes the site beside Sphinx and sphinx-gallery: `make docs`."""
