"""Measuring: batches, who makes them, and how a section becomes a record."""
