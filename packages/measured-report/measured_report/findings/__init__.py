"""Findings: what an edition's records come to, values and outcomes, before anything is put into words."""
