"""Deriving: what section modules make of records, kept from build to build."""
