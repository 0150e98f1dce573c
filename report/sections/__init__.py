"""One module for each section: what it derives from its results, shows and claims."""
