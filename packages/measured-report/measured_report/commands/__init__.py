"""Commands of make and build.py, a module each."""
