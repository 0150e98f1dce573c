"""Build reports of any subject: from measured records to values, claims, figures and a
site.
"""
