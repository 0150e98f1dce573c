"""Check that the numbers in a text are still the numbers in your result files."""
