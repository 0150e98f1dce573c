"""A report that measures itself: from measured records to values, claims, figures and a site.

It knows no subject: what is measured, derived and said is a report's own, in the folder that has a ``report.toml``.
"""
