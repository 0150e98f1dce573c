"""Provide files, the cache and processes to all other packages."""
