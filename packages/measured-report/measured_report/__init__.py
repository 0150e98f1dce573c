"""A report that measures itself: from measured records to values, claims, figures and a site, of any subject."""
