"""Define numbers with a unit, a source and noise."""
