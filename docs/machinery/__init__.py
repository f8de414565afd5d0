"""Generators of pages for the site, in addition to Sphinx and sphinx-gallery (`make docs`)."""
