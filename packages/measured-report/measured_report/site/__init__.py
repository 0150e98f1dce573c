"""The site: written, checked, published and served."""
