"""The shake test as an example: ``python -m experiments.shake``."""
