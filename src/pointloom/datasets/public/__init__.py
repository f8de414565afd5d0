"""Public data sets: addresses, contents, download."""
