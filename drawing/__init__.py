"""Pictures, recordings and the live viewer."""
