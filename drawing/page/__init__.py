"""What recordings and the live viewer show in a browser: plain scripts, styles and pages, joined without a build step."""
