"""Commands of this report alone, a module each, as those in measured_report/commands/."""
