"""One module per section, which derives its values, tables, figures and claims."""
