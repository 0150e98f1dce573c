"""Derive findings: the values and outcomes of an edition's records, before they are put
into words.
"""
