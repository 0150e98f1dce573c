"""Records: what was measured, where it lies, whether it is fresh, and how it is measured again.

Both the experiments and the page read and write through this room; it knows neither.
"""
