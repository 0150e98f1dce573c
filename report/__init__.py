"""Derive values and claims from the records, in sections and in a story that combines them."""
