"""Measure sections in batches and write their records."""
