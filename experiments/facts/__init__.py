"""Define facts about the scene and about how runs end, for measuring and reporting.

This package uses only Python and NumPy.
"""
