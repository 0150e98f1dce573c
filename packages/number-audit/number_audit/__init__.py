"""Checks that the numbers in a text still agree with your result files."""
