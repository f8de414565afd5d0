"""Images, recordings and the live viewer."""
